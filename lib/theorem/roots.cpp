#include "theorem/roots.hpp"

#include <algorithm>

namespace kov {

namespace {

MFraction without_square(const MPoly& p, const Roots::Root& root) {
  const auto c = coefficients(p, root.first);
  if (c.size() < 3) return MFraction(p);
  const MFraction r = MFraction::variable(p.ring(), root.first);
  MFraction even = MFraction(p.ring()), odd = even, power = MFraction(p.ring(), Rational(1));
  for (std::size_t i = 0; i < c.size(); ++i) {
    (i % 2 == 0 ? even : odd) = (i % 2 == 0 ? even : odd) + MFraction(c[i]) * power;
    if (i % 2 == 1) power = power * root.second;
  }
  return even + odd * r;
}

} // namespace

MFraction Roots::reduced(const MPoly& p) const {
  MFraction value(p);
  for (auto root = squares_.rbegin(); root != squares_.rend(); ++root)
    value = without_square(value.num(), *root) / without_square(value.den(), *root);
  return value;
}

std::pair<MPoly, MPoly> Roots::norm_and_factor(const MPoly& p) const {
  MPoly value = p, factor(p.ring(), Integer(1));
  for (auto root = squares_.rbegin(); root != squares_.rend(); ++root) {
    if (!kov::uses(value, root->first)) continue;
    const MFraction r = MFraction::variable(p.ring(), root->first);
    const MPoly conjugate = substitute(value, {{root->first, -r}}).num();
    const MFraction product = without_square(value * conjugate, *root);
    factor = factor * conjugate * product.den();
    value = product.num();
  }
  return {value, factor};
}

bool Roots::uses_root(const MFraction& f) const {
  return std::ranges::any_of(squares_, [&](const Root& root) { return kov::uses(f, root.first); });
}

} // namespace kov
