#pragma once
// Exact proofs that a polynomial is positive under sign conditions.  docs/theory/strata.md, 2

#include "parameters/conditions.hpp"

namespace kov {

/// c with p = c q, if there is one.
/// Example ratio((a + a).num(), a.num())  // -> 2
[[nodiscard]] std::optional<Rational> ratio(const MPoly& p, const MPoly& q);

/// sign p is the sum of these terms, none of which is negative and one of which is positive.
struct SignedSum {
  int sign = 1;
  std::vector<certify::LemmaTerm> terms;
};

/// Known signs of variables and polynomials are given as conditions; `real` lists the real variables.
/// Proofs by the signs of the terms, also after a shift of one variable.  Requires that the conditions
/// stay alive.
///
/// Given   Assumptions assumed; assumed.require(a, Sign::positive);
/// Given   const SignProver signs(a.ring(), assumed.conditions, {}, {1});
/// Example signs.sign_of((a * a + a + one).num())  // -> 1
/// Example signs.sign_of((a * a - a + one).num())  // -> 0
/// Example signs.sum((a * a + a + one).num())->terms.size()  // -> 3
class SignProver {
public:
  SignProver(const Ring& ring, const std::vector<Condition>& conditions,
             const std::vector<MPoly>& nonzero, const std::vector<std::size_t>& real);

  /// +1 or -1 if p is positive or negative wherever the conditions hold, 0 if no proof was found.
  /// Cost  a few substitutions; no search
  [[nodiscard]] int sign_of(const MPoly& p) const;
  /// Has it a sign, or is it a number besides a sum of squares of real variables (squares.hpp)?
  [[nodiscard]] bool is_never_zero(const MPoly& p) const;

  /// In powers of conditions and even powers of real variables.
  [[nodiscard]] std::optional<SignedSum> by_terms(const MPoly& p) const {
    return by_terms(p, known_);
  }
  /// The same after a shift, or times a positive condition.
  [[nodiscard]] std::optional<SignedSum> sum(const MPoly& p) const;

private:
  /// A variable x: k x is a condition, or x is real, or nothing is known.
  struct Known {
    enum class As : std::uint8_t { nothing, real, real_nonzero, nonnegative, positive };
    As as = As::nothing;
    std::size_t condition = 0;
    Rational k{1};
  };
  [[nodiscard]] int by_condition(const MPoly& p) const;
  [[nodiscard]] std::optional<SignedSum> by_terms(const MPoly& p,
                                                  const std::vector<Known>& known) const;
  [[nodiscard]] std::optional<SignedSum> by_shift(const MPoly& p) const;

  const std::vector<Condition>& conditions_;
  std::vector<Known> known_; ///< by variable
};

} // namespace kov
