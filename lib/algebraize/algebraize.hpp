#pragma once
// From y'' + a1(t) y' + a0(t) y = 0 along a phase curve to an equation over Q(parameters)(z).
//
//   p = (z'' + a1 z')/z'^2,   q = a0/z'^2,   r = p^2/4 + p_z/2 - q
//
// r may be a function of z alone where p and q are not: the factor exp(-1/2 int p) that leads to
// y_zz = r y multiplies the group by scalars only, so that r decides.
//
// Source  [MoralesRuiz1999] 4; [AcostaBlazquez2008] (Hamiltonian algebrization); docs/theory/mechanics.md (6)

#include "algebraize/function_field.hpp"
#include "variation/normal.hpp"

namespace kov {

struct AlgebraicOde {
  std::string unknown; ///< whose variation
  std::string change;  ///< text of phi
  MFraction phi;
  std::shared_ptr<const FunctionField> field; ///< in which p, q and r were computed
  std::size_t z = 0;                          ///< the variable of the ring
  std::optional<MFraction> z_dot_squared, z_ddot;
  std::optional<MFraction> p, q; ///< unset where only r is a function of z
  MFraction r;
  std::size_t field_degree = 1;    ///< [function field of the curve : K(z)]
  std::vector<std::string> checks; ///< the hypotheses, as checked
  std::vector<MPoly> generic;      ///< polynomials in the parameters assumed not 0
  std::vector<MPoly> divided_by;   ///< functions on the curve: where one vanishes nothing is said
  long singular_places = 0;        ///< finite poles of r, with multiplicity of conjugates
};

/// field: of the curve.  If r is not a function of z, a change for which it is one is looked for if the caller has
/// none yet: that costs more than all else here.
[[nodiscard]] std::variant<AlgebraicOde, ChangeFailure>
algebraize(std::shared_ptr<const FunctionField> field, std::size_t z, const MFraction& phi,
           const NormalVariationalEquation& e, bool look_for_better = true);

/// Changes of variable worth trying, simplest first: coordinates and functions that are not
/// constant on the curve, their squares, half-angles x/(1+y) where x^2 + y^2 = 1, quotients.
[[nodiscard]] std::vector<MFraction> propose_changes(const VectorField& v,
                                                     const InvariantManifold& m);

/// Degree in z of the squarefree part of the denominator.
[[nodiscard]] long finite_singularities(const MFraction& r, std::size_t z);

} // namespace kov
