#pragma once
// Two exponent differences that are special together at finitely many values only: theorem_certificates.md 17.

#include "certify/strata/certificate.hpp"
#include "certify/theorem/family.hpp"

namespace kov::certify {

/// A number whose square is a function of parameters.  If the identity component is abelian it is in (1/N)Z, and
/// special.
class ExponentDifference {
public:
  /// Refuses one of which nothing follows.   Requires that its polynomials are in one ring
  explicit ExponentDifference(OneDifference d);

  [[nodiscard]] const Fraction& square() const { return d_.square; }
  [[nodiscard]] const Integer& N() const { return N_; }
  [[nodiscard]] bool is_special(const Rational& x) const;

private:
  OneDifference d_;
  Integer N_;
};

/// Delta2^2 = F(Delta1^2), F = A/B.
struct ValuesOfDifferences {
  std::vector<Rational> A, B; ///< ascending
  long bound = 0;             ///< of N Delta1
  /// For larger ones N Delta2 lies between this number and the next; unset:
  /// Delta2^2 is negative.
  std::optional<Integer> gap{};
};
/// It is 0 where Delta2^2 = F(Delta1^2).
[[nodiscard]] MPoly off_function(const ExponentDifference& first, const ExponentDifference& second,
                                 const ValuesOfDifferences& f, Arithmetic& a);
/// Is it shown that there is no value from the bound on?
[[nodiscard]] bool shows_bound(const ExponentDifference& first, const ExponentDifference& second,
                               const ValuesOfDifferences& f);
/// Delta1 is none of the values at which both may be special.
[[nodiscard]] Conditions no_common_values(const ExponentDifference& first,
                                          const ExponentDifference& second,
                                          const ValuesOfDifferences& f);

} // namespace kov::certify
