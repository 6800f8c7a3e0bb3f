#include "elementary/check.hpp"

#include "symbol/read_back.hpp"

namespace kov::elementary {
namespace {

Expression formula(const Element& f) { return parse_expression(text(f), "an element"); }

bool are_equal(Expression left, Expression right, const Letters& letters) {
  return holds_where_positive(
             Expression::made(Expression::Kind::equation, {std::move(left), std::move(right)}),
             letters.variable()) == ReadBack::solves;
}

} // namespace

bool is_derivative_at_points(const Element& f, const Element& g) {
  return are_equal(Expression::made(Expression::Kind::derivative, {formula(f)}, {}, 1), formula(g),
                   *g.letters());
}

bool are_equal_at_points(const Element& f, const Element& g) {
  return are_equal(formula(f), formula(g), *g.letters());
}

bool holds_at_points(const Expression& ode, const std::string& unknown, const Element& y) {
  return holds_at_points(ode, unknown, formula(y), *y.letters());
}
bool holds_at_points(const Expression& ode, const std::string& unknown, const Expression& y,
                     const Letters& letters) {
  return holds_where_positive(ode, letters.variable(), {{unknown, y}}) == ReadBack::solves;
}

} // namespace kov::elementary
