#include "certify/theorem/tower.hpp"

#include "certify/equation/facts.hpp"

#include <algorithm>

namespace kov::certify {

PhaseFunction Functions::times(const PhaseFunction& a, const PhaseFunction& b) const {
  if (is_zero(a.p) || is_zero(b.p)) return zero();
  return {a_.times(a.p, b.p), a_.times(a.n, b.n)};
}

PhaseFunction Functions::plus(const PhaseFunction& a, const PhaseFunction& b) const {
  if (is_zero(a.p)) return b;
  if (is_zero(b.p)) return a;
  const Integer n = a_.common_multiple(a.n, b.n);
  return {a_.plus(a_.scaled(a.p, exact_div(n, a.n)), a_.scaled(b.p, exact_div(n, b.n))), n};
}

PhaseFunction Functions::minus(const PhaseFunction& a, const PhaseFunction& b) const {
  return plus(a, {-b.p, b.n});
}

PhaseFunction Functions::composed(const PhaseFunction& f,
                                  const std::vector<std::optional<PhaseFunction>>& images) const {
  if (is_zero(f.p)) return zero();
  PhaseFunction g = put(f.p, used_variables(f.p), images);
  g.n = a_.times(g.n, f.n);
  return g;
}

// By powers of one variable after the other; at the end f is a number.
PhaseFunction Functions::put(const MPoly& f, std::vector<std::size_t> order,
                             const std::vector<std::optional<PhaseFunction>>& images) const {
  if (is_zero(f)) return zero();
  if (order.empty()) return {MPoly(ring_, f.coefficient(0)), Integer(1)};
  const std::size_t x = order.back();
  order.pop_back();
  need(x < images.size() && images[x].has_value(), "a name has no value");
  PhaseFunction sum = zero(), power = one();
  bool first = true;
  for (const MPoly& c : coefficients(f, x)) {
    if (!first) power = times(power, *images[x]);
    first = false;
    if (!is_zero(c)) sum = plus(sum, times(put(c, order, images), power));
  }
  return sum;
}

bool Tower::has_roots() const {
  return std::ranges::any_of(steps_, [](const AdjoinedName& x) { return x.square.has_value(); });
}

MPoly Tower::half(const Coefficients& c, std::size_t first, const PhaseFunction& square) const {
  Arithmetic& a = f_.arithmetic();
  MPoly sum(f_.ring());
  Integer lift(1);
  Coefficients rows;
  for (std::size_t j = first; j < c.size(); j += 2)
    rows.push_back(c[j]);
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    sum = a.plus(a.times(sum, square.p), a.scaled(*row, lift));
    lift = a.times(lift, square.n);
  }
  return sum;
}

MPoly Tower::without_inverse(const MPoly& f, const AdjoinedName& u) const {
  Arithmetic& a = f_.arithmetic();
  MPoly sum(f_.ring());
  for (const MPoly& c : coefficients(f, u.variable)) // ((c_0 h + c_1) h + c_2) ...
    sum = a.plus(a.times(sum, u.inverse_of), c);
  return sum;
}

bool Tower::clears(MPoly f, std::size_t steps) const {
  while (!is_zero(f) && steps > 0) {
    const AdjoinedName& x = steps_[--steps];
    if (!uses(f, x.variable)) continue;
    if (!x.square) {
      f = without_inverse(f, x);
      continue;
    }
    const Coefficients c = coefficients(f, x.variable);
    return clears(half(c, 0, *x.square), steps) && clears(half(c, 1, *x.square), steps);
  }
  return is_zero(f);
}

} // namespace kov::certify
