#pragma once
// Linear equations over a field: elimination by Gauss and Jordan.  Residues modulo a prime: exact/nmod_matrix.hpp.

#include "exact/budget.hpp"
#include "exact/lists.hpp"

#include <concepts>
#include <optional>
#include <ranges>
#include <utility>
#include <vector>

namespace kov {

template <class T>
concept HasInverse = requires(const T& x) {
  { inverse(x) } -> std::same_as<T>;
};

/// The arithmetic of an elimination by the operators of T.  Another struct with these members may
/// count its work, or compute modulo something.
template <class T> struct FieldArithmetic {
  [[nodiscard]] static bool is_unit(const T& x) { return !is_zero(x); }
  /// The first unit of least cost in a column is its pivot.
  [[nodiscard]] static long cost(const T&) { return 0; }
  static void divide(std::vector<T>& row, const T& by) {
    if constexpr (HasInverse<T>) {
      const T unit = inverse(by); // one division
      for (T& x : row)
        x = x * unit;
    } else {
      for (T& x : row)
        if (!is_zero(x)) x = x / by;
    }
  }
  /// x - factor y
  static void subtract(T& x, const T& factor, const T& y) { x = x - factor * y; }
};

/// Divides row r by its entry in column c, and subtracts it from the rows from `first` on so that
/// their entries there are 0.   Requires a unit there.
/// Given   std::vector<std::vector<Rational>> rows{{2, 4}, {3, 7}}; clear_column(rows, 0, 0);
/// Example rows  // -> {{1, 2}, {0, 1}}
template <class T, class Arithmetic = FieldArithmetic<T>>
void clear_column(std::vector<std::vector<T>>& rows, std::size_t r, std::size_t c,
                  const Arithmetic& a = {}, std::size_t first = 0) {
  a.divide(rows[r], T(rows[r][c]));
  for (std::size_t i = first; i < rows.size(); ++i) {
    if (i == r || is_zero(rows[i][c])) continue;
    const T factor = rows[i][c];
    for (std::size_t j = 0; j < rows[i].size(); ++j)
      if (!is_zero(rows[r][j])) a.subtract(rows[i][j], factor, rows[r][j]);
  }
}

/// Swaps a row with a unit in column c to the place r, from below; false: there is none.
template <class T, class Arithmetic = FieldArithmetic<T>>
bool bring_pivot(std::vector<std::vector<T>>& rows, std::size_t r, std::size_t c,
                 const Arithmetic& a = {}) {
  std::size_t best = rows.size();
  for (std::size_t i = r; i < rows.size(); ++i)
    if (a.is_unit(rows[i][c]) &&
        (best == rows.size() || a.cost(rows[i][c]) < a.cost(rows[best][c])))
      best = i;
  if (best == rows.size()) return false;
  std::swap(rows[r], rows[best]);
  return true;
}

/// Reduces the rows in these columns, one after the other.  Returns those with a pivot: the i-th
/// has 1 in row i and 0 elsewhere.  Below these rows all entries of the columns are 0.
/// Cost    rows * pivots * length   Errors  OutOfBudget
/// Given   std::vector<std::vector<Rational>> square{{0, 2}, {1, 3}};
/// Example row_reduce(square, std::vector<std::size_t>{0, 1})  // -> {0, 1}
/// Example square  // -> {{1, 0}, {0, 1}}
template <class T, class Columns, class Arithmetic = FieldArithmetic<T>>
std::vector<std::size_t> row_reduce(std::vector<std::vector<T>>& rows, const Columns& columns,
                                    const Budget& budget = {}, const Arithmetic& a = {}) {
  std::vector<std::size_t> pivots;
  for (const std::size_t c : columns) {
    if (pivots.size() == rows.size()) break;
    if (!bring_pivot(rows, pivots.size(), c, a)) continue;
    budget.check();
    clear_column(rows, pivots.size(), c, a);
    pivots.push_back(c);
  }
  return pivots;
}

/// A basis of the x with rows x = 0, each with 1 at a column of its own and 0 at those of the others.
/// Example kernel(std::vector<std::vector<Rational>>{{1, 2}, {2, 4}}, 2, Rational(1))  // -> {{-2, 1}}
/// Example kernel(std::vector<std::vector<Rational>>{{1, 2}, {2, 5}}, 2, Rational(1))  // -> {}
template <class T, class Arithmetic = FieldArithmetic<T>>
[[nodiscard]] std::vector<std::vector<T>>
kernel(std::vector<std::vector<T>> rows, std::size_t columns, const T& one,
       const Budget& budget = {}, const Arithmetic& a = {}) {
  const auto all = std::views::iota(std::size_t{0}, columns);
  const std::vector<std::size_t> pivots = row_reduce(rows, all, budget, a);
  std::vector<std::vector<T>> basis;
  for (const std::size_t free : all) {
    if (is_among(free, pivots)) continue;
    std::vector<T>& x = basis.emplace_back(columns, one - one);
    for (std::size_t i = 0; i < pivots.size(); ++i)
      x[pivots[i]] = -rows[i][free];
    x[free] = one;
  }
  return basis;
}

/// The x with rows x = right, 0 at free unknowns; unset: there is none.  The last entry of a row
/// is its right side, those before it are of the unknowns.
/// Example solution(std::vector<std::vector<Rational>>{{1, 2, 3}, {0, 2, 4}}, 2)  // -> {-1, 2}
/// Example solution(std::vector<std::vector<Rational>>{{1, 2, 3}, {1, 2, 4}}, 2)  // -> none
template <class T, class Arithmetic = FieldArithmetic<T>>
[[nodiscard]] std::optional<std::vector<T>>
solution(std::vector<std::vector<T>> rows, std::size_t unknowns, const Budget& budget = {},
         const Arithmetic& a = {}) {
  const auto pivots = row_reduce(rows, std::views::iota(std::size_t{0}, unknowns), budget, a);
  for (std::size_t i = pivots.size(); i < rows.size(); ++i)
    if (!is_zero(rows[i].back())) return std::nullopt;
  std::vector<T> x(unknowns);
  for (std::size_t i = 0; i < pivots.size(); ++i)
    x[pivots[i]] = rows[i].back();
  return x;
}

} // namespace kov
