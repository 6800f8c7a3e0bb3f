#pragma once
// Polynomials in the phase variables with unknown coefficients, and the linear equations that make
// them first integrals.
//
//   I = (sum of u_m m over monomials m) / W,   W a denominator that is fixed beforehand
//
// Function symbols count as phase variables, modulo their relations; algebraic constants count as
// parameters, with their relations as equations.
//
// Source  docs/theory/integrals.md (1)

#include "exact/lists.hpp"
#include "integrals/kernel.hpp"
#include "system/system.hpp"

namespace kov {

/// The least one.
[[nodiscard]] inline MPoly common_multiple(const MPoly& a, const MPoly& b) {
  return exact_div(a * b, gcd(a, b));
}

[[nodiscard]] MPoly common_denominator(const Ring& ring, const std::vector<MFraction>& all);
/// The functions times a common multiple of their denominators.
[[nodiscard]] std::vector<MPoly> numerators(const std::vector<MFraction>& all, const MPoly& den);

/// The variables of one system in their two roles, with what is divided by.
struct PhaseSpace {
  explicit PhaseSpace(const System& s, const Budget& budget = {});

  VectorField field;
  std::vector<std::size_t> variables; ///< coordinates and function symbols
  std::vector<bool> momentum; ///< is variables[i] a momentum?  none outside kind hamiltonian
  /// Is variables[i] a coordinate that occurs in nothing but function symbols, an angle?  No ansatz
  /// contains it.
  std::vector<bool> angle;
  std::vector<std::size_t> parameters;  ///< with the algebraic constants
  std::optional<Ideal> relations;       ///< those between phase variables
  std::vector<MPoly> equations;         ///< between parameters: relations of the system
  std::vector<MPoly> assumed_equations; ///< between parameters: assumptions of the file
  std::vector<MPoly> nonzero;           ///< in the parameters: what is assumed or divided by
  std::vector<MPoly> not_covered;       ///< those of `nonzero` that the file does not assume
  MPoly denominator; ///< of the Hamiltonian, or of the field, in the phase variables
  MPoly of_bracket;  ///< the same of the bracket alone: Casimir functions know nothing of H

  /// Some variables are momenta, so that the bracket has full rank.
  [[nodiscard]] bool is_canonical() const { return is_among(true, momentum); }
  [[nodiscard]] std::vector<std::size_t> momenta() const;
  /// Only parameters, the phase variables being free: a polynomial that is not 0 is a function that
  /// is not 0, so that absence in the ansatz is absence.
  [[nodiscard]] bool is_polynomial_ring() const { return field.functions.empty() && !relations; }
  /// f by monomials in the phase variables, reduced by the relations; up to a common factor that
  /// vanishes nowhere in `nonzero`, which `scale` receives.
  [[nodiscard]] std::map<std::vector<unsigned long>, MPoly> coefficients(const MPoly& f,
                                                                         MPoly* scale) const;
  /// f = 0 wherever it is defined, at all parameter values of the set.  f is reduced by the
  /// relations.
  [[nodiscard]] bool vanishes(const Set& where, const MFraction& f) const;
};

/// f as a polynomial in some of its variables: coefficients by exponents.
/// Given   const Ring ring = make_ring({"x", "a"});
/// Given   const MPoly x = MPoly::variable(ring, "x"), a = MPoly::variable(ring, "a");
/// Example by_monomials(a * x + x, {0}).at({1})  // -> a + 1
[[nodiscard]] std::map<std::vector<unsigned long>, MPoly>
by_monomials(const MPoly& f, const std::vector<std::size_t>& variables);

/// H = p^T G p/2 + a(q)·p + V(q) with a constant matrix G, in canonical coordinates.
struct NaturalHamiltonian {
  MPoly determinant;       ///< of G, up to a factor; the bounds below hold where it is not 0
  bool even = true;        ///< a = 0
  bool polynomial = false; ///< a and V are polynomials in q
  /// a and V are rational in q: twice what each layer below the highest one adds to the degree of
  /// the numerators (Theorems 2 and 3).  Computed for generic parameters: an upper bound for all.
  std::optional<long> twice_step = {};
};
[[nodiscard]] std::optional<NaturalHamiltonian> natural_hamiltonian(const PhaseSpace& p);

/// Which monomials the numerator may have.
struct AnsatzBounds {
  long degree = 0; ///< in the momenta; in all phase variables where there are none
  /// of the coefficients in the other variables; unset: by docs/theory/integrals.md, Theorems 2 and
  /// 3, which need a natural Hamiltonian with rational a and V
  std::optional<long> coefficients = {};
  /// For natural Hamiltonians: beside momenta of the highest degree only what Theorem 2 leaves,
  /// beside those of lower degrees the powers of the denominator that they need.
  bool layered = false;
  unsigned long power = 1; ///< of the denominator of a system without momenta
};

/// The columns of the linear problem.
struct Ansatz {
  std::vector<MPoly> numerators;
  MPoly denominator; ///< W
  /// Beside momenta of degree k the numerators contain this factor of W; empty: none do.
  std::vector<MPoly> layers = {};
  std::vector<MPoly> monomials = {}; ///< the numerators without it
  std::vector<long> powers = {};     ///< of the denominator of the system below them
  std::map<std::vector<unsigned long>, std::size_t> column; ///< of a monomial (variables only)
};
/// W: a power of the denominator of the system, without momenta this one.
[[nodiscard]] MPoly ansatz_denominator(const PhaseSpace& p, long degree, unsigned long power);
/// The degree of f in the phase variables; 0 for 0.
[[nodiscard]] long degree_of(const PhaseSpace& p, const MPoly& f);
/// The same in the momenta alone, where there are any.
[[nodiscard]] long degree_in_momenta(const PhaseSpace& p, const MPoly& f);
/// D X(f) for a field with denominator D, its numerators given on the variables.
[[nodiscard]] MPoly derived(const std::vector<std::size_t>& variables,
                            const std::vector<MPoly>& numerators, const MPoly& f);
/// Errors  OutOfBudget above 20000 unknowns, 4000 beside parameters
[[nodiscard]] Ansatz make_ansatz(const PhaseSpace& p, const AnsatzBounds& bounds,
                                 const std::optional<NaturalHamiltonian>& natural);

/// The equations X(I) = 0 for all fields in `fields` at the same time (one field for integrals, all
/// {x_j, .} for Casimirs).
[[nodiscard]] EchelonForm equations_of(const PhaseSpace& p, const Ansatz& ansatz,
                                       const std::vector<std::vector<MFraction>>& fields,
                                       const Budget& budget = {});

/// The coordinates of a function in the ansatz, up to a factor that vanishes nowhere; unset if it
/// lies outside.
[[nodiscard]] std::optional<SparseRow> coordinates(const PhaseSpace& p, const Ansatz& ansatz,
                                                   const MFraction& f);

} // namespace kov
