#pragma once
// One question about an equation, as every door reads it: options, lines of a batch, files, Python.  Notations that are not ours
// (symbol/pasted.hpp) are read here, too, and told.

#include "equation/understood.hpp"

#include <optional>
#include <string>
#include <vector>

namespace kov {

/// A question, and how it was understood.
struct AskedEquation {
  EquationText text;
  std::string given;                ///< the equation, as it was read; "": only formulas were given
  std::vector<std::string> read_as; ///< "r = 2*x", an equation: what was read in another way
  std::vector<ReadingNote> notes;   ///< and how
  std::optional<std::string> right_side; ///< of the given equation: what is decided is homogeneous
  std::optional<elementary::WholeEquation> whole; ///< with it, with initial values, or of Riccati
};

/// Exactly one of r, ode, (p and q).
struct EquationTexts {
  std::optional<std::string> r, ode, p, q, minpoly;
};
/// Their names in errors: -r, -e, --p, or r, ode, p.
enum class Door : std::uint8_t { options, keys };

/// `given` has the variable, the parameters, the values and what is assumed.  If the variable is named, all other names
/// are parameters.
/// Errors   InputError
/// Given    const auto asked = [](const char* ode) { EquationTexts one; one.ode = ode; return asked_equation(one, {}, Door::keys); };
/// Example  asked("y'' = x y").read_as.size()  // -> 1
/// Example  asked("y'' + y = sin(x)").right_side.value()  // -> sin(x)
/// Example  asked("y'' = yx").given  // -> throws InputError
[[nodiscard]] AskedEquation asked_equation(const EquationTexts& texts, EquationText given,
                                           Door door);

/// Sentences as they were given under this name.
[[nodiscard]] std::vector<AssumedText> assumed_texts(const std::vector<std::string>& sentences,
                                                     const std::string& origin);
/// Assumptions, and the names in them that occur in the equation as parameters, unless they are its variable.
/// Errors   InputError
void add_assumptions(EquationText& text, const std::vector<AssumedText>& sentences);

} // namespace kov
