#pragma once
// Liouvillian solutions from the evidence of a classification.

#include "galois/classify.hpp"

#include <string>
#include <vector>

namespace kov {

/// y'/y itself, or its minimal polynomial sum_i coefficients[i] w^i = 0 over K(z) (ascending).
struct LiouvillianSolution {
  std::optional<ExponentialSolution> exponential{};
  std::vector<RationalFunction> minimal_polynomial{};

  // what is said of the constants
  bool adjoined = false;            ///< K = Q, and the exponential is written over Q(square root)
  std::optional<NfElem> radicand{}; ///< the minimal polynomial splits over K(sqrt(radicand))
  bool three_quadratics = false;    ///< it is the product of three that are conjugate over K
};

/// An exponential as P*(z-c)^e*exp(R); empty for the others.
[[nodiscard]] std::string text(const LiouvillianSolution& s, const std::string& variable = "z",
                               const Budget& budget = {});
/// "over Q(sqrt(5))", or what else is said of the constants; may be empty.
[[nodiscard]] std::string note(const LiouvillianSolution& s);

/// At most two: exponentials where they exist, else one irreducible minimal polynomial of y'/y
/// (degree 2, 6, 6, 12 for dihedral, A4, S4, A5).  Each is verified before it is returned.
/// Throws  OutOfBudget; InternalError if a verification fails
/// Given   const RationalFunction hermite(z*z + 3), dihedral(16*z - 3, 16*z*z);
/// Example solutions(classify(hermite), hermite).front().exponential->omega()  // -> (z^2 + 1)/z
/// Example solutions(classify(dihedral), dihedral).front().minimal_polynomial
///         // -> {(-16*z + 1)/(16*z^2), -1/(2*z), 1}
[[nodiscard]] std::vector<LiouvillianSolution>
solutions(const Classification& c, const RationalFunction& r, const Budget& budget = {});

/// The coefficients A_i/(m-i)! of the polynomial that y'/y satisfies for every linear factor y of
/// the invariant whose value v has the logarithmic derivative u (docs/theory/descent.md (6)).  InternalError unless
/// A_-1 = 0.
[[nodiscard]] std::vector<RationalFunction> riccati_polynomial(long m, const RationalFunction& u,
                                                               const RationalFunction& r,
                                                               const Budget& budget = {});

} // namespace kov
