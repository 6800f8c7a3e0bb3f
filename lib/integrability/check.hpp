#pragma once
// From a system to its verdict: every stage, the theorem, and the class of first integrals.
//
//   claims -> manifolds (proved) -> VE -> normal part -> linear integrals -> blocks
//          -> scalar equation -> change of variable -> r(z) -> group -> verdict
//
// The verdict of a manifold is
//   non-integrable   a block of order 2 has a non-abelian identity component (a theorem), or the
//                    whole of VE, by certified monodromy matrices,
//   no obstruction   all blocks have abelian ones, and they are the whole of VE up to a vector
//                    group (variation/whole.hpp): nothing follows,
//   undecided        anything else, with the reason.
//
// Source  [MoralesRamis2001] Theorem 7 (Hamiltonian systems, also on symplectic leaves of a
//         Poisson manifold); [AyoulZung2010] (general vector fields)

#include "integrability/report.hpp"

namespace kov {

/// One manifold of a system; claims: those of the system with their results.
/// Errors  OutOfBudget is turned into "undecided"; InputError and InternalError pass
/// Given   const System system = read_system(parse_document("system = {kind = 'hamiltonian', "
///             "coordinates = ['q1', 'q2'], momenta = ['p1', 'p2'], parameters = ['h'], "
///             "hamiltonian = '(p1^2 + p2^2)/2 + q1^2*q2 + q2^3/2'}\n"
///             "manifold = [{name = 'N', equations = ['q1 = 0', 'p1 = 0'], level = ['H = h']}]",
///             "cubic.toml"), {{"h", "1"}});
/// Example check_manifold(system, system.manifolds.front(), {}).verdict  // -> non-integrable
[[nodiscard]] ManifoldReport check_manifold(const System& s, const ManifoldSpec& spec,
                                            const std::vector<ClaimReport>& claims,
                                            const CheckOptions& options = {});

} // namespace kov
