#include "kovacic/plug_back.hpp"

namespace kov::kovacic {

bool solves_riccati(const RationalFunction& omega, const RationalFunction& r) {
  const Poly& a = omega.num();
  const Poly& b = omega.den();
  const Poly left = (derivative(a) * b - a * derivative(b) + a * a) * r.den();
  return is_zero(left - r.num() * b * b);
}

bool solves_second_power(const RationalFunction& phi, const RationalFunction& r) {
  const Poly& a = phi.num();
  const Poly& b = phi.den();
  const Poly db = derivative(b);
  const Poly a1 = derivative(a) * b - a * db; // phi' = a1/b^2
  const Poly cubed =                          // b^3 (phi'' + 3 phi phi' + phi^3)
      derivative(a1) * b - scale(a1 * db, NfElem(2)) + scale(a * a1, NfElem(3)) + a * a * a;
  const Poly& c = r.num();
  const Poly& e = r.den();
  const Poly dr = derivative(c) * e - c * derivative(e); // r' = dr/e^2
  const Poly right = scale(c * e * a, NfElem(4)) + scale(dr * b, NfElem(2));
  return is_zero(cubed * e * e - right * b * b);
}

} // namespace kov::kovacic
