#pragma once
// First-order systems Y' = A(z) Y over K(z), row by row over a common denominator:
//
//   den_i(z) Y_i' = sum_j num_ij(z) Y_j.
//
// A row of its own denominator keeps the companion form of a scalar equation as cheap as the
// equation: its first row is y0' = y1.

#include "exact/rational_function.hpp"

#include <vector>

namespace kov::monodromy {

struct Row {
  Poly den;              ///< integral over Z[generator]
  std::vector<Poly> num; ///< likewise
};

struct DifferentialSystem {
  Field field;
  std::vector<Row> rows;

  [[nodiscard]] long size() const noexcept { return static_cast<long>(rows.size()); }
};

inline constexpr long largest_size = 8;

/// Errors  InvalidArgument: not square, empty, larger than `largest`
[[nodiscard]] DifferentialSystem make_system(const std::vector<std::vector<RationalFunction>>& a,
                                             std::size_t largest = largest_size);
/// y'' + p y' + q y = 0 for the vector (y, y').
[[nodiscard]] DifferentialSystem companion(const RationalFunction& p, const RationalFunction& q);
/// An entry of A.
[[nodiscard]] RationalFunction entry(const DifferentialSystem& s, std::size_t i, std::size_t j);
/// The strongly connected parts of "Y_i' uses Y_j": A is block triangular, and these are its
/// diagonal blocks.  Ascending inside a part.
[[nodiscard]] std::vector<std::vector<std::size_t>> diagonal_blocks(const DifferentialSystem& s);
/// The least common denominator of A, monic.
[[nodiscard]] Poly common_denominator(const DifferentialSystem& s);
/// The trace of A.
[[nodiscard]] RationalFunction trace(const DifferentialSystem& s);

} // namespace kov::monodromy
