#pragma once
// Ideals of k[x1, ..., xm] over k = Q(the other variables of the ring), by Gröbner bases.
//
// Which variables are "main" is chosen per ideal; the others (parameters, the new independent
// variable) are generic, that is, elements of the coefficient field.  What is proved over
// Q(parameters) holds for all parameter values at which none of inverted() vanishes.
//
//   membership         f in I                        normal form 0
//   saturation         I : (g1 g2 ...)^infinity      one more variable t with t g1 g2 ... = 1,
//                                                    and an order that eliminates t
//   vanishing          f = 0 on V(I)                 1 in I + (1 - t f)
//
// Source  [CoxLittleOShea2007] 2.6-2.9 (Buchberger's algorithm and its criteria), 4.2, 4.4, 5.3

#include "exact/work.hpp"

#include <cstdint>
#include <map>
#include <vector>

namespace kov {

/// Exponents of the main variables, in their order.
using Monomial = std::vector<std::uint32_t>;

/// Graded reverse lexicographic, after the degree in the last `eliminate` entries; descending, so
/// that the leading term of a polynomial stands first.
struct MonomialOrder {
  std::size_t eliminate = 0;
  [[nodiscard]] bool operator()(const Monomial& a, const Monomial& b) const;
};

/// A polynomial in the main variables with coefficients in k.
using KPoly = std::map<Monomial, MFraction, MonomialOrder>;

/// An ideal with its reduced Groebner basis.
///
/// Given   const Ring ring = make_ring({"x", "y", "a"});
/// Given   const MPoly x = MPoly::variable(ring, "x"), y = MPoly::variable(ring, "y");
/// Given   const MPoly a = MPoly::variable(ring, "a");
/// Example Ideal(ring, {0, 1}, {x*x + y*y - a, x - y}).normal_form(x*x)  // -> a/2
/// Example Ideal(ring, {0, 1}, {x*x}).contains(x)  // -> no
/// Example Ideal(ring, {0, 1}, {x*x}).vanishes(x)  // -> yes
class Ideal {
public:
  /// The ideal of `generators`, saturated by the product of `nonzero`.  Every search in it, now and
  /// later, obeys the budget.
  /// Errors  InvalidArgument if a main variable is repeated; OutOfBudget
  Ideal(Ring ring, std::vector<std::size_t> main, const std::vector<MPoly>& generators,
        const std::vector<MPoly>& nonzero = {}, const Budget& budget = {});

  [[nodiscard]] const Ring& ring() const noexcept { return ring_; }
  [[nodiscard]] const std::vector<std::size_t>& main() const noexcept { return main_; }
  [[nodiscard]] const Budget& budget() const noexcept { return budget_; }
  [[nodiscard]] const std::vector<KPoly>& basis() const noexcept { return basis_; }
  [[nodiscard]] bool is_zero_ideal() const noexcept { return basis_.empty(); }
  [[nodiscard]] bool is_unit() const; ///< 1 in I: the variety is empty

  /// The remainder of f; zero exactly when f is in I.  f may have denominators without main
  /// variables.
  [[nodiscard]] KPoly reduce(const MFraction& f) const;
  [[nodiscard]] bool contains(const MPoly& f) const;
  /// The remainder as one rational function (its denominator has no main variables).
  [[nodiscard]] MFraction normal_form(const MFraction& f) const;
  /// f = 0 at every point of V(I) (radical membership).
  /// Cost  membership first; then one fibre over a random point of a largest independent set of
  ///       variables, which usually decides "no"; the general test last
  [[nodiscard]] bool vanishes(const MPoly& f) const;

  /// Dimension of V(I) over the algebraic closure of k; -1 if it is empty.
  [[nodiscard]] int dimension() const;
  /// A largest set of main variables that is algebraically independent modulo I.
  [[nodiscard]] std::vector<std::size_t> independent_variables() const;
  /// The monomials outside the leading ideal, ascending.  Requires dimension() == 0.
  /// Errors  OutOfBudget
  [[nodiscard]] std::vector<Monomial> standard_monomials() const;

  /// The elements of k that were inverted on the way: polynomials in the parameters, irreducible,
  /// sorted.
  [[nodiscard]] const std::vector<MPoly>& inverted() const noexcept { return inverted_; }

  [[nodiscard]] KPoly to_kpoly(const MFraction& f) const; ///< Requires a denominator in k.
  [[nodiscard]] MFraction from_kpoly(const KPoly& f) const;

private:
  void note_inverted(const MFraction& c);
  [[nodiscard]] bool nonzero_on_a_fibre(const MFraction& f) const;
  [[nodiscard]] KPoly divide(KPoly f, Work& work) const;
  void buchberger(std::vector<KPoly> generators);
  void minimise(Work& work);
  [[nodiscard]] Monomial one() const;

  Ring ring_;
  std::vector<std::size_t> main_;
  Budget budget_;
  std::size_t extra_ = 0; ///< 1 while the variable t of the saturation is present
  std::vector<KPoly> basis_;
  std::vector<MPoly> inverted_;
};

} // namespace kov
