#include "certify/theorem/tower.hpp"

#include "certify/equation/facts.hpp"

#include <algorithm>

namespace kov::certify {

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

MPoly Tower::cleared(MPoly f) const {
  for (auto u = steps_.rbegin(); u != steps_.rend(); ++u)
    f = without_inverse(f, u->variable, u->inverse_of, f_.arithmetic());
  return f;
}

bool Tower::clears(MPoly f, std::size_t steps) const {
  while (!is_zero(f) && steps > 0) {
    const AdjoinedName& x = steps_[--steps];
    if (!uses(f, x.variable)) continue;
    if (!x.square) {
      f = without_inverse(f, x.variable, x.inverse_of, f_.arithmetic());
      continue;
    }
    const Coefficients c = coefficients(f, x.variable);
    return clears(half(c, 0, *x.square), steps) && clears(half(c, 1, *x.square), steps);
  }
  return is_zero(f);
}

} // namespace kov::certify
