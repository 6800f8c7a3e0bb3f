#pragma once
// Kovacic 1986: all Liouvillian solutions of y'' = r y, or a proof that there are none.
//
// For each case in turn: is it possible? then exponent sets, families, degree, polynomial; what is
// found is put back into the equation before it leaves.  Each case relies on the failure of the
// ones before it, and a failure is exhaustive: a limit of the budget ends in Unable, never in
// "there is none".
//
// r has coefficients in K = Q or a number field; completeness over K alone, although solutions may
// live over extensions of K, is proved in docs/theory/descent.md.

#include "kovacic/outcome.hpp"
#include "kovacic/trace.hpp"
#include "linode/normal_form.hpp"
#include "linode/singularities.hpp"

namespace kov::kovacic {

/// Cost    cases 1 to 3 look at the families that pass the degree condition, one linear system
///         each; rational products need one system of at most D_m + 1 unknowns (m = 2, 6, 12)
/// Unknown Unable::budget with the limit that was reached
/// Throws  InternalError if a self-check fails
/// Source  [Kovacic1986] §2 - §5
[[nodiscard]] Outcome solve(const Singularities& s, const Budget& budget = {},
                            Trace* trace = nullptr);

/// The same for r, which may be 0.
/// Example case_of(solve(z))  // -> 4
/// Example std::get<Exponential>(solve(z*z + 3)).omega  // -> (z^2 + 1)/z
/// Example std::get<ExponentialPair>(solve(-1)).w_squared  // -> -4
[[nodiscard]] Outcome solve(const RationalFunction& r, const Budget& budget = {},
                            Trace* trace = nullptr);

/// The same for the r of a normal form.
[[nodiscard]] Outcome solve(const NormalForm& equation, const Budget& budget = {},
                            Trace* trace = nullptr);

} // namespace kov::kovacic
