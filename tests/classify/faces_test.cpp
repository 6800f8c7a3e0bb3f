// Systems with exponentials: what is excluded where some of them are 0, and what is not.

#include "classify/faces.hpp"

#include "classify/classify.hpp"
#include "exact/error.hpp"
#include "support/points.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov::faces_test {
namespace {

using test::status_at;

System of(const std::string& coordinates, const std::string& momenta, const std::string& parameters,
          const std::string& hamiltonian, const std::string& more = "") {
  return read_system(parse_document(
      "[system]\nkind = 'hamiltonian'\ncoordinates = [" + coordinates + "]\nmomenta = [" + momenta +
          "]\nparameters = [" + parameters + "]\nhamiltonian = '" + hamiltonian + "'\n" + more,
      "test.toml"));
}
System plane(const std::string& parameters, const std::string& hamiltonian,
             const std::string& more = "") {
  return of("'x', 'y'", "'u', 'v'", parameters, hamiltonian, more);
}

SystemClassification classified(const System& s) {
  ClassifyOptions options;
  options.check.decide.budget.give(1e8 * 120);
  return classify_system(s, options);
}

// A1 x A1, A2, B2 twice and G2 twice, for real exponents; nothing stays open.
TEST(Faces, TwoExponentials) {
  const auto c = classified(plane("'s', 't'", "(u^2 + v^2)/2 + exp(x) + exp(t*y - s*x)",
                                  "[assume]\nt = 'positive'\ns = 'real'\n"));
  std::vector<std::string> integrable;
  for (const ClassifiedStratum& s : c.strata) {
    EXPECT_NE(s.status, StratumStatus::open);
    if (s.status != StratumStatus::integrable) continue;
    std::string where;
    for (const std::string& one : conditions(c, s.where))
      where += (where.empty() ? "" : ", ") + one;
    integrable.push_back(where);
  }
  EXPECT_THAT(integrable, testing::UnorderedElementsAre(
                              "s = 0", "s = 1/2, t^2 = 3/4", "t = 1/2, s = 1/2", "t = 1, s = 1",
                              "s = 3/2, t^2 = 3/4", "s = 1/2, t^2 = 1/12"));
}

// Integers m and 2/m, for complex m as well.
TEST(Faces, TwoIntegralConditionsWithoutRealParameters) {
  const auto c = classified(plane("'m'", "(u^2 + v^2)/2 + exp(x - y) + exp(m*y)"));
  for (const long m : {1, 2})
    EXPECT_EQ(status_at(c, {{"m", m}}), "integrable") << m;
  for (const Rational& m : {Rational(-1), Rational(-2), Rational(3), Rational(1, 2), Rational(4)})
    EXPECT_EQ(status_at(c, {{"m", m}}), "excluded") << to_string(m);
}

// Three particles on a line, the last with another mass: A2, B2 and G2, nothing else.
TEST(Faces, FewerExponentialsThanCoordinates) {
  const auto c = classified(of("'a', 'b', 'c'", "'u', 'v', 'w'", "'m'",
                               "(u^2 + v^2 + m*w^2)/2 + exp(a - b) + exp(b - c)"));
  EXPECT_EQ(status_at(c, {{"m", 1}}), "integrable");
  EXPECT_EQ(status_at(c, {{"m", 0}}), "integrable");
  EXPECT_EQ(status_at(c, {{"m", Rational(-1, 3)}}), "integrable"); // G2, of degree six
  for (const Rational& m :
       {Rational(2), Rational(-1, 2), Rational(-1), Rational(1, 2), Rational(-2)})
    EXPECT_EQ(status_at(c, {{"m", m}}), "excluded") << to_string(m);
}

// Nothing is said where the exponents depend on one another, or the equations cannot be solved.
TEST(Faces, TheirConditionsAreNamed) {
  const System s = plane("'s', 't'", "(u^2 + v^2)/2 + exp(x) + exp(t*y - s*x)");
  const MPoly t = MPoly::variable(s.ring(), "t");
  const auto all = exclusions_at_faces(s, {});
  ASSERT_FALSE(all.empty());
  for (const Exclusion& e : all) {
    const auto needs = [&](const MPoly& p) {
      return std::find(e.not_all_zero.begin(), e.not_all_zero.end(), std::vector{p}) !=
             e.not_all_zero.end();
    };
    EXPECT_TRUE(needs(t));
    EXPECT_EQ(e.by.integrals.without, (std::vector<std::string>{"x", "y"}));
    EXPECT_EQ(e.by.integrals.kind, IntegralClass::Kind::rational);
  }
}

// u is solved for by -t u + s v = c.
TEST(Faces, TheEquationsAreSolvedWhereTheyCanBe) {
  const System s = plane("'s', 't'", "(u^2 + v^2)/2 + exp(y) + exp(s*x + t*y)");
  const std::vector<MPoly> slope{-MPoly::variable(s.ring(), "t")};
  int solved = 0;
  for (const Exclusion& e : exclusions_at_faces(s, {}))
    if (e.by.solution.rfind("exp_y = 0", 0) == 0) {
      ++solved;
      EXPECT_EQ(std::count(e.not_all_zero.begin(), e.not_all_zero.end(), slope), 1)
          << e.by.solution;
    }
  EXPECT_GT(solved, 0);
}

// Open Toda lattices with all kinds of coefficients, masses and further degrees of freedom.
TEST(Faces, NoFalseAlarm) {
  for (const System& s : {plane("'m', 'k'", "(u^2 + v^2)/2 + k*exp(x - y) + m*exp(y)"),
                          plane("'k'", "(u^2 + 3*v^2)/2 + exp(x) + k*exp((y - x)/2)"),
                          plane("'m', 'k'", "(u^2 + v^2)/2 + exp(x - y) + k*exp(y) + m*exp(2*y)"),
                          plane("'m'", "(u^2 + v^2)/2 + exp(2*x) - 2*exp(x) + exp(2*y) + m*exp(y)"),
                          plane("'m'", "(u^2 + v^2)/2 + m*u + exp(x) + exp(y)"),
                          plane("'m'", "(u^2 + v^2)/2 + exp(x + m*y) + exp(m*x - y)"),
                          of("'x', 'y', 'q'", "'u', 'v', 'p'", "'m'",
                             "(u^2 + v^2 + p^2)/2 + exp(x) + exp(y) + m*q^4"),
                          of("'a', 'b', 'c'", "'u', 'v', 'w'", "'m'",
                             "(u^2 + v^2 + w^2)/2 + exp(a - b) + m*exp(b - c)")})
    for (const ClassifiedStratum& x : classified(s).strata)
      EXPECT_NE(x.status, StratumStatus::excluded) << to_string(*s.field.hamiltonian);
}

// A periodic lattice has a pole where an exponential is 0; other functions of the same coordinate.
TEST(Faces, WhereThereIsNone) {
  for (const System& s :
       {plane("'m'", "(u^2 + v^2)/2 + exp(x) + exp(-x/2 + m*y) + exp(-x/2 - m*y)"),
        plane("", "(u^2 + v^2)/2 + cos(x) + exp(y)"), plane("", "(u^2 + v^2)/2 + x*y"),
        plane("", "(u^2 + v^2)/2 + x*exp(x) + y^2")})
    EXPECT_FALSE(exponential_coordinates(s)) << to_string(*s.field.hamiltonian);
}

} // namespace
} // namespace kov::faces_test
