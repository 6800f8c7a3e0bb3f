#pragma once
// One checking function for each rule of docs/theory/certificates.md.  Each refuses (throws
// Refused) or returns what the step establishes; none searches.

#include "certify/equation/modular_equation.hpp"
#include "proof/text/limits.hpp"
#include "proof/text/meter.hpp"

#include <algorithm>

namespace kov::certify {

struct Judge {
  Field field;
  Equation equation;

  [[nodiscard]] Reduced reduced(const PrimeIdeal& p) const {
    spend(20 * length());
    return reduce(equation, field, p);
  }
  /// deg num + deg den + 2, and the same in machine words
  [[nodiscard]] double length() const {
    return static_cast<double>(degree(equation.num) + degree(equation.den) + 2);
  }
  [[nodiscard]] double words() const {
    return length() * (1 + std::max(bits(equation.num), bits(equation.den)) / 64);
  }
  /// Refuses when all steps together cost too much; before the work is done.
  void spend(double work) const {
    FileMeter::charge(0, 0, work);
    spent += work;
    need_within(spent <= max_total, "the certificate is too much work");
  }

  mutable double spent = 0;
};

[[nodiscard]] LocalFact check_local(const Judge& j, const Local& data);
/// The fact that check_local would establish, without the tests that concern all places together:
/// for the writer of a certificate that is judged as a whole afterwards.  Never part of a
/// judgement.
[[nodiscard]] LocalFact claimed_local(const Judge& j, const Local& data);
[[nodiscard]] ExponentialFact check_exponential(const Judge& j, const Exponential& data);
[[nodiscard]] InvariantFact check_invariant(const Judge& j, const Invariant& data);
[[nodiscard]] IrreducibleFact check_no_exponential(const Judge& j, const NoExponential& data,
                                                   const LocalFact& local);
/// L: a rational solution of the Riccati equation, times t^nu at the place x, obeys a linear
/// recurrence of length L or less (riccati_one_place.md, 3).
[[nodiscard]] Integer length_bound(const LocalFact& local, const PlaceFact& x);
/// local: needed for "sl2" only, else null.
[[nodiscard]] PCurvatureFact check_p_curvature(const Judge& j, const PCurvature& data,
                                               const LocalFact* local);
[[nodiscard]] AbsentFact check_no_invariant(const Judge& j, const NoInvariant& data,
                                            const LocalFact& local);
/// v: m = 2 with a half-integer exponent and w^2 != 0.  local may be null.
[[nodiscard]] TorsionFact check_torsion_function(const Judge& j, const TorsionFunction& data,
                                                 const InvariantFact& v, const LocalFact* local);
[[nodiscard]] ReductionFact check_good_reduction(const Judge& j, const GoodReduction& data,
                                                 const InvariantFact& v);
/// The curve of v modulo the prime of a step (reduce_curve of modular_equation.hpp).
[[nodiscard]] inline ReducedCurve reduced_curve(const Judge& j, const InvariantFact& v,
                                                const PrimeIdeal& prime) {
  j.spend(20 * (j.length() + static_cast<double>(degree(v.branch))));
  return reduce_curve(j.equation, j.field, v.branch, v.w_squared, prime);
}
/// From a theorem of the fixed table and the facts that it needs.
[[nodiscard]] Conclusion conclude(const std::string& theorem, const Premises& premises);

/// m = 2 and w^2 != 0: two exponential solutions exp(int (v' +- w)/(2v)).
[[nodiscard]] inline bool is_quadratic(const InvariantFact& v) {
  return v.data.m == 2 && !is_zero(v.w_squared);
}

} // namespace kov::certify
