#pragma once
// Darboux polynomials of a polynomial vector field, and what they give:
//
//   X(f) = K f                              f a Darboux polynomial, K its cofactor
//   sum l_i K_i + X(g/W) = 0                g/W + sum l_i log f_i is a first integral, W a product of some f_i
//   [X, N] = (sum n_i K_i) N                N/prod f_i^n_i commutes with X
//
// A rational field is multiplied by its denominator for the first two.
//
// Each of the last two is linear in what is unknown, and is solved at all parameter values of a set.
//
// Source  docs/theory/integrals.md (5), (6)

#include "integrals/ansatz.hpp"

namespace kov {

/// X(f) = K f for the parameters at which the equations hold.
struct DarbouxPolynomial {
  MPoly polynomial;
  MFraction cofactor;           ///< its denominator in the parameters
  std::vector<MPoly> equations; ///< between parameters; those that hold on the set are left out
};

/// A polynomial multiple of the field over a common denominator in the parameters: it has the same
/// first integrals, and Darboux polynomials with other cofactors.
struct PolynomialField {
  std::vector<MPoly> numerators;
  MPoly denominator;
  MPoly multiplier; ///< of the field; 1: it is polynomial itself
  long degree = 0;  ///< in the phase variables
};
/// Unset: the phase variables satisfy relations.
[[nodiscard]] std::optional<PolynomialField> polynomial_field(const PhaseSpace& p);

/// Some Darboux polynomials, irreducible over Q: coordinates, those of degree 1, and those of degree
/// 2 with cofactors of low degree.  Nothing is said of others.
[[nodiscard]] std::vector<DarbouxPolynomial> darboux_polynomials(const PhaseSpace& p,
                                                                 const PolynomialField& x,
                                                                 const Set& where,
                                                                 const Budget& budget = {});

/// Polynomials in the variables, from 1 up to a degree.
[[nodiscard]] std::vector<MPoly> monomials(const Ring& ring,
                                           const std::vector<std::size_t>& variables, long degree);

/// g/W + sum of l_i log f_i, W a product of some f_i with this cofactor: the columns are the f_i, then monomials for g
/// (without 1 where W = 1).
struct LogarithmicAnsatz {
  std::vector<DarbouxPolynomial> polynomials;
  std::vector<MPoly> monomials;
  MPoly below;
  MFraction cofactor;
};
[[nodiscard]] EchelonForm equations_of(const PhaseSpace& p, const PolynomialField& x,
                                       const LogarithmicAnsatz& ansatz);

/// Vector fields N/W: the columns are monomials for the first component of N, then for the second,
/// and so on.  Those that annihilate the functions with these gradients.
[[nodiscard]] EchelonForm commuting_fields(const PhaseSpace& p, const PolynomialField& x,
                                           const std::vector<MPoly>& monomials,
                                           const MFraction& cofactor_of_w,
                                           const std::vector<std::vector<MFraction>>& gradients,
                                           const Budget& budget = {});

/// [X, Y], from the definition.
[[nodiscard]] std::vector<MFraction>
commutator(const VectorField& v, const std::vector<MFraction>& x, const std::vector<MFraction>& y);

} // namespace kov
