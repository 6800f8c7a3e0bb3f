// Rule "exponential": omega = num/den + p'/p satisfies omega' + omega^2 = r.  Multiplied out this
// is linear in p, which may be long while num and den are short.

#include "certify/equation/rules.hpp"

namespace kov::certify {

ExponentialFact check_exponential(const Judge& j, const Exponential& data) {
  const Poly& P = data.p;
  const Poly& n = data.num;
  const Poly& e = data.den;
  need(!is_zero(P) && !is_zero(e), "omega is not defined");
  const Poly first = derivative(P);
  const Poly s = derivative(n) * e - n * derivative(e) + n * n;
  const Poly left = e * e * derivative(first) + scale(n * e, NfElem(2)) * first + s * P;
  need(j.equation.den * left == j.equation.num * (e * e) * P, "omega' + omega^2 is not r");
  return {};
}

} // namespace kov::certify
