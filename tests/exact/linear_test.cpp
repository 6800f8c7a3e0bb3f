#include "exact/linear.hpp"

#include "exact/fields.hpp"
#include "exact/modular.hpp"
#include "exact/nmod_matrix.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

using namespace testing;
using Vector = std::vector<NfElem>;
using Rows = std::vector<Vector>;

class LinearEquations : public OverFields {
protected:
  // A product of two factors: of rank `rank` at most, and often of that.
  [[nodiscard]] Rows matrix(std::size_t rows, std::size_t columns, std::size_t rank) {
    Rows left(rows), right(rank), all(rows, Vector(columns, NfElem(k)));
    for (Vector& row : left)
      for (std::size_t j = 0; j < rank; ++j)
        row.push_back(entry());
    for (Vector& row : right)
      for (std::size_t j = 0; j < columns; ++j)
        row.push_back(entry());
    for (std::size_t i = 0; i < rows; ++i)
      for (std::size_t l = 0; l < rank; ++l)
        for (std::size_t j = 0; j < columns; ++j)
          all[i][j] += left[i][l] * right[l][j];
    return all;
  }
  [[nodiscard]] NfElem entry() { return number(0, 2) == 0 ? NfElem(k) : element(); }
  static Vector times(const Rows& m, const Vector& x) {
    Vector all;
    for (const Vector& row : m) {
      NfElem sum(0);
      for (std::size_t j = 0; j < x.size(); ++j)
        sum += row[j] * x[j];
      all.push_back(sum);
    }
    return all;
  }
  static bool all_zero(const Vector& v) {
    return std::ranges::all_of(v, [](const NfElem& x) { return is_zero(x); });
  }
  static std::size_t rank(Rows m, std::size_t columns) {
    return row_reduce(m, std::views::iota(std::size_t{0}, columns)).size();
  }
};

TEST_P(LinearEquations, APivotStandsAloneInItsColumn) {
  for (int round = 0; round < 20; ++round) {
    Rows m = matrix(4, 5, static_cast<std::size_t>(number(0, 4)));
    const std::vector<std::size_t> order{3, 0, 4, 1}; // not column 2
    const auto pivots = row_reduce(m, order);
    for (std::size_t i = 0; i < m.size(); ++i)
      for (std::size_t p = 0; p < pivots.size(); ++p)
        EXPECT_EQ(m[i][pivots[p]], NfElem(i == p ? 1 : 0));
    for (std::size_t i = pivots.size(); i < m.size(); ++i)
      for (const std::size_t c : order)
        EXPECT_TRUE(is_zero(m[i][c]));
    auto next = order.begin(); // the pivots are in the order that was asked for
    for (const std::size_t p : pivots) {
      next = std::find(next, order.end(), p);
      EXPECT_NE(next, order.end());
    }
  }
}

TEST_P(LinearEquations, TheKernelIsAllOfIt) {
  for (int round = 0; round < 20; ++round) {
    const Rows m = matrix(4, 6, static_cast<std::size_t>(number(0, 4)));
    const Rows basis = kernel(m, 6, NfElem(1));
    EXPECT_EQ(basis.size() + rank(m, 6), 6U);
    EXPECT_EQ(rank(basis, 6), basis.size());
    for (const Vector& x : basis)
      EXPECT_TRUE(all_zero(times(m, x)));
  }
}

TEST_P(LinearEquations, ASolutionSolvesAndNoneMeansNone) {
  for (int round = 0; round < 20; ++round) {
    const Rows m = matrix(4, 3, static_cast<std::size_t>(number(1, 3)));
    Vector right = number(0, 1) == 0 ? times(m, {entry(), entry(), entry()})
                                     : Vector{entry(), entry(), entry(), entry()};
    Rows whole = m;
    for (std::size_t i = 0; i < m.size(); ++i)
      whole[i].push_back(right[i]);
    const auto x = solution(whole, 3);
    EXPECT_EQ(x.has_value(), rank(whole, 4) == rank(m, 3));
    if (x) {
      EXPECT_EQ(times(m, *x), right);
    }
  }
}

// Modulo a prime the kernel is as large, but for a few primes.
TEST_P(LinearEquations, ModuloAPrimeTheyAreTheSame) {
  const PrimeIdeal prime = PrimeIdeals::large(k).next();
  for (int round = 0; round < 10; ++round) {
    const Rows m = matrix(5, 4, static_cast<std::size_t>(number(0, 4)));
    NmodMatrix modulo(5, 4, prime.p);
    ASSERT_TRUE(modulo.fill([&](std::size_t i, std::size_t j) { return prime.reduce(m[i][j]); }));
    EXPECT_EQ(modulo.kernel().size(), kernel(m, 4, NfElem(1)).size());
    EXPECT_EQ(modulo.has_independent_columns(), rank(m, 4) == 4);
    Rows reduced = m;
    EXPECT_EQ(modulo.row_reduce(), row_reduce(reduced, std::views::iota(std::size_t{0}, 4UL)));
    for (std::size_t i = 0; i < 5; ++i)
      for (std::size_t j = 0; j < 4; ++j)
        EXPECT_EQ(modulo(i, j), prime.reduce(reduced[i][j]));
  }
}
KOV_OVER_ALL_FIELDS(LinearEquations);

/// Rational numbers modulo nothing, of which only integers are taken for pivots: 3 before 2.
struct LargestInteger : FieldArithmetic<Rational> {
  static bool is_unit(const Rational& x) { return !is_zero(x) && is_integer(x); }
  static long cost(const Rational& x) { return -to_long(x.num()); }
};

TEST(LinearArithmetic, ChoosesThePivots) {
  std::vector<std::vector<Rational>> rows{{Rational(1, 2), 1}, {2, 5}, {3, 6}};
  EXPECT_TRUE(bring_pivot(rows, 0, 0, LargestInteger{}));
  EXPECT_EQ(rows[0][0], Rational(3));
  clear_column(rows, 0, 0, LargestInteger{}, 2); // the row in between stays
  EXPECT_EQ(rows[0], (std::vector<Rational>{1, 2}));
  EXPECT_EQ(rows[1], (std::vector<Rational>{2, 5}));
  EXPECT_EQ(rows[2], (std::vector<Rational>{0, 0}));
  std::vector<std::vector<Rational>> halves{{Rational(1, 2)}};
  EXPECT_FALSE(bring_pivot(halves, 0, 0, LargestInteger{}));
  EXPECT_TRUE(row_reduce(halves, std::vector<std::size_t>{0}, {}, LargestInteger{}).empty());
}

TEST(LinearEmpty, HasTheWholeKernel) {
  using Matrix = std::vector<std::vector<Rational>>;
  EXPECT_EQ(kernel(Matrix{}, 2, Rational(1)), (Matrix{{1, 0}, {0, 1}}));
  EXPECT_EQ(kernel(Matrix{{1}}, 1, Rational(1)), Matrix{});
  EXPECT_EQ(solution(Matrix{}, 2), (std::vector<Rational>{0, 0}));
  EXPECT_EQ(NmodMatrix(0, 3, 2).kernel().size(), 3U);
  EXPECT_TRUE(NmodMatrix(0, 3, 2).row_reduce().empty());
  EXPECT_TRUE(NmodMatrix(2, 0, 7).has_independent_columns());
}

TEST(NmodMatrices, AnUnsetEntryEndsIt) {
  NmodMatrix m(2, 2, 7);
  EXPECT_FALSE(m.fill([](std::size_t i, std::size_t j) {
    return i + j < 2 ? std::optional<mp_limb_t>(3) : std::nullopt;
  }));
}

} // namespace
} // namespace kov
