// Published classifications, found without a hint; and no false alarm where systems are integrable.

#include "classify/classify.hpp"

#include "classify/darboux_points.hpp"
#include "exact/error.hpp"
#include "study/proof_tree.hpp"
#include "support/points.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace kov::classify_test {
namespace {

using test::contains;
using test::Point;
using test::status_at;
using testing::AnyOf;
using testing::ElementsAre;
using testing::UnorderedElementsAre;

System planar(const std::string& hamiltonian, const std::string& parameters = "",
              const std::string& more = "") {
  return read_system(parse_document(
      "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
      "parameters = [" +
          parameters + "]\nhamiltonian = '" + hamiltonian + "'\n" + more,
      "test.toml"));
}

ClassifyOptions within(double seconds, long degree = 4) {
  ClassifyOptions options;
  options.check.decide.budget.give(1e8 * seconds);
  options.degree = degree;
  return options;
}

std::vector<std::vector<std::string>> strata_with(const SystemClassification& c,
                                                  StratumStatus status) {
  std::vector<std::vector<std::string>> all;
  for (const ClassifiedStratum& s : c.strata)
    if (s.status == status) all.push_back(conditions(c, s.where));
  return all;
}

TEST(Classify, EigenvalueChoicesAreThoseOfTheLiterature) {
  using Choice = std::vector<Rational>;
  EXPECT_THAT(eigenvalue_choices(3, 3, -1),
              UnorderedElementsAre(Choice{-1, -1, 1}, Choice{Rational(-7, 8), 14, 14},
                                   Choice{Rational(-2, 3), Rational(7, 3), 14},
                                   Choice{Rational(-2, 3), 4, 4}));
  EXPECT_THAT(eigenvalue_choices(4, 4, -1),
              UnorderedElementsAre(Choice{-1, -1, 2, 2}, Choice{Rational(-5, 8), 2, 14, 35},
                                   Choice{Rational(-5, 8), 2, 20, 20},
                                   Choice{Rational(-5, 8), Rational(27, 8), Rational(27, 8), 135},
                                   Choice{Rational(-5, 8), 5, 5, 5}));
  EXPECT_THAT(eigenvalue_choices(3, 2, -1), testing::IsEmpty());
  EXPECT_THAT(eigenvalue_choices(3, 1, -1), ElementsAre(Choice{-1}));
}

TEST(Classify, HenonHeiles) {
  const auto c = classify_system(
      planar("(u^2 + v^2 + A*x^2 + B*y^2)/2 + x^2*y + b/3*y^3", "'A', 'B', 'b'"), within(60));
  const auto at = [&](const Rational& a, const Rational& b, const Rational& beta) {
    return status_at(c, {{"A", a}, {"B", b}, {"b", beta}});
  };
  for (const auto& [a, b] : {std::pair(1, 1), std::pair(2, 5), std::pair(0, 0), std::pair(0, 1)})
    EXPECT_EQ(at(a, b, 6), "integrable") << a << ' ' << b;
  EXPECT_EQ(at(3, 3, 1), "integrable");
  EXPECT_EQ(at(1, 16, 16), "integrable");
  EXPECT_EQ(at(0, 0, 16), "integrable");
  for (const auto& beta : {Rational(-1), Rational(3), Rational(0), Rational(16, 5), Rational(3, 5)})
    EXPECT_EQ(at(1, 1, beta), "excluded") << to_string(beta);
  EXPECT_EQ(at(1, 1, 16), "excluded");
  // the first variational equations are abelian there, those of order 3 are not
  EXPECT_EQ(at(1, 2, 1), "excluded");
  EXPECT_EQ(at(1, 1, 2), "excluded");
  ASSERT_EQ(c.excluded.size(), 1U);
  EXPECT_EQ(c.excluded.front().kind, IntegralClass::Kind::rational);
}

// Where c = 0 in H = c p^2 + V(q) nothing is excluded by V, and q1, q2 are integrals.
TEST(Classify, TheKineticPartMayVanish) {
  const auto c = classify_system(planar("a*(u^2 + v^2)/2 + x^3 + 5*x*y^2", "'a'"), within(60));
  EXPECT_EQ(status_at(c, {{"a", 0}}), "integrable");
  EXPECT_EQ(status_at(c, {{"a", 1}}), "excluded");
}

TEST(Classify, OneLevelIsEnough) {
  // the published statement is about k + a != 0, and names no energy
  const auto c = classify_system(
      planar("(u^2 + v^2 + x^2 + y^2)/2 + a*x^2*y^2", "'a', 'h'",
             "[[manifold]]\nname = 'diagonal'\nequations = ['x = y', 'u = v']\nlevel = 'H = h'\n"),
      within(60));
  EXPECT_EQ(status_at(c, {{"a", 0}}), "integrable");
  EXPECT_EQ(status_at(c, {{"a", 1}}), "excluded");
  EXPECT_EQ(status_at(c, {{"a", -3}}), "excluded");
  EXPECT_EQ(c.status(), Verdict::depends);
  for (const ClassifiedStratum& s : c.strata) // h is not a parameter of the theorem
    for (const std::string& condition : conditions(c, s.where))
      EXPECT_EQ(condition.find('h'), std::string::npos) << condition;
}

TEST(Classify, IntegrableSystemsRaiseNoAlarm) {
  const std::vector<std::string> integrable = {
      "(u^2 + v^2)/2 + x^3/3 + a*y^3",
      "(u^2 + v^2)/2 + x^4 + 6*x^2*y^2 + y^4 + a*(x^2 + y^2)",
      "(u^2 + v^2)/2 + x^4 + 12*x^2*y^2 + 16*y^4 + a*(x^2 + 4*y^2)",
      "(u^2 + v^2)/2 + (x^2 + y^2)^2 + a*(x^2 + y^2)",
      "(u^2 + v^2)/2 + x^2*y + 2*y^3 + a*x^2",
      "(u^2 + v^2)/2 + x^2*y + 16/3*y^3 + a*(x^2 + 16*y^2)/2",
      "(u^2 + v^2)/2 + a*(x^2 + 4*y^2) + 1/x^2",
      "(u^2 + v^2)/2 + a*x*y",
      "(a*u^2 + v^2)/2 + x^2*y/a + 2*y^3 + 1/x^2", // a mass
      "(v^2 - u^2)/2 + 2*y^3 - x^2*y + a*x^2",     // indefinite
      "u*v + (x + y)^3 + a*(x - y)^3 + x*y",       // isotropic axes
      "(u^2 + v^2 + u*v)/2 + a*(x + 2*y)^4 + (5*x - 4*y)^4 + (x + 2*y)^2",
      "(u^2 + v^2)/2 - a*(x*v - y*u) + (x^2 + y^2)^2 + x^2 + y^2", // in a rotating frame
      "(u^2 + v^2)/2 + 1/x + a/y",
      "(u^2 + v^2)/2 + 1/(x + y)^4 + a/(x - y)^4",
      "(u^2 + v^2)/2 + a/(x^2 + y^2)^3",
      "(u^2 + v^2)/2 + x^2*y + 16*y^3/3 + 1/x^2 + a*(x^2 + 16*y^2)/2"};
  for (const std::string& h : integrable) {
    const auto c = classify_system(planar(h, "'a'"), within(30));
    EXPECT_THAT(strata_with(c, StratumStatus::excluded), testing::IsEmpty()) << h;
  }
}

bool excludes(const std::vector<Exclusion>& all, const System& s, const Point& point) {
  Substitution there;
  for (const auto& [name, value] : point)
    there[*s.ring()->find(name)] = MFraction(s.ring(), value);
  const auto vanishes = [&](const MPoly& p) { return is_zero(substitute(p, there)); };
  return std::any_of(all.begin(), all.end(), [&](const Exclusion& e) {
    return std::all_of(e.zero.begin(), e.zero.end(), vanishes) &&
           std::none_of(e.not_all_zero.begin(), e.not_all_zero.end(), [&](const auto& list) {
             return std::all_of(list.begin(), list.end(), vanishes);
           });
  });
}

// q -> Bq, p -> B^-T p: what the Darboux points exclude does not depend on the coordinates.
TEST(Classify, DarbouxPointsDoNotDependOnCoordinates) {
  const std::string form = "b*(X)^3/3 + c*(X)^2*(Y)/2 + (Y)^3/3";
  const auto at = [&](const std::string& kinetic, const std::string& x, const std::string& y) {
    std::string v = form;
    for (std::size_t i; (i = v.find_first_of("XY")) != std::string::npos;)
      v.replace(i, 1, v[i] == 'X' ? x : y);
    return planar(kinetic + " + " + v, "'b', 'c'");
  };
  const std::vector<System> systems = {
      at("(u^2 + v^2)/2", "x", "y"), at("(u^2 + (v - u)^2)/2", "x + y", "y"),
      at("(4*u^2 + v^2/9)/2", "x/2", "3*y"),
      at("((u + 2*v)^2 + (u - v)^2)/2", "(x + y)/3", "(2*x - y)/3")};
  std::vector<std::vector<Exclusion>> all;
  for (const System& s : systems)
    all.push_back(exclusions_by_darboux_points(s));
  for (long b = -2; b <= 2; ++b)
    for (const Rational& c : {Rational(0), Rational(1), Rational(2), Rational(1, 3), Rational(1, 8),
                              Rational(5), Rational(-3), Rational(7, 2)})
      for (std::size_t i = 1; i < systems.size(); ++i)
        EXPECT_EQ(excludes(all[i], systems[i], {{"b", b}, {"c", c}}),
                  excludes(all[0], systems[0], {{"b", b}, {"c", c}}))
            << i << " at " << b << ' ' << to_string(c);
}

// Potentials of negative degree, complex and indefinite masses, other terms beside the leading one.
TEST(Classify, DarbouxPointsOfAllDegrees) {
  const auto excluded = [](const std::string& h, const Rational& a) {
    const System s = planar(h, "'a'");
    return excludes(exclusions_by_darboux_points(s), s, {{"a", a}});
  };
  EXPECT_TRUE(excluded("u^2 + v^2 - u*v - 1/x - 1/y - a/(x + y)", 1)); // three bodies on a line
  EXPECT_FALSE(excluded("(u^2 + v^2)/2 + 1/x + 1/y + a/(x + y)", 0));
  EXPECT_TRUE(excluded("(u^2 + v^2)/2 - (x*v - y*u) + x^2*y - a*y^3/3", 1));
  EXPECT_FALSE(excluded("(u^2 + v^2)/2 - (x*v - y*u) + x^2*y + a*y^3/3", 6));
  EXPECT_FALSE(excluded("(u^2 + v^2)/2 - (1 + x)*(x*v - y*u) + x^2*y - a*y^3/3", 1));
  EXPECT_TRUE(excluded("(v^2 - u^2)/2 + x^4 + y^4 + a*x^2*y^2", 1));
  EXPECT_FALSE(excluded("(v^2 - u^2)/2 + x^4 + y^4 + a*x^2*y^2", -2)); // (x^2 - y^2)^2
  EXPECT_FALSE(excluded("(v^2 - u^2)/2 + x^4 + y^4 + a*x^2*y^2", -6)); // 1:6:1
  EXPECT_TRUE(excluded("(u^2 + v^2)/2 + x^2 + y^2 + x^2*y - a*y^3/3 + x/y^5", 1));
}

// A common factor of leading forms may vanish: then other parts lead, here an integrable system.
TEST(Classify, LeadingPartsOfSpecialParametersAreOthers) {
  const std::string v = "(x^4 + 6*x^2*y^2 + 8*y^4)";
  for (const std::string& h : std::vector<std::string>{
           "(u^2 + v^2)/2 + (a*(x^5 + x^4*y + 3*y^5) + " + v + ")/(a*y + 1)",
           "(u^2 + v^2)/2 + (a*(x^3 + 2*x^2*y - x*y^2 + 3*y^3) + (x + y)*" + v + ")/(a + x + y)",
           "(u^2 + v^2)/2 + (a*x^3/(x - y)^2 + x/y^3)/(a*x^2 + y)"}) {
    const System s = planar(h, "'a'");
    const auto all = exclusions_by_darboux_points(s);
    EXPECT_TRUE(excludes(all, s, {{"a", 1}})) << h;
    EXPECT_FALSE(excludes(all, s, {{"a", 0}})) << h;
  }
  // what is linear in the momenta is of lower weight for a != 0 only
  const System s = planar("(u^2 + v^2)/2 + u*y^3/(a*x^3 + 1) + x^4 + x^3*y + 3*y^4 + x^2", "'a'");
  EXPECT_TRUE(excludes(exclusions_by_darboux_points(s), s, {{"a", 1}}));
  EXPECT_FALSE(excludes(exclusions_by_darboux_points(s), s, {{"a", 0}}));
}

TEST(Classify, StrataAreDisjointAndCover) {
  const auto c = classify_system(planar("(u^2 + v^2)/2 + b*x^3/3 + c*x^2*y/2 + y^3/3", "'b', 'c'"),
                                 within(60));
  for (long b = -2; b <= 2; ++b)
    for (const Rational& value : {Rational(0), Rational(1), Rational(2), Rational(1, 3),
                                  Rational(1, 8), Rational(5), Rational(-3)}) {
      const std::string status = status_at(c, {{"b", b}, {"c", value}});
      EXPECT_THAT(status, testing::AnyOf("integrable", "excluded", "open"))
          << b << ' ' << to_string(value);
    }
  EXPECT_EQ(status_at(c, {{"b", 0}, {"c", Rational(1, 8)}}), "integrable");
  EXPECT_EQ(status_at(c, {{"b", 0}, {"c", Rational(1, 3)}}), "integrable");
  EXPECT_EQ(status_at(c, {{"b", 1}, {"c", 3}}), "excluded");
}

TEST(Classify, WithAllParametersGivenThereIsOneStatus) {
  const auto status = [](const std::string& h, int order = 3) {
    ClassifyOptions options = within(30);
    options.order = order;
    return classify_system(planar(h), options).status();
  };
  EXPECT_EQ(status("(u^2 + v^2)/2 + x^2*y - y^3/3"), Verdict::non_integrable);
  EXPECT_EQ(status("(u^2 + v^2)/2 + x^2*y + 2*y^3"), Verdict::integrable);
  const std::string higher = "(u^2 + v^2 + x^2 + 2*y^2)/2 + x^2*y + y^3/3";
  EXPECT_EQ(status(higher, 1), Verdict::undecided);
  EXPECT_EQ(status(higher), Verdict::non_integrable);
}

TEST(Classify, TheHeadlineIsThatOfItsSets) {
  const auto agree = [](const System& s, Verdict expected) {
    const SystemClassification c = classify_system(s, within(30));
    const study::Headline h = study::headline(c);
    EXPECT_EQ(h.verdict, expected) << to_string(h.verdict);
    EXPECT_EQ(h.trusted, c.trusted.size());
    EXPECT_EQ(h.excluded, c.excluded);
    EXPECT_TRUE(h.complete);
    for (const ClassifiedStratum& x : c.strata)
      for (const ClassifiedStratum& y : c.strata)
        if (x.status == StratumStatus::integrable && y.status == StratumStatus::excluded)
          EXPECT_NO_THROW(study::refuse_contradiction(
              s, y.by.front(), study::complete_integrals(s, x.integrals), x.where, cut_of(y.where)))
              << "each point belongs to one set";
  };
  agree(planar("(u^2 + v^2)/2 + x^2*y - y^3/3"), Verdict::non_integrable);
  agree(planar("(u^2 + v^2)/2 + x^2*y + 2*y^3"), Verdict::integrable);
  agree(planar("(u^2 + v^2 + x^2 + y^2)/2 + x^2*y + b*y^3", "'b'"), Verdict::depends);
  agree(planar("(u^2 + v^2)/2 + x^9*y + b*y^11*x^2 + x", "'b'"), Verdict::undecided);
}

// What is said of all parameters and what is said of one value must agree.
TEST(Classify, OneValueNeverContradictsAllOfThem) {
  std::mt19937 random(11);
  const auto coefficient = [&] { return std::to_string(static_cast<long>(random() % 5) - 2); };
  for (int k = 0; k < 6; ++k) {
    const std::string h = "(u^2 + v^2)/2 + " + coefficient() + "*(x^2 + a*y^2) + " + coefficient() +
                          "*x^2*y + a*y^3 + " + (k % 2 == 0 ? "0" : coefficient()) + "*x^2*y^2";
    const auto all = classify_system(planar(h, "'a'"), within(20, 2));
    for (const long a : {-2, 0, 1, 2}) {
      std::string special = h;
      for (auto at = special.find('a'); at != std::string::npos; at = special.find('a'))
        special.replace(at, 1, "(" + std::to_string(a) + ")");
      const std::string general = status_at(all, {{"a", a}});
      const auto one = classify_system(planar(special), within(20, 2)).status();
      EXPECT_FALSE(general == "integrable" && one == Verdict::non_integrable) << h << a;
      EXPECT_FALSE(general == "excluded" && one == Verdict::integrable) << h << a;
    }
  }
}

// Every snapshot covers the parameters, and what is decided in one stays as it is.
TEST(Classify, WhatIsProvedIsToldOnTheWay) {
  ClassifyOptions options = within(60);
  std::vector<SystemClassification> told;
  options.so_far = [&](const SystemClassification& c) { told.push_back(c); };
  const auto c =
      classify_system(planar("(u^2 + v^2)/2 + x^4 + a*x^2*y^2 + b*y^4", "'a', 'b'"), options);
  ASSERT_GT(told.size(), 3U);
  told.push_back(c);
  for (const Point& point :
       {Point{{"a", 0}, {"b", 5}}, Point{{"a", 2}, {"b", 1}}, Point{{"a", 6}, {"b", 1}},
        Point{{"a", 12}, {"b", 16}}, Point{{"a", 1}, {"b", 1}}, Point{{"a", -7}, {"b", 3}}}) {
    std::string before = "open";
    for (const SystemClassification& t : told) {
      const std::string now = status_at(t, point);
      EXPECT_TRUE(now == before || before == "open") << before << ", then " << now;
      EXPECT_THAT(now, testing::AnyOf("integrable", "excluded", "open"));
      before = now;
    }
  }
}

System of(const std::string& text) { return read_system(parse_document(text, "test.toml")); }

// The set of both directions of the pendulum falls into two phase curves.
TEST(Classify, TheVerticalOfAPendulumIsFound) {
  const auto c = classify_system(
      of("[system]\nkind = 'hamiltonian'\ncoordinates = ['r', 'f']\nmomenta = ['p', 'L']\n"
         "hamiltonian = '(p^2 + L^2/r^2)/2 - r*c + (r - 1)^2'\nrelations = ['s^2 + c^2 = 1']\n"
         "[[system.function]]\nname = 's'\nmeans = 'sin(f)'\nderivative = {f = 'c'}\n"
         "[[system.function]]\nname = 'c'\nmeans = 'cos(f)'\nderivative = {f = '-s'}\n"),
      within(60, 2));
  EXPECT_EQ(c.status(), Verdict::non_integrable);
}

// Casimirs that the file does not name.
TEST(Classify, TopsAreStudiedOnTheirLeaves) {
  const auto c = classify_system(
      of("system = {kind = 'euler-poisson', coordinates = ['M1', 'M2', 'M3', 'G1', 'G2', 'G3'], "
         "parameters = ['c'], hamiltonian = '(M1^2 + M2^2 + c*M3^2)/2 + G1'}"),
      within(60));
  EXPECT_EQ(status_at(c, {{"c", 1}}), "integrable");
  EXPECT_EQ(status_at(c, {{"c", 2}}), "integrable"); // Kovalevskaya
  EXPECT_EQ(status_at(c, {{"c", 3}}), "excluded");
  EXPECT_EQ(status_at(c, {{"c", Rational(1, 3)}}), "excluded");
  EXPECT_NE(status_at(c, {{"c", 4}}), "integrable"); // Goryachev-Chaplygin: on one level
}

TEST(Classify, ManyBodiesThatAreIntegrable) {
  for (const std::string v : {"1/(x-y)^2 + 3/(y-z)^2", "(x-y)^2 + 2/(x-y)^2 + z"}) {
    const auto c = classify_system(
        of("system = {kind = 'hamiltonian', coordinates = ['x', 'y', 'z'], momenta = ['u', 'v', "
           "'w'], hamiltonian = '(u^2 + v^2 + w^2)/2 + " +
           v + "'}"),
        within(300));
    EXPECT_EQ(c.status(), Verdict::integrable) << v;
  }
}

TEST(Classify, WhereNothingMovesEverythingIsConserved) {
  const auto c =
      classify_system(of("[system]\nkind = 'vector-field'\ncoordinates = ['x', 'y', 'z']\n"
                         "parameters = ['a', 'b', 'c']\n[system.field]\nx = '(b - c)*y*z'\n"
                         "y = '(c - a)*x*z'\nz = '(a - b)*x*y'\n"),
                      within(60));
  EXPECT_EQ(c.status(), Verdict::integrable);
}

// y'' = -x*y': the error function, beside a logarithm and a field.
TEST(Classify, LogarithmsAndFieldsTogether) {
  const auto c = classify_system(of("[system]\nkind = 'vector-field'\n"
                                    "coordinates = ['x', 'y', 'z']\n[system.field]\n"
                                    "x = '1'\ny = 'z'\nz = '-x*z'\n"),
                                 within(30, 2));
  EXPECT_EQ(c.status(), Verdict::integrable);
  EXPECT_EQ(integrals_text(c.strata.front()), "x^2 + 2*log(z), and the commuting field d/dy");
}

System chain(const std::string& potential, const std::string& parameters) {
  return of("[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y', 'z']\n"
            "momenta = ['u', 'v', 'w']\nparameters = [" +
            parameters + "]\nhamiltonian = '(u^2 + v^2 + w^2)/2 + " + potential + "'\n");
}

// Three particles on a line: the motion of their centre is not an obstacle.
TEST(Classify, ForcesBetweenParticles) {
  const auto c = classify_system(chain("((x - y)^2 + (y - z)^2 + (z - x)^2)/2"
                                       " + a*((x - y)^3 + (y - z)^3 + (z - x)^3)",
                                       "'a'"),
                                 within(60));
  EXPECT_EQ(c.status(), Verdict::depends);
  EXPECT_EQ(places(c, {StratumStatus::integrable}), std::vector<std::string>{"a = 0"});
  EXPECT_THAT(c.strata.back().by.front().solution, // which of them the work decides
              AnyOf("x = 0, y = -z, u = 0, v = -w", "x = -y, z = 0, u = -v, w = 0",
                    "x = -z, y = 0, u = -w, v = 0"));
}

// Lines over a square root of b are solutions, too, and nobody needs them.
TEST(Classify, ConstantsThatAreNotNeededAreNotSaid) {
  const auto c = classify_system(chain("b*((x - y)^4 + (y - z)^4 + (z - x)^4)", "'b'"), within(60));
  EXPECT_EQ(c.status(), Verdict::integrable);
  EXPECT_TRUE(c.constants.empty());
}

// Quartic forces on a ring of three are integrable, as the square of the quadratic ones.
TEST(Classify, QuarticForcesBetweenParticles) {
  const auto c = classify_system(chain("(x - y)^4 + (y - z)^4 + (z - x)^4", ""), within(60));
  EXPECT_EQ(c.status(), Verdict::integrable);
}

TEST(Classify, CommutingFields) {
  const auto c = classify_system(of("[system]\nkind = 'vector-field'\n"
                                    "coordinates = ['x', 'y', 'z']\nparameters = ['a']\n"
                                    "[system.field]\nx = 'y'\ny = '-x - y*z'\n"
                                    "z = 'a*(y^2 - 1)'\n"),
                                 within(30));
  EXPECT_EQ(c.status(), Verdict::depends);
  EXPECT_EQ(integrals_text(c.strata.front()), "z, and the commuting field x*d/dx + y*d/dy");
}

TEST(Classify, LogarithmsAreSaid) {
  const auto c = classify_system(of("[system]\nkind = 'vector-field'\ncoordinates = ['x', 'y']\n"
                                    "[system.field]\nx = 'x - x*y'\ny = 'x*y - y'\n"),
                                 within(30));
  EXPECT_EQ(statement(c),
            "The system is integrable, with logarithms in some of the first integrals.");
  const auto with_parameter = classify_system(
      of("[system]\nkind = 'vector-field'\ncoordinates = ['x', 'y']\nparameters = ['a']\n"
         "[system.field]\nx = 'a*(x - x*y)'\ny = 'a*(x*y - y)'\n"),
      within(30));
  EXPECT_EQ(statement(with_parameter), "The system is integrable, with logarithms in some of the "
                                       "first integrals, for all parameters.");
}

// Of real parameters none are left: that is not a theorem on all of them.
TEST(Classify, NoRealParametersIsAnErrorOfTheInput) {
  const auto classify = [](const std::string& assumed) {
    return classify_system(
        planar("(u^2 + v^2)/2 + x^4 + y^4 + a*x^2*y^2", "'a', 'b'", "[assume]\n" + assumed),
        within(20, 2));
  };
  for (const std::string assumed :
       {"a = 'real'\nconditions = ['a^2 = -1']", "a = 'positive'\nconditions = ['a < -1']",
        "a = 'positive'\nb = 'positive'\nconditions = ['a*b + 1 < 0']",
        "conditions = ['a > 1', 'a^2 = 1']", "conditions = ['a = 1', 'a = 2']"})
    EXPECT_THROW(static_cast<void>(classify(assumed)), InvalidArgument) << assumed;
  for (const std::string assumed :
       {"a = 'real'\nconditions = ['a^2 = 1']", "conditions = ['a^2 = -1']"})
    EXPECT_NE(classify(assumed).status(), Verdict::integrable) << assumed;
}

// A parameter that only assumptions contain labels no level: it restricts the others.
TEST(Classify, AssumedEquationsWithFurtherParameters) {
  const auto c = classify_system(planar("(u^2 + v^2)/2 + x^4 + y^4 + a*x^2*y^2", "'a', 'b'",
                                        "[assume]\nconditions = ['a = b^2 + 2', 'b >= 0']\n"),
                                 within(60));
  EXPECT_THAT(c.notes, testing::IsEmpty());
  EXPECT_EQ(status_at(c, {{"b", 0}, {"a", 2}}), "integrable");
  EXPECT_EQ(status_at(c, {{"b", 2}, {"a", 6}}), "integrable");
  EXPECT_EQ(status_at(c, {{"b", 1}, {"a", 3}}), "excluded");
  EXPECT_EQ(status_at(c, {{"b", 0}, {"a", 0}}), ""); // not what the file is about
}

// Parts of a closed answer: what is not abelian only where a difference is not special.
TEST(Classify, ClosedAnswersExcludeWhatTheyExclude) {
  const auto c = classify_system(
      of("[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
         "parameters = ['m']\nhamiltonian = '(u^2/(1 + m) + v^2/x^2)/2 + x*(m - c)'\n"
         "relations = ['s^2 + c^2 = 1']\n"
         "[[system.function]]\nname = 's'\nmeans = 'sin(y)'\nderivative = {y = 'c'}\n"
         "[[system.function]]\nname = 'c'\nmeans = 'cos(y)'\nderivative = {y = '-s'}\n"),
      within(60, 2));
  for (const Rational& m :
       {Rational(2), Rational(4), Rational(-3), Rational(1, 3), Rational(15), Rational(35, 19)})
    EXPECT_EQ(status_at(c, {{"m", m}}), "excluded") << to_string(m);
  for (const long p : {2, 3, 4}) { // m = 1 + 4/(p^2 + p - 4)
    const Rational m = Rational(1) + Rational(4, p * p + p - 4);
    EXPECT_EQ(status_at(c, {{"m", m}}), "open") << to_string(m);
  }
  EXPECT_EQ(status_at(c, {{"m", 0}}), "integrable");
}

// Both axes of the van der Waals problem at energy 0 leave finitely many values together.
TEST(Classify, TwoDifferencesLeaveFinitelyManyValues) {
  const auto c = classify_system(
      of("[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
         "parameters = ['b']\nhamiltonian = '(u^2 + v^2)/2 - 1/r + x^2 + b*y^2'\n"
         "relations = ['r^2 = x^2 + y^2']\n[[system.function]]\nname = 'r'\n"
         "derivative = {x = 'x/r', y = 'y/r'}\n[assume]\nb = 'nonzero'\n"),
      within(120));
  for (const Rational& b : {Rational(1), Rational(4), Rational(1, 4)})
    EXPECT_EQ(status_at(c, {{"b", b}}), "integrable") << to_string(b);
  EXPECT_THAT(strata_with(c, StratumStatus::open), testing::IsEmpty());
}

// All even quartic forms with x^2*y^2; 136 : 816 : 1088 falls by VE_5.
TEST(Classify, EvenQuartics) {
  const auto c = classify_system(
      planar("(u^2 + v^2)/2 + x^2*y^2/2 + c*x^4/4 + d*y^4/4", "'c', 'd'"), within(240));
  const auto at = [&](const Rational& x, const Rational& y) {
    return status_at(c, {{"c", x}, {"d", y}});
  };
  const Rational third(1, 3), sixth(1, 6);
  for (const auto& [x, y] : {std::pair(Rational(1), Rational(1)),
                             {third, third},
                             {8 * third, sixth},
                             {sixth, 8 * third},
                             {third, 8 * third},
                             {8 * third, third}})
    EXPECT_EQ(at(x, y), "integrable") << to_string(x) << ' ' << to_string(y);
  for (const auto& [x, y] : {std::pair(Rational(2), Rational(5)),
                             {Rational(0), Rational(2)},
                             {third, Rational(1)},
                             {8 * third, Rational(1, 136)}})
    EXPECT_EQ(at(x, y), "excluded") << to_string(x) << ' ' << to_string(y);
  EXPECT_THAT(strata_with(c, StratumStatus::open), testing::IsEmpty());
}

// Where H is not a quotient any more, the degrees of the coefficients are other ones.
// V vanishes along an isotropic direction, x = 0, where c = 0: of all parameters, or of these alone.
TEST(Classify, IsotropicDirectionsOnWhichThePotentialVanishes) {
  const auto merged =
      classify_system(planar("u*v + x^3 + 3*x^2*y + b*x*y^2 + c*y^3", "'b', 'c'"), within(20, 2));
  const auto always =
      classify_system(planar("u*v + x^3 + 3*x^2*y + b*x*y^2", "'b'"), within(20, 2));
  for (long b = -5; b <= 5; ++b)
    EXPECT_EQ(status_at(merged, {{"b", b}, {"c", 0}}), status_at(always, {{"b", b}})) << b;
  EXPECT_EQ(status_at(merged, {{"b", 2}, {"c", 0}}), "excluded");
  EXPECT_EQ(status_at(merged, {{"b", 0}, {"c", 0}}), "integrable");
}
// Of one direction of two, x^2 + y^2 = 0, which the rational numbers do not tell apart.
TEST(Classify, OneIsotropicDirectionOfTwo) {
  const auto c = classify_system(planar("(u^2 + v^2)/2 + x^2*y/2 + a/3*x^3 + c/3*y^3", "'a', 'c'"),
                                 within(60, 2));
  for (const ClassifiedStratum& s : c.strata)
    for (const MPoly& p : s.where.equations())
      EXPECT_FALSE(s.status == StratumStatus::open && to_string(p) == "4*a^2 + 4*c^2 - 12*c + 9");
}
// All but the radial potential, whatever the first other term.
TEST(Classify, MultipleDarbouxPoints) {
  const auto excluded = [](const std::string& v, const std::string& mass = "u^2 + v^2") {
    for (const Exclusion& e : exclusions_by_darboux_points(planar("(" + mass + ")/2 + " + v), {})) {
      const bool here = e.zero.empty() || std::all_of(e.zero.begin(), e.zero.end(),
                                                      [](const MPoly& p) { return is_zero(p); });
      const bool proved =
          here && std::all_of(e.not_all_zero.begin(), e.not_all_zero.end(), [](const auto& list) {
            return std::any_of(list.begin(), list.end(),
                               [](const MPoly& p) { return !is_zero(p); });
          });
      if (proved && e.by.solution.rfind("a multiple", 0) == 0) return true;
    }
    return false;
  };
  EXPECT_TRUE(excluded("y^3/3 + x^2*y/2"));
  EXPECT_TRUE(excluded("y^3/3 + x^2*y/2 + 5*x^3"));
  EXPECT_TRUE(excluded("y^4/4 + x^2*y^2/2 + x^4"));
  EXPECT_TRUE(excluded("y^6/6 + x^2*y^4/2 + x^4*y^2/2 + x^6/7"));
  EXPECT_TRUE(excluded("y^3/3 + x^2*y", "u^2/2 + v^2")); // x = q/sqrt(2)
  EXPECT_FALSE(excluded("y^6/6 + x^2*y^4/2 + x^4*y^2/2 + x^6/6"));
  EXPECT_FALSE(excluded("y^4/4 + x^2*y^2/2 + x^4/4"));
  EXPECT_FALSE(excluded("y^3/3 + x^2*y")); // simple
  EXPECT_FALSE(excluded("y^3/3"));         // an isotropic multiple zero
}
TEST(Classify, IntegralsOfASpecialFormAreLookedForAgain) {
  const auto c = classify_system(
      planar("(u^2 + v^2)/(2 + 2*b*x^2) + 6*x^4*y + 32*x^2*y^3 + 32*y^5", "'b'"), within(60, 2));
  EXPECT_EQ(status_at(c, {{"b", 0}}), "integrable");
}

// w is conserved, and w^2 + a takes all values: what is left at one level is excluded at others.
TEST(Classify, LevelsBesideTheEnergyAreFree) {
  const auto c =
      classify_system(of("[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y', 'z']\n"
                         "momenta = ['u', 'v', 'w']\nparameters = ['a']\n"
                         "hamiltonian = '(u^2 + v^2)/2 + (w^2 + a)*x^2*y^2 + x^4 + y^4'\n"),
                      within(60, 2));
  EXPECT_EQ(c.status(), Verdict::non_integrable);
}

// A limit is never a verdict.
TEST(Classify, WithoutTimeAllIsOpen) {
  ClassifyOptions options;
  options.check.decide.budget = Budget::of_seconds(0);
  const auto c = classify_system(planar("(u^2 + v^2)/2 + x^2*y + b*y^3", "'b'"), options);
  for (const ClassifiedStratum& s : c.strata)
    EXPECT_EQ(s.status, StratumStatus::open);
  EXPECT_FALSE(c.complete); // the clock ended it
}

// mechanics.md (6): H, x exp(-phi) and an integral with exp(s phi) are independent and entire, so
// that no step may exclude integrals with phi.
TEST(Classify, EachReasonSaysItsWholeClass) {
  const System s = read_system(
      parse_document("[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'phi', 'q']\n"
                     "momenta = ['px', 'pphi', 'p']\nconstants = ['s']\nrelations = ['s^2 = 2']\n"
                     "hamiltonian = 'x*px + pphi + p^2/2 - ((s + x/(x-1))^2 - x/(x-1)^2)*q^2/2'\n",
                     "test.toml"));
  const SystemClassification c = classify_system(s, within(20));
  ASSERT_EQ(c.status(), Verdict::non_integrable);
  EXPECT_THAT(statement(c), testing::HasSubstr("do not depend on phi"));
  for (const ClassifiedStratum& x : c.strata)
    for (const ExclusionReason& by : x.by)
      EXPECT_THAT(statement(by), testing::HasSubstr("do not depend on phi"));
}

} // namespace
} // namespace kov::classify_test
