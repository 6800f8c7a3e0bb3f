// Complete integrals where none are: seen, and only where all conditions hold.

#include "study/contradiction.hpp"

#include "decide/afterwards.hpp"
#include "exact/error.hpp"
#include "study/proof_tree.hpp"
#include "study/study.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace kov::study::contradiction_test {
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

void refuse(const System& s, const Exclusion& e, const Integrable& i) {
  refuse_contradiction(s, e.by, i.integrals, i.where, e);
}

TEST(Contradiction, IsSeenOnAllParameters) {
  const Read r = read(both);
  ASSERT_TRUE(r.known);
  EXPECT_TRUE(contradict(r.system, everywhere(), *r.known));
  EXPECT_THROW(refuse(r.system, everywhere(), *r.known), Contradiction);
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
  e.statements = {{SomeIn{{MFraction(real.a)}}, false}}; // not where sqrt(a) is rational
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

// ---- laws of random sets

// Sets of values of a and b through a known point, or through none.
struct RandomSet {
  Exclusion e = everywhere();
  MPoly a, b;
  long at_a, twice_b; ///< a and 2 b at the point

  RandomSet(const Read& r, test::Random& random, bool positive)
      : a(r.a), b(MPoly::variable(r.a.ring(), "b")), at_a(random.between(positive ? 1 : -4, 4)),
        twice_b(random.between(positive ? 1 : -4, 4)) {
    if (random.once_in(2)) e.zero.push_back(multiple(random));
    if (random.once_in(2)) e.zero.push_back(multiple(random));
    for (long k = random.between(0, 2); k > 0; --k)
      e.not_all_zero.push_back(random.once_in(2) ? std::vector{multiple(random), beside(random)}
                                                 : std::vector{beside(random)});
  }

private:
  [[nodiscard]] MPoly number(long n) const { return {a.ring(), Integer(n)}; }
  // of m (a - a0) + n (2 b - 2 b0), or a multiple of it: it vanishes at the point
  MPoly multiple(test::Random& random) const {
    const MPoly line = number(random.between(-2, 2)) * (a - number(at_a)) +
                       number(random.between(1, 3)) * (b + b - number(twice_b));
    return random.once_in(3) ? line * (a * b + number(7)) : line;
  }
  // it does not
  MPoly beside(test::Random& random) const {
    return a + b + b - number(at_a + twice_b) + number(random.between(1, 5));
  }
};

// The exclusion holds at a point of the integrable family: that is seen, whatever describes the set.
TEST(ContradictionLaws, SetsThatMeetAreSeen) {
  const Read r = read(both);
  ASSERT_TRUE(r.known);
  test::random_rounds(80, [&](test::Random& random) {
    RandomSet set(r, random, false);
    EXPECT_TRUE(contradict(r.system, set.e, *r.known)) << set.e.zero.size();
    EXPECT_THROW(refuse(r.system, set.e, *r.known), Contradiction);
    // the same conditions in another order, and one that follows
    std::reverse(set.e.zero.begin(), set.e.zero.end());
    std::reverse(set.e.not_all_zero.begin(), set.e.not_all_zero.end());
    if (!set.e.zero.empty()) set.e.zero.push_back(set.e.zero.front() * set.e.zero.back());
    EXPECT_TRUE(contradict(r.system, set.e, *r.known));
  });
}

// No alarm for what holds nowhere.
TEST(ContradictionLaws, EmptySetsDoNotMeet) {
  for (const std::string assumed : {"", "assume = {a = 'positive', b = 'positive'}\n"}) {
    const Read r = read(both + assumed);
    ASSERT_TRUE(r.known);
    const MPoly one(r.a.ring(), Integer(1));
    test::random_rounds(15, [&](test::Random& random) {
      RandomSet set(r, random, true);
      const MPoly p = set.e.zero.empty() ? set.a * set.b : set.e.zero.front();
      if (random.once_in(2)) {
        set.e.zero.push_back(p);
        set.e.zero.push_back(p * set.a + one);
      } else {
        set.e.zero.push_back(p);
        set.e.not_all_zero.push_back({p * set.a, p * p});
      }
      EXPECT_FALSE(contradict(r.system, set.e, *r.known));
      EXPECT_NO_THROW(refuse(r.system, set.e, *r.known));
    });
  }
}

// Proved for more parameters is proved for fewer: a point that two conditions leave was left by one.
TEST(ContradictionLaws, FewerConditionsMeetMore) {
  const Read r = read(std::string(both) + "assume = {a = 'positive', b = 'real'}\n");
  ASSERT_TRUE(r.known);
  test::random_rounds(15, [&](test::Random& random) {
    RandomSet set(r, random, true);
    if (!contradict(r.system, set.e, *r.known)) return;
    if (!set.e.not_all_zero.empty()) set.e.not_all_zero.pop_back();
    EXPECT_TRUE(contradict(r.system, set.e, *r.known));
  });
}

// True integrals, and what a proof excludes of the same family elsewhere.
TEST(ContradictionLaws, AFamilyWithBothIsNoContradiction) {
  for (const std::string assumed : {"", "assume = {a = 'real'}\n", "assume = {a = 'nonzero'}\n"}) {
    const SystemStudy all =
        study(parse_document("system = {kind = 'hamiltonian', coordinates = ['x', 'y'], "
                             "momenta = ['u', 'v'], parameters = ['a', 'h'], "
                             "hamiltonian = '(u^2 + v^2 + x^2 + y^2)/2 + a*x^2*y^2'}\n"
                             "manifold = [{name = 'axis', equations = ['y = 0', 'v = 0'], "
                             "level = ['H = h']}]\n" +
                                 assumed,
                             "family.toml"),
              {});
    ASSERT_FALSE(all.manifolds.at(0).exclusions.empty());
    const MPoly a = MPoly::variable(all.system.ring(), "a");
    SystemClassification told;
    const Set whole = all_parameters(all.system, {}, {}, told);
    CompleteIntegrals integrals;
    integrals.polynomial = true;
    for (const Exclusion& e : all.manifolds.at(0).exclusions) {
      EXPECT_FALSE(contradict(all.system, e, {whole.where_zero(a), integrals}))
          << "two oscillators";
      EXPECT_TRUE(contradict(all.system, e, {whole, integrals})) << "if they were for all a";
    }
  }
}

} // namespace
} // namespace kov::study::contradiction_test
