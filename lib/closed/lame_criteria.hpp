#pragma once
// Lame's equation on a stratum.  docs/theory/lame.md; strata.md, 10

#include "closed/criteria.hpp"
#include "closed/lame_family.hpp"

namespace kov::strata {

/// As classical_answer.  Unset: the degenerate curve, where the equation is another classical one.
/// Throws  OutOfBudget
/// Given   const ParametrisedSet there = everywhere.where_nonzero(a.num());
/// Given   const MFraction f = Rational(4) * pow(z, 3) - a, slope = derivative(f, 0);
/// Given   const MFraction r = (Rational(1, 4) * derivative(slope, 0) + Rational(5, 16) * z) / f -
///             Rational(3, 16) * slope * slope / (f * f);
/// Given   const auto answer = lame_answer_on(*recognize_lame(r, 0), there, {});
/// Example std::get<ClassicalAnswer>(answer).parts.at(0).group->type  // -> S4
[[nodiscard]] std::variant<std::monostate, ClassicalAnswer, Needs>
lame_answer_on(const LameFamilyForm& form, const ParametrisedSet& region, const Budget& budget);

} // namespace kov::strata
