#include "splitting/cone.hpp"

namespace kov {
namespace {

int coefficient_sign(const MPoly& f) {
  int sign = 0;
  for (long i = 0; i < f.length(); ++i) {
    const int s = kov::sign(f.coefficient(i));
    if (sign != 0 && s != sign) return 0;
    sign = s;
  }
  return sign;
}

int fraction_sign(const MFraction& f) {
  return is_zero(f) ? 0 : coefficient_sign(f.num()) * coefficient_sign(f.den());
}

// The coefficient of a monomial.
Integer coefficient_of(const MPoly& f, const std::vector<unsigned long>& e) {
  for (long i = 0; i < f.length(); ++i)
    if (f.exponents(i) == e) return f.coefficient(i);
  return Integer(0);
}

} // namespace

int Cone::sign(const MPoly& f) const {
  return kov::is_zero(f) ? 0 : fraction_sign(substitute(f, values_));
}

// f - q g for the rational numbers q that remove one term of f.
int Cone::sign_of_irreducible(const MPoly& f, const std::vector<MPoly>& zero,
                              std::vector<SignIdentity>* used) const {
  if (const int s = sign(f); s != 0) return s;
  for (const MPoly& g : zero) {
    const MFraction on = substitute(f, values_), equation = substitute(g, values_);
    if (is_zero(on) || is_zero(equation)) continue;
    const MPoly left = on.num() * equation.den(), right = equation.num() * on.den();
    for (long i = 0; i < right.length(); ++i) {
      const Rational q(coefficient_of(left, right.exponents(i)), right.coefficient(i));
      const int s = fraction_sign(MFraction(left) - q * MFraction(right));
      if (s == 0) continue;
      if (used != nullptr) used->push_back({f, q, g});
      return s;
    }
  }
  return 0;
}

int Cone::sign(const MPoly& f, const std::vector<MPoly>& zero,
               std::vector<SignIdentity>* used) const {
  if (kov::is_zero(f)) return 0;
  const auto [content, factors] = factor(f);
  int product = kov::sign(content);
  for (const MFactor& x : factors) {
    const int s = sign_of_irreducible(x.base, zero, used);
    if (s == 0 || x.exponent % 2 != 0) product *= s;
  }
  return product;
}

std::string to_string(const SignIdentity& i) {
  return to_string(i.f) + " = " + to_string(i.q) + "*(" + to_string(i.g) + ") + (" +
         to_string(MFraction(i.f) - i.q * MFraction(i.g)) + ")";
}

} // namespace kov
