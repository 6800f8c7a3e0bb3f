// strata_certificates.md 7.1, 7.2, 7.5: the places and their exponents.

#include "certify/strata/places.hpp"

#include "certify/equation/bounds.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>

namespace kov::certify {

namespace {

constexpr long max_log_difference = 40;

} // namespace

std::optional<Rational> ProvedPlace::largest() const {
  return bound ? std::optional(root_above(*bound, Integer(2))) : std::nullopt;
}

Places::Places(const Stratum& s, const ByPlaces& leaf) : s_(s), leaf_(leaf), a_(s.arithmetic()) {
  const Fraction& r = s.r();
  need(!is_zero(r.num), "r is 0");
  std::vector<InvariantPlace> factors;
  for (const StratumPlace& x : leaf.places)
    factors.push_back({*x.q, x.order, 0});
  need_denominator(s, leaf.content, factors);
  for (const StratumPlace& x : leaf.places)
    all.push_back({{degree(*x.q, 0), x.order}, *x.q});
  all.push_back({{1, 4 - (degree(r.den, 0) - degree(r.num, 0))}});
  need_separate();
  for (std::size_t i = 0; i < all.size(); ++i)
    examine(all[i], i < leaf.places.size() ? leaf.places[i] : leaf.infinity);
}

MPoly Places::resultant(const MPoly& f, const MPoly& g) const {
  return Elimination(a_).resultant(coefficients(f, 0), coefficients(g, 0));
}

// The roots of all q are different at every point, and their number does not change.
void Places::need_separate() const {
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    const MPoly& q = *all[i].q;
    if (all[i].n >= 2)
      need(s_.is_unit(resultant(q, derivative(q, 0))), "a place may have a multiple root");
    for (std::size_t j = 0; j < i; ++j)
      need(s_.is_unit(resultant(q, *all[j].q)), "two places may have a common root");
  }
}

// The pole has exactly the order that is stated; at order 2 the formula for Delta^2 does not ask.
void Places::need_order(const ProvedPlace& x) const {
  if (x.regular() || x.ordinary()) return;
  if (x.q)
    need(s_.is_unit(resultant(*x.q, s_.r().num)), "the order of a place may drop");
  else
    need(s_.is_unit(lead(s_.r().num)), "the order at infinity may drop");
}

void Places::examine(ProvedPlace& x, const StratumPlace& given) {
  need_order(x);
  if (x.regular()) {
    examine_exponent(x, given);
  } else {
    need(given.chi.empty() && !given.irrational && !given.bound,
         "exponents are stated at a place of another order than 2");
    if (x.simple()) x.logs = x.n;
  }
  if (!given.log || x.has_log()) return;
  need(x.delta && is_integer(*x.delta) && *x.delta <= Rational(max_log_difference) && x.n == 1,
       "a logarithm is stated where none can be tested");
  need(has_logarithm(s_, x), "the logarithm is not proved");
  x.logs = 1;
}

namespace {

Irrational irrational_by(const std::string& word) {
  if (word == "constant") return Irrational::constant;
  if (word == "positive") return Irrational::positive;
  need(word == "discriminant", "irrational: constant, positive or discriminant is expected");
  return Irrational::discriminant;
}

} // namespace

void Places::examine_exponent(ProvedPlace& x, const StratumPlace& given) {
  x.chi = given.chi;
  if (!x.chi.empty()) {
    need_chi(x);
    if (x.linear()) {
      if (const auto ratio = constant_value({x.chi[0], x.chi[1]})) x.square = -*ratio;
      if (x.square && kov::sign(*x.square) >= 0) x.delta = exact_sqrt(*x.square);
    }
  }
  if (x.delta && is_zero(*x.delta)) x.logs = x.n;
  if (given.irrational) {
    need(!x.delta, "the exponent difference is rational");
    x.by = irrational_by(*given.irrational);
    need_irrational(x);
    x.irrational = true;
  }
  x.bound = given.bound;
  if (x.bound) need_bound(x);
  set_real(x);
  const bool asks_nothing = leaf_.theorem == "irreducible-log" || leaf_.theorem == "torus-log";
  need(!x.open() || x.linear() || asks_nothing, "an exponent difference is not known");
}

// An upper bound of |Re Delta| (local_exponents.md 4), if there is one.
void Places::set_real(ProvedPlace& x) {
  if (x.delta)
    x.real = x.delta;
  else if (x.by == Irrational::positive && x.linear())
    x.real = Rational(0);
  else if (x.by == Irrational::constant)
    x.real = root_above(*x.square, Integer(8));
  else if (x.linear())
    x.real = x.largest();
}

MPoly without_pole(const Stratum& s, const MPoly& q) {
  Arithmetic& a = s.arithmetic();
  const auto rest = a.quotient(s.r().den, a.times(q, q));
  need(rest.has_value(), "internal: q^2 does not divide den");
  return *rest;
}

Fraction difference_squared(const Stratum& s, const MPoly& q) {
  Arithmetic& a = s.arithmetic();
  const MPoly slope = derivative(q, 0);
  const MPoly Y = a.times(a.times(slope, slope), without_pole(s, q));
  return {a.plus(Y, scaled(s.r().num, Integer(4))), Y};
}

// chi(Delta^2) = 0 at every root, Delta^2 = X/Y.
void Places::need_chi(const ProvedPlace& x) const {
  for (const MPoly& c : x.chi)
    s_.need_parameters(c);
  need(s_.is_unit(x.chi.back()), "the leading coefficient of chi may vanish");
  const Fraction& r = s_.r();
  const auto at_infinity = [&] {
    const MPoly below = lead(r.den);
    return Fraction{a_.plus(below, scaled(lead(r.num), Integer(4))), below};
  };
  const auto [X, Y] = x.q ? difference_squared(s_, *x.q) : at_infinity();
  const MPoly sum = a_.homogeneous(x.chi, X, Y);
  const bool zero =
      x.q ? Elimination(a_).pseudo_remainder(coefficients(sum, 0), coefficients(*x.q, 0)).empty()
          : is_zero(sum);
  need(zero, "chi does not vanish on Delta^2");
}

void Places::need_irrational(const ProvedPlace& x) const {
  const Coefficients& c = x.chi;
  need(!c.empty(), "chi is missing");
  if (x.by == Irrational::constant) {
    need(x.linear() && x.square, "Delta^2 is not a constant");
  } else if (x.by == Irrational::positive) {
    const auto all = [&](bool negated) {
      return std::ranges::all_of(c,
                                 [&](const MPoly& f) { return s_.is_positive(negated ? -f : f); });
    };
    need(all(false) || all(true), "the coefficients of chi are not known to have one sign");
  } else {
    need(c.size() == 3 && std::ranges::all_of(c, [&](const MPoly& f) { return s_.is_real(f); }),
         "chi is not real of degree 2");
    const MPoly four = scaled(a_.times(c[2], c[0]), Integer(4));
    need(s_.is_positive(a_.minus(four, a_.times(c[1], c[1]))),
         "the discriminant of chi is not known to be negative");
  }
}

// B - Delta^2 = (B chi_1 + chi_0) chi_1/chi_1^2, and chi_1^2 > 0 where chi_1 is real.
void Places::need_bound(const ProvedPlace& x) const {
  need(x.linear(), "a bound needs chi of degree 1");
  const MPoly f = a_.plus(scaled(x.chi[1], x.bound->num()), scaled(x.chi[0], x.bound->den()));
  if (is_zero(f)) return;
  need(s_.is_real(x.chi[1]), "the leading coefficient of chi is not known to be real");
  need(s_.is_positive(a_.times(f, x.chi[1])), "the bound is not proved");
}

} // namespace kov::certify
