#include "integrability/levels.hpp"
#include "support/checked.hpp"
#include "support/source_dir.hpp"
#include "symbol/input_error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov::pipeline_test {
namespace {

using testing::HasSubstr;

ManifoldReport run(const std::string& text) { return test::checked(text); }

std::string all_reasons(const ManifoldReport& m) {
  std::string all;
  for (const auto& r : reasons(m))
    all += r + "\n";
  return all;
}

const std::string two_degrees = R"t([system]
kind = "hamiltonian"
coordinates = ["q1", "q2"]
momenta = ["p1", "p2"]
parameters = ["a", "b", "h"]
hamiltonian = "(p1^2 + p2^2)/2 + a*q1^2*q2 + b/3*q2^3"
[[manifold]]
name = "axis"
equations = ["q1 = 0", "p1 = 0"]
level = "H = h"
)t";

TEST(Pipeline, WithoutAChangeOneIsProposed) {
  const ManifoldReport m = run(two_degrees + "[set]\na = \"1/4\"\nb = \"1\"\nh = \"1\"");
  ASSERT_EQ(m.blocks.size(), 1U);
  ASSERT_TRUE(m.blocks[0].ode);
  EXPECT_EQ(m.verdict, Verdict::non_integrable); // lambda = 2a = 1/2
}

TEST(Pipeline, ProposalsDoNotChangeTheAnswer) {
  for (const char* change : {"z = q2", "z = q2^3", "z = p2", "z = 1/q2"}) {
    const ManifoldReport m =
        run(two_degrees + "[set]\na = \"1/4\"\nb = \"1\"\nh = \"1\"\n[reduce]\nchange = \"" +
            change + "\"");
    EXPECT_EQ(m.verdict, Verdict::non_integrable) << change << "\n" << all_reasons(m);
  }
}

TEST(Pipeline, AChangeMustNotBeConstant) {
  const ManifoldReport m = run(
      two_degrees + "[set]\na = \"1\"\nb = \"1\"\nh = \"1\"\n[reduce]\nchange = \"z = q1 + 1\"");
  EXPECT_EQ(m.verdict, Verdict::undecided);
  EXPECT_THAT(all_reasons(m), HasSubstr("constant along the curve"));
}

TEST(Pipeline, WhatIsLeftForFreeParametersIsSaid) {
  const ManifoldReport m = run(two_degrees);
  EXPECT_EQ(m.verdict, Verdict::undecided);
  EXPECT_THAT(all_reasons(m), HasSubstr("abelian only if"));
}

TEST(Pipeline, QuadraticExtensionsAreRecognised) {
  const std::string file = test::in_source("/cases/sliding_top/lemma2.toml");
  System s = read_system(file, {{"a", "3"}, {"b", "2"}, {"c", "4"}, {"d", "1/2"}, {"h", "1"}});
  s.reductions[0].change = formula(s, "Gamma1");
  const ManifoldReport given = test::checked(study::FileStudy(s));
  EXPECT_EQ(given.verdict, Verdict::undecided);
  EXPECT_THAT(all_reasons(given), HasSubstr("quadratic extension"));
  EXPECT_THAT(all_reasons(given), HasSubstr("would do"));
  s.reductions[0].change.reset();
  EXPECT_EQ(test::checked(study::FileStudy(s)).verdict, Verdict::non_integrable);
}

// Three degrees of freedom: two normal blocks of order 2 each, or one of order 4.
const std::string three_degrees = R"t([system]
kind = "hamiltonian"
coordinates = ["q1", "q2", "q3"]
momenta = ["p1", "p2", "p3"]
parameters = ["c", "h"]
hamiltonian = "(p1^2 + p2^2 + p3^2)/2 + q3^3/3 + q3*(q1^2 + 3*q2^2)/4 + c*q1*q2"
[[manifold]]
name = "axis"
equations = ["q1 = 0", "p1 = 0", "q2 = 0", "p2 = 0"]
level = "H = h"
)t";

TEST(Pipeline, BlocksAreStudiedOneByOne) {
  const ManifoldReport m = run(three_degrees + "[set]\nc = \"0\"\nh = \"1\"");
  ASSERT_EQ(m.blocks.size(), 2U);
  EXPECT_EQ(m.verdict, Verdict::non_integrable); // lambda = 1/2
}

TEST(Pipeline, ABlockOfOrderFourIsReported) {
  const ManifoldReport m = run(three_degrees + "[set]\nc = \"1\"\nh = \"1\"");
  ASSERT_EQ(m.blocks.size(), 1U);
  EXPECT_EQ(m.verdict, Verdict::undecided);
  EXPECT_THAT(all_reasons(m),
              HasSubstr("a normal block of order 4: not reducible to second order"));
}

TEST(Pipeline, NonlinearManifoldEquations) {
  // the same curve, its equations mixed and one of them not linear
  const std::string text =
      two_degrees + "[set]\na = \"1/4\"\nb = \"1\"\nh = \"1\"\n[reduce]\nchange = \"z = q2^3\"";
  const ManifoldReport plain = run(text);
  std::string mixed = text;
  const std::string old = R"t(["q1 = 0", "p1 = 0"])t";
  mixed.replace(mixed.find(old), old.size(),
                R"t(["q1 = p1*q2", "p1 = q1*p2*q2^2", "q1*p2 = 0", "p1*p2 = 0", "q1 = 0"])t");
  const ManifoldReport other = run(mixed);
  ASSERT_TRUE(other.blocks.at(0).ode) << all_reasons(other);
  EXPECT_EQ(other.verdict, plain.verdict);
}

TEST(Pipeline, EquationsWithMultiplicities) {
  const std::string text = two_degrees + "[set]\na = \"1/4\"\nb = \"1\"\nh = \"1\"";
  const std::string old = R"t(["q1 = 0", "p1 = 0"])t";
  const auto with = [&](const std::string& equations) {
    std::string t = text;
    return run(t.replace(t.find(old), old.size(), equations));
  };
  EXPECT_EQ(with(R"t(["q1^2 = 0", "p1^3 = 0"])t").verdict, run(text).verdict); // the same set
  const ManifoldReport hidden = with(R"t(["q1^2 + p1 = 0", "p1 = 0"])t");
  EXPECT_EQ(hidden.verdict, Verdict::undecided);
  EXPECT_THAT(all_reasons(hidden), HasSubstr("without multiplicities"));
}

TEST(Pipeline, NormalDirectionsOfAWholeCurve) {
  // all equations of the curve given: three normal variations, dH takes one away
  std::string text =
      two_degrees + "[set]\na = \"1/4\"\nb = \"1\"\nh = \"1\"\n[reduce]\nchange = \"z = q2^3\"";
  const std::string old = R"t(equations = ["q1 = 0", "p1 = 0"]
level = "H = h")t";
  text.replace(text.find(old), old.size(),
               R"t(equations = ["q1 = 0", "p1 = 0", "p2^2/2 + b*q2^3/3 = h"])t");
  const ManifoldReport m = run(text);
  EXPECT_EQ(m.normal.system.names.size(), 3U);
  EXPECT_EQ(m.reduced.eliminations.size(), 1U);
  EXPECT_EQ(m.verdict, Verdict::non_integrable) << all_reasons(m);
}

TEST(Pipeline, AlgebraicConstants) {
  // a Darboux point that is not rational: the plane q1 = s q2 with s^2 = 2
  const std::string text = R"t([system]
kind = "hamiltonian"
coordinates = ["q1", "q2"]
momenta = ["p1", "p2"]
parameters = ["h"]
constants = ["s"]
relations = ["s^2 = 2"]
hamiltonian = "(p1^2 + p2^2)/2 + (q1^2 + q2^2)^2/4 + q1*q2*(q1^2 - 2*q2^2)"
[[manifold]]
name = "plane"
equations = ["q1 = s*q2", "p1 = s*p2"]
level = "H = h"
)t";
  const ManifoldReport m = run(text);
  ASSERT_TRUE(m.failure); // d/dt (p1 - s p2) is not 0 there: the message shows its value
  EXPECT_THAT(m.failure->message, HasSubstr("not invariant"));
}

// q1 occurs through its sine and cosine only: the curve lives in (p1, s, c).  With z = cos q1 the
// normal equation is Lame's with n(n+1) = 2a.
ManifoldReport pendulum(const std::string& a, const std::string& reduce) {
  return run(R"t([system]
kind = "hamiltonian"
coordinates = ["q1", "q2"]
momenta = ["p1", "p2"]
parameters = ["a", "E"]
hamiltonian = "(p1^2 + p2^2)/2 - c + a*c*q2^2/2"
relations = ["s^2 + c^2 = 1"]
[[system.function]]
name = "s"
derivative = { q1 = "c" }
[[system.function]]
name = "c"
derivative = { q1 = "-s" }
[[manifold]]
equations = ["q2 = 0", "p2 = 0"]
level = "H = E"
[set]
a = ")t" + a +
             "\"\n" + reduce);
}

TEST(Pipeline, AngularVariables) {
  const std::string level = "E = \"2\"\n";
  EXPECT_EQ(pendulum("1", level).verdict, Verdict::no_obstruction); // n = 1
  EXPECT_EQ(pendulum("3", level).verdict, Verdict::no_obstruction); // n = 2
  const ManifoldReport m = pendulum("2", level);
  EXPECT_EQ(m.verdict, Verdict::non_integrable) << all_reasons(m); // n is not rational
  EXPECT_EQ(pendulum("2", level + "[reduce]\nchange = \"z = s/(1 + c)\"").verdict,
            Verdict::non_integrable);
  EXPECT_THAT(all_reasons(pendulum("2", level + "[reduce]\nchange = \"z = q1\"")),
              HasSubstr("not algebraic on the curve"));
}

// q1 occurs as e = exp(q1): z = e gives exponent differences 0, 1/2, sqrt(1/4 + 2a).
TEST(Pipeline, Exponentials) {
  const std::string text = R"t([system]
kind = "hamiltonian"
coordinates = ["q1", "q2"]
momenta = ["p1", "p2"]
parameters = ["a"]
hamiltonian = "(p1^2 + p2^2)/2 + e + a*e*q2^2/2"
[[system.function]]
name = "e"
means = "exp(q1)"
derivative = { q1 = "e" }
[[manifold]]
equations = ["q2 = 0", "p2 = 0"]
level = "H = 1"
[set]
a = "1/2"
)t";
  const ManifoldReport m = run(text);
  EXPECT_EQ(m.verdict, Verdict::non_integrable) << all_reasons(m);
  ASSERT_TRUE(m.blocks.at(0).ode);
}

TEST(Pipeline, TheEnergyParameterNeedNotBeCalledH) {
  const ManifoldReport m = pendulum("2", "[reduce]\nchange = \"z = c\"\nenergy = \"auto\"");
  EXPECT_EQ(m.verdict, Verdict::non_integrable) << all_reasons(m);
  EXPECT_EQ(m.blocks.at(0).special.size(), 2U); // E = 1 and E = -1
}

TEST(Pipeline, GeneralVectorFields) {
  const ManifoldReport m = run(R"t([system]
kind = "vector-field"
coordinates = ["x", "y", "w"]
[system.field]
x = "y"
y = "x*w"
w = "1"
[[manifold]]
name = "line"
equations = ["x = 0", "y = 0"]
)t");
  EXPECT_EQ(m.by->theorem, &ayoul_zung());
  EXPECT_EQ(m.verdict, Verdict::non_integrable);                      // Airy's equation
  EXPECT_EQ(m.by->integrals.near, IntegralClass::Near::closed_curve); // its infinity is irregular
}

// A coordinate on which nothing depends, and which moves: the curve is an infinite cover of what is
// studied.  The first two systems are integrable with integrals that contain it.
TEST(Pipeline, CyclicCoordinatesThatMove) {
  const std::string borel = "((s + x/(x-1))^2 - x/(x-1)^2)";
  const std::string head = "constants = ['s']\nrelations = ['s^2 = 2']\n";
  const ManifoldReport cyclic = run("[system]\nkind = 'hamiltonian'\n" + head +
                                    "coordinates = ['x', 'phi', 'q']\nmomenta = ['px', 'pphi', "
                                    "'p']\nhamiltonian = 'x*px + pphi + p^2/2 - " +
                                    borel +
                                    "*q^2/2'\n[[manifold]]\nname = 'N'\nequations = ['q = 0', "
                                    "'p = 0', 'px = 0', 'pphi = 0']\n");
  EXPECT_EQ(cyclic.verdict, Verdict::non_integrable);
  EXPECT_EQ(cyclic.by->integrals.without.size(), 1U);
  EXPECT_THAT(statement(cyclic), testing::HasSubstr("do not depend on phi"));
  const ManifoldReport exponential = run(
      "[system]\nkind = 'hamiltonian'\n" + head +
      "coordinates = ['q1', 'q2']\nmomenta = ['p1', 'p2']\nhamiltonian = 'p1 + p2^2/2 - ((s + "
      "u/(u-1))^2 - u/(u-1)^2)*q2^2/2'\n[[system.function]]\nname = 'u'\nmeans = "
      "'exp(q1)'\nderivative = {q1 = 'u'}\n[[manifold]]\nname = 'N'\nequations = ['q2 = 0', 'p2 "
      "= 0']\nlevel = 'H = 0'\n");
  EXPECT_EQ(exponential.verdict, Verdict::non_integrable);
  EXPECT_THAT(statement(exponential),
              testing::HasSubstr("do not depend on q1 otherwise than through u"));
  const auto field = [&](const std::string& phi, const std::string& v) {
    return run("[system]\nkind = 'vector-field'\n" + head +
               "coordinates = ['x', 'phi', 'y', 'v']\n[system.field]\nx = 'x'\nphi = '" + phi +
               "'\ny = 'v'\nv = '" + v +
               "*y'\n[[manifold]]\nname = 'N'\nequations = ['y = 0', "
               "'v = 0']\n");
  };
  EXPECT_EQ(field("1", borel).by->integrals.without.size(), 1U);
  EXPECT_TRUE(field("0", borel).by->integrals.without.empty()); // it stands still
  // SL(2, C) at regular singular places stays SL(2, C) over every such cover.
  const ManifoldReport sl2 = field("1", "(1/3 + x/(7*(x - 1)^2))");
  EXPECT_EQ(sl2.verdict, Verdict::non_integrable);
  EXPECT_TRUE(sl2.by->integrals.without.empty());
  EXPECT_EQ(field("1", "(1 + x)").by->integrals.without.size(), 1U); // an irregular place
}

TEST(Energies, MergingLocus) {
  const System s = read_system(parse_document(two_degrees, "test.toml"));
  const MFraction r = formula(s, "1/((z^2 - h)*(z - 2))");
  std::vector<std::string> names;
  for (const auto& f : merging_locus(r, s.z, s.ring()->index("h")))
    names.push_back(to_string(f));
  EXPECT_EQ(names, (std::vector<std::string>{"h", "h - 4"}));
}

} // namespace
} // namespace kov::pipeline_test
