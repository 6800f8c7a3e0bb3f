#pragma once
// R = k[x1, ..., xm]/I for an ideal I of dimension 0 over k = Q(the other variables).
//
// Elements are vectors of length dim R over k, in the basis of standard monomials.  If I is prime,
// R is a field; if not, R is a product of local rings and some elements are neither 0 nor
// invertible. A computation in R that divides by units only holds on every component of the
// variety, so that whoever works here asks invert() and handles its refusal.
//
// Source  [CoxLittleOShea2005] 2.4 (multiplication maps)

#include "exact/ideal.hpp"

#include <functional>
#include <optional>

namespace kov {

/// The algebra R with its multiplication.
///
/// Given   const Ring ring = make_ring({"x"});
/// Given   const MFraction x = MFraction::variable(ring, "x"), one(ring, 1), two(ring, 2);
/// Given   const FiniteAlgebra field(Ideal(ring, {0}, {(x*x - two).num()}));
/// Given   const FiniteAlgebra split(Ideal(ring, {0}, {(x*x - one).num()}));
/// Example field.lift(*field.invert(*field.evaluate(x + one)))  // -> x - 1
/// Example split.invert(*split.evaluate(x + one))  // -> none
/// Example field.minimal_polynomial(*field.evaluate(x + one))  // -> {-1, -2, 1}
class FiniteAlgebra {
public:
  using Element = std::vector<MFraction>;

  /// Requires I of dimension 0 and not the unit ideal; otherwise InvalidArgument.
  explicit FiniteAlgebra(Ideal ideal, long max_dimension = 200);

  [[nodiscard]] std::size_t dimension() const noexcept { return basis_.size(); }
  [[nodiscard]] const Ideal& ideal() const noexcept { return ideal_; }
  [[nodiscard]] const std::vector<Monomial>& basis() const noexcept { return basis_; }
  [[nodiscard]] const Ring& ring() const noexcept { return ideal_.ring(); }

  [[nodiscard]] Element zero() const;
  [[nodiscard]] Element constant(const MFraction& c) const; ///< c in k
  /// A rational function of the main variables.  Unset when its denominator is not a unit of R.
  [[nodiscard]] std::optional<Element> evaluate(const MFraction& f) const;
  [[nodiscard]] Element multiply(const Element& a, const Element& b) const;
  /// Unset when a is 0 or a zero divisor.
  [[nodiscard]] std::optional<Element> invert(const Element& a) const;
  /// The value in k, if the element is a constant.
  [[nodiscard]] std::optional<MFraction> in_base_field(const Element& a) const;
  /// The element written in the main variables.
  [[nodiscard]] MFraction lift(const Element& a) const;
  /// Coefficients of the minimal polynomial of a over k, ascending, monic; nothing if its degree is
  /// above `most`.
  /// Cost  the numbers grow fast with the degree: say `most` where a small one is meant
  [[nodiscard]] std::optional<std::vector<MFraction>> minimal_polynomial(const Element& a,
                                                                         std::size_t most) const;
  [[nodiscard]] std::vector<MFraction> minimal_polynomial(const Element& a) const {
    return *minimal_polynomial(a, dimension());
  }

private:
  [[nodiscard]] Element coordinates(const KPoly& f) const;
  [[nodiscard]] bool has_independent_powers(const Element& a, std::size_t most) const;
  [[nodiscard]] const Element& product_of_basis(std::size_t i, std::size_t j) const;

  Ideal ideal_;
  std::vector<Monomial> basis_; ///< ascending; basis_[0] = 1
  std::map<Monomial, std::size_t> place_;
  mutable std::vector<std::optional<Element>> table_;
};

// Coordinate by coordinate.  Requires elements of one algebra.
[[nodiscard]] FiniteAlgebra::Element operator+(const FiniteAlgebra::Element& a,
                                               const FiniteAlgebra::Element& b);
[[nodiscard]] FiniteAlgebra::Element operator-(const FiniteAlgebra::Element& a,
                                               const FiniteAlgebra::Element& b);
[[nodiscard]] FiniteAlgebra::Element scale(const FiniteAlgebra::Element& a, const MFraction& c);
[[nodiscard]] bool is_zero(const FiniteAlgebra::Element& a);

/// A solution x of the square or rectangular system m x = b over Q(x1, ..., xn); rows of equal
/// length. Unset if there is none.  Free unknowns are 0.   Errors  OutOfBudget
[[nodiscard]] std::optional<std::vector<MFraction>>
solve_linear(std::vector<std::vector<MFraction>> m, std::vector<MFraction> b,
             const Budget& budget = {});
/// A basis of {x : m x = 0} over the fractions of `ring`; a matrix without rows has `columns` too.
/// Cost    full rank is usually seen at one point modulo a prime, which proves it
/// Errors  OutOfBudget
[[nodiscard]] std::vector<std::vector<MFraction>> null_space(std::vector<std::vector<MFraction>> m,
                                                             std::size_t columns, const Ring& ring,
                                                             const Budget& budget = {});

/// Expands along the first row, without divisions: for small matrices.   Shape: square
/// Example determinant({{x, one}, {one, x}}, ring)  // -> x^2 - 1
/// Example determinant({}, ring)  // -> 1
[[nodiscard]] MFraction determinant(const std::vector<std::vector<MFraction>>& m, const Ring& ring);
/// Is one of the minors with all rows like this?  They are made one after the other.
/// Given   const auto is_one = [&](const MFraction& d) { return d == one; };
/// Example some_minor({{x, one}}, 2, ring, is_one)  // -> yes
[[nodiscard]] bool some_minor(const std::vector<std::vector<MFraction>>& rows, std::size_t columns,
                              const Ring& ring,
                              const std::function<bool(const MFraction&)>& is_like_this);

} // namespace kov
