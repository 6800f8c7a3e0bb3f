#include "elementary/homogeneous.hpp"

#include "elementary/antiderivative.hpp"
#include "elementary/rational_integral.hpp"
#include "exact/tried.hpp"

namespace kov::elementary {
namespace {

Element of(const LettersPtr& letters, const MFraction& f) { return {letters, f}; }

// f exp(+- g), or f cos(g') and f sin(g') for g^2 = -g'^2; discriminant: of the characteristic equation.
Basis by_discriminant(const Element& centre, const Element& variable,
                      const MFraction& discriminant) {
  const LettersPtr& letters = centre.letters();
  const MFraction half = letters->number(Rational(1, 2));
  const Element f = exp(centre);
  if (is_zero(discriminant)) return {f, f * variable};
  if (sample(discriminant, *letters) > 0) {
    const Element g = half * letters->root(discriminant) * variable;
    return {exp(centre + g), exp(centre - g)};
  }
  const Element g = half * letters->root(-discriminant) * variable;
  return {f * cos(g), f * sin(g)};
}

} // namespace

std::optional<Basis> characteristic_basis(const MFraction& p, const MFraction& q,
                                          const LettersPtr& letters) {
  return tried<NotElementary>([&]() -> std::optional<Basis> {
    const MFraction x = letters->variable_value(), four = letters->number(4),
                    half = letters->number(Rational(1, 2));
    if (!uses(p, Letters::x) && !uses(q, Letters::x))
      return by_discriminant(of(letters, -half * p * x), of(letters, x),
                             letters->reduced(p * p - four * q));
    const MFraction b = p * x - letters->number(1), c = q * x * x; // m^2 + b m + c = 0
    if (uses(b, Letters::x) || uses(c, Letters::x)) return std::nullopt;
    const Element ell = log(of(letters, x));
    return by_discriminant(-half * b * ell, ell, letters->reduced(b * b - four * c));
  });
}

Element second_solution(const LinearEquation& e, const Element& first) {
  const auto p = antiderivative(simplified(e.c1 / e.c2));
  if (!p) throw NotElementary("an integral in an exponent");
  return simplified(first * integral(simplified(exp(-*p) / (first * first))));
}

} // namespace kov::elementary
