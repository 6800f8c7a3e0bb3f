#pragma once
// A differential equation as other programs write it, read into our tree:
//
//   Maple        diff(y(x), x, x), diff(y(x), x$2), D(D(y))(x), (D@@2)(y)(x), a ; at the end
//   Mathematica  y''[x] == x y[x], D[y[x], {x, 2}], Derivative[2][y][x], products without a sign
//   Maxima       'diff(y, x, 2) = x*y, %i, a ; or $ at the end
//   SymPy        Eq(Derivative(y(x), (x, 2)), x*y(x)), y(x).diff(x, 2), Rational(1, 4)
//   Sage         diff(y(x), x, x) == x*y(x), derivative(y(x), x, 2)
//   ore_algebra  Dx^2 - x, a product of operators is their composition (operators.hpp)
//
// Tokens become tokens, each with its place in the text as it was written, so that messages point at
// what the user sees.  Only operators are written out anew.

#include "symbol/expression.hpp"

namespace kov {

/// An equation, or the left side of one whose right side is 0.
///
/// Errors  InputError as for parse_expression; brackets and parentheses around arguments mixed
/// Cost    linear in the text
/// Example parse_ode("diff(y(x), x$2) = x*y(x)", "-e").operand(0).operands().size()  // -> 3
/// Example parse_ode("y''[x] == x*y[x]", "-e").kind()  // -> Kind::equation
/// Example parse_ode("(Dx - 1)*(Dx + x)", "-e").kind()  // -> Kind::sum
[[nodiscard]] Expression parse_ode(std::string_view text, const OriginPtr& origin,
                                   const ParseLimits& limits = {});
/// The same for a text by itself; `name` is what messages call it.
[[nodiscard]] Expression parse_ode(std::string text, const std::string& name);

} // namespace kov
