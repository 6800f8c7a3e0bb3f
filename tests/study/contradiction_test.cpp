// Complete integrals where none are: seen, and only where all conditions hold.

#include "study/contradiction.hpp"

#include "decide/afterwards.hpp"
#include "exact/error.hpp"
#include "study/proof_tree.hpp"
#include "study/study.hpp"

#include <gtest/gtest.h>

namespace kov::study {
namespace {

// Two oscillators: both energies are integrals.
std::string oscillators(const std::string& more) {
  return "system = {kind = 'hamiltonian', coordinates = ['x', 'y'], momenta = ['u', 'v'], "
         "parameters = ['a', 'b', 'h'], hamiltonian = '(u^2 + v^2)/2 + a*x^2 + b*y^2'}\n"
         "manifold = [{name = 'axis', equations = ['y = 0', 'v = 0'], level = ['H = h']}]\n" +
         more;
}
constexpr const char* both = "integral = [{name = 'F', value = 'u^2/2 + a*x^2'}]\n";

struct Read {
  System system;
  std::optional<Integrable> known;
  MPoly a;
};
Read read(const std::string& more) {
  System s = read_system(parse_document(oscillators(more), "oscillators.toml"));
  auto known = known_integrals(s, decide_claims(s, {}));
  const MPoly a = MPoly::variable(s.ring(), "a");
  return {std::move(s), std::move(known), a};
}

Exclusion everywhere() {
  Exclusion e;
  e.by.solution = "axis";
  return e;
}

TEST(Contradiction, IsSeenOnAllParameters) {
  const Read r = read(both);
  ASSERT_TRUE(r.known);
  EXPECT_TRUE(contradict(r.system, everywhere(), *r.known));
  EXPECT_THROW(refuse_contradiction(r.system, everywhere(), *r.known), Contradiction);
}

TEST(Contradiction, IsSeenBetweenStepsOfATree) {
  const Read r = read(both);
  ASSERT_TRUE(r.known);
  ProofTree t{{"axis"}, {}, {}, {}};
  t.steps.push_back({"", Rule::known_integrals, *r.known});
  EXPECT_NO_THROW(refuse_contradictions(r.system, t));
  t.steps.push_back({"axis", Rule::first_order, Excluded{{}, true, std::nullopt}});
  EXPECT_NO_THROW(refuse_contradictions(r.system, t)) << "a cover: its premises are looked at";
  t.steps.push_back({"axis", Rule::first_order, Excluded{{}, true, everywhere()}});
  EXPECT_THROW(refuse_contradictions(r.system, t), Contradiction);
}

TEST(Contradiction, IsSeenOnASetAndOutsideOfOne) {
  const Read r = read(both);
  Exclusion e = everywhere();
  e.zero = {r.a};
  EXPECT_TRUE(contradict(r.system, e, *r.known));
  e = everywhere();
  e.not_all_zero = {{r.a, r.a * r.a}};
  EXPECT_TRUE(contradict(r.system, e, *r.known));
  e.zero = {r.a};
  EXPECT_FALSE(contradict(r.system, e, *r.known)) << "the set is empty";
}

TEST(Contradiction, NeedsCompleteIntegrals) {
  EXPECT_FALSE(read("").known);
  EXPECT_FALSE(read("integral = [{name = 'F', value = '2*H + H^2'}]\n").known) << "dependent";
  EXPECT_FALSE(read("integral = [{name = 'F', value = 'x*v - y*u'}]\n").known) << "refuted";
  EXPECT_FALSE(read("integral = [{name = 'F', value = 'u^2/2 + a*x^2', on = 'H = 1'}]\n").known)
      << "on a level only";
}

TEST(Contradiction, NeedsAClassThatContainsThem) {
  const Read r = read(both);
  Exclusion e = everywhere();
  for (const auto near : {IntegralClass::Near::curve, IntegralClass::Near::closed_curve}) {
    e.by.integrals = {.near = near, .curves = {"axis"}};
    EXPECT_TRUE(contradict(r.system, e, *r.known));
  }
  e.by.integrals = {.kind = IntegralClass::Kind::real_analytic};
  EXPECT_TRUE(contradict(r.system, e, *r.known)) << "polynomials are real-analytic";
  Integrable rational = *r.known;
  rational.integrals.polynomial = false;
  EXPECT_FALSE(contradict(r.system, e, rational)) << "not everywhere";
  e.by.integrals = {.without = {"x"}};
  EXPECT_FALSE(contradict(r.system, e, *r.known));
  e.by.integrals = {.liouville = false};
  EXPECT_FALSE(contradict(r.system, e, *r.known));
}

TEST(Contradiction, NeedsAPointThatTheFileAdmits) {
  const Read real = read(std::string(both) + "assume = {a = 'real'}\n");
  Exclusion e = everywhere();
  EXPECT_TRUE(contradict(real.system, e, *real.known));
  e.zero = {real.a - MPoly(real.a.ring(), Integer(3))};
  EXPECT_TRUE(contradict(real.system, e, *real.known)) << "a = 3";
  e.zero = {real.a * real.a + MPoly(real.a.ring(), Integer(1))};
  EXPECT_FALSE(contradict(real.system, e, *real.known)) << "complex points only";
  e.unless = DifferenceCondition{DifferenceCondition::Kind::rational, {MFraction(real.a)}};
  EXPECT_FALSE(contradict(real.system, e, *real.known));
}

// By values that satisfy what is assumed.
TEST(Contradiction, NeedsAPointOfTheRightSign) {
  const Read r = read(std::string(both) + "assume = {a = 'positive', b = 'positive'}\n");
  const MPoly b = MPoly::variable(r.a.ring(), "b");
  Exclusion e = everywhere();
  EXPECT_TRUE(contradict(r.system, e, *r.known));
  e.zero = {r.a - b * b};
  EXPECT_TRUE(contradict(r.system, e, *r.known));
  e.zero = {r.a + b};
  EXPECT_FALSE(contradict(r.system, e, *r.known));
  const MPoly one(r.a.ring(), Integer(1)), five(r.a.ring(), Integer(5));
  e.zero = {r.a - b + five, b - one}; // each may vanish
  EXPECT_FALSE(contradict(r.system, e, *r.known)) << "a = -4";
  e.zero = {r.a - b + five, b - five - one};
  EXPECT_TRUE(contradict(r.system, e, *r.known)) << "a = 1";
  e.zero = {r.a * r.a - b * b * b};
  EXPECT_FALSE(contradict(r.system, e, *r.known)) << "no graph: not known";
  e.zero = {r.a - b};
  e.not_all_zero = {{r.a * r.a - b * b}};
  EXPECT_FALSE(contradict(r.system, e, *r.known)) << "the set is empty";
}

TEST(Contradiction, NeedsAPointOfIntegers) {
  const Read r = read(std::string(both) + "assume = {a = 'integer'}\n");
  const MPoly one(r.a.ring(), Integer(1));
  Exclusion e = everywhere();
  e.zero = {r.a - one - one};
  EXPECT_TRUE(contradict(r.system, e, *r.known));
  e.zero = {r.a + r.a - one};
  EXPECT_FALSE(contradict(r.system, e, *r.known)) << "a = 1/2";
}

TEST(Contradiction, NeedsCheckedHypotheses) {
  const Read r = read(both);
  Exclusion e = everywhere();
  e.by.unchecked = "that the curve is connected";
  EXPECT_FALSE(contradict(r.system, e, *r.known));
}

// What is true is left alone: one integral too few, and an obstruction.
TEST(Contradiction, IsNotSeenWhereThereIsNone) {
  const Entry file = parse_document(
      "system = {kind = 'hamiltonian', coordinates = ['q1', 'q2'], momenta = ['p1', 'p2'], "
      "parameters = ['h'], hamiltonian = '(p1^2 + p2^2)/2 + q1^2*q2 + q2^3/2'}\n"
      "integral = [{name = 'E', value = 'H'}]\n"
      "manifold = [{name = 'N', equations = ['q1 = 0', 'p1 = 0'], level = ['H = h']}]",
      "cubic.toml");
  EXPECT_EQ(study(file, {{"h", "1"}}).headline.verdict, Verdict::non_integrable);
}

} // namespace
} // namespace kov::study
