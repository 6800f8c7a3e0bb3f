// The headline is a function of the steps.

#include "study/proof_tree.hpp"

#include "decide/afterwards.hpp"
#include "study/study.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace kov::study::proof_tree_test {
namespace {

using test::Random;
using test::random_rounds;

Step excludes(const std::string& curve, bool everywhere, IntegralClass integrals = {}) {
  return {curve, Rule::first_order, Excluded{{std::move(integrals)}, everywhere}};
}
Step passes(const std::string& curve, bool elsewhere = false) {
  return {curve, Rule::first_order, Passes{elsewhere}};
}
ProofTree tree(std::vector<std::string> curves, std::vector<Step> steps) {
  return {std::move(curves), std::move(steps), {}, {}};
}

TEST(ProofTree, VerdictOfOneCurve) {
  EXPECT_EQ(headline(tree({"N"}, {})).verdict, Verdict::undecided);
  EXPECT_EQ(headline(tree({"N"}, {passes("N")})).verdict, Verdict::no_obstruction);
  EXPECT_EQ(headline(tree({"N"}, {passes("N", true)})).verdict, Verdict::depends);
  EXPECT_EQ(headline(tree({"N"}, {passes("N"), excludes("N", false)})).verdict, Verdict::depends);
  EXPECT_EQ(headline(tree({"N"}, {excludes("N", false)})).verdict, Verdict::undecided);
  EXPECT_EQ(headline(tree({"N"}, {passes("N"), excludes("N", true)})).verdict,
            Verdict::non_integrable);
}

TEST(ProofTree, VerdictOfSeveralCurves) {
  EXPECT_EQ(headline(tree({}, {})).verdict, Verdict::undecided) << "nothing was asked";
  EXPECT_EQ(headline(tree({"N", "M"}, {passes("N")})).verdict, Verdict::undecided);
  EXPECT_EQ(headline(tree({"N", "M"}, {passes("N"), passes("M")})).verdict,
            Verdict::no_obstruction);
  EXPECT_EQ(headline(tree({"N", "M"}, {excludes("M", true)})).verdict, Verdict::non_integrable);
  ProofTree t = tree({"N", "M"}, {excludes("N", false), excludes("M", false)});
  EXPECT_EQ(headline(t).verdict, Verdict::undecided);
  t.steps.push_back({"", Rule::cover, Excluded{{{}}, true}, {0, 1}});
  EXPECT_EQ(headline(t).verdict, Verdict::non_integrable);
}

TEST(ProofTree, ARefusedManifoldIsCountedAndHidesNoObstruction) {
  ProofTree t = tree({"N", "M"}, {passes("N")});
  t.refused.push_back("M");
  EXPECT_EQ(headline(t).verdict, Verdict::failed);
  t.steps.push_back(excludes("N", true));
  EXPECT_EQ(headline(t).verdict, Verdict::non_integrable);
  EXPECT_EQ(headline(t).refused, 1U);
}

std::vector<Trusted> steps(const std::vector<std::string>& names) {
  std::vector<Trusted> all;
  for (const std::string& name : names)
    all.push_back({Trusted::Step::by_author, name});
  return all;
}

TEST(ProofTree, TrustedStepsAreThoseOfAllBelow) {
  ProofTree t = tree({"N", "M"}, {excludes("N", false), excludes("M", false)});
  t.steps[0].trusted = steps({"a", "b"});
  t.steps[1].trusted = steps({"b", "c"});
  t.steps[1].unchecked = {"d"};
  t.steps.push_back({"", Rule::cover, Excluded{{{}}, true}, {0, 1}});
  EXPECT_EQ(support(t, 2).trusted.size(), 3U);
  EXPECT_EQ(headline(t).trusted, 3U);
  EXPECT_EQ(headline(t).unchecked, 1U);
}

// The larger class, then less trust, then the earlier one.
TEST(ProofTree, TheBestObstructionIsTold) {
  const IntegralClass closed{.near = IntegralClass::Near::closed_curve};
  ProofTree t = tree({"N"}, {excludes("N", true, closed)});
  t.steps.push_back(excludes("N", true));
  EXPECT_EQ(headline(t).excluded, std::vector<IntegralClass>{IntegralClass{}});
  t.steps[1].trusted = steps({"a"});
  EXPECT_EQ(headline(t).trusted, 1U);
  t.steps.push_back(excludes("N", true));
  EXPECT_EQ(headline(t).trusted, 0U);
}

TEST(ProofTree, ALimitEndsAStudy) {
  ProofTree t = tree({"N"}, {passes("N")});
  t.cut_short.push_back("N");
  EXPECT_EQ(headline(t).verdict, Verdict::no_obstruction);
  EXPECT_FALSE(headline(t).complete);
}

// One manifold, one step.
TEST(ProofTree, OfAFile) {
  const Entry file = parse_document(
      "system = {kind = 'hamiltonian', coordinates = ['q1', 'q2'], momenta = ['p1', 'p2'], "
      "parameters = ['h'], hamiltonian = '(p1^2 + p2^2)/2 + q1^2*q2 + q2^3/2'}\n"
      "manifold = [{name = 'N', equations = ['q1 = 0', 'p1 = 0'], level = ['H = h']}]",
      "cubic.toml");
  const SystemStudy found = study(file, {{"h", "1"}});
  ASSERT_EQ(found.tree.steps.size(), 1U);
  EXPECT_EQ(found.tree.steps[0].curve, "N");
  EXPECT_EQ(headline(found.tree), found.headline);
  EXPECT_EQ(found.headline, found.manifolds.at(0).headline);
}

// ---- laws of random trees

// Of the curves N and M; classes of which each contains the next.
Step random_step(Random& random) {
  const std::string curve = random.once_in(2) ? "N" : "M";
  static const std::vector<IntegralClass> classes{
      {}, {.near = IntegralClass::Near::closed_curve}, {.kind = IntegralClass::Kind::rational}};
  Step step = random.once_in(3) ? passes(curve, random.once_in(2))
                                : excludes(curve, random.once_in(3), random.one_of(classes));
  for (const std::string name : {"a", "b", "c"})
    if (random.once_in(4)) step.trusted.push_back({Trusted::Step::by_author, name});
  if (random.once_in(6)) step.unchecked = {"d"};
  return step;
}
ProofTree random_tree(Random& random) {
  ProofTree t{{"N", "M"}, {}, {}, {}};
  for (long k = random.between(0, 6); k > 0; --k)
    t.steps.push_back(random_step(random));
  return t;
}
bool excludes_everywhere(const Step& step) {
  const auto* x = std::get_if<Excluded>(&step.says);
  return x != nullptr && x->everywhere;
}

TEST(ProofTreeLaws, NotIntegrableIsWhatOneStepSaysOfAllParameters) {
  random_rounds(300, [](Random& random) {
    const ProofTree t = random_tree(random);
    const Headline h = headline(t);
    const bool proved = std::ranges::any_of(t.steps, excludes_everywhere);
    EXPECT_EQ(h.verdict == Verdict::non_integrable, proved);
    if (!proved) return;
    const auto is_told = [&](StepId id) {
      const auto* x = std::get_if<Excluded>(&t.steps[id].says);
      return x != nullptr && x->everywhere && x->integrals == h.excluded &&
             support(t, id).trusted.size() == h.trusted &&
             support(t, id).unchecked.size() == h.unchecked;
    };
    bool told = false;
    for (StepId id = 0; id < t.steps.size(); ++id)
      told = told || is_told(id);
    EXPECT_TRUE(told) << "class and trust are those of one proof";
  });
}

TEST(ProofTreeLaws, TheOrderOfStepsIsNoMatter) {
  random_rounds(300, [](Random& random) {
    ProofTree t = random_tree(random);
    const Headline before = headline(t);
    std::shuffle(t.steps.begin(), t.steps.end(), random.bits());
    std::swap(t.curves[0], t.curves[1]);
    const Headline after = headline(t);
    EXPECT_EQ(after.verdict, before.verdict);
    if (before.verdict == Verdict::non_integrable) {
      EXPECT_EQ(after.excluded, before.excluded);
      EXPECT_EQ(after.trusted + after.unchecked, before.trusted + before.unchecked);
    }
  });
}

// Nor does a manifold that was refused, or a limit.
TEST(ProofTreeLaws, OneMoreStepTakesNothingBack) {
  random_rounds(300, [](Random& random) {
    ProofTree t = random_tree(random);
    const Headline before = headline(t);
    t.steps.push_back(random_step(random));
    if (random.once_in(3)) {
      t.curves.push_back("K");
      t.refused.push_back("K");
    }
    if (random.once_in(3)) t.cut_short.push_back("N");
    const Headline after = headline(t);
    if (before.verdict != Verdict::non_integrable) return;
    EXPECT_EQ(after.verdict, Verdict::non_integrable);
    EXPECT_EQ(contains(after.excluded.at(0), before.excluded.at(0)), Truth::yes);
    if (after.excluded == before.excluded) {
      EXPECT_LE(after.trusted + after.unchecked, before.trusted + before.unchecked);
    }
  });
}

// What two premises share is counted once, however deep it lies.
TEST(ProofTreeLaws, TheSupportIsThatOfAllThatCanBeReached) {
  random_rounds(100, [](Random& random) {
    ProofTree t{{"N"}, {}, {}, {}};
    std::vector<std::set<StepId>> below; // and itself
    for (StepId id = 0; id < 9; ++id) {
      Step step = random_step(random);
      below.push_back({id});
      for (StepId k = 0; k < id; ++k)
        if (random.once_in(3)) {
          step.premises.push_back(k);
          below.back().insert(below[k].begin(), below[k].end());
        }
      t.steps.push_back(std::move(step));
    }
    for (StepId id = 0; id < t.steps.size(); ++id) {
      Support expected;
      for (const StepId k : below[id]) {
        expected.trusted.insert(t.steps[k].trusted.begin(), t.steps[k].trusted.end());
        expected.unchecked.insert(t.steps[k].unchecked.begin(), t.steps[k].unchecked.end());
      }
      EXPECT_EQ(support(t, id).trusted, expected.trusted);
      EXPECT_EQ(support(t, id).unchecked, expected.unchecked);
    }
  });
}

// A classification with an open set decides nothing, whatever is known of the others.
TEST(Headline, OfAClassificationIsDecidedIfNothingIsOpen) {
  const Ring ring = make_ring({"a"});
  for (const bool open : {false, true})
    for (const bool integrable : {false, true})
      for (const bool excluded : {false, true}) {
        SystemClassification c;
        if (open) c.strata.push_back({Set(ring, {0}), StratumStatus::open});
        if (integrable) c.strata.push_back({Set(ring, {0}), StratumStatus::integrable});
        if (excluded) c.strata.push_back({Set(ring, {0}), StratumStatus::excluded});
        if (excluded) c.strata.back().by.emplace_back();
        const Verdict expected = open || (!integrable && !excluded) ? Verdict::undecided
                                 : integrable && excluded           ? Verdict::depends
                                 : integrable                       ? Verdict::integrable
                                                                    : Verdict::non_integrable;
        EXPECT_EQ(headline(c).verdict, expected);
        EXPECT_EQ(headline(c).excluded.size(), excluded ? 1U : 0U);
      }
}

} // namespace
} // namespace kov::study::proof_tree_test
