#pragma once
// Two solutions of a linear equation, for what is made of them: a right side, initial values, Riccati's unknown.

#include "decide/decide.hpp"
#include "elementary/element.hpp"
#include "elementary/solutions.hpp"
#include "symbol/expression.hpp"

#include <optional>
#include <vector>

namespace kov::cli {

/// A basis: the solutions that are shown, where they are elementary; else one with integrals, where
/// `is_in_its_variable`: the decision is in the variable of the question.  gauge: -p/2.
[[nodiscard]] std::optional<elementary::Basis> known_basis(const std::vector<Expression>& shown,
                                                           const Decision& decision,
                                                           const RationalFunction& gauge,
                                                           bool is_in_its_variable,
                                                           const elementary::LettersPtr& letters);

} // namespace kov::cli
