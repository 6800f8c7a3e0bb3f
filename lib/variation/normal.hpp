#pragma once
// Variational equations along a phase curve in an invariant manifold, and their normal part.
//
//   VE          xi' = J xi,  J = (d_j X_i) on the manifold
//   normal      y_i = df_i . xi for the equations f_i = 0 of the manifold:  y' = C y, where
//               (grad f)' + (grad f) J = C grad f  on the manifold (solved for C, then checked)
//   integrals   dF . xi is a first integral of VE for each first integral F; where dF lies in the
//               span of the df_i it is one of the normal part, and its zero level takes away one
//               unknown
//   blocks      the strongly connected parts of "y_i' uses y_j": C is block triangular
//
// The differential Galois group of a part (the zero level of a linear integral, a diagonal block)
// is a quotient of the group of VE; a non-abelian identity component of a part is therefore one of
// VE.
//
// Source  [MoralesRuiz1999] 4.1-4.3; [PrzybylskaMaciejewski2024] eq. (normal_sys), (norvariat)

#include "manifold/invariant_manifold.hpp"

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace kov {

/// y' = a y with entries on the manifold.
struct LinearSystem {
  std::vector<std::string> names; ///< "M1" stands for the variation of M1
  Matrix a;
};

/// Coefficients c with target = sum_i c_i rows_i on the phase curve; unset if there are none.  What
/// was divided by is added to `divisors`.   Requires rows that are independent there.
[[nodiscard]] std::optional<std::vector<MFraction>>
combination(const InvariantManifold& m, const Matrix& rows, const std::vector<MFraction>& target,
            std::vector<MPoly>& divisors);

/// The gradient of f on the manifold.
[[nodiscard]] std::vector<MFraction>
restricted_gradient(const VectorField& v, const InvariantManifold& m, const MFraction& f);

/// The full variational equations, in the order of the coordinates.
[[nodiscard]] LinearSystem variational_equations(const VectorField& v, const InvariantManifold& m);

/// Indices of the strongly connected blocks, ordered so that a block uses only itself and earlier
/// ones; inside a block ascending.
[[nodiscard]] std::vector<std::vector<std::size_t>> blocks(const LinearSystem& s,
                                                           const InvariantManifold& m);

/// The unknowns outside of the block that it uses, directly or through others; ascending.
[[nodiscard]] std::vector<std::size_t> used_by(const LinearSystem& s, const InvariantManifold& m,
                                               const std::vector<std::size_t>& block);

/// A linear first integral sum_i c_i y_i of a linear system.
struct LinearIntegral {
  std::string name; ///< of the first integral that it comes from
  std::vector<MFraction> coefficients;
  bool casimir = false; ///< its level is the tangent space of the symplectic leaves
};

struct NormalSystem {
  LinearSystem system;
  std::vector<std::size_t> equations;    ///< which equations of the manifold y belongs to
  std::vector<LinearIntegral> integrals; ///< of the normal part
  std::vector<MPoly> divisors;           ///< must be units of the function field (checked later)
};

/// Requires a manifold that prove_invariant returned.
[[nodiscard]] NormalSystem normal_system(const VectorField& v, const InvariantManifold& m,
                                         const std::vector<SystemClaim>& proved_integrals);

/// One use of a linear integral: the unknown taken away, on the zero level.
struct Elimination {
  std::string integral;
  std::string unknown;
  bool casimir = false;
};

struct ReducedSystem {
  LinearSystem system;
  std::vector<Elimination> eliminations;
  std::vector<MPoly> divisors;
};

/// Uses every linear integral, one after the other; `keep` names unknowns not to eliminate.
[[nodiscard]] ReducedSystem reduce_by_integrals(const VectorField& v, const InvariantManifold& m,
                                                const NormalSystem& n,
                                                const std::vector<std::string>& keep);

/// y'' + a1 y' + a0 y = 0 for a combination y of the unknowns of a block of order 2 (cyclic vector).
struct NormalVariationalEquation {
  std::string unknown;                                    ///< "M1", or "L1*M1 + L3*M3"
  std::vector<std::pair<std::string, MPoly>> combination; ///< the unknowns with their coefficients
  MFraction a1, a0;                                       ///< functions on the manifold
  std::vector<MPoly> divisors;
};

/// Unset when that unknown is not a cyclic vector (the other one does not occur in its derivative).
[[nodiscard]] std::optional<NormalVariationalEquation>
scalar_equation(const VectorField& v, const InvariantManifold& m, const LinearSystem& s,
                const std::vector<std::size_t>& block, std::size_t unknown);

/// The same for c1 y1 + c2 y2, y1 and y2 the unknowns of the block; c polynomials in the parameters.
[[nodiscard]] std::optional<NormalVariationalEquation>
scalar_equation(const VectorField& v, const InvariantManifold& m, const LinearSystem& s,
                const std::vector<std::size_t>& block, const std::array<MPoly, 2>& c);

} // namespace kov
