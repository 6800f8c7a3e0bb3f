// Every operation on balls of two doubles contains what Arb makes of points of its operands, at random: of all sizes,
// with radii from none to more than the middle.

#include "flow/number/double_ball.hpp"

#include <gtest/gtest.h>

#include <cfenv>
#include <random>

namespace kov::flow::double_ball_test {
namespace {

class Balls {
public:
  double number(int largest) {
    std::uniform_int_distribution<int> exponent(-largest, largest);
    std::uniform_real_distribution<double> part(-1, 1);
    return std::ldexp(part(engine_), exponent(engine_));
  }
  DoubleBall ball(int largest) {
    const double m = number(largest);
    switch (std::uniform_int_distribution<int>(0, 3)(engine_)) {
    case 0:
      return m;
    case 1:
      return {m, std::abs(m * std::ldexp(number(1), -20))};
    case 2:
      return {0, std::abs(m)};
    default:
      return {m, std::abs(number(largest))};
    }
  }
  // A point of it, exactly: an end, or between.
  Enclosure point(const DoubleBall& b) {
    const double along[] = {-1, 1, 0, std::uniform_real_distribution<double>(-1, 1)(engine_)};
    return Enclosure(b.mid()) +
           Enclosure(b.radius()) *
               Enclosure(along[std::uniform_int_distribution<int>(0, 3)(engine_)]);
  }

private:
  std::mt19937_64 engine_{20261126};
};

bool holds(const DoubleBall& b, const Enclosure& x) {
  return std::isnan(b.radius()) || arb_contains(around(b).raw(), x.raw()) != 0;
}

// Points are exact with so many bits, but quotients, whose radius is far below that of the result.
void compare(int largest, int runs) {
  const EnclosureScope scope(8000);
  Balls random;
  for (int i = 0; i < runs; ++i) {
    const DoubleBall a = random.ball(largest), b = random.ball(largest);
    const Enclosure x = random.point(a), y = random.point(b);
    ASSERT_TRUE(holds(a, x));
    EXPECT_TRUE(holds(a + b, x + y));
    EXPECT_TRUE(holds(a - b, x - y));
    EXPECT_TRUE(holds(-a, -x));
    EXPECT_TRUE(holds(a * b, x * y));
    if (!b.contains_zero()) EXPECT_TRUE(holds(a / b, x / y));
    EXPECT_TRUE(holds(power(a, 5), power(x, 5)));
    DoubleBall sum = a;
    add_product(sum, a, b);
    EXPECT_TRUE(holds(sum, x + x * y));
    EXPECT_TRUE(holds(a.widened(b), x + y));
    EXPECT_TRUE(holds(DoubleBall::hull(a, b), x) && holds(DoubleBall::hull(a, b), y));
    EXPECT_LE(std::abs(static_cast<double>(x)), a.most());
    // what is said of the ball holds of the point
    EXPECT_TRUE(!a.is_positive() || x.is_positive());
    EXPECT_TRUE(!a.is_negative() || x.is_negative());
    EXPECT_TRUE(!(a < b) || x < y);
    EXPECT_TRUE(!a.inside(b) || arb_contains(around(b).raw(), x.raw()) != 0);
    EXPECT_TRUE(holds(double_ball(x), x));
  }
}

TEST(DoubleBall, ContainsWhatArbMakesOfItsPoints) {
  for (const int largest : {1, 30, 400})
    compare(largest, 1500);
}

TEST(DoubleBall, InEveryRoundingMode) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    compare(30, 500);
    std::fesetround(FE_TONEAREST);
  }
}

TEST(DoubleBall, SumsOfProducts) {
  const EnclosureScope scope(8000);
  Balls random;
  for (const int n : {1, 2, 3, 17, 40})
    for (int run = 0; run < 60; ++run) {
      std::vector<Dual<DoubleBall>> a, b;
      std::vector<Dual<Enclosure>> x, y;
      for (int j = 0; j < n; ++j)
        for (auto* one : {&a, &b}) {
          one->push_back({random.ball(20), random.ball(20), random.ball(20)});
          const auto& o = one->back();
          (one == &a ? x : y)
              .push_back({random.point(o.v), random.point(o.d[0]), random.point(o.d[1])});
        }
      const Dual<DoubleBall> sum = dot(a.data(), b.data() + n - 1, n);
      Dual<Enclosure> exact(Enclosure(0));
      for (int j = 0; j < n; ++j)
        add_product(exact, x[j], y[n - 1 - j]);
      EXPECT_TRUE(holds(sum.v, exact.v));
      for (int d = 0; d < 2; ++d)
        EXPECT_TRUE(holds(sum.d[d], exact.d[d]));
    }
}

TEST(DoubleBall, IntersectionsHoldWhatBothHold) {
  const EnclosureScope scope(8000);
  Balls random;
  for (int i = 0; i < 2000; ++i) {
    const DoubleBall a = random.ball(3);
    const Enclosure x = random.point(a);
    const DoubleBall b = double_ball(x).widened(random.ball(3));
    const auto both = intersection(a, b);
    ASSERT_TRUE(both);
    EXPECT_TRUE(holds(*both, x));
    const auto off = intersection(a, a + DoubleBall(3 * a.radius() + 1));
    EXPECT_FALSE(off);
  }
}

TEST(DoubleBall, FromAndToArb) {
  const EnclosureScope scope(200);
  Balls random;
  for (int i = 0; i < 500; ++i) {
    const DoubleBall a = random.ball(30);
    EXPECT_NE(arb_contains(around(a).raw(), within(a).raw()), 0);
    const Enclosure third = around(a) / Enclosure(3);
    EXPECT_NE(arb_contains(around(double_ball(third)).raw(), third.raw()), 0);
  }
}

// Nothing is known of them, and nothing is said.
TEST(DoubleBall, NothingIsSaidOfWhatIsTooLarge) {
  const DoubleBall large(1e300), zero(0, 1e-300),
      lost[] = {large * large,         large * large - large * large,         large / zero,
                large / DoubleBall(0), DoubleBall::unknown() * DoubleBall(0), DoubleBall(0, NAN),
                DoubleBall(NAN, 0)};
  for (const DoubleBall& x : lost) {
    EXPECT_TRUE(x.contains_zero());
    EXPECT_FALSE(x.is_positive() || x.is_negative() || x.inside(DoubleBall(0, 1e308)));
    EXPECT_FALSE(x < large || x > large || x == x);
    EXPECT_FALSE(intersection(x, large));
    EXPECT_FALSE((DoubleBall::hull(x, large)).finite());
  }
}

// It was cut to an integer.
TEST(Dual, OfEnclosuresKeepsADouble) {
  const std::vector<double> x{0.25};
  const std::vector<Dual<Enclosure>> y(x.begin(), x.end());
  EXPECT_EQ(static_cast<double>(y[0].v), 0.25);
}

} // namespace
} // namespace kov::flow::double_ball_test
