#pragma once
// A solution as text, for people and for programs.

#include "answer/answer.hpp"
#include "symbol/expression.hpp"

#include <optional>
#include <string>
#include <vector>

namespace kov::answer {

/// Special functions as they stand in books: J_n(x), P_n(x), 2F1(a, b; c; x).
/// Given   const Expression y = parse_expression("sqrt(x)*besselj(0, 2*x)", "y");
/// Example for_people(y)  // -> sqrt(x)*J_0(2*x)
[[nodiscard]] std::string for_people(const Expression& y);
/// SymPy's parser and Python read it; the functions have the names of mpmath.
/// Example for_programs(parse_expression("x^2*besselj(0, x)", "y"))  // -> x**2*besselj(0, x)
[[nodiscard]] std::string for_programs(const Expression& y);
[[nodiscard]] std::vector<std::string> for_programs(const Solutions& all);
/// A special function as it stands in books: J with n below it, P with n below and m above.
struct InBooks {
  std::string letter;
  std::optional<Expression> below, above;
  std::vector<Expression> arguments;
  std::size_t parameters = 0; ///< of the arguments: what stands before a semicolon
};
[[nodiscard]] std::optional<InBooks> in_books(const Expression& call);
/// Does a special function stand in it?
[[nodiscard]] bool is_special(const Expression& y);
/// "M and U are Kummer's functions": what a letter of the formulas for people means; "" where the books agree.
[[nodiscard]] std::string meaning_of_functions(const Solutions& all);

} // namespace kov::answer
