#pragma once
// A linear system along a phase curve, xi' = J(t) xi, as a system dY/dz = A(z) Y over K(z).
//
// The entries of J lie in the function field F of the curve, of degree d over K(z), with a basis
// b_k. Writing xi_i = sum_k y_ik b_k gives a system of size n d over K(z) (restriction of scalars).
// It falls into blocks that do not use each other; one block for each unknown xi_i is enough. Where
// the entries of J have parities (as for a natural Hamiltonian on a curve w^2 = f(z)) a block has
// the size n.
//
// Every solution xi is a combination of those of the blocks, and the identity component of the
// group of xi' = J xi over F is abelian exactly when that of every block over K(z) is.
// docs/theory/monodromy.md 8

#include "algebraize/function_field.hpp"
#include "variation/normal.hpp"

namespace kov {

struct RationalSystem {
  std::vector<std::string> names; ///< "q1", or "q1/(b)" for the coordinate of q1 that belongs to b
  std::vector<std::size_t> unknowns; ///< q1, by its number
  std::vector<MFraction> basis;      ///< b, a function on the curve
  Matrix a;
  std::string change; ///< text of phi
  std::size_t z = 0;  ///< the variable of the ring
  std::size_t field_degree = 1;
  std::vector<MPoly> inverted; ///< polynomials in the parameters and z that were divided by
};

/// `divisors`: what the derivation of the system divided by, units on the curve.
/// Errors   ChangeFailure: phi is not a change of variable on this curve, or an entry of J has a
///          pole along all of it
/// Source   docs/theory/monodromy.md 8
[[nodiscard]] std::variant<RationalSystem, ChangeFailure>
rational_system(const VectorField& v, const InvariantManifold& m, std::size_t z,
                const MFraction& phi, const LinearSystem& s, const std::vector<MPoly>& divisors,
                const Budget& budget = {});

/// The same system by the time t, where the curve is w^2 = F(z), w = dz/dt:
/// xi' = (even + w odd) xi, the entries functions of z.
struct SystemOnTwoSheets {
  std::vector<std::string> names;
  Matrix even, odd;
  MFraction z_dot_squared; ///< F
  std::string change;
  std::size_t z = 0;
};

/// Errors   ChangeFailure: as above, and where the function field of the curve is not K(z, dz/dt)
///          with (dz/dt)^2 in K(z)
[[nodiscard]] std::variant<SystemOnTwoSheets, ChangeFailure>
system_on_two_sheets(const VectorField& v, const InvariantManifold& m, std::size_t z,
                     const MFraction& phi, const LinearSystem& s, const Budget& budget = {});

} // namespace kov
