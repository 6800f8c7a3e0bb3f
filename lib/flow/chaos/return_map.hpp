#pragma once
// The section map P and its inverse, from chart to chart, with derivatives: enclosed, and quickly in double.
//
// Enclosed: integration as in prove_fixed_point.cpp, i.e. a Taylor polynomial whose remainder is the next coefficient
// over a box that provably contains the orbit during the step; every step proves that it makes no wanted crossing, or
// exactly one, at which the orbit has landed.  The inverse is the same with time running backward: the crossing before.
//
// Against the widening of boxes (Lohner's method, docs/theory/chaos.md 1.3): the orbits that start in the box lie in
// m + B (r + R (a - middle)), m a point, B a matrix of nearly orthogonal axes that turn with the flow.

#include "flow/chaos/krawczyk.hpp"
#include "flow/chaos/section_surface.hpp"

#include <atomic>

namespace kov::flow {

/// A box of the surface in a chart.  For every value of the chart's two coordinates in the box there is exactly one
/// point of the surface whose other coordinates lie in `sheet`.
struct Patch {
  Chart chart;
  std::array<Enclosure, 2> box;
  PhasePoint<Enclosure> at; ///< encloses those points, with derivatives by the chart's coordinates
  std::vector<Enclosure> sheet; ///< of chart.rest
};

struct Landing {
  PhasePoint<Enclosure> at; ///< with derivatives by the coordinates of the patch that it came from
  Enclosure time;           ///< negative for the inverse
  std::vector<Enclosure> middle = {}; ///< where the middle of the box lands
};

class EnclosedMap {
public:
  /// Takes the precision of the thread's EnclosureScope.
  EnclosedMap(const SectionSurface& s, const std::atomic<bool>* stop);

  /// `near`: all coordinates, approximately.  Throws NotProved.
  [[nodiscard]] Patch patch(const Chart& chart, const std::array<Enclosure, 2>& box,
                            const std::vector<double>& near);
  /// The wanted crossing that comes next, or with `backward` the one before; `turns` times.  Throws NotProved.
  [[nodiscard]] Landing operator()(const Patch& from, bool backward = false, int turns = 1);
  /// The landing's points that have the chart's coordinates in the patch's box are points of the patch.
  [[nodiscard]] static bool same_sheet(const Landing& l, const Patch& to);
  [[nodiscard]] static bool same_sheet(const PhasePoint<Enclosure>& x, const Patch& to);
  [[nodiscard]] SurfaceValues<Enclosure> values(const PhasePoint<Enclosure>& x) {
    return point_.at(x);
  }
  [[nodiscard]] const SectionSurface& surface() const noexcept { return s_; }
  /// What the remainder of one step may add to each coordinate.
  [[nodiscard]] double tolerance() const noexcept { return tolerance_; }

private:
  enum class Verdict : unsigned char { goes_on, lands, retry };
  /// Orbits from the starts a of a box: x in middle + axes (error + slope (a - its middle)), and in `hull`.
  struct Front {
    BallVector middle, error;
    BallMatrix axes, slope; ///< exact; n x 2
    PhasePoint<Enclosure> hull;
  };
  /// The orbits during a step: where they are, and their coefficients; one code for each two derivatives.  The boxes and
  /// the last coefficients are common to all orbits of the hull, the middle's too.
  struct Step {
    std::vector<SurfaceCode<Enclosure>> code;
    std::vector<PhasePoint<Enclosure>> box = {}, last = {};
  };
  /// Where the middle goes, how its neighbours go along, and where all of them are.
  struct Move {
    BallVector middle;
    BallMatrix slope;
    PhasePoint<Enclosure> hull;
  };
  [[nodiscard]] Front start(const Patch& from);
  void transport(Front& f, const Move& m) const;
  [[nodiscard]] Landing returned(Front& front);
  void expand(const Front& f);
  [[nodiscard]] bool contained(Step& s, double& h);
  void advance(double& h);
  [[nodiscard]] Move moved(const Enclosure& t) const;
  [[nodiscard]] PhasePoint<Enclosure> reached(const Step& s, std::size_t part,
                                              const Enclosure& t) const;
  [[nodiscard]] Verdict look(const PhasePoint<Enclosure>& from, const PhasePoint<Enclosure>& to,
                             bool& leaving);
  [[nodiscard]] Enclosure crossing_time(const Step& s, double h);
  [[nodiscard]] Move landed(const Enclosure& t, const Enclosure& of_middle);
  [[nodiscard]] Enclosure rate(const SurfaceValues<Enclosure>& v) const;
  [[nodiscard]] Enclosure onward(double h) const; ///< [0, h] in the direction of time
  const SectionSurface& s_;
  const std::atomic<bool>* stop_;
  double tolerance_;
  int order_;
  Step wide_, thin_;
  SurfaceCode<Enclosure> over_box_, point_;
  std::array<Enclosure, 2> off_; ///< the box of starts minus its middle
  int way_ = 1;                  ///< of time
  double room_ = 1;
};

/// The same in double, without proof.
class QuickMap {
public:
  explicit QuickMap(const SectionSurface& s) : s_(s), code_(s, order) {}
  struct Image {
    PhasePoint<double> at;
    double time = 0;
  };
  /// Nothing if the orbit does not come back.
  [[nodiscard]] std::optional<Image> operator()(const PhasePoint<double>& from,
                                                bool backward = false, int turns = 1);
  /// The point of the surface over two chart coordinates near x, with derivatives by them.
  [[nodiscard]] std::optional<PhasePoint<double>>
  lifted(const Chart& chart, std::array<double, 2> at, const std::vector<double>& near);
  [[nodiscard]] SurfaceCode<double>& code() noexcept { return code_; }

private:
  static constexpr int order = 18;
  [[nodiscard]] std::optional<Image> returned(const PhasePoint<double>& from, bool backward);
  const SectionSurface& s_;
  SurfaceCode<double> code_;
};

[[nodiscard]] std::vector<double> doubles(const PhasePoint<double>& x);
[[nodiscard]] std::vector<double> doubles(const PhasePoint<Enclosure>& x);

} // namespace kov::flow
