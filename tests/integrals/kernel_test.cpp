// The dimension of the kernel of a matrix with parameters is right at every point.

#include "integrals/kernel.hpp"

#include "exact/finite_algebra.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace kov {
namespace {

const Ring ring = make_ring({"a", "b"});

MPoly value(const MPoly& f, long a, long b) {
  return substitute(f, {{0, MFraction(ring, Rational(a))}, {1, MFraction(ring, Rational(b))}})
      .num();
}

bool contains(const Set& s, long a, long b) {
  for (const MPoly& f : s.equations())
    if (!is_zero(value(f, a, b))) return false;
  for (const MPoly& f : s.inequations())
    if (is_zero(value(f, a, b))) return false;
  return true;
}

std::size_t kernel_dimension(const EchelonForm& e, long a, long b) {
  std::vector<std::vector<MFraction>> m;
  for (const SparseRow& row : e.rows) {
    m.emplace_back(e.columns, MFraction(ring));
    for (const auto& [j, c] : row)
      m.back()[j] = value(c, a, b);
  }
  return null_space(m, e.columns, ring).size();
}

EchelonForm random_matrix(std::mt19937& random) {
  const auto draw = [&](int n) { return static_cast<long>(random() % static_cast<unsigned>(n)); };
  EchelonForm e{4, {}};
  for (int i = 0; i < 4; ++i) {
    SparseRow row;
    for (std::size_t j = 0; j < 4; ++j) {
      MPoly c(ring, Integer(draw(3) - 1));
      for (const char* x : {"a", "b"})
        c += MPoly(ring, Integer(draw(3) - 1)) * MPoly::variable(ring, x);
      if (draw(3) == 0) c *= MPoly::variable(ring, "a") - MPoly(ring, Integer(1));
      if (!is_zero(c) && draw(3) > 0) row.emplace(j, c);
    }
    e.rows.push_back(std::move(row));
  }
  return e;
}

TEST(Kernel, OnePartForEachPoint) {
  std::mt19937 random(7);
  for (int sample = 0; sample < 25; ++sample) {
    const EchelonForm e = random_matrix(random);
    std::vector<std::pair<Set, std::size_t>> parts;
    for_each_kernel(Set(ring, {0, 1}), e, [&](const Set& where, const EchelonForm& done) {
      parts.emplace_back(where, kernel_basis(where, done).size());
    });
    for (long a = -2; a <= 2; ++a)
      for (long b = -2; b <= 2; ++b) {
        int covered = 0;
        for (const auto& [where, dimension] : parts)
          if (contains(where, a, b)) {
            ++covered;
            EXPECT_EQ(dimension, kernel_dimension(e, a, b)) << sample << ": " << a << ", " << b;
          }
        EXPECT_EQ(covered, 1) << sample << ": " << a << ", " << b;
      }
  }
}

// Many more rows than columns, as the ansatz of an integral has them: independent is said where it is true and only there.
TEST(Kernel, IndependentModuloAPrime) {
  std::mt19937 random(11);
  const auto draw = [&](int n) { return static_cast<long>(random() % static_cast<unsigned>(n)); };
  for (const std::size_t columns : {1U, 3U, 8U})
    for (const std::size_t height : {columns, columns + 1, 5 * columns, 40 * columns})
      for (const bool dependent : {false, true}) {
        EchelonForm e{columns, {}};
        for (std::size_t i = 0; i < height; ++i) {
          SparseRow row;
          MPoly sum(ring);
          for (std::size_t j = 0; j < columns; ++j) {
            const MPoly c(ring, Integer(draw(3) == 0 || i % columns == j ? draw(9) - 4 : 0));
            if (dependent && j + 1 == columns) break;
            sum += c;
            if (!is_zero(c)) row.emplace(j, c);
          }
          if (dependent && !is_zero(sum)) row.emplace(columns - 1, sum); // the sum of the others
          if (i + 1 != height || height == columns) e.rows.push_back(row);
        }
        const bool full = kernel_dimension(e, 0, 0) == 0;
        EXPECT_EQ(independent_modulo_a_prime(e), full) << columns << " x " << e.rows.size();
        if (dependent) {
          EXPECT_FALSE(full);
        }
      }
  EchelonForm parameter{1, {{{0, MPoly::variable(ring, "a")}}}};
  EXPECT_FALSE(independent_modulo_a_prime(parameter)); // a may be 0
}

// Blocks of numbers, of full rank or not, beside one with parameters, the columns in any order: at every point the
// kernel has the dimension of that of the whole, and its vectors are those of the whole.
TEST(Kernel, OfBlocks) {
  std::mt19937 random(5);
  const auto draw = [&](int n) { return static_cast<long>(random() % static_cast<unsigned>(n)); };
  for (int sample = 0; sample < 20; ++sample) {
    EchelonForm e = random_matrix(random); // 4 columns
    for (const std::size_t size : {1U, 2U, 3U, 3U}) {
      for (std::size_t i = 0; i < size + static_cast<std::size_t>(draw(3)); ++i) {
        SparseRow row;
        for (std::size_t j = 0; j < size; ++j)
          if (const long c = draw(3) - 1; c != 0)
            row.emplace(e.columns + j, MPoly(ring, Integer(c)));
        e.rows.push_back(std::move(row));
      }
      e.columns += size;
    }
    std::vector<std::size_t> to(e.columns);
    std::iota(to.begin(), to.end(), 0);
    std::shuffle(to.begin(), to.end(), random);
    std::shuffle(e.rows.begin(), e.rows.end(), random);
    for (SparseRow& row : e.rows) {
      SparseRow moved;
      for (const auto& [j, c] : row)
        moved.emplace(to[j], c);
      row = std::move(moved);
    }
    for_each_kernel(Set(ring, {0, 1}), e, [&](const Set& where, const EchelonForm& done) {
      const auto basis = kernel_basis(where, done);
      for (long a = -2; a <= 2; ++a)
        for (long b = -2; b <= 2; ++b)
          if (contains(where, a, b)) {
            EXPECT_EQ(basis.size(), kernel_dimension(e, a, b)) << sample << ": " << a << ", " << b;
          }
      for (const auto& v : basis)
        for (const SparseRow& row : e.rows) {
          MFraction sum(ring);
          for (const auto& [j, c] : row)
            if (const auto x = v.find(j); x != v.end()) sum += MFraction(c) * x->second;
          EXPECT_TRUE(is_zero(sum) || is_zero(where.restrict(sum.num()))) << sample;
        }
    });
  }
}

} // namespace
} // namespace kov
