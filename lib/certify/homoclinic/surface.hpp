#pragma once
// The surface { section = 0, H = level }, pieces of it over boxes of two coordinates, and the section
// map and its inverse over such a piece (docs/theory/chaos.md 1).

#include "certify/homoclinic/check.hpp"
#include "certify/homoclinic/flow.hpp"

namespace kov::certify {

using TwoNumbers = std::array<Interval, 2>;
using TwoRows = std::array<TwoNumbers, 2>;
using Chart = std::array<std::size_t, 2>; ///< two of the four coordinates

inline TwoNumbers operator*(const TwoRows& a, const TwoNumbers& v) {
  return {a[0][0] * v[0] + a[0][1] * v[1], a[1][0] * v[0] + a[1][1] * v[1]};
}
inline TwoRows operator*(const TwoRows& a, const TwoRows& b) {
  const TwoNumbers first = a * TwoNumbers{b[0][0], b[1][0]},
                   second = a * TwoNumbers{b[0][1], b[1][1]};
  return {{{first[0], second[0]}, {first[1], second[1]}}};
}
[[nodiscard]] inline Interval determinant(const TwoRows& a) {
  return a[0][0] * a[1][1] - a[0][1] * a[1][0];
}
[[nodiscard]] inline TwoRows inverse(const TwoRows& a) {
  const Interval d = determinant(a);
  return {{{a[1][1] / d, -a[0][1] / d}, {-a[1][0] / d, a[0][0] / d}}};
}

/// (1.1) Over each point of the box of the chart's two coordinates exactly one point of the surface
/// has its other coordinates in the sheet.
struct SurfacePatch {
  Chart chart{};
  TwoNumbers box;
  Chart rest{}; ///< the other coordinates
  TwoNumbers sheet;
  State at; ///< those points, with derivatives by the chart's coordinates
  /// A point with chart coordinates in the box whose other coordinates are those of x is a point of
  /// the patch.
  [[nodiscard]] bool holds(const State& x) const {
    return x[rest[0]].inside(sheet[0]) && x[rest[1]].inside(sheet[1]);
  }
};

/// The image of a patch, with derivatives by its chart's coordinates, and the image of its middle.
struct Carried {
  State at, middle;
  /// The derivatives of two coordinates there.
  [[nodiscard]] TwoRows by_chart(const Chart& c) const {
    return {{{at[4 + c[0]], at[8 + c[0]]}, {at[4 + c[1]], at[8 + c[1]]}}};
  }
};

class LevelSurface {
public:
  explicit LevelSurface(const HomoclinicCertificate& c)
      : section_({c.section}), energy_({c.hamiltonian}), section_slope_(gradient(c.section)),
        energy_slope_(gradient(c.hamiltonian)), level_(c.level), period_(c.period),
        flow_(c.hamiltonian, c.section, c.where, c.rising) {}

  /// Throws Refused.
  [[nodiscard]] SurfacePatch patch(const Chart& chart, const TwoNumbers& box,
                                   const State& near) const {
    SurfacePatch p{chart, box, others(chart), {}, {}};
    TwoNumbers y{near[p.rest[0]].middle(), near[p.rest[1]].middle()};
    const TwoNumbers middle{box[0].middle(), box[1].middle()};
    for (int i = 0; i < sharpenings; ++i) {
      const Local l = local(p, joined(p, middle, y));
      const TwoNumbers step = inverse(l.by_rest) * l.value;
      for (std::size_t k = 0; k < 2; ++k)
        y[k] = (y[k] - step[k]).middle();
    }
    bool held = false;
    for (long room = widest_sheet; !held && room >= narrowest_sheet; room -= next_sheet) {
      p.sheet = {y[0].wider(power_of_two(room)), y[1].wider(power_of_two(room))};
      held = find_sheet(p, y);
    }
    need(held, "a piece of the surface is not enclosed");
    const Local l = local(p, p.at);
    const TwoRows slopes = inverse(l.by_rest) * l.by_chart;
    p.at.resize(12);
    for (std::size_t i = 0; i < 2; ++i) { // of the implicit functions
      p.at[4 + 4 * i + chart[i]] = Interval(1);
      for (std::size_t k = 0; k < 2; ++k)
        p.at[4 + 4 * i + p.rest[k]] = -slopes[k][i];
    }
    return p;
  }
  /// (1.2) The wanted crossing that comes next, way = 1, or the one before, way = -1; to the power of
  /// the period.  Throws Refused.
  [[nodiscard]] Carried carried(const SurfacePatch& from, int way = 1) {
    const TwoNumbers middle{from.box[0].middle(), from.box[1].middle()};
    const TwoNumbers off{from.box[0] - middle[0], from.box[1] - middle[1]};
    State x = from.at, thin = patch(from.chart, middle, from.at).at;
    need(from.holds(thin), "the middle of a patch is not known to lie on its sheet");
    thin.resize(4);
    for (long k = 0; k < period_; ++k)
      flow_.to_crossing(x, thin, off, way);
    return {x, thin};
  }
  /// The coordinates for which the others are determined best.
  [[nodiscard]] Chart chart_at(const State& x) const {
    Chart best{};
    double most = -1;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) {
        const SurfacePatch p{{i, j}, {}, others({i, j}), {}, {}};
        const double d = std::abs(determinant(local(p, x).by_rest).about());
        if (d <= most) continue;
        most = d;
        best = p.chart;
      }
    return best;
  }

private:
  static constexpr int sharpenings = 8;
  static constexpr long widest_sheet = -6, narrowest_sheet = -57,
                        next_sheet = 3; // binary logarithms

  static Chart others(const Chart& c) {
    std::vector<std::size_t> rest{0, 1, 2, 3};
    std::erase_if(rest, [&](std::size_t i) { return i == c[0] || i == c[1]; });
    return {rest[0], rest[1]};
  }
  static State joined(const SurfacePatch& p, const TwoNumbers& free, const TwoNumbers& solved) {
    State x(4);
    for (std::size_t k = 0; k < 2; ++k) {
      x[p.chart[k]] = free[k];
      x[p.rest[k]] = solved[k];
    }
    return x;
  }

  struct Local {
    TwoNumbers value;
    TwoRows by_chart, by_rest;
  };
  [[nodiscard]] Local local(const SurfacePatch& p, const State& x) const {
    const std::array by{section_slope_.at(x), energy_slope_.at(x)};
    Local l{{section_.at(x)[0], energy_.at(x)[0] - level_}, {}, {}};
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t k = 0; k < 2; ++k) {
        l.by_chart[i][k] = by[i][p.chart[k]];
        l.by_rest[i][k] = by[i][p.rest[k]];
      }
    return l;
  }
  // Interval Newton over the box and the sheet: y - (by rest)^-1 (value at y) inside the sheet.
  [[nodiscard]] bool find_sheet(SurfacePatch& p, const TwoNumbers& y) const {
    const Local over = local(p, joined(p, p.box, p.sheet)), here = local(p, joined(p, p.box, y));
    const TwoNumbers step = inverse(over.by_rest) * here.value;
    p.at = joined(p, p.box, {y[0] - step[0], y[1] - step[1]});
    return p.holds(p.at);
  }

  Polynomials section_, energy_, section_slope_, energy_slope_;
  Interval level_;
  long period_;
  SectionFlow flow_;
};

} // namespace kov::certify
