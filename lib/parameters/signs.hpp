#pragma once
// Exact proofs that a polynomial is positive under sign conditions.  docs/theory/strata.md, 2

#include "parameters/conditions.hpp"

namespace kov {

/// c with p = c q, if there is one.
/// Example ratio((a + a).num(), a.num())  // -> 2
[[nodiscard]] std::optional<Rational> ratio(const MPoly& p, const MPoly& q);

/// Known signs of variables and polynomials are given as conditions; `real` lists the real variables.
/// Proofs by the signs of the terms, also after a shift of one variable.
///
/// Given   Assumptions assumed; assumed.require(a, Sign::positive);
/// Given   const SignProver signs(a.ring(), assumed.conditions, {}, {1});
/// Example signs.sign_of((a * a + a + one).num())  // -> 1
/// Example signs.sign_of((a * a - a + one).num())  // -> 0
class SignProver {
public:
  SignProver(const Ring& ring, const std::vector<Condition>& conditions,
             const std::vector<MPoly>& nonzero, const std::vector<std::size_t>& real);

  /// +1 or -1 if p is positive or negative wherever the conditions hold, 0 if no proof was found.
  /// Cost  a few substitutions; no search
  [[nodiscard]] int sign_of(const MPoly& p) const;
  /// Has it a sign, or is it a number besides a sum of squares of real variables (squares.hpp)?
  [[nodiscard]] bool is_never_zero(const MPoly& p) const;

private:
  enum class Known : std::uint8_t { nothing, real, real_nonzero, nonnegative, positive };
  [[nodiscard]] int by_condition(const MPoly& p) const;
  [[nodiscard]] int by_terms(const MPoly& p, const std::vector<Known>& known) const;
  [[nodiscard]] int by_shift(const MPoly& p) const;

  const std::vector<Condition>& conditions_;
  std::vector<Known> known_; ///< by variable
};

} // namespace kov
