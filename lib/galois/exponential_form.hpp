#pragma once
// The kind of the function y = exp(int omega), omega in K(z).  Residues, radicals, text.

#include "exact/budget.hpp"
#include "exact/factor.hpp"
#include "exact/rational_function.hpp"

#include <optional>
#include <string>
#include <vector>

namespace kov {

/// omega = R' + sum over places q of rho_q(c)/(z - c) over the roots c of q.
struct LogarithmicParts {
  RationalFunction rational_part; ///< R: y = exp(R) * ...
  struct Residue {
    Poly q;
    Poly rho; ///< in K[c]/q
  };
  std::vector<Residue> residues; ///< nonzero ones
};

/// Hermite's reduction.
/// Throws  OutOfBudget
/// Cost    one factorisation of the denominator, an inverse modulo each place and order
/// Given   const LogarithmicParts parts = logarithmic_parts(RationalFunction(z*z + 1, z));
/// Example parts.rational_part  // -> z^2/2
[[nodiscard]] LogarithmicParts logarithmic_parts(const RationalFunction& omega,
                                                 const Budget& budget = {});

/// The least m >= 1 with y^m in Kbar(z); unset when there is none (R not constant, or a residue
/// that is not rational).
/// Example radical_order(logarithmic_parts(RationalFunction(1, 4*z)))  // -> 4
[[nodiscard]] std::optional<Integer> radical_order(const LogarithmicParts& parts);

/// P exp(int theta) as text: P*(q)^(e)*exp(R), with an integral sign where residues differ between
/// conjugates.
/// Example exponential_text(1, parts)  // -> z*exp(z^2/2)
[[nodiscard]] std::string exponential_text(const Poly& p, const LogarithmicParts& parts,
                                           const std::string& variable = "z");

/// The two exponentials with product v and Wronskian w: omega = (v' +- w)/(2v), v in K(z), w^2 in
/// K.
struct ExponentialPair {
  RationalFunction v;
  NfElem w_squared;
};
/// w^2 = v'^2 - 2vv'' + 4rv^2 (docs/theory/normal_form.md, 2.4), without a gcd.  InternalError unless it
/// is a constant.
/// Example wronskian_squared(z, RationalFunction(-3, 16*z*z))  // -> 1/4
[[nodiscard]] NfElem wronskian_squared(const RationalFunction& v, const RationalFunction& r);
/// The least m with y1^m in Kbar(z), without adjoining w; unset when there is none.
[[nodiscard]] std::optional<Integer> radical_order(const ExponentialPair& pair,
                                                   const Budget& budget = {});

} // namespace kov
