#pragma once
// What Python asks: an equation as texts, and how the answer is wanted.

#include "computation.hpp"
#include "decide/decide.hpp"
#include "equation/question.hpp"

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

/// One equation as text.
struct QuestionTexts {
  EquationTexts equation;
  std::string variable, unknown;
  std::vector<std::string> parameters, assume;
  std::vector<std::pair<std::string, std::string>> set;

  /// Errors  InputError
  [[nodiscard]] AskedEquation read() const;
};

/// The answer to one equation: numbers, or all values of the parameters.
[[nodiscard]] py::object answer(const Wishes& wishes, const AskedEquation& asked);

} // namespace kov::python
