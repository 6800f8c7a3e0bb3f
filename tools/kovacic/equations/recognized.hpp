#pragma once
// "This is Lame's equation with n = ...": what lib/closed recognises, as JSON and as a sentence.

#include "answer/solve.hpp"
#include "equations/result.hpp"
#include "exact/letters.hpp"

namespace kov::cli {

/// {"type": "SL2", "n": null}
[[nodiscard]] Json group_json(const GaloisGroup& g);
/// {"abelian", "group", "reason"}
[[nodiscard]] Json closed_json(const ClosedAnswer& answer,
                               const FreshLetters& letters = FreshLetters());

/// The object under "recognized"; null if nothing is.  taken: the names of the question, and the
/// generator of the field in texts.
/// Throws Contradiction when the classical criterion of the family contradicts the decision.
[[nodiscard]] Json recognized_json(const Decision& decision, const std::set<std::string>& taken,
                                   const Budget& budget);
/// For an equation with free parameters: the family, and its answer as conditions.
[[nodiscard]] Json symbolic_json(const strata::GenericForm& family, const EquationPart& part);

/// "Lame's equation y_tt = ... with n = 1/3, B = 1, ..."; "" for families that say nothing new.
[[nodiscard]] std::string recognized_text(const Json& recognized);

} // namespace kov::cli
