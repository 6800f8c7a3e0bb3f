#include "system/linear_formula.hpp"

#include "symbol/linear_reader.hpp"

namespace kov {
namespace {

class OverParameters : public FieldOfCoefficients<MFraction> {
public:
  OverParameters(std::size_t z, const Scope& scope) : z_(z), scope_(scope) {}

  [[nodiscard]] MFraction constant(long n) const override { return {scope_.ring(), Rational(n)}; }
  [[nodiscard]] MFraction value(const Expression& e) const override { return evaluate(e, scope_); }
  [[nodiscard]] MFraction derivative(const MFraction& f) const override {
    return kov::derivative(f, z_);
  }
  [[nodiscard]] std::string text(const MFraction& f) const override { return to_string(f); }

private:
  std::size_t z_;
  const Scope& scope_;
};

} // namespace

ParametricSecondOrder parametric_second_order(const Expression& equation,
                                              const std::string& unknown, std::size_t z,
                                              const Scope& scope) {
  const OverParameters coefficients(z, scope);
  auto form =
      LinearReader<MFraction>(unknown, scope.ring()->name(z), coefficients).second_order(equation);
  return {form.c[0], form.c[1], form.c[2]};
}

} // namespace kov
