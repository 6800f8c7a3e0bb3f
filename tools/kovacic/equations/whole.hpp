#pragma once
// Solutions of the equation as it was asked, with its right side, initial values, or of a Riccati equation.

#include "elementary/whole.hpp"
#include "equations/result.hpp"

#include <string>
#include <utility>
#include <vector>

namespace kov::cli {

/// The object under "whole": unknown, general, particular, special, with_values, integrals, no_values,
/// nonzero, each where it is
/// known; what failed goes where `do_part` puts it.
void put_whole(Json& result, const std::string& unknown, const elementary::WholeAnswer& answer);
/// Label and text of each line.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> whole_lines(const Json& result);
/// Does it say what the solutions of the linear homogeneous equation would say once more?
[[nodiscard]] bool answers_whole(const Json& result);

} // namespace kov::cli
