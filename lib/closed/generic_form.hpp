#pragma once
// The classical equation that y'' = r(z; parameters) y is for generic parameters, in words.
//
// Source  docs/theory/recognition.md

#include "closed/criteria.hpp"
#include "exact/letters.hpp"

namespace kov::strata {

/// The numbers of a classical equation by name, in letters that the ring has not.
struct NamedNumbers {
  FreshLetters letter;
  std::vector<std::pair<std::string, std::string>> all; ///< {"m", "sqrt(a + 1)"}
};
[[nodiscard]] NamedNumbers numbers_of(const ClassicalForm& form, const Ring& ring);

/// "n is an integer and m > 0, or where ...": the parts with an abelian identity component.
[[nodiscard]] std::string abelian_where(const std::vector<Part>& parts);

/// The answer holds where none of `generic` vanishes: there places may meet or disappear.
struct GenericForm {
  ClassicalAnswer answer;
  std::vector<MPoly> generic;
  std::string equation; ///< the canonical one, in letters that r has not
  std::vector<std::pair<std::string, std::string>> numbers; ///< names and values: {"m", "nu"}
  std::string change;                                       ///< "x = z - c"; "" where x is z

  /// The answer that all parts share: yes, no, or unknown if they differ.
  [[nodiscard]] Truth abelian() const;
  /// "the identity component is never abelian"
  [[nodiscard]] std::string summary() const;
};

/// Unset for other equations, and for places that are rational for special parameters only.
/// Throws  OutOfBudget
/// Given   const ParametrisedSet there = everywhere;
/// Example generic_form(a, 0, there)->equation   // -> y'' = c y
/// Example generic_form(a, 0, there)->summary()  // -> the identity component is always abelian
[[nodiscard]] std::optional<GenericForm>
generic_form(const MFraction& r, std::size_t z, ParametrisedSet region, const Budget& budget = {});

} // namespace kov::strata
