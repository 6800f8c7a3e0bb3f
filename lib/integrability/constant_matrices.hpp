#pragma once
// Matrices of constants, over the parameters, that commute with a block of a linear system.

#include "integrability/study.hpp"

#include <map>

namespace kov {

[[nodiscard]] Matrix zeros(const Ring& ring, std::size_t n);
[[nodiscard]] Matrix identity(const Ring& ring, std::size_t n);
[[nodiscard]] Matrix product(const Matrix& a, const Matrix& b);
[[nodiscard]] Matrix sum(Matrix a, const MFraction& f, const Matrix& b); ///< a + f b

/// Coefficients of det(x - t), ascending.
/// Source  Faddeev and LeVerrier
[[nodiscard]] std::vector<MFraction> characteristic_polynomial(const Matrix& t);
[[nodiscard]] Matrix value(const std::vector<MFraction>& polynomial, const Matrix& t);
/// The irreducible factors over the parameters, each with its multiplicity; coefficients ascending.
[[nodiscard]] std::vector<std::pair<std::vector<MFraction>, long>>
factors_of(const std::vector<MFraction>& polynomial);
/// A basis of the rows l with l m = 0.
[[nodiscard]] Matrix row_kernel(const Matrix& m, const Budget& budget);

/// C without denominators, on the manifold, by monomials: the coefficients are constants.
[[nodiscard]] std::map<Monomial, Matrix> by_monomials(const LinearSystem& s,
                                                      const InvariantManifold& m,
                                                      const std::vector<std::size_t>& block);
/// A basis of the matrices T with T A = A T for all A, of size n.
/// Cost    n^2 linear unknowns
[[nodiscard]] std::vector<Matrix> commutant(const std::map<Monomial, Matrix>& all, std::size_t n,
                                            const Budget& budget);
/// These, and some combinations of them.
[[nodiscard]] std::vector<Matrix> with_combinations(std::vector<Matrix> commuting);

/// Of blocks with more members nothing is looked for.
inline constexpr std::size_t largest_decoupled = 8;

/// Combinations of the equations of a block stand for them: one row of coefficients for each.
void replace_equations(ManifoldSpec& m, const NormalSystem& normal,
                       const std::vector<std::size_t>& block, const Matrix& rows);

} // namespace kov
