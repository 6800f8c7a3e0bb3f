#pragma once
// The answer for all values of the parameters at once.

#include "answer/solve.hpp"

namespace kov::python {

/// The answer for one part of the parameters, and beside it the others.
struct FamilyAnswer {
  answer::Family all;
  std::size_t at = 0; ///< the part

  FamilyAnswer(answer::Family family, std::size_t at);
  /// The first part that has an answer.
  explicit FamilyAnswer(answer::Family family);
  /// No equation that somebody wrote.
  explicit FamilyAnswer(strata::StrataAnswer answer);

  [[nodiscard]] const answer::FamilyPart& part() const { return all.parts.at(at); }
  [[nodiscard]] const strata::StrataAnswer& answer() const { return *part().answer; }
};

} // namespace kov::python
