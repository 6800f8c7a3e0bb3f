// The headline is a function of the steps.

#include "study/proof_tree.hpp"

#include "decide/afterwards.hpp"
#include "study/study.hpp"

#include <gtest/gtest.h>

namespace kov::study {
namespace {

Step excludes(const std::string& curve, bool everywhere, IntegralClass integrals = {}) {
  return {curve, Rule::first_order, Excluded{{std::move(integrals)}, everywhere}};
}
Step passes(const std::string& curve, bool elsewhere = false) {
  return {curve, Rule::first_order, Passes{1, elsewhere}};
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
  t.refused.push_back({"M", "it is not invariant"});
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

TEST(ProofTree, ALimitIsAnAttempt) {
  ProofTree t = tree({"N"}, {passes("N")});
  t.attempts.push_back({"N", "the higher orders: work limit", true});
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

} // namespace
} // namespace kov::study
