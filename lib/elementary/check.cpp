#include "elementary/check.hpp"

#include "symbol/at_point.hpp"
#include "symbol/written.hpp"

#include <optional>
#include <vector>

namespace kov::elementary {
namespace {

constexpr slong bits = 300;

// Wherever there is a value, and at one place at least.
bool holds(const Expression& equation, const Letters& letters, const std::string& unknown = {},
           const std::optional<Expression>& y = {}) {
  std::vector<std::string> names = letters.ring()->names();
  if (letters.pi()) std::erase(names, "pi");
  long values = 0;
  try {
    for (long number = 0; number < 6 && values < 3; ++number) {
      AtPoint::Values at = some_values(names, letters.variable(), number, false);
      if (y) at.insert_or_assign(unknown, AtPoint(at, bits)(*y));
      const std::optional<bool> here = AtPoint(std::move(at), bits).holds(equation);
      if (here == false) return false;
      values += here ? 1 : 0;
    }
  } catch (const NoValueHere&) {
    return false;
  }
  return values > 0;
}

Expression formula(const Element& f) { return parse_expression(text(f), "an element"); }

Expression equation(Expression left, Expression right) {
  return Expression::made(Expression::Kind::equation, {std::move(left), std::move(right)});
}

} // namespace

bool is_derivative_at_points(const Element& f, const Element& g) {
  const Expression slope = Expression::made(Expression::Kind::derivative, {formula(f)}, {}, 1);
  return holds(equation(slope, formula(g)), *g.letters());
}

bool are_equal_at_points(const Element& f, const Element& g) {
  return holds(equation(formula(f), formula(g)), *g.letters());
}

bool holds_at_points(const Expression& ode, const std::string& unknown, const Element& y) {
  return holds(ode, *y.letters(), unknown, formula(y));
}
bool holds_at_points(const Expression& ode, const std::string& unknown, const Expression& y,
                     const Letters& letters) {
  return holds(ode, letters, unknown, y);
}

} // namespace kov::elementary
