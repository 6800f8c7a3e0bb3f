// A rational solution of a symmetric power at every point of a stratum: strata_certificates.md 6.
//
// With V = prod q^e, S = prod q^ceil(k/2) and theta = S V'/V, content S^2 r = W is a polynomial,
// and L_i v = V T_i/(content S)^i for v = pV (normal_form.md 2.5, with content^i put into T_i).

#include "certify/strata/rules.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>

namespace kov::certify {

MPoly lead(const MPoly& f) {
  need(!is_zero(f), "internal: the leading coefficient of 0");
  return coefficients(f, 0).back();
}

void need_denominator(const Stratum& s, const MPoly& content,
                      const std::vector<InvariantPlace>& places) {
  s.need_parameters(content);
  need(s.is_unit(content), "content is not known to be nonzero");
  Arithmetic& a = s.arithmetic();
  const long top = degree(s.r().den, 0);
  long total = 0;
  for (const InvariantPlace& x : places) {
    s.need_variables(x.q);
    need(degree(x.q, 0) >= 1, "a place has no roots");
    need(x.order >= 1 && x.order <= top, "the order of a place is impossible");
    total += x.order * degree(x.q, 0);
    need(total <= top, "the places are not those of den");
    need(s.is_unit(lead(x.q)), "the leading coefficient of a place may vanish");
  }
  MPoly den = content;
  for (const InvariantPlace& x : places)
    den = a.times(den, a.power(x.q, static_cast<unsigned long>(x.order)));
  need(den == s.r().den, "den is not the product of the places");
}

InvariantRecurrence::InvariantRecurrence(const Stratum& s, const MPoly& content,
                                         const std::vector<InvariantPlace>& places)
    : a_(s.arithmetic()), content_(content) {
  const MPoly one(content.ring(), Integer(1));
  S_ = one;
  W_ = a_.times(s.r().num, content);
  for (const InvariantPlace& x : places) {
    S_ = a_.times(S_, a_.power(x.q, static_cast<unsigned long>((x.order + 1) / 2)));
    if (x.order % 2 != 0) W_ = a_.times(W_, x.q);
  }
  theta_ = MPoly(content.ring());
  for (const InvariantPlace& x : places) {
    need_within(abs(Rational(x.e)) <= Rational(10000000), "an exponent is too large");
    if (is_zero(x.e)) continue;
    const auto rest = a_.quotient(S_, x.q);
    need(rest.has_value(), "internal: a place does not divide S");
    theta_ = a_.plus(theta_, a_.times(scaled(derivative(x.q, 0), x.e), *rest));
  }
  dS_ = derivative(S_, 0);
}

MPoly InvariantRecurrence::last(const MPoly& p, long m) const {
  MPoly before(p.ring());
  MPoly T = p;
  for (long i = 0; i <= m; ++i) {
    const MPoly shifted = a_.minus(theta_, scaled(dS_, Integer(i)));
    const MPoly step = a_.plus(a_.times(S_, derivative(T, 0)), a_.times(shifted, T));
    MPoly next = a_.minus(a_.times(content_, step),
                          scaled(a_.times(W_, before), Integer(i) * Integer(m - i + 1)));
    before = std::move(T);
    T = std::move(next);
  }
  return T;
}

void check_invariant(const Stratum& s, const ByInvariant& leaf) {
  need(leaf.m >= 1 && leaf.m <= max_sym, "m must be from 1 to 200");
  need_denominator(s, leaf.content, leaf.places);
  s.need_variables(leaf.p);
  const Coefficients c = coefficients(leaf.p, 0);
  need(std::ranges::any_of(c, [&](const MPoly& f) { return s.is_unit(f); }), "p may vanish");
  const InvariantRecurrence recurrence(s, leaf.content, leaf.places);
  need(is_zero(recurrence.last(leaf.p, leaf.m)), "the symmetric power does not vanish on v");
}

} // namespace kov::certify
