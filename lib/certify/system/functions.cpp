#include "certify/system/functions.hpp"

#include "certify/equation/facts.hpp"

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

MPoly without_inverse(const MPoly& f, std::size_t u, const MPoly& h, Arithmetic& a) {
  MPoly sum(f.ring());
  for (const MPoly& c : coefficients(f, u)) // ((c_0 h + c_1) h + c_2) ...
    sum = a.plus(a.times(sum, h), c);
  return sum;
}

PhaseFunction Functions::product(const std::vector<PhaseFunction>& a,
                                 const std::vector<PhaseFunction>& b) const {
  PhaseFunction sum = zero();
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!is_zero(a[i].p) && !is_zero(b[i].p)) sum = plus(sum, times(a[i], b[i]));
  return sum;
}

} // namespace kov::certify
