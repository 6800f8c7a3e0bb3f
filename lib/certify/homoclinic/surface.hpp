#pragma once
// The surface { section = 0, H = level }, pieces of it over boxes of two coordinates, and the section
// map and its inverse over such a piece (docs/theory/chaos.md 1).

#include "certify/homoclinic/certificate.hpp"
#include "certify/homoclinic/flow.hpp"

namespace kov::certify {

using TwoNumbers = std::array<Interval, 2>;
using TwoRows = std::array<TwoNumbers, 2>;
using Chart = std::array<std::size_t, 2>; ///< two of the four coordinates

[[nodiscard]] TwoRows product(const TwoRows& a, const TwoRows& b);
[[nodiscard]] TwoRows inverse(const TwoRows& a);

/// (1.1) Over each point of the box of the chart's two coordinates exactly one point of the surface
/// has its other coordinates in the sheet.
struct SurfacePatch {
  Chart chart{};
  TwoNumbers box;
  std::vector<std::size_t> rest; ///< the other coordinates
  TwoNumbers sheet;
  Jet at; ///< those points, with derivatives by the chart's coordinates
  /// A point with chart coordinates in the box whose other coordinates are those of x is a point of
  /// the patch.
  [[nodiscard]] bool holds(const Point& x) const {
    return x[rest[0]].inside(sheet[0]) && x[rest[1]].inside(sheet[1]);
  }
};

/// The image of a patch, with derivatives by its chart's coordinates, and the image of its middle.
struct Carried {
  Point at;
  Point middle;
  Jet jet;
  /// The derivatives of two coordinates there.
  [[nodiscard]] TwoRows by_chart(const Chart& c) const;
};

class LevelSurface {
public:
  explicit LevelSurface(const HomoclinicCertificate& c);

  /// Throws Refused.
  [[nodiscard]] SurfacePatch patch(const Chart& chart, const TwoNumbers& box,
                                   const Point& near) const;
  /// (1.2) The wanted crossing that comes next, way = 1, or the one before, way = -1; to the power of
  /// the period.  Throws Refused.
  [[nodiscard]] Carried carried(const SurfacePatch& from, int way = 1);
  /// The coordinates for which the others are determined best.
  [[nodiscard]] Chart chart_at(const Point& x) const;

private:
  struct Local {
    TwoNumbers value;
    TwoRows by_chart, by_rest;
  };
  [[nodiscard]] Local local(const Chart& chart, const std::vector<std::size_t>& rest,
                            const Point& x) const;
  [[nodiscard]] bool find_sheet(SurfacePatch& p, const TwoNumbers& y, Point& found) const;

  Polynomials values_, slopes_;
  Interval level_;
  long period_;
  SectionFlow flow_;
};

} // namespace kov::certify
