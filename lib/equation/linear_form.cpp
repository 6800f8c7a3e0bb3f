#include "equation/linear_form.hpp"

#include "symbol/suggest.hpp"

#include <algorithm>
#include <set>

namespace kov {
namespace {

using Kind = Expression::Kind;

// y, or y(z) where y is not a function that formulas know
bool is_function_name(const Expression& e) {
  static const std::set<std::string> known{"sqrt", "root", "diff", "sin", "cos", "exp"};
  return e.kind() == Kind::name ||
         (e.kind() == Kind::call && e.operands().size() == 1 && !known.contains(e.name()));
}

struct Found {
  std::set<std::string> unknowns;
  std::set<std::string> variables;
};

void look(const Expression& e, Found& found) {
  const bool differentiates = e.kind() == Kind::derivative || is_diff(e);
  if (differentiates && is_function_name(e.operand(0))) {
    const Expression& f = e.operand(0);
    found.unknowns.insert(f.name());
    if (f.kind() == Kind::call && f.operand(0).kind() == Kind::name)
      found.variables.insert(f.operand(0).name());
  }
  if (is_diff(e) && e.operands().size() > 1 && e.operand(1).kind() == Kind::name)
    found.variables.insert(e.operand(1).name());
  for (const Expression& operand : e.operands())
    look(operand, found);
}

class OverNumbers : public FieldOfCoefficients<RationalFunction> {
public:
  explicit OverNumbers(const Reading& reading) : reading_(reading) {}

  [[nodiscard]] RationalFunction constant(long n) const override {
    return RationalFunction(coerce(Poly(n), reading_.constants->field()));
  }
  [[nodiscard]] RationalFunction value(const Expression& e) const override {
    return rational_function(e, reading_);
  }
  [[nodiscard]] RationalFunction derivative(const RationalFunction& f) const override {
    reading_.budget.check();
    return kov::derivative(f);
  }
  [[nodiscard]] std::string text(const RationalFunction& f) const override {
    return to_string(f, reading_.variable);
  }
  void check(const RationalFunction& f) const override {
    reading_.budget.check();
    reading_.budget.check_degree(std::max(degree(f.num()), degree(f.den())));
  }

private:
  const Reading& reading_;
};

} // namespace

OdeNames ode_names(const Expression& equation) {
  Found found;
  look(equation, found);
  for (const std::string& v : found.variables) // (z*y')': z is differentiated by name in diff only
    if (found.unknowns.size() > 1) found.unknowns.erase(v);
  if (found.unknowns.empty())
    throw equation.error("no derivative of an unknown function appears",
                         "write e.g. y'' = z*y, with primes for derivatives");
  if (found.unknowns.size() > 1) {
    const std::vector<std::string> names(found.unknowns.begin(), found.unknowns.end());
    throw equation.error("two functions are differentiated: " + enumerate(names),
                         "one equation for one unknown function is expected");
  }
  if (found.variables.size() > 1) {
    const std::vector<std::string> names(found.variables.begin(), found.variables.end());
    throw equation.error("derivatives with respect to two variables: " + enumerate(names));
  }
  return {*found.unknowns.begin(),
          found.variables.empty() ? std::string() : *found.variables.begin()};
}

LinearForm linear_form(const Expression& equation, const std::string& unknown,
                       const Reading& reading) {
  return LinearReader<RationalFunction>(unknown, reading.variable, OverNumbers(reading))
      .form(equation);
}

SecondOrder second_order(const Expression& equation, const std::string& unknown,
                         const Reading& reading) {
  const OverNumbers numbers(reading);
  const LinearForm form =
      LinearReader<RationalFunction>(unknown, reading.variable, numbers).second_order(equation);
  const auto check = [&](const RationalFunction& a, const RationalFunction& b) {
    reading.budget.check_degree(std::max(degree(a.num()), 0L) + std::max(degree(b.den()), 0L));
    reading.budget.check_degree(std::max(degree(a.den()), 0L) + std::max(degree(b.num()), 0L));
  };
  check(form.c[1], form.c[2]);
  check(form.c[0], form.c[2]);
  return {form.c[1] / form.c[2], form.c[0] / form.c[2]};
}

} // namespace kov
