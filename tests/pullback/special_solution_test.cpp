// Standard equations behind a rational map and a gauge y = a u(f) + b u'(f).

#include "pullback/special_solution.hpp"

#include "pullback/standard.hpp"

#include <gtest/gtest.h>

#include <random>

namespace kov {
namespace {

const Poly z = Poly::z();
const RationalFunction half(Rational(1, 2));

Rational q(long n, long d = 1) { return {Integer(n), Integer(d)}; }

// The normal form of the equation of a U + b U', U'' = r U.
RationalFunction gauged(const RationalFunction& r, const RationalFunction& a,
                        const RationalFunction& b) {
  const RationalFunction a1 = derivative(a) + r * b, b1 = derivative(b) + a;
  const RationalFunction a2 = derivative(a1) + r * b1, b2 = derivative(b1) + a1;
  const RationalFunction det = a1 * b - b1 * a;
  const RationalFunction p = (a2 * b - b2 * a) / det;
  return p * p * RationalFunction(q(1, 4)) - derivative(p) * half + (a1 * b2 - b1 * a2) / det;
}

class Generator {
public:
  explicit Generator(unsigned seed) : gen_(seed) {}

  long number(long bound) { return static_cast<long>(gen_() % (2 * bound + 1)) - bound; }
  Poly poly(long deg) {
    Poly p = Poly::monomial(NfElem(1 + static_cast<long>(gen_() % 3)), deg);
    for (long i = 0; i < deg; ++i)
      p += Poly::monomial(NfElem(number(4)), i);
    return p;
  }
  RationalFunction map(long deg) {
    const auto below = static_cast<long>(gen_() % static_cast<unsigned long>(deg + 1));
    if (gen_() % 2 == 0) return RationalFunction(poly(deg));
    const auto above = below == deg ? number(deg / 2) + deg - deg / 2 : deg;
    return RationalFunction(poly(above), poly(below));
  }
  // without: a = 1, b = 0
  RationalFunction gauge_part() {
    return gen_() % 2 == 0 ? RationalFunction(poly(static_cast<long>(gen_() % 3)))
                           : RationalFunction(poly(static_cast<long>(gen_() % 2)), poly(1));
  }
  unsigned long pick(unsigned long n) { return gen_() % n; }

private:
  std::mt19937 gen_;
};

enum class Gauging { none, shift, general };

RationalFunction disguised(Generator& g, const RationalFunction& standard, long deg,
                           Gauging gauging) {
  RationalFunction f;
  do
    f = g.map(deg);
  while (is_zero(derivative(f)));
  const RationalFunction r = pullback::pulled_back(standard, f);
  if (gauging == Gauging::none) return r;
  if (gauging == Gauging::shift) return gauged(r, RationalFunction(0), RationalFunction(1));
  return gauged(r, g.gauge_part(), g.gauge_part());
}

RationalFunction airy(Generator& /*g*/) { return {z}; }
RationalFunction bessel(Generator& g) {
  const Rational nu = q(1 + static_cast<long>(g.pick(4)), 5);
  const Rational c = nu * nu - q(1, 4);
  return RationalFunction(-1) + RationalFunction(Poly(c), z * z);
}
RationalFunction whittaker(Generator& g) {
  const Rational m = q(1 + static_cast<long>(g.pick(4)), 5);
  return RationalFunction(q(1, 4)) - RationalFunction(Poly(q(g.number(6), 7)), z) +
         RationalFunction(Poly(m * m - q(1, 4)), z * z);
}
RationalFunction weber(Generator& g) {
  return {scale(z * z, NfElem(q(1, 4))) + Poly(q(7 * g.number(3) + 1, 7))};
}
RationalFunction bessel_of_root(Generator& g) {
  const Rational nu = q(1 + static_cast<long>(g.pick(4)), 5);
  return RationalFunction(1, z) + RationalFunction(Poly((nu * nu - q(1)) / q(4)), z * z);
}

RationalFunction riemann(Generator& g) {
  const RationalFunction x(z), y(z - Poly(1)), one(1);
  const auto d = [&] { return RationalFunction(q(1 + static_cast<long>(g.pick(6)), 7)); };
  const RationalFunction a = d(), b = d(), c = d();
  return ((a * a - one) / (x * x) + (b * b - one) / (y * y) +
          (one + c * c - a * a - b * b) / (x * y)) *
         RationalFunction(q(1, 4));
}

struct Kind {
  const char* name;
  RationalFunction (*make)(Generator&);
};

class Disguised : public ::testing::TestWithParam<Kind> {};

TEST_P(Disguised, IsFound) {
  for (const Gauging gauging : {Gauging::none, Gauging::shift, Gauging::general})
    for (long deg = 1; deg <= 3; ++deg)
      for (unsigned seed = 0; seed < 3; ++seed) {
        Generator g(1000 * static_cast<unsigned>(deg) + seed);
        const RationalFunction standard = GetParam().make(g);
        const RationalFunction r = disguised(g, standard, deg, gauging);
        const auto y = special_solution(singularities(r), Budget::of_seconds(60));
        ASSERT_TRUE(y) << to_string(r);
        EXPECT_TRUE(satisfies(*y, r));
      }
}

INSTANTIATE_TEST_SUITE_P(Kinds, Disguised,
                         ::testing::Values(Kind{"Airy", airy}, Kind{"Bessel", bessel},
                                           Kind{"Whittaker", whittaker}, Kind{"Weber", weber},
                                           Kind{"BesselOfRoot", bessel_of_root},
                                           Kind{"Riemann", riemann}),
                         [](const auto& one) { return one.param.name; });

std::string text_of(const RationalFunction& r) {
  const auto y = special_solution(singularities(r));
  if (!y) return "";
  return std::string(to_string(y->family)) + " of " + to_string(y->f, "z");
}

TEST(SpecialSolution, MapsThatAreFound) {
  EXPECT_EQ(text_of(z), "Airy of z");
  EXPECT_EQ(text_of(gauged(z, 0, 1)), "Airy of z");
  EXPECT_EQ(text_of(z * z * z * z + z), "Whittaker of z^3");
  EXPECT_EQ(text_of(z * z * z), "Bessel of z^5/25");
}

TEST(SpecialSolution, OverANumberField) {
  const NfElem s = NfElem::generator(make_field({-2, 0, 1}, "s"));
  const RationalFunction f(z * z + Poly(s), z - Poly(1));
  const RationalFunction r = gauged(pullback::pulled_back(z, f), z + Poly(s), 1);
  const auto y = special_solution(singularities(r));
  ASSERT_TRUE(y);
  EXPECT_EQ(y->family, Classical::airy);
  EXPECT_TRUE(satisfies(*y, r));
}

// Triconfluent and doubly confluent equations of Heun: their two parameters are general.
TEST(SpecialSolution, NothingElseIsClaimed) {
  EXPECT_EQ(text_of(z * z * z * z + z * z + z), "");
  EXPECT_EQ(text_of(RationalFunction(1) + RationalFunction(1, z) + RationalFunction(1, pow(z, 4))),
            "");
}

TEST(SpecialSolution, IsCheckedByDifferentiation) {
  SpecialSolution y = *special_solution(singularities(gauged(z, z, 1)));
  EXPECT_TRUE(satisfies(y, gauged(z, z, 1)));
  EXPECT_FALSE(satisfies(y, gauged(z, z, 2)));
  y.a = y.a + RationalFunction(1);
  EXPECT_FALSE(satisfies(y, gauged(z, z, 1)));
  y.a = y.b = RationalFunction(0); // the zero function is none
  EXPECT_FALSE(satisfies(y, gauged(z, z, 1)));
}

} // namespace
} // namespace kov
