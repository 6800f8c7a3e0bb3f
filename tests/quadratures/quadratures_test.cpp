// Primitives in K(I), and obstructions of higher order along rational curves.

#include "exact/error.hpp"
#include "quadratures/obstruction.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace kov {
namespace {

const Poly z = Poly::z();
using Element = PrimitiveExtension::Element;

RationalFunction over(const Poly& den) { return {Poly(1), den}; }

TEST(PrimitiveExtension, DerivativesHavePrimitives) {
  std::mt19937 generator(5);
  std::uniform_int_distribution<int> number(-3, 3);
  const auto some = [&] {
    const Poly num =
        Rational(number(generator)) * z * z + Rational(number(generator)) * z + Poly(1);
    return RationalFunction(num, (z - Poly(Rational(number(generator)))) * (z * z + Poly(1)));
  };
  for (const RationalFunction& u :
       {over(z), over(z * z + Poly(1)), over(z * z) + over(z - Poly(2))}) {
    const auto l = PrimitiveExtension::make(u);
    ASSERT_TRUE(l);
    for (int trial = 0; trial < 10; ++trial) {
      const Element g{some(), some(), some()};
      const auto found = l->primitive(l->derivative(g));
      ASSERT_TRUE(found);
      EXPECT_EQ(l->derivative(*found), l->derivative(g));
    }
  }
}

// Places of the same multiplicity that lose it one after the other.
TEST(PrimitiveExtension, HermiteReducesEveryPlace) {
  for (const RationalFunction& g : {over(z * z) + over(pow(z - Poly(1), 2)) + over(z),
                                    over(pow(z, 3)) + over(pow(z * z + Poly(1), 3)) +
                                        over(pow(z * z - Poly(2), 2)) + RationalFunction(z)}) {
    const HermiteParts parts = hermite_parts(derivative(g) + over(z - Poly(5)));
    EXPECT_EQ(parts.poles, over(z - Poly(5)));
    EXPECT_EQ(derivative(parts.rational), derivative(g));
  }
}

TEST(PrimitiveExtension, DilogarithmsHaveNone) {
  const auto log = *PrimitiveExtension::make(over(z - Poly(1)));
  std::size_t level = 9;
  EXPECT_FALSE(log.primitive({RationalFunction(0), over(z)}, {}, &level)); // log(z - 1)/z
  EXPECT_EQ(level, 1U);                   // 1/z is not a multiple of I'
  EXPECT_FALSE(log.primitive({over(z)})); // another logarithm
  EXPECT_TRUE(log.primitive({RationalFunction(0), over(z - Poly(1))})); // its square
  EXPECT_TRUE(log.primitive({}));
}

TEST(PrimitiveExtension, IntegralsThatAreRationalGenerateNothing) {
  EXPECT_FALSE(PrimitiveExtension::make(over(z * z)));
  EXPECT_FALSE(PrimitiveExtension::make(RationalFunction(z)));
  EXPECT_FALSE(PrimitiveExtension::make(RationalFunction(0)));
}

System of(const std::string& text) { return read_system(parse_document(text, "test.toml")); }
System atwood(const std::string& mu) {
  return of("[system]\nkind = 'hamiltonian'\ncoordinates = ['r', 't']\nmomenta = ['p', 'L']\n"
            "parameters = ['E']\nhamiltonian = '(p^2/(1 + " +
            mu + ") + L^2/r^2)/2 + r*(" + mu +
            " - cos(t))'\n[[manifold]]\nname = 'vertical'\nequations = ['L = 0', 'sin_t = 0', "
            "'cos_t = 1']\nlevel = 'H = E'\n");
}
QuadratureOrders orders(const System& s, int order) {
  return orders_by_quadratures(s, s.manifolds.front(), order, {});
}

// Martinez and Simo: of the masses that pass the first order only mu = 3 is integrable.
TEST(Quadratures, SwingingAtwoodMachine) {
  EXPECT_FALSE(orders(atwood("3"), 5).obstruction);
  for (const std::string mu : {"3/2", "5/4", "15/13", "21/19"}) {
    const auto found = orders(atwood(mu), 3);
    ASSERT_TRUE(found.obstruction) << mu << found.open;
    EXPECT_EQ(found.obstruction->order, 3);
    EXPECT_EQ(found.obstruction->of, "c1^0*c2^3 in the variation of L");
  }
  EXPECT_FALSE(orders(atwood("3/2"), 2).obstruction);
  EXPECT_THAT(orders(atwood("7/5"), 3).open, testing::HasSubstr("neither C nor trivial"));
}

System along_the_axis(const std::string& potential) {
  return of(
      "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
      "parameters = ['E']\nrelations = ['r^2 = x^2 + y^2']\nhamiltonian = '(u^2 + v^2)/2 + " +
      potential +
      "'\n[[system.function]]\nname = 'r'\nderivative = {x = 'x/r', y = 'y/r'}\n"
      "[[manifold]]\nname = 'line'\nequations = ['y = 0', 'v = 0', 'r = x']\nlevel = 'H = E'\n");
}

// Central forces: the angular momentum makes the normal group C, or trivial.
TEST(Quadratures, NoAlarmWhereTheSystemIsIntegrable) {
  int with_an_integral = 0;
  for (const std::string potential :
       {"-1/r", "-1/r + 1/r^2", "-1/r + 3/r^2", "1/r^2 + r^2/2", "-2/r - 5/r^2", "-1/r + x",
        "r^2/2", "-1/r + 1/(2*x^2)", "r^2/2 + 1/x^2", "1/r - 1/r^2 + 1/r^4", "1/r^2 + 1/r^3"}) {
    const auto found = orders(along_the_axis(potential), 4);
    EXPECT_FALSE(found.obstruction) << potential;
    if (found.open == "no obstruction by quadratures up to VE_4") ++with_an_integral;
  }
  EXPECT_GE(with_an_integral, 3);
}

// What is of degree k in y disturbs VE_(k-1).
TEST(Quadratures, CentralForcesDisturbed) {
  for (const auto& [potential, order] : {std::pair("-1/r + 1/r^2 + y^3", 2),
                                         {"-1/r + 1/r^2 + y^3/r^4", 2},
                                         {"-1/r + 1/r^2 + y^4", 3},
                                         {"-1/r + 3/r^2 - y^5/7", 4}}) {
    const auto found = orders(along_the_axis(potential), 5);
    ASSERT_TRUE(found.obstruction) << potential << ": " << found.open;
    EXPECT_EQ(found.obstruction->order, order) << potential;
  }
}

// Integrable with the commuting fields d/da, d/dv + x*y*d/da, which contain x = log(z).
TEST(Quadratures, WhatIsNoFunctionOnTheCurveIsNamed) {
  const System s = of("[system]\nkind = 'vector-field'\ncoordinates = ['x', 'a', 'v', 'y']\n"
                      "[system.field]\nx = '1'\na = 'u + y*v'\nv = 'y*u/(u - 1)'\ny = '0'\n"
                      "[[system.function]]\nname = 'u'\nmeans = 'exp(x)'\nderivative = {x = 'u'}\n"
                      "[[manifold]]\nname = 'line'\nequations = ['y = 0', 'v = 0', 'a = u']\n");
  const auto found = orders(s, 4);
  ASSERT_TRUE(found.obstruction) << found.open;
  EXPECT_THAT(found.obstruction->integrals.without, testing::ElementsAre("x"));
  EXPECT_TRUE(found.obstruction->level.empty());
  EXPECT_THAT(orders(atwood("3/2"), 3).obstruction->integrals.without, testing::IsEmpty());
}

// y is an integral and d/dz commutes: a second logarithm is not an obstruction.
TEST(Quadratures, AnotherIntegralIsNoObstruction) {
  for (const std::string slope :
       {"y*x/(x - 1) + y^2*x/(x - 2)", "y*x/(x - 1) + y^3*x/(x - 2)^2 + y^2"}) {
    const auto found =
        orders(of("[system]\nkind = 'vector-field'\ncoordinates = ['x', 'y', 'z']\n[system.field]\n"
                  "x = 'x'\ny = '0'\nz = '" +
                  slope +
                  "'\n[[manifold]]\nname = 'line'\n"
                  "equations = ['y = 0', 'z = 0']\n"),
               4);
    EXPECT_FALSE(found.obstruction) << slope;
    EXPECT_THAT(found.open, testing::HasSubstr("which is not an obstruction")) << slope;
  }
}

// t = 0 and cos(t) = -1: nothing is there.  Functions whose relations are not known: a hypothesis.
TEST(Quadratures, TheCurveMustHavePoints) {
  const std::string begin =
      "[system]\nkind = 'lagrangian'\ncoordinates = ['r', 't']\n"
      "velocities = ['dr', 'dt']\nparameters = ['E']\n"
      "lagrangian = '(5*dr^2/2 + r^2*dt^2)/2 - r*(3/2 + cos(t))'\n"
      "[[manifold]]\nname = 'line'\nlevel = 'H = E'\nequations = ['p_t = 0', ";
  EXPECT_TRUE(orders(of(begin + "'sin_t = 0', 'cos_t = -1']\n"), 3).obstruction);
  const auto nowhere = orders(of(begin + "'t = 0', 'sin_t = 0', 'cos_t = -1']\n"), 3);
  EXPECT_FALSE(nowhere.obstruction);
  EXPECT_THAT(nowhere.open, testing::HasSubstr("no points"));
  const auto unknown = orders(
      of("[system]\nkind = 'hamiltonian'\ncoordinates = ['r', 't']\nmomenta = ['p', 'L']\n"
         "parameters = ['E']\nhamiltonian = '(p^2*2/5 + L^2/r^2)/2 + r*(3/2 - c)'\n"
         "[[system.function]]\nname = 'c'\nderivative = {t = '-s'}\n"
         "[[system.function]]\nname = 's'\nderivative = {t = 'c'}\n"
         "[[manifold]]\nname = 'any'\nequations = ['L = 0', 's = 0', 'c = 1']\nlevel = 'H = E'\n"),
      3);
  ASSERT_TRUE(unknown.obstruction) << unknown.open;
  EXPECT_THAT(unknown.obstruction->unchecked, testing::HasSubstr("meant by c, s"));
  EXPECT_EQ(orders(atwood("3/2"), 3).obstruction->unchecked, "");
}

TEST(Quadratures, ALimitIsToldAndDoesNoMore) {
  const System s = atwood("3/2");
  const auto found = orders_by_quadratures(s, s.manifolds.front(), 3, Budget::of_seconds(0));
  EXPECT_FALSE(found.obstruction);
  EXPECT_THAT(found.open, testing::HasSubstr("limit"));
}

TEST(Quadratures, WhatItIsNotForIsSaid) {
  const System parameters =
      of("[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
         "parameters = ['a']\nhamiltonian = '(u^2 + v^2)/2 + x^3 + a*x*y^2'\n[[manifold]]\n"
         "name = 'line'\nequations = ['y = 0', 'v = 0']\n");
  EXPECT_FALSE(orders(parameters, 2).obstruction);
  EXPECT_EQ(orders(parameters, 2).open, "");
  const System elliptic =
      of("[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
         "parameters = ['E']\nhamiltonian = '(u^2 + v^2)/2 + x^3 + x + x*y^2'\n[[manifold]]\n"
         "name = 'line'\nequations = ['y = 0', 'v = 0']\nlevel = 'H = E'\n");
  EXPECT_THAT(orders(elliptic, 2).open, testing::HasSubstr("rationally"));
}

} // namespace
} // namespace kov
