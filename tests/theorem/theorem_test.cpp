// Theorem files: reading, the built-in steps, and what openness does.

#include "theorem/prove.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace kov;
using testing::HasSubstr;

namespace {

const std::string cases = KOV_SOURCE_DIR "/cases/";

Theorem parsed(const std::string& nodes) {
  return read_theorem(
      parse_document("format = \"theorem/1\"\ntitle = \"T\"\nstatement = \"S\"\n" + nodes,
                     cases + "sliding_top/test.toml"));
}

TheoremNode node(NodeKind kind, const std::string& file) {
  TheoremNode n;
  n.id = n.title = "n";
  n.kind = kind;
  n.file = file;
  return n;
}

NodeResult run(const TheoremNode& n) {
  return prove({cases + "sliding_top/test.toml", "T", "S", {}, {n}}).nodes.front();
}

std::string error_of(const std::string& nodes) {
  try {
    (void)parsed(nodes);
  } catch (const InputError& e) {
    return e.what() + e.hint();
  }
  return "";
}

} // namespace

TEST(TheoremFile, MistakesAreInputErrors) {
  EXPECT_THAT(error_of("[[node]]\nid = \"a\"\nstatement = \"\"\nkind = \"argumnt\"\n"),
              HasSubstr("argument"));
  EXPECT_THAT(
      error_of("[[node]]\nid = \"a\"\nstatement = \"\"\nkind = \"argument\"\nneeds = [\"b\"]\n"),
      HasSubstr("not there"));
  EXPECT_THAT(
      error_of("[[node]]\nid = \"a\"\nstatement = \"\"\nkind = \"argument\"\nneeds = [\"a\"]\n"),
      HasSubstr("circle"));
  EXPECT_THAT(error_of("[[node]]\nid = \"a\"\nstatement = \"\"\nkind = \"case\"\n"),
              HasSubstr("file"));
  EXPECT_THAT(
      error_of("[[node]]\nid = \"a\"\nstatement = \"\"\nkind = \"argument\"\n[[node]]\nid = \"a\"\n"
               "statement = \"\"\nkind = \"argument\"\n"),
      HasSubstr("twice"));
}

TEST(TheoremFile, OpennessTravelsUpAndUncheckedHypothesesShow) {
  const Theorem t = parsed(R"(
[[node]]
id = "top"
kind = "argument"
statement = "top"
needs = ["middle"]
[[node]]
id = "middle"
kind = "theorem"
statement = "middle"
needs = ["bottom", "fine"]
hypotheses = [{ text = "nobody looks" }, { text = "checked", by = "fine" }, { text = "not yet", by = "bottom" }]
[[node]]
id = "bottom"
kind = "case"
statement = "with parameters"
file = "sliding_top.toml"
[[node]]
id = "fine"
kind = "claims"
statement = "euler"
file = "euler.toml"
)");
  const TheoremResult r = prove(t);
  EXPECT_FALSE(r.complete());
  EXPECT_TRUE(r.nodes[0].rests_on_open);
  EXPECT_TRUE(r.nodes[1].rests_on_open);
  EXPECT_EQ(r.nodes[3].status, NodeStatus::proved);
  EXPECT_EQ(r.unchecked_hypotheses().size(), 2U);
  EXPECT_THAT(r.conclusion(), HasSubstr("NOT YET PROVED"));
}

TEST(ClaimsStep, AFalseClaimRefutes) {
  // the scaling without the factor: M does not scale
  TheoremNode n = node(NodeKind::scaling, "sliding_top.toml");
  n.where = {{"g", "0"}};
  n.small = {"L1", "L2", "L3"};
  n.scaled = {"M1", "M2", "M3"};
  EXPECT_EQ(run(n).status, NodeStatus::refuted);
  n.scaled = {"Gamma1", "Gamma2", "Gamma3"};
  EXPECT_EQ(run(n).status, NodeStatus::proved);
}

TEST(ScalingStep, HoldsForTheHeavyTopTooAndNotForTheSlidingTopWithGravity) {
  TheoremNode n = node(NodeKind::scaling, "../classics/heavy_top.toml");
  n.small = {"L1", "L2", "L3"};
  n.scaled = {"Gamma1", "Gamma2", "Gamma3"};
  EXPECT_EQ(run(n).status, NodeStatus::proved);
}

TEST(LowestOrderStep, TheSlidingTopIsLowestOrderAHeavyTop) {
  TheoremNode n = node(NodeKind::lowest_order, "sliding_top.toml");
  n.other = "lowest_order.toml";
  EXPECT_EQ(run(n).status, NodeStatus::proved);
  n.other = "euler.toml";
  EXPECT_NE(run(n).status, NodeStatus::proved);
}

TEST(SplittingStep, AFamilyThatIsNotListedLeavesTheStepOpen) {
  TheoremNode n = node(NodeKind::splitting, "sliding_top.toml");
  n.where = {{"g", "0"}};
  n.small = {"L1", "L2", "L3"};
  const NodeResult open = run(n);
  EXPECT_EQ(open.status, NodeStatus::open);
  EXPECT_THAT(open.summary, HasSubstr("2*A - 2*B - C = 0"));
  n.families = {"L3 = 0, L2 = 0, 2*A - 2*B - C = 0"};
  EXPECT_EQ(run(n).status, NodeStatus::proved);
  n.triangle = false; // then there is one more
  EXPECT_EQ(run(n).status, NodeStatus::open);
}

// What `where` fixes was not studied for other values, and the sentence must not say that it was.
TEST(SplittingStep, SaysWhatWasFixedAndWhichDirectionsWereLookedAt) {
  TheoremNode n = node(NodeKind::splitting, "../classics/heavy_top.toml");
  n.where = {{"L2", "0"}, {"L3", "0"}};
  n.small = {"L1"};
  const NodeResult one = run(n);
  EXPECT_EQ(one.status, NodeStatus::proved);
  EXPECT_THAT(one.summary, HasSubstr("with L2 = 0, L3 = 0"));
  EXPECT_THAT(one.summary, HasSubstr("every L1 other than 0"));
  n.where = {};
  n.small = {"L1", "L2", "L3"};
  EXPECT_THAT(run(n).summary, HasSubstr("every (L1, L2, L3) other than (0, 0, 0)"));
}

// Bodies outside the triangle inequality are left out, and that is said.
TEST(SplittingStep, SaysThatTheTriangleInequalityWasUsed) {
  TheoremNode n = node(NodeKind::splitting, "sliding_top.toml");
  n.where = {{"g", "0"}};
  n.small = {"L1", "L2", "L3"};
  n.families = {"L3 = 0, L2 = 0, 2*A - 2*B - C = 0"};
  EXPECT_THAT(run(n).summary, HasSubstr("A <= B + C"));
}

TEST(SplittingStep, OtherSystemsAreOpenWithAReason) {
  TheoremNode n = node(NodeKind::splitting, "../classics/henon_heiles.toml");
  n.small = {"A"};
  EXPECT_EQ(run(n).status, NodeStatus::open);
}

TEST(CaseStep, ASampleIsProvedWithACertificate) {
  TheoremNode n = node(NodeKind::case_file, "lemma3.toml");
  n.where = {{"A", "1"}, {"C", "3/2"}};
  const NodeResult r = run(n);
  EXPECT_EQ(r.status, NodeStatus::proved);
  EXPECT_EQ(r.certificates.size(), 1U);
  EXPECT_FALSE(r.theorems.empty());
}

// A member of the family that the splitting leaves, and one where singular points meet.
TEST(CaseStep, MembersOfTheRemainingFamilyAreNotIntegrable) {
  TheoremNode n = node(NodeKind::case_file, "long_axis.toml");
  n.where = {{"A", "5/4"}, {"B", "1"}};
  EXPECT_EQ(run(n).status, NodeStatus::proved);
  n.where = {{"A", "2"}, {"B", "3/2"}};
  EXPECT_EQ(run(n).status, NodeStatus::proved);
}

TEST(CaseStep, AnIntegrableSystemIsNotProvedNonIntegrable) {
  TheoremNode n = node(NodeKind::case_file, "lemma3.toml");
  n.where = {{"A", "1"}, {"C", "1"}};
  EXPECT_EQ(run(n).status, NodeStatus::open);
}

// A report on a system that passes the test must not read like a proof of integrability.
TEST(Conclusion, OfAVerdictSaysDecidedAndNotProved) {
  TheoremNode n = node(NodeKind::case_file, "lemma3.toml");
  n.where = {{"A", "1"}, {"C", "1"}};
  n.expect = "any";
  const TheoremResult r = prove({cases + "sliding_top/test.toml", "T", "S", {}, {n}});
  EXPECT_THAT(r.conclusion(), HasSubstr("DECIDED"));
  EXPECT_THAT(r.conclusion(), testing::Not(HasSubstr("PROVED")));
  EXPECT_THAT(r.nodes[0].summary, HasSubstr("no-obstruction"));
}
