#include "parameters/set.hpp"

#include "support/random.hpp"

#include <gtest/gtest.h>

namespace kov::set_test {
namespace {

// The same set by its definition: one Gröbner basis of all equations, saturated by all inequations.
struct Plain {
  Ring ring;
  std::vector<std::size_t> parameters;
  std::vector<MPoly> zero, nonzero;

  [[nodiscard]] Ideal ideal() const { return {ring, parameters, zero, nonzero}; }
  [[nodiscard]] bool vanishes(const MPoly& f) const {
    auto more = nonzero;
    more.push_back(f);
    return Ideal(ring, parameters, zero, more).is_unit();
  }
  [[nodiscard]] bool is_nonzero(const MPoly& f) const {
    auto more = zero;
    more.push_back(f);
    return Ideal(ring, parameters, more, nonzero).is_unit();
  }
};

class Polynomials {
public:
  Polynomials(const Ring& ring, test::Random& random) : ring_(ring), random_(random) {}

  // Often linear in one parameter, as equations of families are; sometimes a square or a product.
  [[nodiscard]] MPoly operator()() {
    switch (number(0, 5)) {
    case 0:
      return linear() * linear();
    case 1:
      return linear() * linear() + MPoly(ring_, Integer(number(-2, 2)));
    case 2:
      return x() * x() + MPoly(ring_, Integer(number(0, 2))) * x() * x();
    case 3:
      return x();
    default:
      return linear();
    }
  }

private:
  [[nodiscard]] long number(long a, long b) { return random_.between(a, b); }
  [[nodiscard]] MPoly x() { return MPoly::variable(ring_, static_cast<std::size_t>(number(0, 2))); }
  [[nodiscard]] MPoly linear() {
    MPoly f = MPoly(ring_, Integer(number(-1, 1))) + x();
    return f + MPoly(ring_, Integer(number(-2, 2))) * x();
  }

  Ring ring_;
  test::Random& random_;
};

TEST(ParameterSets, AreWhatTheirDefinitionSays) {
  test::random_rounds(400, [](test::Random& random) {
    const Ring ring = make_ring({"a", "b", "c"});
    Polynomials polynomial(ring, random);
    Set set(ring, {0, 1, 2});
    Plain plain{ring, {0, 1, 2}, {}, {}};
    for (int step = 0; step < 5; ++step) {
      const MPoly p = polynomial();
      if (is_zero(p)) continue;
      const bool equation = random.once_in(2);
      (equation ? plain.zero : plain.nonzero).push_back(p);
      set = equation ? set.where_zero(p) : set.where_nonzero(p);
      const bool has_equations = !plain.zero.empty();
      ASSERT_EQ(set.is_empty(), has_equations && plain.ideal().is_unit());
      const MPoly f = polynomial();
      if (is_zero(f)) continue;
      EXPECT_EQ(set.vanishes(f), plain.vanishes(f)) << to_string(f);
      EXPECT_EQ(set.is_nonzero(f), plain.is_nonzero(f)) << to_string(f);
    }
  });
}

TEST(ParameterSets, OfAGraphAFactorThatIsKnownIsNowhereZero) {
  const Ring ring = make_ring({"a", "b", "c"});
  const MPoly a = MPoly::variable(ring, "a"), b = MPoly::variable(ring, "b"),
              c = MPoly::variable(ring, "c");
  const Set set = Set(ring, {0, 1, 2}).where_nonzero(b - c).where_zero(a - b);
  EXPECT_TRUE(set.is_nonzero(a - c));
  EXPECT_TRUE(set.is_nonzero((a - c) * (b - c)));
  EXPECT_FALSE(set.is_nonzero(a + c));
  EXPECT_FALSE(set.is_nonzero(b));
  EXPECT_TRUE(set.where_zero(b - c).is_empty());
  EXPECT_TRUE(set.where_nonzero(a - b).is_empty());
}

TEST(ParameterSets, AnInequationIsSaidOnce) {
  const Ring ring = make_ring({"a", "b", "c"});
  const MPoly a = MPoly::variable(ring, "a"), b = MPoly::variable(ring, "b"),
              c = MPoly::variable(ring, "c");
  const Set set = Set(ring, {0, 1, 2})
                      .where_nonzero(a)
                      .where_nonzero(b)
                      .where_nonzero(a - b + c)
                      .where_zero(a - MPoly(ring, Integer(2)) * b);
  ASSERT_EQ(set.proper_inequations().size(), 2U); // a != 0 is b != 0 there
  EXPECT_EQ(to_string(set.proper_inequations().front()), "a");
}

TEST(ParameterSets, ANodeIsNoGraph) { // b^2 = a^2: two lines, and only one of them is left
  const Ring ring = make_ring({"a", "b"});
  const MPoly a = MPoly::variable(ring, "a"), b = MPoly::variable(ring, "b");
  const Set lines = Set(ring, {0, 1}).where_zero(a * a - b * b);
  EXPECT_FALSE(lines.vanishes(a - b));
  EXPECT_TRUE(lines.where_nonzero(a + b).vanishes(a - b));
  EXPECT_TRUE(lines.where_nonzero(a + b).is_nonzero(a));
  EXPECT_FALSE(lines.is_nonzero(a));
}

} // namespace
} // namespace kov::set_test
