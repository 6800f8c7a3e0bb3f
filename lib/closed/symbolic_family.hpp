#pragma once
// Classical equations with parameters: y'' = r(z) y, r in Q(parameters)(z), recognised as one of
// the families with closed answers, and the answer as conditions on the parameters.
//
// The places must be rational over Q(parameters).  The answer holds for all parameter values at
// which none of `generic` vanishes (there places meet or disappear).
//
// Source  docs/theory/kimura.md, confluent.md, lame.md, recognition.md

#include "closed/classical.hpp"
#include "exact/budget.hpp"
#include "exact/multivariate.hpp"
#include "exact/truth.hpp"
#include "galois/group.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace kov {

/// One line of the answer: where the condition holds, and none before it.
struct FamilyCase {
  std::string when;               ///< "m is in 1/2 + Z"; "" = always, "else" = in all other cases
  std::optional<GroupType> group; ///< unset: see `when`
  Truth abelian = Truth::unknown;
};

struct SymbolicFamily {
  Classical family = Classical::constant;
  std::string equation; ///< its canonical form
  /// Names and values, e.g. m = nu; the value is a square root where it has none in
  /// Q(parameters).
  std::vector<std::pair<std::string, std::string>> parameters;
  std::vector<FamilyCase> cases;
  std::vector<MPoly> generic;

  /// The answer that all cases share: yes, no, or unknown if they differ.
  [[nodiscard]] Truth abelian() const;
  /// "abelian exactly when ...; never abelian; ..." in words.
  [[nodiscard]] std::string summary() const;
};

/// Unset for other equations.
/// Cost  one factorisation of the denominator, operations with polynomials of degree <= 9 in z
/// Throws OutOfBudget
/// Given  const Ring ring = make_ring({"z", "nu"});
/// Given  const MFraction x = MFraction::variable(ring, "z"), nu = MFraction::variable(ring, "nu");
/// Given  const MFraction one(ring, 1), bessel = (nu * nu - Rational(1, 4) * one) / (x * x) - one;
/// Example symbolic_family(bessel, 0)->parameters  // -> {{m, nu}, {a, -1}}
/// Example symbolic_family(bessel, 0)->summary()
///         // -> the identity component is abelian where m is in 1/2 + Z, not abelian otherwise
[[nodiscard]] std::optional<SymbolicFamily> symbolic_family(const MFraction& r, std::size_t z,
                                                            const Budget& budget = {});

/// +-sqrt(a) as text: "nu", "2*n + 1", "sqrt(a + 1)"; of the two roots the one with a positive
/// leading coefficient.
[[nodiscard]] std::string root_text(const MFraction& a);

} // namespace kov
