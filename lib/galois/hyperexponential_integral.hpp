#pragma once
// int a E dz for a hyperexponential function E, E'/E = phi in K(z), and a in K(z): what can be
// integrated inside K(z) E is, the rest has as few poles as Hermite's reduction leaves.
//
// Source  docs/theory/second_solution.md, with proofs

#include "exact/budget.hpp"
#include "exact/rational_function.hpp"

#include <string>
#include <vector>

namespace kov {

/// int a E dz = w E + int b E dz.
struct HyperexponentialIntegral {
  RationalFunction phi; ///< E'/E
  RationalFunction w;
  RationalFunction b; ///< 0: the integral is w E
};

/// places: squarefree, pairwise coprime polynomials; at all other poles nothing is reduced.  The
/// result is checked: w' + phi w + b = a.
/// Throws  OutOfBudget
/// Cost    one inverse modulo each place for each order that goes
/// Example reduced_integral(2*z, 1, {}).w  // -> 2*z - 2
/// Example reduced_integral(RationalFunction(1, z*z), RationalFunction(1), {z}).b  // -> 1/z
[[nodiscard]] HyperexponentialIntegral reduced_integral(const RationalFunction& a,
                                                        const RationalFunction& phi,
                                                        const std::vector<Poly>& places,
                                                        const Budget& budget = {});

/// The integral as text, by names where it has one: logarithms (E = 1), erf and erfi (E the
/// exponential of a quadratic polynomial), Ei (of a linear one); otherwise as int(...).
/// Example to_string(reduced_integral(1, -2*z, {}))  // -> (1/2)*sqrt(pi)*erf(z)
/// Example to_string(reduced_integral(RationalFunction(1, z), RationalFunction(1), {z}))  // -> Ei(z)
[[nodiscard]] std::string to_string(const HyperexponentialIntegral& integral,
                                    const std::string& variable = "z", const Budget& budget = {});

} // namespace kov
