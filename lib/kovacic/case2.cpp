#include "kovacic/case2.hpp"

#include "exact/error.hpp"
#include "kovacic/exponents.hpp"
#include "kovacic/invariant_families.hpp"
#include "kovacic/necessary.hpp"

#include <algorithm>

namespace kov::kovacic {
namespace {

// The resultant of omega^2 - phi omega + phi'/2 + phi^2/2 - r with its derivation vanishes exactly
// when phi'' + 3 phi phi' + phi^3 = 4 r phi + 2 r'.
Imprimitive verified(Imprimitive found, const RationalFunction& r) {
  const RationalFunction& phi = found.phi;
  const RationalFunction d = derivative(phi);
  KOV_ENSURE(is_zero(derivative(d) + RationalFunction(3) * phi * d + phi * phi * phi -
                     RationalFunction(4) * r * phi - RationalFunction(2) * derivative(r)));
  return found;
}

// The parities of e that differ from a rational v: not all exponents of v integral.
bool is_not_rational(const std::vector<Rational>& e) {
  return !std::all_of(e.begin(), e.end(), [](const Rational& x) { return is_integer(x); });
}

// Three conjugate pairs of lines: each root of a place with Delta in 1/2 + Z belongs to one of them
// (its local monodromy generates one of the three subgroups of order four), conjugation permutes
// the three transitively, so each such place has degree 3k and is not infinity.
bool may_be_three_conjugates(const Singularities& s) {
  return !any_place(s, [](const Singularity& p) {
    if (certainly(p.log) || !has_denominator_dividing(p, 2)) return true;
    if (has_denominator_dividing(p, 1)) return false;
    return p.at_infinity || p.degree() % 3 != 0;
  });
}

} // namespace

std::optional<Outcome> case2(const Singularities& s, const Budget& budget, Trace* trace) {
  ProductSearch search;
  search.kovacic_case = 2;
  search.m = 2;
  search.scale = 2;
  search.classes = [](const Singularity& place) { return classes(place, 2, 2); };
  search.wanted = is_not_rational;
  search.name = "Case 2";
  const auto found = products(s, search, budget, trace);
  if (!found.empty()) {
    const Imprimitive answer{found.front().phi()};
    note(trace, 2, 3,
         "omega^2 - phi omega + phi'/2 + phi^2/2 - r = 0 with phi = " + to_string(answer.phi) +
             ".");
    return verified(answer, s.r);
  }
  if (!may_be_three_conjugates(s)) return std::nullopt;
  const auto triple =
      rational_products(s, 6, 2, "three conjugate quadratics, v1 v2 v3 rational", budget, trace);
  if (triple.empty()) return std::nullopt;
  KOV_ENSURE(triple.size() == 1);
  note(trace, 2, 3,
       "The three quadratics of the quaternion group are conjugate over a cubic "
       "extension; their product of degree 6 is rational.");
  return ImprimitiveTriple{riccati_polynomial(triple.front().chain, triple.front().S)};
}

} // namespace kov::kovacic
