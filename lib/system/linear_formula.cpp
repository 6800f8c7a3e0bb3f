#include "system/linear_formula.hpp"

namespace kov {

ParametricSecondOrder parametric_second_order(const Expression& equation,
                                              const std::string& unknown, std::size_t z,
                                              const Scope& scope) {
  const CoefficientsOverRing coefficients(scope, z, MFraction(scope.ring(), Rational(1)));
  auto form =
      LinearReader<MFraction>(unknown, scope.ring()->name(z), coefficients).second_order(equation);
  return {form.c[0], form.c[1], form.c[2]};
}

} // namespace kov
