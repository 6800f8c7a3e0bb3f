#pragma once
// The answer as input of another program: the equation, the solutions, and a check that the program makes.

#include "equations/result.hpp"
#include "output/program_formula.hpp"

#include <string>

namespace kov::cli {

/// A script.  It defines r, the solutions y1, y2 or the polynomials P1, ... of y'/y, and prints what is left of each
/// in the equation: 0.  With parameters: the equation and the conditions, as comments.  Names of the question stay what
/// they are; where it has an r, the script's own is called r_, and so on.
[[nodiscard]] std::string program_text(const Json& result, Program program);

} // namespace kov::cli
