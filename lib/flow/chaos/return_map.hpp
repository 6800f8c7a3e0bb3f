#pragma once
// The section map P and its inverse, from chart to chart, with derivatives: enclosed, and quickly in double.
//
// Enclosed: integration as in prove_fixed_point.cpp, i.e. a Taylor polynomial whose remainder is the next coefficient
// over a box that provably contains the orbit during the step; every step proves that it makes no wanted crossing, or
// exactly one, at which the orbit has landed.  The inverse is the same with time running backward: the crossing before.
//
// Against the widening of boxes the orbit of the box's middle m is enclosed beside them: x(t; a) lies in
// x(t; m) + D x(t; box) (a - m), by the mean value theorem, and so in the intersection of that with the box.

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

private:
  enum class Verdict : unsigned char { goes_on, lands, retry };
  /// A box of orbits, and the orbit of its middle.
  struct Front {
    PhasePoint<Enclosure> x, thin;
  };
  /// The orbits during a step: where they are, their coefficients, and the first that is not computed at a point.
  struct Step {
    SurfaceCode<Enclosure> code;
    PhasePoint<Enclosure> box = {}, last = {};
  };
  [[nodiscard]] Front start(const Patch& from);
  [[nodiscard]] Landing returned(Front& front);
  [[nodiscard]] PhasePoint<Enclosure> advance(Step& s, double& h);
  [[nodiscard]] PhasePoint<Enclosure> reached(const Step& s, const Enclosure& t) const;
  void tighten(PhasePoint<Enclosure>& x, const PhasePoint<Enclosure>& thin) const;
  [[nodiscard]] Verdict look(const PhasePoint<Enclosure>& from, const PhasePoint<Enclosure>& to,
                             bool& leaving);
  [[nodiscard]] Landing land(const Step& s, double h, const Enclosure& before);
  [[nodiscard]] Enclosure rate(const SurfaceValues<Enclosure>& v) const;
  [[nodiscard]] Enclosure onward(double h) const; ///< [0, h] in the direction of time
  const SectionSurface& s_;
  const std::atomic<bool>* stop_;
  double tolerance_;
  int order_;
  Step wide_, thin_;
  SurfaceCode<Enclosure> over_box_, point_;
  std::array<Enclosure, 2> off_; ///< the box minus its middle
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
