#include "report/render_theorem.hpp"

#include <algorithm>

namespace kov::report {

PlacedPicture place(const PolePicture& p, long width, long height) {
  PlacedPicture out{width, height, {}, {}, {}, {}};
  Rational low_x(-1), high_x(1), low_y(p.strip ? 0 : -1), high_y(p.strip ? 2 : 1);
  for (const auto& q : p.points) {
    low_x = std::min(low_x, q.x);
    high_x = std::max(high_x, q.x);
    low_y = std::min(low_y, q.y);
    high_y = std::max(high_y, q.y);
  }
  // the same scale on both axes, with a margin of a tenth
  const Rational inner(Integer(8), Integer(10));
  const Rational span_x = high_x - low_x, span_y = high_y - low_y;
  const Rational scale = inner * std::min(Rational(width) / span_x, Rational(height) / span_y);
  const Rational half(Integer(1), Integer(2));
  const Rational mid_x = half * (low_x + high_x), mid_y = half * (low_y + high_y);
  const auto at = [&](const Rational& v, const Rational& mid, long size) {
    return to_long(floor(scale * (v - mid) + half * Rational(size)));
  };
  for (const auto& q : p.points)
    out.points.push_back({at(q.x, mid_x, width), at(q.y, mid_y, height), q.label, q.special});
  out.axis_x = at(Rational(0), mid_x, width);
  out.axis_y = at(Rational(0), mid_y, height);
  if (p.strip) out.band = {at(Rational(0), mid_y, height), at(Rational(2), mid_y, height)};
  if (*out.axis_x < 0 || *out.axis_x > width) out.axis_x.reset();
  if (*out.axis_y < 0 || *out.axis_y > height) out.axis_y.reset();
  return out;
}

std::string settled(const TheoremHypothesis& h) {
  return h.settled == Settled::checked  ? "checked (" + h.how + "): "
         : h.settled == Settled::stated ? "part of the statement: "
                                        : "NOT CHECKED: ";
}

std::string remark(const NodeResult& n) {
  return n.statement.empty() && n.node.kind == NodeKind::argument ? "argument in words: "
                                                                  : "the author's remark: ";
}

} // namespace kov::report
