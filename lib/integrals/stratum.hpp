#pragma once
// A set of parameter values: some polynomials vanish there, and others vanish nowhere on it.
//
// Source  docs/theory/integrals.md (2)

#include "exact/ideal.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace kov {

/// A locally closed set of parameter values over the complex numbers.
///
/// Given   const Ring ring = make_ring({"a", "b"});
/// Given   const MPoly a = MPoly::variable(ring, "a"), b = MPoly::variable(ring, "b");
/// Given   const ParameterSet all(ring, {0, 1});
/// Example all.where_nonzero(a).is_nonzero(a*a)  // -> yes
/// Example all.where_zero(a*b).where_nonzero(a).restrict(b)  // -> 0
/// Example all.where_zero(a).where_nonzero(a).is_empty()  // -> yes
/// Example all.where_zero(a*a + b).where_zero(b).vanishes(a)  // -> yes
class ParameterSet {
public:
  ParameterSet(Ring ring, std::vector<std::size_t> parameters, Budget budget = {});

  /// All values of the same parameters.
  [[nodiscard]] ParameterSet plain() const { return {ring_, parameters_, budget_}; }
  /// The part where p vanishes, and the part where it does not.
  [[nodiscard]] ParameterSet where_zero(const MPoly& p) const;
  [[nodiscard]] ParameterSet where_nonzero(const MPoly& p) const;

  [[nodiscard]] bool is_empty() const;
  /// f as a function on the set; its denominator is an integer.  f in the parameters.
  [[nodiscard]] MFraction restrict(const MPoly& f) const;
  /// f vanishes at all points of the set.  f in the parameters.
  [[nodiscard]] bool vanishes(const MPoly& f) const;
  /// f vanishes at no point of the set.  f in the parameters.
  [[nodiscard]] bool is_nonzero(const MPoly& f) const;
  /// The irreducible factors of f that may vanish somewhere on the set.  Requires f != 0.
  [[nodiscard]] std::vector<MPoly> doubtful_factors(const MPoly& f) const;

  [[nodiscard]] const Ring& ring() const noexcept { return ring_; }
  [[nodiscard]] const std::vector<std::size_t>& parameters() const noexcept { return parameters_; }
  /// A Gröbner basis of the equations.
  [[nodiscard]] std::vector<MPoly> equations() const;
  [[nodiscard]] const std::vector<MPoly>& inequations() const noexcept { return nonzero_; }
  /// The inequations that say something beside the equations: not those that follow from these.
  [[nodiscard]] std::vector<MPoly> proper_inequations() const;

private:
  [[nodiscard]] bool irreducible_is_nonzero(const MPoly& f) const;
  [[nodiscard]] const std::vector<MPoly>& factors_of_inequations() const;
  /// Saturated by the inequations.
  [[nodiscard]] Ideal ideal_of(const std::vector<MPoly>& equations) const;
  void add_equation(MPoly p);
  void add_inequations(const std::vector<MPoly>& p);

  Ring ring_;
  std::vector<std::size_t> parameters_;
  Budget budget_;
  std::vector<MPoly> nonzero_;                ///< irreducible, each once
  std::optional<Ideal> ideal_;                ///< saturated by nonzero_; unset without equations
  mutable std::map<std::string, bool> known_; ///< what was asked before
  mutable std::optional<std::vector<MPoly>>
      factors_; ///< of the inequations, where the set is a graph
};

} // namespace kov
