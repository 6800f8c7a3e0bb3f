#include "kovacic/case3.hpp"

#include "exact/error.hpp"
#include "exact/factor.hpp"
#include "kovacic/exponents.hpp"
#include "kovacic/invariant_families.hpp"
#include "kovacic/necessary.hpp"

#include <algorithm>

namespace kov::kovacic {
namespace {

// The local monodromy in PGL(2) is a rotation whose order is the denominator of Delta: which
// groups have elements of all the orders that occur?
bool orders_allowed(const Singularities& s, std::initializer_list<long> orders) {
  return !any_place(s, [&](const Singularity& place) {
    return std::ranges::none_of(orders, [&](long n) { return place.delta->den() == Integer(n); });
  });
}

// A4 maps onto its quotient of order three, which the rotations of order three generate; their
// product is 1, so there are at least two.
bool may_be_tetrahedral(const Singularities& s) {
  long roots = 0;
  for_each_place(s, [&](const Singularity& place) {
    if (place.delta->den() == Integer(3)) roots += place.degree();
  });
  return roots >= 2 && orders_allowed(s, {1, 2, 3});
}

// How many places leave a choice when the denominator n does.
long places_with_denominator(const Singularities& s, long n) {
  long count = 0;
  for_each_place(s, [&](const Singularity& place) {
    if (place.delta->den() == Integer(n)) ++count;
  });
  return count;
}

Algebraic algebraic(Primitive group, const RadicalProduct& v) {
  return {group, riccati_polynomial(v.chain, v.S)};
}

void keep(std::vector<Rational>& from, bool integral) {
  std::erase_if(from, [&](const Rational& e) { return is_integer(e) != integral; });
}

// ----- tetrahedral ------------------------------------------------------------------------------

// A rotation of order three multiplies v by a primitive cube root of unity.
std::vector<RadicalProduct> four_lines(const Singularities& s, const Budget& budget, Trace* trace) {
  ProductSearch search;
  search.kovacic_case = 3;
  search.m = 4;
  search.N = 3;
  search.scale = 3;
  search.name = "n = 4";
  search.classes = [](const Singularity& place) {
    auto found = classes(place, 4, 3);
    if (place.delta->den() == Integer(3)) keep(found, false);
    return found;
  };
  return products(s, search, budget, trace);
}

std::optional<Outcome> tetrahedral(const Singularities& s, const Budget& budget, Trace* trace) {
  const auto six = rational_products(s, 6, 3, "n = 6, all exponents integral", budget, trace);
  if (six.empty()) return std::nullopt;
  KOV_ENSURE(six.size() == 1);
  if (places_with_denominator(s, 3) <= many_choices) {
    const auto four = four_lines(s, budget, trace);
    if (!four.empty()) return algebraic(Primitive::tetrahedral, four.front());
  }
  note(trace, 3, 3,
       "The two orbits of four lines are not taken apart over the field of r; the orbit of "
       "six lines gives a polynomial of degree 6.");
  return algebraic(Primitive::tetrahedral, six.front());
}

// ----- octahedral and icosahedral ---------------------------------------------------------------

// A rotation of order four is an odd permutation and changes the sign of v; one of order three is
// even; one of order two can be either.
std::vector<RadicalProduct> six_lines(const Singularities& s, const Budget& budget, Trace* trace) {
  ProductSearch search;
  search.kovacic_case = 3;
  search.m = 6;
  search.scale = 2;
  search.name = "n = 6";
  search.classes = [](const Singularity& place) {
    auto found = classes(place, 6, 2);
    if (place.delta->den() == Integer(4)) keep(found, false);
    return found;
  };
  search.wanted = [](const std::vector<Rational>& e) {
    return !std::ranges::all_of(e, [](const Rational& x) { return is_integer(x); });
  };
  return products(s, search, budget, trace);
}

// When the families of n = 6 are too many: v^2 of the octahedral group is the one rational product
// of twelve solutions.  Is f = P prod q^(e_q) a square of that kind?  Factors of P of odd
// multiplicity can only be places, where v branches.
std::optional<Algebraic> octahedral_root(const Singularities& s, const RadicalProduct& f) {
  const RationalFunction half(Rational(1, 2));
  RationalFunction theta = f.theta * half;
  Poly root(Rational(1));
  for (const Factor& factor : squarefree_factors(f.P)) {
    root *= pow(factor.base, static_cast<unsigned long>(factor.exponent / 2));
    if (factor.exponent % 2 == 0) continue;
    if (!divides(factor.base, f.S)) return std::nullopt;
    theta += RationalFunction(derivative(factor.base), factor.base) * half;
  }
  const PolynomialStep step(6, f.S, s.r);
  const auto chain = step.chain(root, step.times_S(theta));
  if (!is_zero(chain.back())) return std::nullopt;
  return Algebraic{Primitive::octahedral, riccati_polynomial(chain, f.S)};
}

std::optional<Outcome> octahedral_or_icosahedral(const Singularities& s, const Budget& budget,
                                                 Trace* trace) {
  const bool octahedral = orders_allowed(s, {1, 2, 3, 4});
  const bool icosahedral = orders_allowed(s, {1, 2, 3, 5});
  const bool by_families = octahedral && places_with_denominator(s, 2) <= many_choices;
  if (by_families) {
    const auto six = six_lines(s, budget, trace);
    if (!six.empty()) return algebraic(Primitive::octahedral, six.front());
  }
  if (!icosahedral && (by_families || !octahedral)) return std::nullopt;
  const auto twelve = rational_products(s, 12, 3, "n = 12", budget, trace);
  if (twelve.empty()) return std::nullopt;
  KOV_ENSURE(twelve.size() == 1);
  if (octahedral && !by_families)
    if (const auto found = octahedral_root(s, twelve.front())) return *found;
  KOV_ENSURE(icosahedral);
  return algebraic(Primitive::icosahedral, twelve.front());
}

} // namespace

std::optional<Outcome> case3(const Singularities& s, const Budget& budget, Trace* trace) {
  if (may_be_tetrahedral(s))
    if (auto found = tetrahedral(s, budget, trace)) return found;
  return octahedral_or_icosahedral(s, budget, trace);
}

} // namespace kov::kovacic
