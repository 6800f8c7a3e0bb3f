// Questions of users that are decided, each with its siblings; and those that are not yet.

#include "classify/classify.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace kov::users_test {
namespace {

Verdict status(const std::string& text, double seconds = 60) {
  ClassifyOptions options;
  options.check.decide.budget.give(1e8 * seconds);
  return classify_system(read_system(parse_document(text, "user.toml")), options).status();
}
std::string planar(const std::string& h, const std::string& parameters = "") {
  return "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
         "parameters = [" +
         parameters + "]\nhamiltonian = '" + h + "'\n";
}
std::string line(const std::string& force, const std::string& parameters = "") {
  return "[system]\nkind = 'vector-field'\ncoordinates = ['x', 'v']\nparameters = [" + parameters +
         "]\n[system.field]\nx = 'v'\nv = '" + force + "'\n";
}

// A charge in a uniform field and a potential of one coordinate, in any gauge.
TEST(Users, GaugesOfAUniformField) {
  for (const std::string h :
       {"((u - y)^2 + v^2)/2 - cos(x)", "(u^2 + (v + x)^2)/2 - cos(x)",
        "((u - y/2)^2 + (v + x/2)^2)/2 - cos(x)", "((u - y - x^2)^2 + v^2)/2 + x^4"})
    EXPECT_EQ(status(planar(h)), Verdict::integrable) << h;
}

TEST(Users, ForcesThatAreRational) {
  for (const std::string force : {"1/x", "-1/(x - 1)", "a/x", "a*x + b/x", "-1/x^2", "1/x - 1/x^2"})
    EXPECT_EQ(status(line(force, "'a', 'b'")), Verdict::integrable) << force;
}

// One option further than the usual: the degree, the power of a denominator, large coefficients.
TEST(Users, WhatIsOneOptionAwayIsTried) {
  EXPECT_EQ(status(line("v^2/x + x^2")), Verdict::integrable);
  EXPECT_EQ(status(line("v^2/x + a*x^2 + b", "'a', 'b'")), Verdict::integrable);
  EXPECT_EQ(status("[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y', 'z']\n"
                   "momenta = ['p', 'q', 'r']\nparameters = ['a']\nhamiltonian = "
                   "'(p^2+q^2+r^2)/2 + a*exp(x+y-2*z) + exp(x-y) + exp(-2*x+y+z)'\n"),
            Verdict::integrable);                                                // of degree 6
  EXPECT_EQ(status(planar("u + v^2/(2*x^2) + x^2*y^6/6")), Verdict::integrable); // Lane-Emden
  // The swinging Atwood machine with three times the mass: the square of an integral in half the angle, of degree 4
  // and with coefficients of degree 11 over r^4.
  EXPECT_EQ(
      status("[system]\nkind = 'hamiltonian'\ncoordinates = ['r', 't']\nmomenta = ['p', 'l']\n"
             "hamiltonian = 'p^2/8 + l^2/(2*r^2) + r*(3 - cos(t))'\n"),
      Verdict::integrable);
}

// Exponent differences of two curves in the ratio of two parameters, by its square.
TEST(Users, ARatioOfParametersHasFewCommonValues) {
  for (const std::string v : {"V*sin(a*x)*sin(b*y)", "V*cos(a*x)*sin(b*y)"})
    EXPECT_EQ(status(planar("(u^2 + v^2)/2 + " + v, "'V', 'a', 'b'")), Verdict::depends) << v;
}

// Integrals that are products of invariant functions, too few of them: they stand with what is open.
TEST(Users, WhatIsFoundIsShown) {
  ClassifyOptions options;
  options.check.decide.budget.give(2e7);
  const auto c =
      classify_system(read_system(parse_document(
                          "[system]\nkind = 'vector-field'\ncoordinates = ['c1', 'c2', 'c3', "
                          "'d1', 'd2', 'd3']\n[system.field]\n"
                          "c1 = 'c1*(d2-d1+c2-c3)'\nc2 = 'c2*(d3-d2+c3-c1)'\n"
                          "c3 = 'c3*(d1-d3+c1-c2)'\nd1 = 'd1*(c1-c3)'\n"
                          "d2 = 'd2*(c2-c1)'\nd3 = 'd3*(c3-c2)'\n",
                          "toda.toml")),
                      options);
  ASSERT_FALSE(c.strata.empty());
  EXPECT_EQ(c.strata.back().integrals.size(), 4U);
}

TEST(Users, LinearSystemsWithManyParameters) {
  EXPECT_EQ(status(planar("(u^2 + v^2)/2 + (x - m)^2/(2*s^2) + (y - n)^2/(2*t^2) - a*x*y",
                          "'m', 's', 'n', 't', 'a'")),
            Verdict::integrable);
  EXPECT_EQ(status(planar("a*u^2 + b*v^2 + c*x*v + d*y*u + e*x^2 + f*x*y",
                          "'a', 'b', 'c', 'd', 'e', 'f'")),
            Verdict::integrable);
}

// Integrals that do not suffice are told.
TEST(Users, IntegralsOfAnOpenSystem) {
  const SystemClassification c = classify_system(read_system(parse_document(
      "[system]\nkind = 'vector-field'\ncoordinates = ['x', 'y', 'z', 'w']\n[system.field]\n"
      "x = 'x*(y - z)'\ny = 'y*(z - x)'\nz = 'z*(x - y)'\nw = 'w^2*x + x*y + 1'\n",
      "user.toml")));
  ASSERT_EQ(c.status(), Verdict::undecided);
  EXPECT_EQ(c.strata.front().integrals.size(), 2);
}

// Each root with a parameter of its own.
TEST(Users, RelativisticCentralForces) {
  EXPECT_EQ(status(planar("-k/sqrt(e + x^2 + y^2) + sqrt(u^2 + v^2 + m^2)", "'k', 'e', 'm'")),
            Verdict::integrable);
  EXPECT_EQ(status(planar("sqrt(u^2 + v^2 + m^2) + k*(x^2 + y^2)", "'k', 'm'")),
            Verdict::integrable);
}

TEST(Users, InverseSquaresBesideAQuartic) {
  EXPECT_EQ(status(planar("(u^2 + v^2)/2 + x^4 + 6*x^2*y^2 + y^4 + a/x^2 + b/y^2", "'a', 'b'"),
                   600), // a third of a second, but on a busy machine
            Verdict::integrable);
}

// A cubic potential beside a third degree of freedom: constants of its planes get values on the way.
TEST(Users, CubicPotentialsInSpace) {
  const auto in_space = [](const std::string& potential) {
    return "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y', 'z']\nmomenta = ['u', 'v', "
           "'w']\nparameters = ['a']\nhamiltonian = '(u^2 + v^2 + w^2)/2 + " +
           potential + "'\n";
  };
  for (const std::string potential : {"x^2*y + a*y^3 + z^2", "(x^2 + y^2)*z + a*z^3"})
    EXPECT_EQ(status(in_space(potential)), Verdict::depends) << potential;
}

// The moments and the lever in a frame that is turned: the theorem is the same.
TEST(Users, TopsInATurnedFrame) {
  const auto on_e3 = [](const std::string& h) {
    return "[system]\nkind = 'euler-poisson'\ncoordinates = ['M1', 'M2', 'M3', 'G1', 'G2', 'G3']\n"
           "parameters = ['x']\nhamiltonian = '" +
           h + "'\n";
  };
  EXPECT_EQ(status(on_e3("G1/3 + G2/3 + 4*G3/3 + 11*M1^2/18 - 4*M1*M2/9 - 4*M1*M3/9 + "
                         "17*M2^2/18 + 8*M2*M3/9 + 17*M3^2/18")),
            Verdict::non_integrable);
  EXPECT_EQ(status(on_e3("2*G1*x/3 - G2*x/3 + 2*G3*x/3 + 5*M1^2/6 - 2*M1*M3/3 + 7*M2^2/6 + "
                         "2*M2*M3/3 + M3^2")),
            Verdict::depends);
  // Lagrange's top, turned by the angle with the cosine 3/5
  EXPECT_EQ(status(on_e3("M1^2/2 + (3*M2 - 4*M3)^2/50 + (4*M2 + 3*M3)^2/25 + x*(4*G2 + 3*G3)")),
            Verdict::integrable);
}

// H = H_1 + H_2 along what excludes H_1, where H_2 rests.
TEST(Users, PartsThatDoNotMeet) {
  for (const std::string more : {"w^2/2 - cos(z)", "w^2/2 + z^3/3 - z", "w^2/2 + (z - 2)^4"})
    EXPECT_EQ(status("[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y', 'z']\n"
                     "momenta = ['u', 'v', 'w']\n"
                     "hamiltonian = '(u^2 + v^2)/2 + x^2*y + y^3 + " +
                     more + "'\n"),
              Verdict::non_integrable)
        << more;
}

// 4 b^2 + c^2 = 0, c != 0 is a set of its own for complex parameters, and empty for real ones.
TEST(Users, NoSetsWithoutRealPoints) {
  const std::string ball =
      "[system]\nkind = 'euler-poisson'\n"
      "coordinates = ['M1', 'M2', 'M3', 'Gamma1', 'Gamma2', 'Gamma3']\nparameters = ['b', 'c']\n"
      "hamiltonian = '(M1^2 + M2^2 + M3^2)/2 + b*(Gamma1^2 - Gamma2^2) + c*Gamma1*Gamma2'\n";
  const auto sets = [&](const std::string& assumed) {
    ClassifyOptions options;
    options.check.decide.budget.give(1e9);
    const SystemClassification c =
        classify_system(read_system(parse_document(ball + assumed, "user.toml")), options);
    EXPECT_EQ(c.status(), Verdict::integrable) << assumed;
    return c.strata.size();
  };
  const std::size_t complex = sets("");
  EXPECT_EQ(sets("[assume]\nb = 'real'\nc = 'real'\n"), complex - 1);
  EXPECT_EQ(sets("[assume]\nb = 'real'\n"), complex);
}

// The work ends while one part of the parameters is studied; Clebsch's case, of low degree, waits and is
// found all the same.
TEST(Users, IntegralsOfLowDegreeWhereTheWorkEnds) {
  const std::string body =
      "[system]\nkind = 'euler-poisson'\n"
      "coordinates = ['M1', 'M2', 'M3', 'Gamma1', 'Gamma2', 'Gamma3']\n"
      "parameters = ['A', 'B', 'C', 'p', 'q', 's']\n"
      "hamiltonian = 'M1^2/(2*A) + M2^2/(2*B) + M3^2/(2*C) + (p*Gamma1^2 + q*Gamma2^2 + "
      "s*Gamma3^2)/2'\n[assume]\nA = 'positive'\nB = 'positive'\nC = 'positive'\n"
      "p = 'real'\nq = 'real'\ns = 'real'\n";
  const auto is_clebsch = [](const ClassifiedStratum& x) {
    const auto equations = x.where.equations();
    return x.status == StratumStatus::integrable && equations.size() == 1 &&
           equations.front().length() == 6;
  };
  for (const double work : {3e8, 1.3e9}) {
    ClassifyOptions options;
    options.check.decide.budget.give(work);
    const SystemClassification c =
        classify_system(read_system(parse_document(body, "user.toml")), options);
    EXPECT_TRUE(std::ranges::any_of(c.strata, is_clebsch)) << work;
  }
}

// Known failures: this test turns red when one of them passes.  Then it moves to the tests above.
TEST(Users, KnownFailures) {
  const std::vector<std::string> failures{
      // an uncoupled system without a rest: only rational integrals would be excluded
      "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y', 'z']\nmomenta = ['u', 'v', 'w']\n"
      "hamiltonian = '(u^2 + v^2 + w^2)/2 + x^4 + 3*x^2*y^2 + y^4 + 1/z'\n"};
  for (const std::string& text : failures)
    EXPECT_EQ(status(text, 1), Verdict::undecided) << "known to fail, and passes now: move it\n"
                                                   << text;
}

} // namespace
} // namespace kov::users_test
