#pragma once
// The answer as input of another program: the equation, the solutions, and a check that the program makes.

#include "result.hpp"

#include <optional>
#include <string>

namespace kov::cli {

enum class Program : std::uint8_t { sympy, maxima, sage };

/// What --format names; nothing for text, json and tex.
[[nodiscard]] std::optional<Program> program_of(const std::string& format);

/// A script.  It defines r, the solutions y1, y2 or the polynomials P1, ... of y'/y, and prints what is left of each
/// in the equation: 0.  With parameters: the equation and the conditions, as comments.
[[nodiscard]] std::string program_text(const Json& result, Program program);

/// A formula of ours in the program's notation; `constant` (with a definition) is the generator of the field.
/// Errors  InputError for what is no formula of ours
[[nodiscard]] std::string program_formula(const std::string& formula, const std::string& variable,
                                          Program program);

} // namespace kov::cli
