#include "closed/riemann.hpp"

#include "exact/factor.hpp"

#include <algorithm>

namespace kov {

// Common roots of the coordinates of f in a basis of
// K, so that nothing is factored over K.
std::vector<Rational> rational_roots(const Poly& f) {
  Poly common(0);
  for (long j = 0; j < f.field()->degree(); ++j) {
    std::vector<NfElem> coordinate;
    for (long i = 0; i <= degree(f); ++i)
      coordinate.emplace_back(f.coeff(i).coeff(j));
    common = gcd(common, Poly::from_coefficients(coordinate));
  }
  std::vector<Rational> roots;
  for (const Factor& factor : irreducible_factors(common))
    if (degree(factor.base) == 1)
      for (long i = 0; i < factor.exponent; ++i)
        roots.push_back(to_rational(-factor.base.coeff(0)));
  return roots;
}

namespace {

// The natural numbers s with f(s^2) = 0.
std::vector<Integer> natural_roots(const Poly& f) {
  std::vector<Integer> roots;
  for (const Rational& root : rational_roots(f))
    if (const auto s = exact_sqrt(root); s && is_integer(*s)) roots.push_back(s->num());
  std::ranges::sort(roots);
  return roots;
}

} // namespace

// The product of (sqrt T +- l +- m +- n) over all signs is
// (sum x_i^2 - 2 sum x_i x_j)^2 - 64 T l^2 m^2 n^2 in x = (T, l^2, m^2, n^2).
std::vector<Integer> odd_relations(const NfElem& e1, const NfElem& e2, const NfElem& e3) {
  const Poly t = Poly::z();
  const Poly sum = t + Poly(e1);
  const Poly pairs = scale(t, e1) + Poly(e2);
  const Poly inner = sum * sum - scale(pairs, NfElem(4));
  std::vector<Integer> odd;
  for (const Integer& k : natural_roots(inner * inner - scale(t, NfElem(64) * e3)))
    if (!is_integer(Rational(k, Integer(2)))) odd.push_back(k);
  return odd;
}

std::vector<Integer> integer_sums(const NfElem& sum, const NfElem& product) {
  const Poly t = Poly::z();
  const NfElem difference_squared = sum * sum - NfElem(4) * product; // (l^2 - m^2)^2
  return natural_roots(t * t - scale(t, NfElem(2) * sum) + Poly(difference_squared));
}

RationalFunction riemann_equation(const SquaredExponents& s) {
  const Poly z = Poly::z();
  const Poly one(1);
  const auto quarter = [](const NfElem& c) { return Poly(c / NfElem(4)); };
  const Poly w = z - one;
  const Poly num = quarter(s[0] - NfElem(1)) * w * w + quarter(s[1] - NfElem(1)) * z * z +
                   quarter(NfElem(1) - s[0] - s[1] + s[2]) * z * w;
  return {num, z * z * w * w};
}

} // namespace kov
