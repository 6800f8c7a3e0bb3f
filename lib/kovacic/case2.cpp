#include "kovacic/case2.hpp"

#include "exact/error.hpp"
#include "kovacic/exponents.hpp"
#include "kovacic/invariant_families.hpp"
#include "kovacic/necessary.hpp"
#include "kovacic/plug_back.hpp"

#include <algorithm>

namespace kov::kovacic {
namespace {

// The parities of e that differ from a rational v: not all exponents of v integral.
bool is_not_rational(const std::vector<Rational>& e) {
  return !std::ranges::all_of(e, [](const Rational& x) { return is_integer(x); });
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

Outcome quadratic(const RationalFunction& phi, const Singularities& s, Trace* trace) {
  note(trace, 2, 3, [&] {
    return "omega^2 - phi omega + phi'/2 + phi^2/2 - r = 0 with phi = " + to_string(phi) + ".";
  });
  KOV_ENSURE(solves_second_power(phi, s.r));
  return Imprimitive{phi};
}

// The quaternion group: v1 v2 v3 is rational.
std::optional<Outcome> three_quadratics(const Singularities& s, const Budget& budget,
                                        Trace* trace) {
  const auto product = rational_products(s, 6, 2, "v1 v2 v3 rational", budget, trace);
  if (product.empty()) return std::nullopt;
  KOV_ENSURE(product.size() == 1);
  note(trace, 2, 3,
       "The group is the quaternion group; the product of its three quadratics is rational.");
  return ImprimitiveTriple{riccati_polynomial(product.front().chain, product.front().S)};
}

// All parities at once: v^2 is a rational product of four solutions.  These form a space of
// dimension 1, of dimension 2 for the quaternion group, 0 when the case does not hold.
std::optional<Outcome> from_square(const Singularities& s, const Budget& budget, Trace* trace) {
  const auto squares = rational_products(s, 4, 2, "v^2 rational", budget, trace);
  if (squares.empty()) return std::nullopt;
  KOV_ENSURE(squares.size() <= 2);
  if (squares.size() == 2) return three_quadratics(s, budget, trace);
  return quadratic(squares.front().phi() * RationalFunction(Rational(1, 2)), s, trace);
}

bool leaves_many_parities(const Singularities& s) {
  long count = 0;
  for_each_place(s, [&](const Singularity& p) {
    if (has_denominator_dividing(p, 2) && !has_denominator_dividing(p, 1)) ++count;
  });
  return count > many_choices;
}

} // namespace

std::optional<Outcome> case2(const Singularities& s, const Budget& budget, Trace* trace) {
  if (leaves_many_parities(s)) return from_square(s, budget, trace);
  ProductSearch search;
  search.kovacic_case = 2;
  search.m = 2;
  search.N = 2;
  search.scale = 2;
  search.classes = [](const Singularity& place) { return classes(place, 2, 2); };
  search.wanted = is_not_rational;
  search.name = "v^2 rational, v not";
  const auto found = products(s, search, budget, trace);
  if (!found.empty()) return quadratic(found.front().phi(), s, trace);
  return may_be_three_conjugates(s) ? three_quadratics(s, budget, trace) : std::nullopt;
}

} // namespace kov::kovacic
