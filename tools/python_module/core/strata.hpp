#pragma once
// The answer for all values of the parameters at once.

#include "answer/answer.hpp"
#include "closed/symbolic_family.hpp"
#include "equation/parametric_equation.hpp"

#include <optional>
#include <string>

namespace kov::python {

struct FamilyAnswer {
  strata::StrataAnswer answer;
  std::string variable;
  /// The classical family that the equation is recognised as, with its classical criterion.
  std::optional<SymbolicFamily> family{};
  std::optional<answer::Given> question{}; ///< of an equation that somebody wrote
  std::optional<ParametricEquation> equation{};
};

[[nodiscard]] FamilyAnswer decide_family(const ParametricEquation& f, const Options& options);
/// yes, no: on all strata; else unknown.
[[nodiscard]] Truth abelian(const FamilyAnswer& a);

} // namespace kov::python
