// Ordinary certificates as leaves: of an equation without parameters, or over Q[x]/(p)
// (strata_certificates.md 4 `root`, 6 `number`).

#include "certify/equation/check.hpp"
#include "certify/strata/rules.hpp"
#include "exact/to_poly.hpp"
#include "proof/text/limits.hpp"

namespace kov::certify {

namespace {

void need_only(const MPoly& f, std::optional<std::size_t> x) {
  for (const std::size_t i : used_variables(f))
    need(i == 0 || i == x, "the equation has a parameter");
}

// Powers of the value up to the degree in x, before they are computed.
void charge_image(Arithmetic& a, const MPoly& f, std::size_t x, const NfElem& value) {
  const auto n = static_cast<double>(value.field()->degree());
  const auto d = static_cast<double>(degree(f, x) + 1);
  const auto height =
      static_cast<double>(std::abs(fmpz_poly_max_bits(value.field()->minpoly())) +
                          std::abs(_fmpz_vec_max_bits(value.raw()->coeffs, value.raw()->length)) +
                          static_cast<long>(fmpz_bits(value.raw()->den)));
  a.charge(d, static_cast<double>(f.length() + 1) * d * d * n * n * (1 + height / 64));
}

void need_same(const Poly& num, const Poly& den, const Certificate& c) {
  need(!is_zero(den), "den is 0 there");
  const auto small = [](const Poly& f, const Poly& g) {
    return static_cast<double>(degree(f) + degree(g) + 2) * (bits(f) + bits(g)) <= max_bulk;
  };
  need_within(small(num, c.den) && small(c.num, den), "a limit: the size of the equation");
  need(num * c.den == c.num * den, "the nested certificate is about another equation");
}

std::size_t accept(const Certificate& c, bool abelian) {
  need(c.claim.abelian == abelian, "the nested certificate does not claim that");
  const auto verdict = check(c);
  if (const auto* no = std::get_if<Rejected>(&verdict))
    throw Refused{"the nested certificate is refused: " +
                      (no->step.empty() ? "" : "step '" + no->step + "': ") + no->why,
                  no->limit};
  return std::get<Accepted>(verdict).trusted_steps;
}

} // namespace

std::size_t check_number(const Stratum& s, const ByNumber& leaf, bool abelian) {
  need_only(s.r().num, {});
  need_only(s.r().den, {});
  need(leaf.certificate.field->is_rational(), "the nested certificate is not over Q");
  const std::size_t trusted = accept(leaf.certificate, abelian);
  const auto over_Q = [](const MPoly& f) { return to_poly(f, 0, rationals(), {}); };
  need_same(over_Q(s.r().num), over_Q(s.r().den), leaf.certificate);
  return trusted;
}

std::size_t check_root(const Stratum& s, const MPoly& p, const RootStratum& zero) {
  const std::size_t x = zero.variable;
  for (const std::size_t i : used_variables(p))
    need(i == x, "the polynomial has another variable");
  const long n = degree(p, x);
  need(n >= 2, "the polynomial is not of degree 2 or more");
  need_only(s.r().num, x);
  need_only(s.r().den, x);
  const Certificate& c = zero.certificate;
  const auto minpoly = c.field->minpoly_coefficients();
  need(static_cast<long>(minpoly.size()) == n + 1, "the minimal polynomial is another one");
  const Coefficients coefficient = coefficients(p, x);
  const Integer lead = coefficient.back().coefficient(0);
  Integer power(1); // of lead: c^(n-1-k)
  for (std::size_t k = minpoly.size() - 1; k-- > 0; power *= lead) {
    const Integer value = is_zero(coefficient[k]) ? Integer(0) : coefficient[k].coefficient(0);
    need(minpoly[k] == power * value, "the minimal polynomial is another one");
  }
  const std::size_t trusted = accept(c, zero.abelian);
  const NfElem value = NfElem::generator(c.field) * NfElem(Rational(Integer(1), lead), c.field);
  const auto at_root = [&](const MPoly& f) {
    charge_image(s.arithmetic(), f, x, value);
    return to_poly(f, 0, c.field, {{x, value}});
  };
  need_same(at_root(s.r().num), at_root(s.r().den), c);
  return trusted;
}

} // namespace kov::certify
