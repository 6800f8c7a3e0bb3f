#include "moves/scalings.hpp"

#include "families.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

// Euler: sum_i w_i x_i df/dx_i of a function of weight d is d f.
MFraction euler(const MFraction& f, const std::vector<MFraction>& weights) {
  MFraction sum(f.ring());
  for (std::size_t i = 0; i < f.ring()->size(); ++i)
    sum += weights[i] * MFraction::variable(f.ring(), i) * derivative(f, i);
  return sum;
}

void expect_homogeneous(const System& s, std::size_t dimension) {
  const VectorField& v = s.field;
  const Matrix all = scalings(s);
  EXPECT_EQ(all.size(), dimension);
  for (const auto& w : all) {
    const MFraction &time = w[v.ring->size()], &bracket = w[v.ring->size() + 1];
    for (std::size_t i = 0; i < v.dimension(); ++i) {
      const MFraction& f = v.components[i];
      EXPECT_TRUE(is_zero(euler(f, w) - (w[v.coordinates[i]] + time) * f));
      for (std::size_t j = 0; v.poisson && j < i; ++j) {
        const MFraction& p = (*v.poisson)[i][j];
        const MFraction weight = w[v.coordinates[i]] + w[v.coordinates[j]] + bracket;
        EXPECT_TRUE(is_zero(euler(p, w) - weight * p));
      }
    }
  }
}

// One of them is that of z, which no equation uses.
TEST(Scalings, TheFieldAndTheBracketAreHomogeneous) {
  expect_homogeneous(in_the_plane("'a'", "(p1^2 + p2^2)/2 + a*q1^2*q2/(q1 + q2)"), 3);
  expect_homogeneous(in_the_plane("'a', 'b'", "(p1^2 + p2^2)/2 + a*q1^4 + b*q2^2"), 3);
  expect_homogeneous(in_the_plane("", "(p1^2 + p2^2)/2 + q1^4 + q2^2 + q1^2*q2"), 1);
  expect_homogeneous(heavy_top_family(), 4);
}

// x + x^2 has no weight but 0, and then none is left for y = x.
TEST(WeightEquations, AreAddedUp) {
  const Ring ring = make_ring({"x", "y"});
  const MFraction x = MFraction::variable(ring, 0), y = MFraction::variable(ring, 1);
  WeightEquations equations(ring);
  equations.add_homogeneous(MFraction(ring)); // 0 has any weight
  EXPECT_EQ(equations.all().size(), 4U);
  equations.add_homogeneous((x * x + y) / (x + y * y / x)); // 2x = y and 2x = 2y
  EXPECT_EQ(equations.all().size(), 2U);                    // time and bracket
  WeightEquations more = equations;
  more.add_row({{more.time(), 1}, {more.bracket(), -2}});
  EXPECT_EQ(more.all().size(), 1U);
  EXPECT_EQ(equations.all().size(), 2U);
}

} // namespace
} // namespace kov
