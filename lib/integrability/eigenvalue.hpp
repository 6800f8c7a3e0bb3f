#pragma once
// Variations that fall apart over an eigenvalue which is not a function of the parameters: it is
// adjoined as an algebraic constant.
//
// Source  docs/theory/mechanics.md (5)

#include "integrability/study.hpp"

namespace kov {

/// A system with one more algebraic constant, which System::adjoined names, or with one that it had.
struct WithEigenvalue {
  System system;         ///< the names of the ring before, and one more
  ManifoldSpec manifold; ///< the same set, by equations with the eigenvalue in them
};

/// If a block of order > 2 of the normal part, y' = C y, commutes with a constant matrix T whose
/// minimal polynomial p is irreducible of degree 2, 3 or 4 over the parameters:
/// eigenrows of T for a root of p (and for the other one, if there are two) stand for the equations
/// of the block. Unset if there is none.
/// Requires  `decoupled` finds nothing
[[nodiscard]] std::optional<WithEigenvalue> with_eigenvalue(const System& s, const ManifoldSpec& m,
                                                            const ManifoldReport& report,
                                                            const Budget& budget);

/// The same along a manifold that is not studied yet; a limit ends the search.
[[nodiscard]] std::optional<WithEigenvalue>
over_an_eigenvalue(const System& s, const ManifoldSpec& m, const std::vector<ClaimReport>& claims,
                   const CheckOptions& options);

/// The system with the eigenvalues that its manifolds ask for, at most two, which
/// System::adjoined names; the manifolds keep their names and places.
/// Cost    all of check_manifold but the decision, for systems of four or more variables
/// Given   const System chain = read_system(parse_document("system = {kind = 'hamiltonian', "
///             "coordinates = ['x', 'y', 'z'], momenta = ['u', 'v', 'w'], hamiltonian = "
///             "'(u^2 + v^2 + w^2)/2 + z^4 + (x^2 + x*y)*z^2'}\nmanifold = [{name = 'axis', "
///             "equations = ['x = 0', 'y = 0', 'u = 0', 'v = 0'], level = ['H = 1']}]",
///             "chain.toml"));
/// Example with_eigenvalues(chain, {}).adjoined.size()  // -> 1
[[nodiscard]] System with_eigenvalues(System s, const CheckOptions& options);

/// The system with an algebraic constant whose square is d, a polynomial in the parameters that is no
/// square; System::adjoined names it.
/// Example with_square_root(chain, MPoly(chain.ring(), Integer(3)), "").adjoined
///         // -> {kappa is a root of kappa^2 - 3}
[[nodiscard]] System with_square_root(const System& s, const MPoly& d, const std::string& remark);

/// The claims in the ring of the system, of which they are.
[[nodiscard]] std::vector<ClaimReport> claims_of(const System& s, std::vector<ClaimReport> claims);

} // namespace kov
