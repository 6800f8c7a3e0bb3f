#pragma once
// A linear equation of second order whose coefficients depend on parameters:
// "z^2*y'' + z*y' + (z^2 - n^2)*y = 0".

#include "symbol/linear_reader.hpp"
#include "system/formula.hpp"

#include <string>

namespace kov {

/// Coefficients over the ring of a scope; ' is speed d/dz.
class CoefficientsOverRing : public FieldOfCoefficients<MFraction> {
public:
  CoefficientsOverRing(const Scope& scope, std::size_t z, MFraction speed)
      : scope_(scope), z_(z), speed_(std::move(speed)) {}

  [[nodiscard]] MFraction constant(long n) const override { return {scope_.ring(), Rational(n)}; }
  [[nodiscard]] MFraction value(const Expression& e) const override { return evaluate(e, scope_); }
  [[nodiscard]] MFraction derivative(const MFraction& f) const override {
    return speed_ * kov::derivative(f, z_);
  }
  [[nodiscard]] std::string text(const MFraction& f) const override { return to_string(f); }

private:
  const Scope& scope_;
  std::size_t z_;
  MFraction speed_;
};

/// c2 y'' + c1 y' + c0 y = 0 over Q(parameters)(z), c2 != 0 for generic parameters.
struct ParametricSecondOrder {
  MFraction c0, c1, c2;
};

/// Errors  InputError: as `second_order` of lib/equation; from evaluate()
/// Given   const Entry file = parse_document("system = {kind = 'vector-field', "
///             "coordinates = ['z'], parameters = ['n'], field = {z = '1'}}", "f.toml");
/// Given   const SystemScope scope(file, {});
/// Given   const Expression ode = parse_expression("(z*y')' = n*y", "ode", true);
/// Example parametric_second_order(ode, "y", scope.ring()->index("z"), scope)
///         // -> {-n, 1, z}
/// Example parametric_second_order(parse_expression("y' = n*y", "ode", true), "y",
///         scope.ring()->index("z"), scope)  // -> throws NoValue
[[nodiscard]] ParametricSecondOrder parametric_second_order(const Expression& equation,
                                                            const std::string& unknown,
                                                            std::size_t z, const Scope& scope);

} // namespace kov
