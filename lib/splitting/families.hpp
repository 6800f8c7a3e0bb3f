#pragma once
// All solutions of the vanishing conditions with 0 < a < b < c and S != 0.
//
// The tree splits on S_j = 0 or not and on the factors of the equations; a branch ends
//   empty     an equation has one sign on the branch (Cone), or S = 0, or
//   family    what is left is one equation in S^2 with opposite signs, or none: described exactly,
//             with a rational witness.
// A branch that cannot be closed is kept as a family without witness: "not seen to be empty" is
// "not empty".

#include "exact/truth.hpp"
#include "splitting/conditions.hpp"

namespace kov {

struct SplittingFamily {
  std::vector<std::string> zero;  ///< components of S that vanish; the others do not
  std::vector<MPoly> moments;     ///< equations in the moments A > B > C
  std::optional<MPoly> direction; ///< equation between the squares of the components of S
  std::optional<std::array<Rational, 3>> witness; ///< A, B, C
  Truth triangle = Truth::unknown;                ///< are there members with A <= B + C?
};

/// A sum vanishes nowhere on a branch: each of its factors is of one of these kinds, this is the first.
struct NonzeroFactor {
  enum class Why : std::uint8_t {
    component,   ///< of the direction, which is not 0 there
    one_sign,    ///< for 0 < a < b < c
    coefficients ///< of the squares of the direction's components: all of one sign
  };
  Why why = Why::one_sign;
  MPoly factor;
  std::vector<SignIdentity> by = {};
};
[[nodiscard]] std::string sentence(const NonzeroFactor& f);

struct EmptyBranch {
  std::string branch; ///< "L2 != 0, L3 = 0"
  NonzeroFactor because;
};

struct SplittingClassification {
  VanishingConditions conditions;
  std::vector<SplittingFamily> families;
  std::vector<EmptyBranch> empty;
};

/// If a branch keeps several equations for the direction, the family has one of them, or none: it is
/// larger than the set where all sums vanish.
/// Errors  OutOfBudget
[[nodiscard]] SplittingClassification classify_families(const VanishingConditions& c,
                                                        const Budget& budget = {});
/// "L2 = 0, L3 = 0, 2*A - 2*B - C = 0"
[[nodiscard]] std::string describe(const SplittingFamily& f);

} // namespace kov
