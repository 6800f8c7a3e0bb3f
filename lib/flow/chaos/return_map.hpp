#pragma once
// The section map P and its inverse, from chart to chart, with derivatives: enclosed, and quickly in double.
//
// Enclosed: a Taylor polynomial whose remainder is the next coefficient over a box that provably contains the orbit
// during the step; every step proves that it makes no wanted crossing, or exactly one, at which the orbit has landed.
// The inverse is the same with time running backward: the crossing before.
//
// Against the widening of boxes (Lohner's method, docs/theory/chaos.md 1.3): the orbits that start in the box lie in
// m + B (r + R (a - middle)), m a point, B a matrix of nearly orthogonal axes that turn with the flow.

#include "flow/chaos/krawczyk.hpp"
#include "flow/chaos/section_surface.hpp"

#include <atomic>
#include <cmath>

namespace kov::flow {

/// A box of the surface in a chart.  For every value of the chart's two coordinates in the box there is exactly one
/// point of the surface whose other coordinates lie in `sheet`.
template <class R> struct PatchOf {
  Chart chart;
  std::array<R, 2> box;
  PhasePoint<R> at;     ///< encloses those points, with derivatives by the chart's coordinates
  std::vector<R> sheet; ///< of chart.rest
};

template <class R> struct LandingOf {
  PhasePoint<R> at; ///< with derivatives by the coordinates of the patch that it came from
  R time;           ///< negative for the inverse
  std::vector<R> middle = {}; ///< where the middle of the box lands
};

/// R: Enclosure, or DoubleBall where boxes are many.
template <class R> class EnclosedMapOf {
public:
  using Patch = PatchOf<R>;
  using Landing = LandingOf<R>;
  /// Takes the precision of the thread's EnclosureScope.
  EnclosedMapOf(const SectionSurface& s, const std::atomic<bool>* stop);

  /// `near`: all coordinates, approximately.  Throws NotProved.
  [[nodiscard]] Patch patch(const Chart& chart, const std::array<R, 2>& box,
                            const std::vector<double>& near);
  /// The wanted crossing that comes next, or with `backward` the one before; `turns` times.  Throws NotProved.
  [[nodiscard]] Landing operator()(const Patch& from, bool backward = false, int turns = 1);
  /// The places where the orbits land that start in a box of phase space, on the section, and cross
  /// it there as wanted.  The map is that of a section alone (section_surface.hpp); where such a
  /// start is nearly tangent the second derivative says which way the orbit goes
  /// (docs/theory/chaos.md 2.2).  With one turn orbits are left out that are seen not to be closed:
  /// they come back while a coordinate has only grown, or fallen, or outside of the box.  Without
  /// derivatives and middle.
  /// Throws NotProved.
  [[nodiscard]] Landing landing_from(const std::vector<R>& box, int turns = 1);
  /// The landing's points that have the chart's coordinates in the patch's box are points of the patch.
  [[nodiscard]] static bool same_sheet(const Landing& l, const Patch& to);
  [[nodiscard]] static bool same_sheet(const PhasePoint<R>& x, const Patch& to);
  [[nodiscard]] SurfaceValues<R> values(const PhasePoint<R>& x) { return point_.at(x); }
  /// The rate of the section's function along the orbits, forward in time, positive where it is
  /// crossed as wanted.
  [[nodiscard]] R rate(const SurfaceValues<R>& v) const;
  [[nodiscard]] const SectionSurface& surface() const noexcept { return s_; }
  /// The most that the remainder of one step may add to each coordinate of a small box.
  [[nodiscard]] double tolerance() const noexcept {
    return std::exp2(-0.625 * static_cast<double>(bits_));
  }

private:
  enum class Verdict : unsigned char { goes_on, lands, retry };
  /// Orbits from the starts a of a box: x in middle + axes (error + slope (a - its middle)), and in `hull`.
  struct Front {
    std::vector<R> middle, error;
    std::vector<std::vector<R>> axes, slope; ///< exact; n x 2
    PhasePoint<R> hull;
  };
  /// The orbits during a step: where they are, and their coefficients; one code for each two derivatives.  The boxes and
  /// the last coefficients are common to all orbits of the hull, the middle's too.
  struct Step {
    std::vector<SurfaceCode<R>> code;
    std::vector<PhasePoint<R>> box = {}, last = {};
  };
  /// The motion of a box: where the middle goes, how its neighbours go along, and where all of them
  /// are.
  struct Move {
    std::vector<R> middle;
    std::vector<std::vector<R>> slope;
    PhasePoint<R> hull;
  };
  /// The state of one return: still on the section of the start; for how long the section's
  /// function has been growing since it was of the sign from which the section is crossed, all over
  /// the front, when some of the front may have crossed.
  struct Crossing {
    bool leaving = true, begun = false;
    /// For starts that may be tangent.  bent: the section's function may have its largest value
    /// behind it; loose: some orbits may have crossed; moving: for each coordinate the sign of its
    /// derivative since the start, 0 where it is not known.
    bool bent = false, loose = false;
    bool apart = false; ///< since it has begun the orbits are not at the start
    std::vector<int> moving = {};
    double since = 0;
  };
  [[nodiscard]] Front start(const Patch& from);
  [[nodiscard]] bool apart_from_start() const;
  [[nodiscard]] bool still_leaving(const SurfaceValues<R>& over, const R& speed, Crossing& c) const;
  void transport(Front& f, const Move& m) const;
  [[nodiscard]] Landing returned(Front& front);
  void expand(const Front& f);
  [[nodiscard]] Landing landing(Front& front, const R& now, double since);
  [[nodiscard]] bool contained(Step& s, double h);
  void of_middle_too();
  void advance(double& h);
  [[nodiscard]] Move moved(const R& t) const;
  [[nodiscard]] PhasePoint<R> reached(const Step& s, std::size_t part, const R& t) const;
  [[nodiscard]] R height(const PhasePoint<R>& x);
  [[nodiscard]] Verdict look(const PhasePoint<R>& from, const Front& to, Crossing& c);
  [[nodiscard]] double middle_crosses(double h);
  [[nodiscard]] R crossing_time(const Step& s);
  [[nodiscard]] Move landed(const R& t, const R& of_middle);
  const SectionSurface& s_;
  const std::atomic<bool>* stop_;
  long bits_;
  double tolerance_ = 0; ///< for this box of starts
  int order_;
  Step wide_, thin_;
  SurfaceCode<DoubleBall> over_box_; ///< boxes are far wider than the rounding of doubles
  SurfaceCode<R> point_;
  std::array<R, 2> off_;     ///< the box of starts minus its middle
  int way_ = 1;              ///< of time
  std::vector<R> closed_in_; ///< only orbits that come back into this box matter; empty: all
  R during_;                 ///< the times of the step, 0 among them
  double scale_ = 1, room_ = 1;
};

using Patch = PatchOf<Enclosure>;
using Landing = LandingOf<Enclosure>;
using EnclosedMap = EnclosedMapOf<Enclosure>;
extern template class EnclosedMapOf<Enclosure>;
extern template class EnclosedMapOf<DoubleBall>;

/// The same without proof: in double, or to the bits of the thread's EnclosureScope, of which the middles matter alone.
template <class R> class QuickMapOf {
public:
  explicit QuickMapOf(const SectionSurface& s);
  struct Image {
    PhasePoint<R> at;
    R time{};
  };
  /// Nothing if the orbit does not come back.
  [[nodiscard]] std::optional<Image> operator()(const PhasePoint<R>& from, bool backward = false,
                                                int turns = 1);
  /// The point of the surface over two chart coordinates near x, with derivatives by them.
  [[nodiscard]] std::optional<PhasePoint<R>> lifted(const Chart& chart, std::array<R, 2> at,
                                                    const std::vector<double>& near);
  /// How fast the section's function grows at a point.
  [[nodiscard]] R rate(const PhasePoint<R>& x) { return rate(code_.at(x)); }
  [[nodiscard]] SurfaceCode<R>& code() noexcept { return code_; }

private:
  [[nodiscard]] std::optional<Image> returned(const PhasePoint<R>& from, bool backward);
  [[nodiscard]] double step_size(std::size_t dimension) const;
  [[nodiscard]] R crossing_time(double h, double s0, double s1, double way);
  [[nodiscard]] R rate(const SurfaceValues<R>& v) const;
  const SectionSurface& s_;
  double tolerance_; ///< of a step
  int order_;
  SurfaceCode<R> code_;
};

using QuickMap = QuickMapOf<double>;
extern template class QuickMapOf<double>;
extern template class QuickMapOf<Enclosure>;

[[nodiscard]] std::vector<double> doubles(const PhasePoint<double>& x);
[[nodiscard]] std::vector<double> doubles(const PhasePoint<Enclosure>& x);
[[nodiscard]] std::vector<double> doubles(const PhasePoint<DoubleBall>& x);

} // namespace kov::flow
