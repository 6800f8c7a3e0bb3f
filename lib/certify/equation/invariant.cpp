// Rule "invariant": v = p prod q^e solves Sym^m, by the recurrence
//   L_0 v = v,  L_1 v = v',  L_(i+1) v = (L_i v)' - i (m-i+1) r L_(i-1) v,  L_(m+1) v = 0
// (normal_form.md, 2).  With V = prod q^e and S a common denominator of V'/V and (squared) of r,
// L_i v = V T_i/S^i and  T_(i+1) = S T_i' + (S V'/V - i S') T_i - i (m-i+1) r S^2 T_(i-1):
// products of a long polynomial with short ones only.

#include "certify/equation/rules.hpp"
#include "exact/in_pairs.hpp"
#include "exact/lists.hpp"
#include "proof/text/limits.hpp"

namespace kov::certify {

namespace {

void need_well_formed(const Invariant& data) {
  need(data.m >= 1 && data.m <= max_sym && !is_zero(data.p),
       "not a nonzero function of degree 1 to 200");
  for (const InvariantFactor& f : data.factors) {
    need(degree(f.q) >= 1 && is_one(lead(f.q)), "a factor is not a monic polynomial");
    need(abs(f.e) <= Rational(10000000) && is_integer(f.e * Rational(data.m == 2 ? 2 : 1)),
         "exponents must be integers (half-integers for m = 2)");
  }
}

// w^2 = V^2 (T_1^2 - 2 T_0 T_2)/S^2.  V^2 and S^2 are quotients of monic polynomials and w^2 is a
// constant: it is the leading coefficient (normal_form.md 2.5).
NfElem square_of_w(const std::vector<Poly>& T) {
  need_within(4 * static_cast<double>(degree(T[1]) + 1) * bits(T[1]) <= max_bulk,
              "the invariant is too large");
  const Poly square = T[1] * T[1] - scale(T[0] * T[2], NfElem(2));
  return is_zero(square) ? NfElem(0) : lead(square);
}

} // namespace

InvariantFact check_invariant(const Judge& j, const Invariant& data) {
  need_well_formed(data);
  auto [S, theta] = sum(mapped<PolyQuotient>(data.factors, [](const InvariantFactor& f) { // V'/V
    return PolyQuotient{f.q, scale(derivative(f.q), NfElem(f.e))};
  }));
  need_squarefree(S, j.reduced(data.prime));
  if (!divides(j.equation.den, S * S)) {
    S *= j.equation.den;
    theta *= j.equation.den;
  }
  const Poly rs = j.equation.num * quotient(S * S, j.equation.den);
  const auto steps = static_cast<double>(data.m + 1);
  const double size = bits(data.p) + steps * (bits(S) + bits(rs) + bits(theta));
  const auto length = static_cast<double>(degree(data.p)) + steps * static_cast<double>(degree(S));
  need_within(length * size <= max_bulk, "the invariant is too large");
  j.spend(steps * length * (1 + size / 64));
  const Poly dS = derivative(S);
  std::vector<Poly> T{data.p, S * derivative(data.p) + theta * data.p};
  for (long i = 1; i <= data.m; ++i) {
    const Poly& t = T[static_cast<std::size_t>(i)];
    const Poly& before = T[static_cast<std::size_t>(i) - 1];
    T.push_back(S * derivative(t) + (theta - scale(dS, NfElem(i))) * t -
                scale(rs * before, NfElem(i * (data.m - i + 1))));
  }
  need(is_zero(T.back()), "the symmetric power does not vanish on v");
  InvariantFact x;
  x.data = data;
  x.branch = Poly(1);
  for (const InvariantFactor& f : data.factors)
    if (!is_integer(f.e)) x.branch *= f.q;
  if (data.m == 2) x.w_squared = square_of_w(T);
  return x;
}

} // namespace kov::certify
