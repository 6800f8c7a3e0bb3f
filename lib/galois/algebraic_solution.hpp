#pragma once
// The polynomial of y itself where the group is A4, S4 or A5: the value of a ground form, its
// Hessian and its Jacobian are the only data.
//
// Source  docs/theory/algebraic_solution.md, with proofs

#include "galois/classify.hpp"

#include <optional>
#include <vector>

namespace kov {

/// y^power = factor * X with sum_i polynomial[i] X^i = 0, monic in X, over K[z].
struct AlgebraicSolution {
  long power = 0; ///< 4, 8, 10 for A4, S4, A5
  RationalFunction factor;
  std::vector<Poly> polynomial; ///< of degree 6, 6, 12; ascending
};

/// Is each y of this form a solution of y'' = r y?  By differentiating the polynomial twice, modulo
/// itself; how it was found is not used.  No also where the polynomial has a double root.
/// Given   const RationalFunction r(Rational(-3, 16), z*z);
/// Example solves(AlgebraicSolution{4, z, {-1, 1}}, r)  // -> yes
/// Example solves(AlgebraicSolution{4, z, {-z, 1}}, r)  // -> no
[[nodiscard]] bool solves(const AlgebraicSolution& y, const RationalFunction& r,
                          const Budget& budget = {});

/// With y^power in it the polynomial is irreducible over C(z), of degree 24, 48, 120.  Verified by
/// solves() before it is returned; unset for all other groups.
/// Throws  OutOfBudget; InternalError if the verification fails
/// Given   const RationalFunction tetrahedral(-32*z*z + 27*z - 27, 144*z*z*(z - 1)*(z - 1));
/// Example algebraic_solution(classify(tetrahedral), tetrahedral)->polynomial.size()  // -> 7
/// Example algebraic_solution(classify(z), z).has_value()  // -> no
[[nodiscard]] std::optional<AlgebraicSolution>
algebraic_solution(const Classification& c, const RationalFunction& r, const Budget& budget = {});

/// exp(int theta) where that is in K(z), up to a constant: a product of powers.
/// Example with_logarithmic_derivative(RationalFunction(-2, z))  // -> 1/z^2
/// Example with_logarithmic_derivative(1)  // -> none
[[nodiscard]] std::optional<RationalFunction>
with_logarithmic_derivative(const RationalFunction& theta, const Budget& budget = {});

/// The solution y exp(int gauge): the same polynomial, and another factor.  Unset where
/// exp(power int gauge) is not in K(z).
/// Given   const AlgebraicSolution y{4, z, {-1, 1}};
/// Example times_exponential(y, RationalFunction(-1, 2*z))->factor  // -> 1/z
/// Example times_exponential(y, 1).has_value()  // -> no
[[nodiscard]] std::optional<AlgebraicSolution>
times_exponential(AlgebraicSolution y, const RationalFunction& gauge, const Budget& budget = {});

} // namespace kov
