#include "certify/theorem/tower.hpp"

#include "certify/equation/facts.hpp"

#include <algorithm>

namespace kov::certify {

bool Tower::has_roots() const {
  return std::ranges::any_of(steps_, [](const AdjoinedName& x) { return x.square.has_value(); });
}

std::array<MPoly, 2> halves(const MPoly& f, std::size_t r, const PhaseFunction& square,
                            Arithmetic& a) {
  std::array<MPoly, 2> sum{MPoly(f.ring()), MPoly(f.ring())};
  Integer lift(1);
  Coefficients c = coefficients(f, r);
  c.resize(c.size() + c.size() % 2, MPoly(f.ring()));
  for (std::size_t j = c.size(); j-- > 0;) {
    sum[j % 2] = a.plus(a.times(sum[j % 2], square.p), a.scaled(c[j], lift));
    if (j % 2 == 0) lift = a.times(lift, square.n);
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
    const auto [even, odd] = halves(f, x.variable, *x.square, f_.arithmetic());
    return clears(even, steps) && clears(odd, steps);
  }
  return is_zero(f);
}

} // namespace kov::certify
