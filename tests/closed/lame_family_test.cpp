// Lame's equation found where coefficients depend on parameters.

#include "closed/lame_family.hpp"

#include "closed/lame.hpp"

#include <gtest/gtest.h>

#include <random>

namespace kov::lame_family_test {
namespace {

const Ring& ring() {
  static const Ring r = make_ring({"z", "a", "b", "u", "v", "c"});
  return r;
}
MFraction var(const char* name) { return MFraction::variable(ring(), std::string_view(name)); }
MFraction number(long n, long d = 1) { return {ring(), Rational(n, d)}; }

// f''/(4f) - 3 f'^2/(16 f^2) + (alpha x + B)/f at x, which is a function of z.
MFraction lame_r(const MFraction& alpha, const LameParameters<MFraction>& p) {
  const MFraction x = var("z");
  const MFraction f = number(4) * x * x * x - p.g2 * x - p.g3;
  const MFraction f1 = derivative(f, 0);
  return derivative(f1, 0) / (number(4) * f) - number(3, 16) * f1 * f1 / (f * f) +
         (alpha * x + p.b) / f;
}

// x = m(z), m of degree 1: m'^2 r(m).
MFraction pulled(const MFraction& r, const MFraction& m) {
  const MFraction slope = derivative(m, 0);
  return slope * slope * substitute(r, {{0, m}});
}

void expect_form(const MFraction& r, const MFraction& alpha, const LameParameters<MFraction>& p) {
  const auto found = recognize_lame(r, 0);
  ASSERT_TRUE(found) << brief(r);
  EXPECT_TRUE(found->alpha == alpha) << to_string(found->alpha);
  const auto& q = found->parameters; // up to (cB, c^2 g2, c^3 g3)
  EXPECT_TRUE(q.b * q.b * p.g2 == p.b * p.b * q.g2);
  EXPECT_TRUE(q.b * q.g2 * p.g3 == p.b * p.g2 * q.g3);
  EXPECT_TRUE(q.g2 * q.g2 * q.g2 * p.g3 * p.g3 == p.g2 * p.g2 * p.g2 * q.g3 * q.g3);
}

TEST(LameFamily, BehindAMoebiusMap) {
  const LameParameters<MFraction> p{var("b"), var("u"), var("v")};
  const MFraction r = lame_r(var("a"), p);
  const MFraction z = var("z");
  expect_form(r, var("a"), p);
  expect_form(pulled(r, z - var("c")), var("a"), p);
  expect_form(pulled(r, number(1) / z), var("a"), p);
  expect_form(pulled(r, number(1) / (z - var("c"))), var("a"), p);
  expect_form(pulled(r, (z + number(2)) / (number(3) * z - var("c"))), var("a"), p);
}

TEST(LameFamily, BehindASquare) { // y(z) = u(z^2)/sqrt z
  const LameParameters<MFraction> p{var("b"), var("u"), var("v")};
  const MFraction z = var("z");
  const auto squared = [&](const MFraction& r) { // 4 z^2 r(z^2) + 3/(4 z^2)
    return number(4) * z * z * substitute(r, {{0, z * z}}) + number(3, 4) / (z * z);
  };
  const MFraction r = lame_r(var("a"), p);
  expect_form(squared(pulled(r, z - var("c"))), var("a"), p);
  expect_form(squared(pulled(r, number(1) / (z + number(1)))), var("a"), p);
}

TEST(LameFamily, NumbersInPlaceOfParameters) {
  std::mt19937 gen(11);
  for (int i = 0; i < 20; ++i) {
    const auto random = [&] {
      return number(static_cast<long>(gen() % 9) - 4, 1 + static_cast<long>(gen() % 3));
    };
    const LameParameters<MFraction> p{random(), random(), random() + number(9)};
    const MFraction alpha = random();
    expect_form(pulled(lame_r(alpha, p), number(1) / (var("z") - random())), alpha, p);
  }
}

TEST(LameFamily, OtherEquations) {
  const MFraction z = var("z");
  EXPECT_FALSE(recognize_lame(number(0), 0));
  EXPECT_FALSE(recognize_lame(z, 0));
  EXPECT_FALSE(recognize_lame(var("a") / (z * z), 0));
  EXPECT_FALSE(
      recognize_lame(number(1) / (z * (z - var("a")) * (z - number(1)) * (z + number(5))), 0));
  const LameParameters<MFraction> p{var("b"), var("u"), var("v")};
  EXPECT_FALSE(recognize_lame(lame_r(var("a"), p) + number(1), 0));
}

} // namespace
} // namespace kov::lame_family_test
