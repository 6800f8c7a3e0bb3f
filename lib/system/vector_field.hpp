#pragma once
// A rational vector field with function symbols, exactly.
//
//   phase variables x_1..x_n with x_i' = X_i;
//   function symbols s (sin q, exp(t), a square root, ...): only their gradient and the algebraic
//   relations between them are known, and that is all that is used;
//   algebraic constants c: derivative 0, relations as for functions;
//   parameters: free.
//
// d_j f = df/dx_j + sum_s (df/ds)(ds/dx_j) is the derivative of f as a function on phase space.

#include "exact/ideal.hpp"
#include "exact/multivariate.hpp"

#include <optional>
#include <string>
#include <vector>

namespace kov {

/// A variable that stands for a function of the phase variables.
struct FunctionSymbol {
  std::size_t variable = 0;
  std::string meaning;             ///< "sin(q1)", for messages
  std::vector<MFraction> gradient; ///< ds/dx_j, in the order of the coordinates
  std::string function = {};       ///< "sin", if it is known which function it is,
  MFraction argument = {};         ///< and of what
};

using Matrix = std::vector<std::vector<MFraction>>;

/// left = right, kept as its difference and its text.
struct Equation {
  MFraction difference;
  std::string text;
};

/// x_j' = X_j with what is known of the functions in X.
struct VectorField {
  Ring ring;
  std::vector<std::size_t> coordinates; ///< phase variables
  std::vector<std::size_t> parameters;
  std::vector<std::size_t> constants; ///< algebraic constants
  std::vector<FunctionSymbol> functions;
  std::vector<MPoly> relations;      ///< between functions and constants; vanish identically
  std::vector<MFraction> components; ///< X_j, in the order of the coordinates
  std::optional<MFraction> hamiltonian;
  std::optional<Matrix> poisson; ///< {x_i, x_j}

  [[nodiscard]] const std::string& name(std::size_t j) const { return ring->name(coordinates[j]); }
  [[nodiscard]] std::size_t dimension() const noexcept { return coordinates.size(); }
  /// Coordinates, functions and constants.
  [[nodiscard]] std::vector<std::size_t> main_variables() const;
};

/// d_j f.
[[nodiscard]] MFraction partial(const VectorField& v, const MFraction& f, std::size_t j);
[[nodiscard]] std::vector<MFraction> gradient(const VectorField& v, const MFraction& f);
/// X(f) = sum_j X_j d_j f.
/// Given   const Ring ring = make_ring({"q", "p"});
/// Given   const MFraction q = MFraction::variable(ring, "q"), p = MFraction::variable(ring, "p");
/// Given   VectorField circle; circle.ring = ring, circle.coordinates = {0, 1};
/// Given   circle.components = {p, -q}, circle.poisson = canonical_structure(ring, 1);
/// Example lie_derivative(circle, q * q + p * p)  // -> 0
[[nodiscard]] MFraction lie_derivative(const VectorField& v, const MFraction& f);
/// The polynomials that must not vanish for the field, its functions and its Hamiltonian to be defined.
/// Example denominators(circle).empty()  // -> yes
[[nodiscard]] std::vector<MPoly> denominators(const VectorField& v);
/// {f, g} = grad f . J grad g.  Requires v.poisson.
/// Example poisson_bracket(circle, q, p)  // -> 1
[[nodiscard]] MFraction poisson_bracket(const VectorField& v, const MFraction& f,
                                        const MFraction& g);
/// J grad h.
[[nodiscard]] std::vector<MFraction> hamiltonian_field(const VectorField& v, const Matrix& j,
                                                       const MFraction& h);

/// Canonical: (q, p) with q' = dH/dp.  Shape: 2n x 2n.
[[nodiscard]] Matrix canonical_structure(const Ring& ring, std::size_t degrees_of_freedom);
/// Lie-Poisson on e(3)*: {M_i, M_j} = -eps_ijk (M_k - B_k), {M_i, G_j} = -eps_ijk G_k.
/// Shape  6 x 6 in the order M1 M2 M3 G1 G2 G3; gyrostat: B, length 3
/// Source [PrzybylskaMaciejewski2024] eq. (Poisson) and the gyrostat of its last section
[[nodiscard]] Matrix e3_structure(const Ring& ring, const std::vector<std::size_t>& coordinates,
                                  const std::vector<MFraction>& gyrostat);
/// Antisymmetry and the Jacobi identity; returns the first failing entry as text, or nothing.
[[nodiscard]] std::optional<std::string> structure_failure(const VectorField& v, const Matrix& j,
                                                           const Ideal& relations);

/// The Legendre transformation of a Lagrangian on a Lie group that is quadratic in the velocities:
/// M = dL/dOmega solved for Omega, H = M . Omega - L.
/// Shape   momenta, velocities: equal length, variables of the ring
/// Errors  DomainError when dL/dOmega is not linear in Omega or degenerate
struct Legendre {
  std::vector<MFraction> velocities; ///< Omega(M, Gamma)
  MFraction hamiltonian;
};
[[nodiscard]] Legendre legendre(const MFraction& lagrangian,
                                const std::vector<std::size_t>& velocities,
                                const std::vector<std::size_t>& momenta);

/// The ideal of the relations and of `more`.  Its main variables are those on which something
/// depends: the field, the relations, the gradients of the functions, or the arguments.  A
/// coordinate on which nothing depends (an angle that occurs through its sine and cosine only, a
/// cyclic coordinate) is left out, so that an algebraic curve stays one.
[[nodiscard]] Ideal relation_ideal(const VectorField& v, const std::vector<MPoly>& more = {},
                                   const std::vector<MPoly>& nonzero = {},
                                   const Budget& budget = {});
/// f = 0 modulo the ideal, where f is defined; decides by its numerator.
[[nodiscard]] bool is_zero_modulo(const MFraction& f, const Ideal& ideal);

/// f is in the ideal, or is where its denominator is inverted.  For f = X(g) and the generators g
/// this makes V(I) invariant; for a radical ideal it is the same as vanishes_on.
[[nodiscard]] bool is_in(const MFraction& f, const Ideal& ideal);
/// f = 0 at every point of V(I) where its denominator is not 0.  For f = X(g) this does not make
/// V(I) invariant: g = x^2 and x' = 1.
[[nodiscard]] bool vanishes_on(const MFraction& f, const Ideal& ideal);
/// A denominator of the field, or of the derivative of a function along it, that vanishes on V(I).
[[nodiscard]] std::optional<MPoly> pole_along(const VectorField& v, const Ideal& ideal);
/// The product of the irreducible factors, each once; 1 for a constant.  Requires f != 0.
/// Example squarefree_part((q * q * p).num())  // -> q*p
[[nodiscard]] MPoly squarefree_part(const MPoly& f);
/// The numerators of left - right, without multiple factors: the same set.
[[nodiscard]] std::vector<MPoly> set_generators(const std::vector<Equation>& equations);

} // namespace kov
