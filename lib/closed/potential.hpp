#pragma once
// Homogeneous potentials: V of degree k (an integer, not 0), a Darboux point c with V'(c) = c, and
// an eigenvalue lambda of V''(c).  Along the solution q = phi(t) c, phi'^2 = (2/k)(1 - phi^k), the
// variation in an eigendirection satisfies xi'' = -lambda phi^(k-2) xi; in z = phi^k it is
// Riemann's equation with exponent differences
//
//   1/k at z = 0,   1/2 at z = 1,   nu = sqrt((k-2)^2 + 8 k lambda)/(2k) at infinity,
//
// so that the eigenvalues with an abelian identity component are read off abelian_third_exponents:
// the table of Morales-Ruiz and Ramis (2001), which they typed from Kimura's, is computed here.
//
// Source  [Yoshida1987], [MoralesRamis2001]; derived in docs/theory/kimura.md

#include "closed/kimura.hpp"
#include "closed/riemann.hpp"
#include "exact/rational_function.hpp"

#include <string>
#include <vector>

namespace kov {

/// lambda = c + (u + v p)^2/w for every integer p (nu = (u + v p)/(2k)).
struct EigenvalueFamily {
  Rational c, u, v, w;
  AbelianRiemann by;

  [[nodiscard]] Rational at(const Integer& p) const;
  /// Coefficients of p^2, p, 1.
  [[nodiscard]] std::vector<Rational> polynomial() const;
  [[nodiscard]] bool contains(const Rational& lambda) const;
};

/// All lambda with an abelian identity component, for one degree k.
struct EigenvalueTable {
  long k = 1;
  bool all = false; ///< every lambda (k = 2, -2)
  std::vector<EigenvalueFamily> families;
};
/// Requires k != 0; otherwise InvalidArgument.
/// Example eigenvalue_table(3).families.front().polynomial()  // -> {3/2, 1/2, 0}
/// Example eigenvalue_table(-2).all  // -> yes
/// Example eigenvalue_table(0).all  // -> throws InvalidArgument
[[nodiscard]] EigenvalueTable eigenvalue_table(long k);

/// l^2, m^2, n^2 of the equation for one lambda.
/// Example potential_exponents(3, 1)  // -> {1/9, 1/4, 25/36}
[[nodiscard]] SquaredExponents potential_exponents(long k, const NfElem& lambda);
/// The normal form of the variational equation in z, from its derivation, not from the exponents.
[[nodiscard]] RationalFunction potential_equation(long k, const NfElem& lambda);

} // namespace kov
