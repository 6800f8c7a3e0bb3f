#include "flow/chaos/index_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>

namespace kov::flow::index_grid_test {
namespace {

using Field = std::function<std::optional<Place>(const Place&)>;

/// A map with the given displacement; slopes by differences.
class GivenMap : public MapOverPicture {
public:
  explicit GivenMap(Field field) : field_(std::move(field)) {}
  std::vector<Displaced> over(const Place& u) override {
    if (!field_(u)) return {};
    return {{.at = u}};
  }
  std::optional<Displaced> follow(const Displaced&, const Place& u) override {
    return field_(u) ? std::optional(Displaced{.at = u}) : std::nullopt;
  }
  void displace(Displaced& x) override {
    constexpr double h = 1e-6;
    x.by = field_(x.at);
    (*x.by)[0] = std::remainder((*x.by)[0], 2 * M_PI);
    for (const std::size_t d : {0U, 1U}) {
      Place low = x.at, high = x.at;
      low[d] -= h;
      high[d] += h;
      const Place a = field_(low).value_or(*x.by), b = field_(high).value_or(*x.by);
      x.slopes[0][d] = std::remainder(b[0] - a[0], 2 * M_PI) / (2 * h);
      x.slopes[1][d] = (b[1] - a[1]) / (2 * h);
    }
  }

private:
  Field field_;
};

constexpr int columns = 48, rows = 40;

struct Grid {
  GivenMap map;
  IndexGrid grid;
  std::vector<IndexGrid::Cell> cells;
  explicit Grid(Field field)
      : map(std::move(field)), grid({true, false}, columns, rows, map), cells(grid.cells()) {}
  [[nodiscard]] const IndexGrid::Cell& with(const Place& u) const {
    return *std::ranges::find_if(cells, [&](const auto& c) { return grid.contains(c, {.at = u}); });
  }
};

struct Zero {
  std::complex<double> at;
  int index;
};

// sin(z - a) for the index 1, its conjugate for -1; steep, and of a size that the section allows.
Field field_of(const std::vector<Zero>& zeros, double steepness) {
  return [=](const Place& u) {
    std::complex<double> f = steepness;
    for (const Zero& z : zeros) {
      const std::complex<double> s = std::sin(std::complex<double>(u[0], u[1]) - z.at);
      f *= z.index > 0 ? s : std::conj(s);
    }
    const double size = std::abs(f);
    f *= 2.5 / (2.5 + size);
    return std::optional(Place{f.real(), f.imag()});
  };
}

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
    const Grid grid(field_of(zeros, std::pow(10, uniform(0, 3))));
    EXPECT_EQ(grid.cells.size(), columns * (rows - 1));
    int without = 0;
    for (const auto& c : grid.cells) {
      int wanted = 0;
      for (const Zero& z : all)
        if (grid.grid.contains(c, {.at = {z.at.real(), z.at.imag()}})) wanted += z.index;
      without += c.index ? 0 : 1;
      EXPECT_EQ(c.index.value_or(wanted), wanted)
          << "trial " << trial << ", cell " << c.column << ", " << c.row;
    }
    EXPECT_LE(without, 8) << "trial " << trial;
  }
}

// A shear whose displacement goes round in l several times: each time it passes a whole turn there
// would be a zero, were the displacement in y not 1/10.
TEST(IndexGrid, WholeTurnsAreNoZerosByThemselves) {
  const Grid grid([](const Place& u) { return Place{9 * u[1], 0.1}; });
  for (const auto& c : grid.cells)
    EXPECT_EQ(c.index, 0) << c.column << ", " << c.row;
}

// And with sin(l) there are two on each of those circles, of opposite index (9 y = -4 pi ... 4 pi).
TEST(IndexGrid, WholeTurnsOfATwistMap) {
  const Grid grid([](const Place& u) { return Place{9 * u[1], 0.1 * std::sin(u[0])}; });
  int positive = 0, negative = 0;
  for (const auto& c : grid.cells) {
    ASSERT_TRUE(c.index) << c.column << ", " << c.row;
    positive += *c.index > 0 ? 1 : 0;
    negative += *c.index < 0 ? 1 : 0;
  }
  EXPECT_EQ(positive, 5);
  EXPECT_EQ(negative, 5);
}

// A jump, a curve of zeros and a hole take the index from the cells that they meet, and from no
// others.
TEST(IndexGrid, WhereTheMapIsNotSmoothThereIsNoIndex) {
  const Grid jump([](const Place& u) { return Place{u[0] > 2 && u[0] < 4 ? 0.5 : -0.5, 0.1}; });
  const Grid curve([](const Place& u) { return Place{std::sin(u[1] - 0.3), 0.0}; });
  const Grid hole([](const Place& u) {
    return u[1] > 1 ? std::nullopt : std::optional(Place{0.3, 0.2});
  });
  const int at2 = jump.with({2, 0}).column, at4 = jump.with({4, 0}).column,
            row = curve.with({0, 0.3}).row;
  for (const auto& c : jump.cells)
    EXPECT_EQ(c.index, c.column == at2 || c.column == at4 ? std::nullopt : std::optional(0));
  for (const auto& c : curve.cells)
    EXPECT_EQ(c.index, c.row == row ? std::nullopt : std::optional(0));
  int top = 0; // no cell lies beyond the hole's border
  for (const auto& c : hole.cells)
    top = std::max(top, c.row);
  EXPECT_LE(hole.grid.place(0, top)[1], 1);
  for (const auto& c : hole.cells)
    EXPECT_EQ(c.index, c.row == top ? std::nullopt : std::optional(0));
}

// A cover with two sheets over each place, the second of which has the zeros: each cell is one of one sheet.
class TwoSheets : public GivenMap {
public:
  TwoSheets() : GivenMap([](const Place& u) { return Place{std::sin(u[0]), u[1]}; }) {}
  std::vector<Displaced> over(const Place& u) override {
    return {{.at = u, .state = {-2}}, {.at = u, .state = {2}}};
  }
  std::optional<Displaced> follow(const Displaced& from, const Place& u) override {
    return Displaced{.at = u, .state = from.state};
  }
  void displace(Displaced& x) override {
    if (x.state[0] > 0)
      GivenMap::displace(x);
    else
      x.by = {1, 1};
  }
};

TEST(IndexGrid, CountsOnEachSheet) {
  TwoSheets map;
  IndexGrid grid({true, false}, 12, 10, map);
  int sum = 0, nonzero = 0;
  for (const auto& c : grid.cells()) {
    ASSERT_TRUE(c.index);
    sum += *c.index;
    nonzero += *c.index != 0 ? 1 : 0;
    if (c.corner.state[0] < 0) {
      EXPECT_EQ(*c.index, 0);
    }
  }
  EXPECT_EQ(sum, 0);
  EXPECT_EQ(nonzero, 2); // at 0 and at pi
}

} // namespace
} // namespace kov::flow::index_grid_test
