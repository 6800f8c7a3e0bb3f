#include "special/moebius.hpp"

#include "exact/error.hpp"

namespace kov {
namespace {

Poly linear(const NfElem& a, const NfElem& b) { return scale(Poly::z(), a) + Poly(b); }

} // namespace

RationalFunction pull_back(const RationalFunction& r, const Moebius& m) {
  const NfElem determinant = m.a * m.d - m.b * m.c;
  if (is_zero(determinant)) throw InvalidArgument("a Moebius map needs ad - bc != 0");
  const Poly below = linear(m.c, m.d);
  const RationalFunction image(linear(m.a, m.b), below);
  const RationalFunction slope(Poly(determinant), below * below);
  return slope * slope * compose(r, image);
}

Moebius inverse(const Moebius& m) { return {m.d, -m.b, -m.c, m.a}; }

std::string to_string(const Moebius& m, const std::string& variable) {
  return to_string(RationalFunction(linear(m.a, m.b), linear(m.c, m.d)), variable);
}

} // namespace kov
