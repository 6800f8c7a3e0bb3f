#include "certify/equation/facts.hpp"

#include "certify/equation/bounds.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>

namespace kov::certify {

namespace {

std::optional<Rational> constant(const Poly& f) {
  if (degree(f) > 0) return std::nullopt;
  const NfElem c = f.coeff(0);
  if (!is_rational(c)) return std::nullopt;
  return to_rational(c);
}

// chi(value) = 0 modulo q?
bool annihilates(const Poly& chi, const Poly& value, const std::optional<Poly>& q) {
  need(degree(chi) <= 500, "the annihilator is too large");
  Poly v;
  for (long i = degree(chi); i >= 0; --i) {
    v = v * value;
    if (q && degree(v) >= degree(*q)) v = v % *q;
    v = v + Poly(chi.coeff(i));
  }
  return is_zero(v);
}

} // namespace

PlaceFact::PlaceFact(std::optional<Poly> place, long points, long pole_order)
    : ExponentData{points, pole_order}, q(std::move(place)) {
  if (order <= 1) delta = Rational(1);
  if (order == 1) logs = n;
}

void PlaceFact::set_square(const Poly& value, const std::optional<Poly>& annihilator) {
  const auto c = constant(value);
  if (order == 2) {
    if (c) delta = exact_sqrt(*c);
    if (degree(value) <= 0 && !delta) irrational = true;
    logs = delta && is_zero(*delta) ? n : 0;
  }
  if (c) {
    real = root_above(*c);
  } else if (annihilator) {
    need(annihilates(*annihilator, value, q), "the annihilator does not vanish");
    real = root_above(root_bound(*annihilator));
  }
}

bool PlaceFact::exchanges_lines() const {
  return ramified() || (order == 2 && !irrational && (!delta || delta->den() == Integer(2)));
}

std::optional<Integer> ExponentData::lowest(long m,
                                            const std::optional<Rational>& open_delta) const {
  if (order <= 1) return Integer(order == 1 ? m : 0);
  if (order >= 3) return m * order % 4 == 0 ? std::optional(Integer(m * order / 4)) : std::nullopt;
  const Integer half(m / 2);
  const auto& difference = open() ? open_delta : delta;
  if (!difference) return half;
  const Integer d = difference->den();
  const Rational steps = logs == n ? Rational(half) : Rational(-(floor_div(half, d) * d));
  return (Rational(half) + steps * *difference).num();
}

std::optional<Rational> ExponentData::lowest_exponent() const {
  if (order <= 1) return order == 1 ? n : 0;
  if (!real) return std::nullopt;
  return Rational(n) * (Rational(order / 2) + (logs == n ? *real : -*real)) / Rational(2);
}

const PlaceFact& LocalFact::place(std::optional<long> number) const {
  if (!number) return infinity();
  need(*number >= 0 && *number + 1 < static_cast<long>(all.size()), "no such place");
  return all[static_cast<std::size_t>(*number)];
}

void LocalFact::need_rational() const {
  need(std::ranges::all_of(all, [](const PlaceFact& x) { return x.order <= 2 && x.delta; }),
       "not all exponent differences are proved rational");
}

Integer LocalFact::degree_bound(long m) const {
  if (!infinity().lowest(m)) return -1;
  need(!any(&PlaceFact::open), "a degree bound needs the exponent difference of every place");
  return LocalData::degree_bound(m).value_or(Integer(-1));
}

Integer LocalFact::degree_bound_1() const {
  need(!any(&PlaceFact::ramified), "use parity");
  const auto D = LocalData::degree_bound_1();
  need(D.has_value(), "D_1 needs delta2 or eps2 (and an annihilator, if it is not rational)");
  return floor(*D);
}

Integer LocalFact::character_order() const {
  need_rational();
  return LocalData::character_order();
}

Integer LocalFact::residue_denominator(const InvariantFact& v) const {
  need_rational();
  Integer L(1);
  long branch_degree = 0;
  for (const PlaceFact& x : all) {
    if (!x.q) continue;
    if (divides(*x.q, v.branch))
      branch_degree += x.n;
    else
      L = lcm(L, x.delta->den());
  }
  need(branch_degree == degree(v.branch), "the branch places are not places of their own");
  return degree(v.branch) % 2 == 0 ? lcm(L, infinity().delta->den()) : L;
}

bool InvariantFact::holomorphic_quotient() const {
  if (data.m != 2 || degree(data.p) > 0) return false;
  Rational growth;
  for (const InvariantFactor& f : data.factors) {
    if (f.e > Rational(1, 2)) return false;
    growth += f.e * Rational(degree(f.q));
  }
  return growth >= Rational(3, 2);
}

std::pair<Poly, Poly> InvariantFact::fraction() const {
  Poly A = data.p;
  Poly B(1);
  double size = 0;
  for (const InvariantFactor& f : data.factors) {
    const long e = to_long(floor(f.e));
    need_within(std::abs(e) * degree(f.q) <= 200000, "an exponent is too large");
    size += static_cast<double>(std::abs(e)) * bits(f.q);
    need_within(static_cast<double>(std::abs(e) * degree(f.q)) * size <= max_bulk,
                "an exponent is too large");
    (e > 0 ? A : B) *= pow(f.q, static_cast<unsigned long>(std::abs(e)));
  }
  return {std::move(A), std::move(B)};
}

} // namespace kov::certify
