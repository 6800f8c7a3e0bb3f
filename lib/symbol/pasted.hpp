#pragma once
// A formula as people type and paste it.  Files are strict (expression.hpp, notations.hpp); the command line forgives:
//
//   products        x y    3y'    (1-x^2)y''    2m        but not 1/2x, x^2a, x2, a(b + c): these are asked back
//   numbers         0.25 is 1/4
//   characters      primes, minus signs, dots, powers, Greek letters, fractions of Unicode
//   LaTeX           \frac{d^2y}{dx^2}, \left( \right), \cdot, y^{\prime\prime}, \ddot x, \sqrt{2}, \alpha
//   derivatives     d^2y/dx^2, d/dx (p y'), besides all of notations.hpp
//   functions       e^x, sin x, Sin[x], RootOf(_Z^2 - 2)
//   wrappers        ode := ..., dsolve({..., y(0) = 1}, y(x)), a list of coefficients, initial values after a comma
//
// The formula that was understood is a text in our own notation, for the answer to show.

#include "symbol/expression.hpp"
#include "symbol/reading_note.hpp"
#include "symbol/written.hpp"

#include <string>
#include <vector>

namespace kov {

/// Names with a meaning that was given: they are not e, d or D of mathematics.
struct PastedNames {
  std::vector<std::string> declared = {};
  std::string variable = {}; ///< "" where it is not known
  std::string unknown = {};  ///< "" where it is what is differentiated

  [[nodiscard]] bool has(std::string_view name) const;
};

struct Pasted {
  Expression formula;
  bool as_written = true;               ///< the text says what was written, but for blanks
  std::vector<ReadingNote> notes{};     ///< what was read in another way than its letters say
  std::vector<Expression> conditions{}; ///< y(0) = 1
  bool by_time = false;                 ///< a dot above is a derivative by the time t

  /// The formula, in our own notation.
  [[nodiscard]] std::string text() const { return written(formula); }
};

/// A name or a sentence with Greek letters and subscripts as formulas have them; as it is where that fails.
/// Example plain_text("\u03bb\u2081 > 0")  // -> lambda1 > 0
[[nodiscard]] std::string plain_text(const std::string& text);

/// Errors  InputError, all that is wrong in one; what could mean two things, with both
/// Given   const auto read = [](const char* s) { return pasted_formula(s, "-r").text(); };
/// Example read("2 m x\u00b2 + 0.25")  // -> 2*m*x^2 + 1/4
/// Example read("1/2x")  // -> throws InputError
/// Example read("a(b + c)")  // -> throws InputError
[[nodiscard]] Pasted pasted_formula(std::string text, const std::string& name,
                                    const PastedNames& names = {});

/// Given   const auto ode = [](const char* s) { return pasted_equation(s, "-e").text(); };
/// Example ode("(1-x^2)y'' - 2x y' + 6y = 0")  // -> (1 - x^2)*y'' - 2*x*y' + 6*y = 0
/// Example ode("\\frac{d^2y}{dx^2} = x y")  // -> diff(y, x, 2) = x*y
/// Example ode("ode := y'' = e^x*y")  // -> y'' = exp(x)*y
/// Example pasted_equation("y'' = x*y, y(0) = 1", "-e").conditions.size()  // -> 1
[[nodiscard]] Pasted pasted_equation(std::string text, const std::string& name,
                                     const PastedNames& names = {});

} // namespace kov
