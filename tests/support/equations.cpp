#include "support/equations.hpp"

namespace kov::testing {
namespace {

RationalFunction over(long n, long d) { return RationalFunction(Rational(n, d)); }
RationalFunction constant(const NfElem& c) { return RationalFunction(Poly(c)); }

} // namespace

RationalFunction from_omega(const RationalFunction& omega) {
  return derivative(omega) + omega * omega;
}

RationalFunction from_square(const RationalFunction& f, const NfElem& w_squared) {
  const RationalFunction phi = derivative(f) / (RationalFunction(2) * f);
  return constant(w_squared) / (RationalFunction(4) * f) + derivative(phi) * over(1, 2) +
         phi * phi * over(1, 4);
}

RationalFunction riemann(const NfElem& at0, const NfElem& at1, const NfElem& at_inf) {
  const RationalFunction z(Poly::z());
  const RationalFunction y = z - RationalFunction(1);
  const NfElem quarter(Rational(1, 4));
  return constant((at0 - NfElem(1)) * quarter) / (z * z) +
         constant((at1 - NfElem(1)) * quarter) / (y * y) +
         constant((NfElem(1) - at0 - at1 + at_inf) * quarter) / (z * y);
}

RationalFunction lame(const NfElem& alpha, const NfElem& B, const NfElem& g2, const NfElem& g3) {
  const Poly f = Poly::from_coefficients({-g3, -g2, NfElem(0), NfElem(4)});
  const RationalFunction p = RationalFunction(derivative(f), f) * over(1, 2);
  const RationalFunction q(-Poly::from_coefficients({B, alpha}), f);
  return derivative(p) * over(1, 2) + p * p * over(1, 4) - q;
}

RationalFunction pull_back(const RationalFunction& r, const RationalFunction& f) {
  const RationalFunction d = derivative(f);
  const RationalFunction u = derivative(d) / d;
  const RationalFunction schwarzian = derivative(u) - u * u * over(1, 2);
  return compose(r, f) * d * d - schwarzian * over(1, 2);
}

RationalFunction gauge(const RationalFunction& r, const RationalFunction& a) {
  const RationalFunction g = r + derivative(a) - a * a;
  // w = a y + y' satisfies w'' + p w' + q w = 0 with
  const RationalFunction p = -derivative(g) / g;
  const RationalFunction q = -(r + RationalFunction(2) * derivative(a)) - p * a;
  return p * p * over(1, 4) + derivative(p) * over(1, 2) - q;
}

} // namespace kov::testing
