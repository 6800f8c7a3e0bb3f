#pragma once
// Changes of scale that carry a family of systems into itself.
//
//   x_i -> s^(w_i) x_i,   parameters p_j -> s^(v_j) p_j,   t -> s^e t,   {,} -> s^d {,}
//
// Source  docs/theory/moves.md (4)

#include "system/system.hpp"
#include "system/weights.hpp"

namespace kov {

/// Linear equations for the weights of the variables of a ring, then of the time and the bracket.
/// Given   const Ring plane = make_ring({"x", "y"});
/// Given   const MFraction x = MFraction::variable(plane, "x"), y = MFraction::variable(plane, "y");
/// Given   WeightEquations equations(plane);
/// Example equations.all().size()  // -> 4
/// Example equations.add_homogeneous(x*x + y); equations.all().size()  // -> 3
/// Example equations.add(x/y, {{equations.time(), 1}}); equations.all().size()  // -> 2
class WeightEquations {
public:
  explicit WeightEquations(Ring ring) : ring_(std::move(ring)) {}

  [[nodiscard]] std::size_t time() const { return ring_->size(); }
  [[nodiscard]] std::size_t bracket() const { return ring_->size() + 1; }

  /// The sum of these weights, with factors, is 0.
  void add_row(const Weights& row);
  /// All terms of the numerator have one weight, and all of the denominator.
  void add_homogeneous(const MFraction& f);
  /// The function is homogeneous, and of this weight.
  void add(const MFraction& f, const Weights& weight);

  /// A basis of the rational weights that satisfy them.
  [[nodiscard]] Matrix all() const;

private:
  Ring ring_;
  Matrix rows_;
};

/// A basis of the rational weights: of the variables of the ring, then of the time and of the bracket.
/// Algebraic constants have weight 0.
/// Given   const System quartic = read_system(parse_document("system = {kind = 'hamiltonian', "
///             "coordinates = ['x'], momenta = ['u'], parameters = ['a'], "
///             "hamiltonian = 'u^2/2 + a*x^4'}", "quartic.toml"));
/// Example scalings(quartic).size()  // -> 2
[[nodiscard]] Matrix scalings(const System& s);
/// Equations for these weights.
[[nodiscard]] WeightEquations weight_equations(const System& s);

} // namespace kov
