#include "flow/section/index_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>

namespace kov::flow::index_grid_test {
namespace {

using Field = std::function<Latitude(const Latitude&)>;

// A map with the given displacement; slopes by differences.
IndexGrid::Map map_of(const Field& field) {
  return [field](const Latitude& u) {
    constexpr double h = 1e-6;
    const auto slope = [&](double l, double y) {
      const Latitude a = field({u.l - l, u.y - y}), b = field({u.l + l, u.y + y});
      return Latitude{std::remainder(b.l - a.l, 2 * M_PI) / (2 * h), (b.y - a.y) / (2 * h)};
    };
    const Latitude by = field(u), along = slope(h, 0), across = slope(0, h);
    return std::optional(Displaced{
        u, {std::remainder(by.l, 2 * M_PI), by.y}, {along.l, across.l, along.y, across.y}});
  };
}

struct Zero {
  std::complex<double> at;
  int index;
};

// sin(z - a) for the index 1, its conjugate for -1; steep, and of a size that the section allows.
Field field_of(const std::vector<Zero>& zeros, double steepness) {
  return [=](const Latitude& u) {
    std::complex<double> f = steepness;
    for (const Zero& z : zeros) {
      const std::complex<double> s = std::sin(std::complex<double>(u.l, u.y) - z.at);
      f *= z.index > 0 ? s : std::conj(s);
    }
    const double size = std::abs(f);
    f *= 2.5 / (2.5 + size);
    return Latitude{f.real(), f.imag()};
  };
}

constexpr int columns = 48, rows = 40;

// Hundreds of multipliers, displacements of half a turn, pairs in neighbouring cells: the index of
// a cell that has one is the number of zeros in it.
TEST(IndexGrid, CountsTheZerosOfSteepFields) {
  std::mt19937 random(22);
  const auto uniform = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  for (int trial = 0; trial < 40; ++trial) {
    std::vector<Zero> zeros, all;
    for (int n = 0; n < 4; ++n)
      zeros.push_back({{uniform(0, M_PI), uniform(-1.4, 1.4)}, uniform(0, 1) < 0.5 ? 1 : -1});
    for (const Zero& z : zeros)
      for (const double turn : {0.0, M_PI})
        all.push_back({z.at + turn, z.index});
    IndexGrid grid(columns, rows, map_of(field_of(zeros, std::pow(10, uniform(0, 3)))));
    grid.count();
    int without = 0;
    for (int i = 0; i < columns; ++i)
      for (int k = 0; k + 1 < rows; ++k) {
        int wanted = 0;
        for (const Zero& z : all)
          if (grid.cell_of({z.at.real(), z.at.imag()}) == std::array{i, k}) wanted += z.index;
        const auto index = grid.index(i, k);
        without += index ? 0 : 1;
        if (index) {
          EXPECT_EQ(*index, wanted) << "trial " << trial << ", cell " << i << ", " << k;
        }
      }
    EXPECT_LE(without, 8) << "trial " << trial;
  }
}

// A shear whose displacement goes round in l several times: each time it passes a whole turn there
// would be a zero, were the displacement in y not 1/10.
TEST(IndexGrid, WholeTurnsAreNoZerosByThemselves) {
  IndexGrid grid(columns, rows, map_of([](const Latitude& u) { return Latitude{9 * u.y, 0.1}; }));
  grid.count();
  for (int i = 0; i < columns; ++i)
    for (int k = 0; k + 1 < rows; ++k)
      EXPECT_EQ(grid.index(i, k), 0) << i << ", " << k;
}

// And with sin(l) there are two on each of those circles, of opposite index (9 y = -4 pi ... 4 pi).
TEST(IndexGrid, WholeTurnsOfATwistMap) {
  IndexGrid grid(columns, rows, map_of([](const Latitude& u) {
                   return Latitude{9 * u.y, 0.1 * std::sin(u.l)};
                 }));
  grid.count();
  int positive = 0, negative = 0;
  for (int i = 0; i < columns; ++i)
    for (int k = 0; k + 1 < rows; ++k) {
      ASSERT_TRUE(grid.index(i, k)) << i << ", " << k;
      positive += *grid.index(i, k) > 0 ? 1 : 0;
      negative += *grid.index(i, k) < 0 ? 1 : 0;
    }
  EXPECT_EQ(positive, 5);
  EXPECT_EQ(negative, 5);
}

// A jump, a curve of zeros and a hole take the index from the cells that they meet, and from no
// others.
TEST(IndexGrid, WhereTheMapIsNotSmoothThereIsNoIndex) {
  const auto has_index = [](IndexGrid& grid, int i, int k) {
    const auto index = grid.index(i, k);
    EXPECT_EQ(index.value_or(0), 0);
    return index.has_value();
  };
  IndexGrid jump(columns, rows, map_of([](const Latitude& u) {
                   return Latitude{u.l > 2 && u.l < 4 ? 0.5 : -0.5, 0.1};
                 }));
  IndexGrid curve(columns, rows, map_of([](const Latitude& u) {
                    return Latitude{std::sin(u.y - 0.3), 0.0};
                  }));
  IndexGrid hole(columns, rows, [](const Latitude& u) {
    return u.y > 1 ? std::nullopt : std::optional(Displaced{u, {0.3, 0.2}, {}});
  });
  for (IndexGrid* grid : {&jump, &curve, &hole})
    grid->count();
  const int at2 = (*jump.cell_of({2, 0}))[0], at4 = (*jump.cell_of({4, 0}))[0],
            row = (*curve.cell_of({0, 0.3}))[1], top = (*hole.cell_of({0, 1}))[1];
  for (int i = 0; i < columns; ++i)
    for (int k = 0; k + 1 < rows; ++k) {
      EXPECT_EQ(has_index(jump, i, k), i != at2 && i != at4) << i << ", " << k;
      EXPECT_EQ(has_index(curve, i, k), k != row) << i << ", " << k;
      EXPECT_EQ(has_index(hole, i, k), k < top) << i << ", " << k;
      EXPECT_EQ(hole.on_level(i, k), k <= top) << i << ", " << k;
    }
}

} // namespace
} // namespace kov::flow::index_grid_test
