#pragma once
// Solutions of equations in mathematical markup: with integrals and special functions as books write them.

#include "report/formula.hpp"

namespace kov::report {

/// Example solution(parse_expression("y = besselj(n, x)", "y", true), Markup::tex)  // -> y = J_{n}\left(x\right)
[[nodiscard]] std::string solution(const Expression& e, Markup m);

} // namespace kov::report
