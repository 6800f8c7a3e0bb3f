#pragma once
// A natural system of two degrees of freedom with an invariant plane of phase space:
//
//   x'' = f(x, y),   y'' = g(x, y),   f(0, y) = 0,
//
// y along the line on which the solutions of the plane run, x across it.  Their energy is free.

#include "manifold/invariant_manifold.hpp"

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace kov::jets {

/// Why something is not what this room is about.
enum class OutOfScope : std::uint8_t {
  several_constants,
  reducible_relation,
  related_coordinates,
  not_polynomial, ///< or not of two degrees of freedom
  not_natural,
  no_line,
  inertias_differ,
  isotropic_line,
  force_off_the_line,
  low_degree,
  irregular,
  exponents_with_parameters,
  exponents_irrational_or_equal,
  large_denominator,
  first_order_logarithm
};
/// As a clause.
/// Example to_string(OutOfScope::isotropic_line)  // -> the line is isotropic
[[nodiscard]] std::string to_string(OutOfScope why);

/// q = start + x across + y along.
struct LineOfConfigurations {
  std::array<MFraction, 2> start, across, along;
};

/// The equations of motion around the plane x = 0.
struct InvariantPlane {
  Ring ring; ///< that of the system, and the variables below
  std::size_t x = 0, y = 0;
  std::size_t e = 0;          ///< the free coefficient of the solution at a place
  std::size_t energy = 0;     ///< the value of H
  std::size_t c1 = 0, c2 = 0; ///< constants of the general solution of the normal equation
  MFraction across, along;    ///< f and g, polynomials in x and y
  LineOfConfigurations line;
  MFraction inertia;              ///< A in H = y'^2/(2 A) + potential, on the plane
  MFraction potential;            ///< V(0, y)
  std::optional<MFraction> level; ///< of H, where the file names one
  std::optional<Ideal> constants; ///< what an algebraic constant satisfies: a field extension
  std::optional<MPoly> relation;
  std::vector<MPoly> nonzero; ///< in the parameters: what was divided by

  /// f modulo the relation of the algebraic constant.
  [[nodiscard]] MFraction reduced(const MFraction& f) const;
  /// A polynomial that is not 0 only where f, a polynomial without x and y, is not 0 for any value
  /// of the algebraic constant: its norm.
  [[nodiscard]] MPoly norm(const MPoly& f) const;
  /// The same system with y replaced by -y.
  [[nodiscard]] InvariantPlane reflected() const;
};

/// The coefficients of f in x_i, ascending; empty for 0.  Requires a denominator without x_i.
[[nodiscard]] std::vector<MFraction> coefficients(const MFraction& f, std::size_t i);

/// 1/f modulo r, polynomials in x_i, by Euclid's algorithm.  Throws DomainError if there is none.
[[nodiscard]] MFraction inverse_modulo(const MFraction& f, const MFraction& r, std::size_t i);

/// H = (a p1^2 + b p2^2)/2 + V with constants a, b and a polynomial V, and a manifold with the
/// equation of a line q = a + s d, d.d != 0, of configurations (a coordinate axis, if a != b).
/// Invariance is verified once more: the force across the line vanishes on it.
[[nodiscard]] std::variant<InvariantPlane, OutOfScope> invariant_plane(const System& s,
                                                                       const ManifoldSpec& m);

} // namespace kov::jets
