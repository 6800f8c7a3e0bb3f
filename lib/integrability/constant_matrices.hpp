#pragma once
// Matrices of constants, over the parameters, that commute with a block of a linear system.

#include "integrability/study.hpp"
#include "system/relations.hpp"

#include <map>

namespace kov {

[[nodiscard]] Matrix zeros(const Ring& ring, std::size_t n);
[[nodiscard]] Matrix identity(const Ring& ring, std::size_t n);
[[nodiscard]] Matrix product(const Matrix& a, const Matrix& b);
[[nodiscard]] Matrix sum(Matrix a, const MFraction& f, const Matrix& b); ///< a + f b
[[nodiscard]] std::vector<MFraction> times(const std::vector<MFraction>& row, const Matrix& t);

/// Coefficients of the minimal polynomial, ascending, the last one 1.
/// Given   const Ring ring = make_ring({"a"});
/// Given   const MFraction a = MFraction::variable(ring, "a"), one(ring, Rational(1)), none(ring);
/// Example minimal_polynomial({{none, one}, {a, none}}, {})  // -> {-a, 0, 1}
/// Example minimal_polynomial({{a, none}, {none, a}}, {})  // -> {-a, 1}
[[nodiscard]] std::vector<MFraction> minimal_polynomial(const Matrix& t, const Budget& budget);
[[nodiscard]] Matrix value(const std::vector<MFraction>& polynomial, const Matrix& t);
/// The irreducible factors over the parameters, each with its multiplicity; coefficients ascending.
[[nodiscard]] std::vector<std::pair<std::vector<MFraction>, long>>
factors_of(const std::vector<MFraction>& polynomial);
/// A basis of the rows l with l m = 0.
[[nodiscard]] Matrix row_kernel(const Matrix& m, const Budget& budget);

/// The rows of constants for a block y' = C y of a linear system: over K = Q(parameters), or over
/// K(kappa) where the system has one algebraic constant, of degree 2.  They are written as rows over
/// K, (l_0, l_1) for l_0 + kappa l_1.
class ConstantRows {
public:
  ConstantRows(const System& s, const LinearSystem& linear, const InvariantManifold& m,
               const std::vector<std::size_t>& block);

  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] std::size_t width() const noexcept { return constant_ ? 2 * size_ : size_; }
  [[nodiscard]] const Ring& ring() const noexcept { return ring_; }
  /// A basis, over K, of the matrices T of constants with T C = C T, as they map these rows: C
  /// without denominators is a sum of monomials, independent on the manifold, with constant matrices.
  /// Cost    size * width linear unknowns
  [[nodiscard]] std::vector<Matrix> commutant(const Budget& budget) const;
  /// l_0 + kappa l_1, in the ring of the entries.
  [[nodiscard]] std::vector<MFraction> row(const std::vector<MFraction>& pair) const;
  /// Over K(kappa).
  [[nodiscard]] bool independent(const Matrix& rows, const Budget& budget) const;
  /// The rows that are independent of the ones before; at most as many as there are.
  [[nodiscard]] Matrix basis(const Matrix& rows, const Budget& budget) const;

private:
  struct Parts {
    Matrix plain, times_constant; ///< of C, and of kappa C
  };
  [[nodiscard]] Matrix with_multiples(const Matrix& rows) const;
  [[nodiscard]] Matrix matrix(const Matrix& t0, const Matrix& t1) const;

  std::size_t size_;
  Ring ring_;
  std::optional<QuadraticConstant> constant_;
  std::map<Monomial, Parts> parts_;
};

/// These, and some combinations of them.
[[nodiscard]] std::vector<Matrix> with_combinations(std::vector<Matrix> commuting);

/// In blocks with more members nothing is looked for.
inline constexpr std::size_t largest_decoupled = 8;

/// Combinations of the equations of a block stand for them: one row of coefficients for each.
void replace_equations(ManifoldSpec& m, const NormalSystem& normal,
                       const std::vector<std::size_t>& block, const Matrix& rows);

} // namespace kov
