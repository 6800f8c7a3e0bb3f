#pragma once
// What Python asks: an equation as texts, and how the answer is wanted.

#include "computation.hpp"
#include "decide/decide.hpp"
#include "equation/read_equation.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace kov::python {

/// The options of a decision, and its limits.
struct Wishes {
  Limits limits;
  Method method = Method::automatic;
  std::optional<int> only_case;
  bool solutions = true, trace = false, certificate = false;

  [[nodiscard]] Options options(const Budget& budget) const;
};

/// One equation; exactly one of r, ode, (p and q).
struct EquationTexts {
  std::optional<std::string> r, ode, p, q, minpoly;
  std::string variable, unknown;
  std::vector<std::string> parameters, assume;
  std::vector<std::pair<std::string, std::string>> set;

  /// Errors  InputError
  [[nodiscard]] EquationText read() const;
};

/// A name in an assumption that occurs in the equation is a parameter, unless it is the variable.
void add_assumptions(EquationText& text, const std::vector<std::string>& assume);

/// The answer to one equation: numbers, or all values of the parameters.
[[nodiscard]] py::object answer(const Wishes& wishes, const EquationText& text);

} // namespace kov::python
