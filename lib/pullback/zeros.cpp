#include "pullback/zeros.hpp"

#include "exact/factor.hpp"
#include "exact/lists.hpp"

#include <algorithm>

namespace kov::pullback {
namespace {

Singularity at(const Poly& place, const Singularities& s) {
  for (const Singularity& p : s.finite)
    if (p.place == place) return p;
  Singularity ordinary;
  ordinary.place = place;
  ordinary.delta = Rational(1);
  return ordinary;
}

// The number d + 2k of least absolute value; d itself if it is not rational.
NfElem reduced(const NfElem& d) {
  if (!is_rational(d)) return d;
  const Rational q = to_rational(d);
  const Integer k = floor((q + Rational(1)) / Rational(2));
  return NfElem(q - Rational(2) * Rational(k));
}

} // namespace

std::vector<Zero> zeros_of(const RationalFunction& f, const Singularities& s,
                           const Budget& budget) {
  std::vector<Zero> found;
  for (const Factor& factor : irreducible_factors(f.num(), budget))
    found.push_back({at(factor.base, s), factor.exponent});
  if (const long at_infinity = degree(f.den()) - degree(f.num()); at_infinity > 0)
    found.push_back({s.infinity, at_infinity});
  return found;
}

namespace {

std::vector<NfElem> squares(const std::vector<Zero>& zeros, long shifts) {
  const auto least = std::ranges::min_element(
      zeros, [](const Zero& a, const Zero& b) { return a.multiplicity < b.multiplicity; });
  if (least == zeros.end() || degree(least->place.delta_squared) > 0) return {};
  const NfElem square = least->place.delta_squared.coeff(0);
  const NfElem e(least->multiplicity);
  const auto root = exact_sqrt(square);
  if (!root) return {square / (e * e)};
  std::vector<NfElem> found;
  if (least->multiplicity == 1) found.push_back(square); // perhaps no gauge is needed
  for (long j = 0; j < shifts * least->multiplicity; ++j) {
    const NfElem d = reduced((*root + NfElem(j)) / e);
    add_once(found, d * d);
  }
  return found;
}

} // namespace

std::vector<NfElem> squares_at_zero(const std::vector<Zero>& zeros) { return squares(zeros, 1); }

std::vector<NfElem> squares_and_odd_shifts(const std::vector<Zero>& zeros) {
  return squares(zeros, 2);
}

} // namespace kov::pullback
