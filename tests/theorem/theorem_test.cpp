// Theorem files: reading, the built-in steps, and what openness does.

#include "support/own_folder.hpp"
#include "support/source_dir.hpp"
#include "theorem/prove.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

using namespace kov;
using testing::HasSubstr;

namespace {

const std::string cases = test::in_source("/cases/");

Theorem parsed(const std::string& nodes) {
  return read_theorem(parse_document(
      "format = \"theorem/1\"\ntitle = \"T\"\nsystem = \"sliding_top.toml\"\n" + nodes,
      cases + "sliding_top/test.toml"));
}

TheoremNode node(NodeKind kind, const std::string& file) {
  TheoremNode n;
  n.id = n.title = "n";
  n.kind = kind;
  n.file = file;
  return n;
}

// A theorem about the system of its only step.
Theorem alone(TheoremNode n, const std::string& directory) {
  if (n.kind != NodeKind::lowest_order) n.place.at = n.where;
  if (n.kind == NodeKind::splitting) {
    n.place.conditions = {"A > B", "B > C", "C > 0", "B + C - A >= 0"};
    std::string direction;
    for (const std::string& name : n.small)
      direction += (direction.empty() ? "" : " + ") + name + "^2";
    n.place.conditions.push_back(direction + " > 0");
    if (!n.families.empty()) n.place.conditions.emplace_back("L2^2 + L3^2 + (2*A - 2*B - C)^2 > 0");
  }
  Theorem t;
  t.file = directory + "test.toml";
  t.title = "T";
  t.system = n.file;
  t.nodes.push_back(std::move(n));
  return t;
}

NodeResult run(const TheoremNode& n) {
  return prove(alone(n, cases + "sliding_top/")).nodes.front();
}

// A system file for one test.
std::string written(const std::string& name, const std::string& text) {
  const std::string path = test::own_folder() + name;
  std::ofstream(path) << text;
  return path;
}

std::string on_axis(const std::string& parameters, const std::string& hamiltonian) {
  return "[system]\nkind = \"hamiltonian\"\ncoordinates = [\"q1\", \"q2\"]\n"
         "momenta = [\"p1\", \"p2\"]\nparameters = [" +
         parameters + "]\nhamiltonian = \"" + hamiltonian +
         "\"\n[[manifold]]\nname = \"axis\"\nequations = [\"q1 = 0\", \"p1 = 0\"]\n"
         "level = \"H = h\"\n[reduce]\nvariable = \"q1\"\nchange = \"z = q2\"\n";
}

// The step by itself, with a file that is not among the cases.
NodeResult run_written(TheoremNode n, const std::string& text) {
  n.file = written(n.file, text).substr(test::own_folder().size());
  return prove(alone(n, test::own_folder())).nodes.front();
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

// A key that nobody looks at would be a promise that nobody keeps.
// A step that carries nothing would only make the theorem look better.
TEST(TheoremFile, EveryNodeCarriesTheRootAndNoneItself) {
  const std::string a = "[[node]]\nid = \"a\"\nstatement = \"\"\nkind = \"argument\"\n";
  const std::string b = "[[node]]\nid = \"b\"\nstatement = \"\"\nkind = \"theorem\"\n";
  EXPECT_THAT(error_of(a + b), HasSubstr("nothing rests on node 'b'"));
  EXPECT_EQ(error_of(a + "needs = [\"b\"]\n" + b), "");
  EXPECT_THAT(error_of(b + "hypotheses = [{ text = \"h\", by = \"b\" }]\n"),
              HasSubstr("checks its own hypothesis"));
}

TEST(Conclusion, SaysWhatTheProofIsGiven) {
  const TheoremResult r = prove(parsed("[[node]]\nid = \"a\"\nstatement = \"\"\n"
                                       "kind = \"argument\"\nneeds = [\"b\"]\n"
                                       "[[node]]\nid = \"b\"\nstatement = \"\"\n"
                                       "kind = \"claims\"\nfile = \"euler.toml\"\n"
                                       "at = { L1 = \"0\", L2 = \"0\", L3 = \"0\" }\n"));
  EXPECT_EQ(r.conclusion(), "NOT PROVED: 1 argument in words is NOT CHECKED; 1 step computed here, "
                            "0 of them with certificates");
  const TheoremResult nothing =
      prove(parsed("[[node]]\nid = \"a\"\nstatement = \"\"\nkind = \"argument\"\n"));
  EXPECT_THAT(nothing.conclusion(), HasSubstr("NOT PROVED"));
}

// A report on one file rests on no composition, and an open step no certificate to count.
TEST(Conclusion, CountsCertificatesOfProvedSteps) {
  TheoremNode n = node(NodeKind::case_file, "lemma3.toml");
  n.where = {{"A", "1"}, {"C", "3/2"}};
  TheoremResult r = prove(alone(n, cases + "sliding_top/"));
  EXPECT_THAT(r.computed(), HasSubstr("1 of them with certificates"));
  EXPECT_TRUE(r.trusted_steps().empty());
  for (NodeResult& one : r.nodes)
    one.status = NodeStatus::open;
  EXPECT_EQ(r.computed(), "0 steps computed here, 0 of them with certificates");
}

// The theorem of the literature is counted, whether the file names it or not.
TEST(Conclusion, CountsTheTheoremsThatStepsUse) {
  TheoremNode n = node(NodeKind::case_file, "lemma3.toml");
  n.where = {{"A", "1"}, {"C", "3/2"}};
  const TheoremResult r = prove(alone(n, cases + "sliding_top/"));
  ASSERT_EQ(r.uses().size(), 1U);
  EXPECT_EQ(r.uses().front().theorem, &morales_ramis());
}

TEST(TheoremFile, KeysThatAKindDoesNotLookAtAreErrors) {
  const std::string head = "[[node]]\nid = \"a\"\nstatement = \"\"\nkind = ";
  EXPECT_THAT(error_of(head + "\"claims\"\nfile = \"x.toml\"\nsample = { A = \"1\" }\n"),
              HasSubstr("does not look at 'sample'"));
  EXPECT_THAT(error_of(head + "\"argument\"\nfile = \"x.toml\"\n"),
              HasSubstr("does not look at 'file'"));
  EXPECT_THAT(error_of(head + "\"splitting\"\nfile = \"x.toml\"\n"), HasSubstr("needs 'small'"));
  EXPECT_THAT(error_of(head + "\"lowest-order\"\nfile = \"x.toml\"\n"), HasSubstr("needs 'other'"));
  EXPECT_THAT(error_of(head + "\"case\"\nfile = \"x.toml\"\nwhere = \"A = 1\"\n"),
              HasSubstr("table of values"));
  EXPECT_THAT(error_of(head + "\"case\"\nfile = \"x.toml\"\nexpect = \"undecided\"\n"),
              HasSubstr("not a verdict"));
}

TEST(TheoremFile, AValueForAnUnknownParameterIsAnErrorOfTheTheoremFile) {
  TheoremNode n = node(NodeKind::case_file, "lemma3.toml");
  n.where = {{"zz", "1"}};
  n.line = 7;
  try {
    (void)run(n);
    FAIL();
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(),
                HasSubstr("test.toml:7: error: node 'n', value of zz: 'zz' is not a parameter"));
  }
}

// Names that the system file does not know are mistakes of the theorem file, not open questions.
TEST(TheoremFile, NamesThatTheSystemDoesNotKnowAreErrors) {
  const auto message = [](TheoremNode n) -> std::string {
    try {
      return "no error: " + run(n).summary;
    } catch (const InputError& e) {
      return e.what() + e.hint();
    }
  };
  TheoremNode n = node(NodeKind::splitting, "sliding_top.toml");
  n.small = {"L1", "L22"};
  EXPECT_THAT(message(n), HasSubstr("'L22' is not a free parameter"));
  EXPECT_THAT(message(n), HasSubstr("did you mean L2"));
  n.small = {"L1"};
  n.where = {{"L1", "0"}};
  EXPECT_THAT(message(n), HasSubstr("'L1' is not a free parameter"));
  TheoremNode c = node(NodeKind::case_file, "lemma3.toml");
  c.manifold = "nope";
  EXPECT_THAT(message(c), HasSubstr("'nope' is not a manifold"));
  const std::string id = "[[node]]\nid = \"../a\"\nstatement = \"\"\nkind = \"argument\"\n";
  EXPECT_THAT(error_of(id), HasSubstr("an id consists of"));
}

// Every node is needed twice: 2^60 paths, and each node is looked at once.
TEST(TheoremFile, ManyPathsAreNoTrouble) {
  std::string text;
  for (int i = 0; i < 60; ++i)
    for (const std::string side : {"a", "b"}) {
      const std::string next = std::to_string(i + 1);
      text += "[[node]]\nid = \"" + side + std::to_string(i) +
              "\"\nstatement = \"\"\nkind = \"argument\"\nneeds = [\"" +
              (i == 0 && side == "a" ? "b0\", \"a" : "a") + next + "\", \"b" + next + "\"]\n";
    }
  for (const std::string side : {"a60", "b60"})
    text += "[[node]]\nid = \"" + side + "\"\nstatement = \"\"\nkind = \"argument\"\n";
  const TheoremResult r = prove(parsed(text));
  EXPECT_EQ(r.count(NodeStatus::open), 0U);
  EXPECT_FALSE(r.complete()); // words are not checked
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
at = { L1 = "0", L2 = "0", L3 = "0" }
)");
  const TheoremResult r = prove(t);
  EXPECT_FALSE(r.complete());
  EXPECT_TRUE(r.nodes[0].rests_on_open);
  EXPECT_TRUE(r.nodes[1].rests_on_open);
  EXPECT_EQ(r.nodes[3].status, NodeStatus::proved);
  EXPECT_EQ(r.unchecked_hypotheses().size(), 2U);
  EXPECT_THAT(r.conclusion(), HasSubstr("NOT PROVED"));
}

TEST(ClaimsStep, AFalseClaimRefutes) {
  const std::string field = "[system]\nkind = \"vector-field\"\ncoordinates = [\"x\", \"y\"]\n"
                            "[system.field]\nx = \"y\"\ny = \"-x\"\n[[integral]]\nvalue = ";
  const TheoremNode n = node(NodeKind::claims, "theorem_test_false.toml");
  EXPECT_EQ(run_written(n, field + "\"x^2 - y^2\"\n").status, NodeStatus::refuted);
  EXPECT_EQ(run_written(n, field + "\"x^2 + y^2\"\n").status, NodeStatus::proved);
}

// What a claim divides by is a condition, whether the proof or the claim itself divides.
TEST(ClaimsStep, WhereAClaimMeansSomething) {
  const std::string field = "[system]\nkind = \"vector-field\"\ncoordinates = [\"x\", \"y\"]\n"
                            "parameters = [\"a\"]\n[system.field]\nx = \"a*x\"\ny = \"x\"\n";
  const std::string quotient = "[[integral]]\nname = \"F\"\nvalue = \"y - x/a\"\n";
  const TheoremNode n = node(NodeKind::claims, "theorem_test_claims.toml");
  for (const std::string& claim :
       {quotient, std::string("[[integral]]\nname = \"F\"\nvalue = \"y\"\non = \"a*x = 0\"\n")}) {
    const NodeResult r = run_written(n, field + claim);
    ASSERT_EQ(r.node.hypotheses.size(), 1U);
    EXPECT_THAT(r.node.hypotheses[0].text, HasSubstr("a != 0"));
    EXPECT_FALSE(r.node.hypotheses[0].checked);
  }
  const std::string assumed = field + "[assume]\na = \"positive\"\n" + quotient;
  EXPECT_TRUE(run_written(n, assumed).node.hypotheses.empty());
}

// The criterion is about small L; the heavy top at L is that at all multiples of L.
TEST(SplittingStep, SmallParametersAreAllIfTheSystemScales) {
  std::ifstream file(cases + "classics/heavy_top.toml");
  std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  TheoremNode n = node(NodeKind::splitting, "theorem_test_scales.toml");
  n.small = {"L1", "L2", "L3"};
  const NodeResult all = run_written(n, text);
  EXPECT_EQ(all.says, Conclusion::not_integrable);
  EXPECT_THAT(all.summary, testing::Not(HasSubstr("small")));
  const std::string linear = " + Gamma3*L3";
  text.replace(text.find(linear), linear.size(), linear + " + Gamma1*L1^2");
  const NodeResult small = run_written(n, text);
  EXPECT_EQ(small.status, NodeStatus::proved) << small.summary;
  EXPECT_EQ(small.says, Conclusion::none);
  EXPECT_THAT(small.summary, HasSubstr("when these parameters are small"));
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

// A family that is left needs another step: without one nothing covers it.
TEST(SplittingStep, AFamilyIsNotSaidToBeExcluded) {
  TheoremNode n = node(NodeKind::splitting, "sliding_top.toml");
  n.where = {{"g", "0"}};
  n.small = {"L1", "L2", "L3"};
  n.families = {"L3 = 0, L2 = 0, 2*A - 2*B - C = 0"};
  Theorem t = alone(n, cases + "sliding_top/");
  EXPECT_EQ(prove(t).nodes.front().status, NodeStatus::proved);
  t.nodes.front().place.conditions.pop_back(); // the region has the family now
  const NodeResult r = prove(t).nodes.front();
  EXPECT_EQ(r.status, NodeStatus::unbound);
  EXPECT_THAT(r.summary, HasSubstr("it assumes that"));
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

// At h = 0 nothing moves along q2: the sample is not decided, and the sentence says so.
TEST(CaseStep, AnUndecidedSampleIsSaid) {
  TheoremNode n = node(NodeKind::case_file, "theorem_test_level.toml");
  n.sample = {{"h", "0"}};
  const NodeResult r = run_written(n, on_axis("\"h\"", "(p1^2 + p2^2*q2)/2 + q1^2*q2^2"));
  EXPECT_EQ(r.status, NodeStatus::proved); // other levels are enough
  EXPECT_THAT(r.summary, HasSubstr("SAMPLE h = 0 BY ITSELF IS UNDECIDED"));
}

// An irregular place leaves a smaller class of first integrals.
TEST(CaseStep, TheClassOfFirstIntegralsIsSaid) {
  const TheoremNode n = node(NodeKind::case_file, "theorem_test_class.toml");
  const NodeResult r = run_written(n, on_axis("\"h\"", "(p1^2 + p2^2 + q2^2)/2 + q1^2*q2^2"));
  EXPECT_EQ(r.status, NodeStatus::proved);
  EXPECT_THAT(r.summary, HasSubstr("meromorphic also at the ends of the phase curve"));
}

// One level is enough, and a level that is abelian is not a counterexample.
TEST(CaseStep, ASampleOfAnotherLevelIsNoContradiction) {
  TheoremNode n = node(NodeKind::case_file, "theorem_test_levels.toml");
  n.where = {{"a", "1"}};
  n.sample = {{"h", "0"}};
  const std::string text = on_axis("\"a\", \"h\"", "(p1^2 + p2^2)/2 + a*q2^2 + q1^2*(a/4 + q2^2)");
  const NodeResult r = run_written(n, text);
  EXPECT_EQ(r.status, NodeStatus::proved);
  EXPECT_THAT(r.summary, HasSubstr("at the level of the sample h = 0: no-obstruction"));
}

TEST(CaseStep, ASampleGivesNoSecondValue) {
  const std::string text = "[[node]]\nid = \"a\"\nstatement = \"\"\nkind = \"case\"\n"
                           "file = \"x.toml\"\nwhere = { A = \"1\" }\nsample = { A = \"2\" }\n";
  EXPECT_THAT(error_of(text), HasSubstr(":10:12: error: 'A' has a value in where already"));
  EXPECT_THAT(error_of(text), HasSubstr("leaves free"));
}

// q1 = p1 = 0 passes the test, q2 = p2 = 0 does not: the file as a whole does not.
TEST(CaseStep, OneManifoldIsEnough) {
  const std::string text = R"t([system]
kind = "hamiltonian"
coordinates = ["q1", "q2"]
momenta = ["p1", "p2"]
hamiltonian = "(p1^2 + p2^2 + q1^2 + q2^2)/2 + q1^4*q2^2"
[[manifold]]
name = "passes"
equations = ["q1 = 0", "p1 = 0"]
level = "H = 1"
[[manifold]]
name = "other"
equations = ["q2 = 0", "p2 = 0"]
level = "H = 1"
)t";
  TheoremNode n = node(NodeKind::case_file, "theorem_test_two.toml");
  n.expect = "any";
  EXPECT_THAT(run_written(n, text).summary, testing::StartsWith("non-integrable"));
  n.expect = "no-obstruction";
  EXPECT_EQ(run_written(n, text).status, NodeStatus::refuted);
  n.manifold = "passes";
  EXPECT_EQ(run_written(n, text).status, NodeStatus::proved);
}

TEST(CaseStep, ADecidedVerdictThatIsAnotherOneRefutes) {
  TheoremNode n = node(NodeKind::case_file, "lemma3.toml");
  n.where = {{"A", "1"}, {"C", "3/2"}};
  n.expect = "no-obstruction";
  const NodeResult r = run(n);
  EXPECT_EQ(r.status, NodeStatus::refuted);
  EXPECT_THAT(r.summary, HasSubstr("expected no-obstruction, found non-integrable"));
}

TEST(LowestOrderStep, NeedsWeights) {
  TheoremNode n = node(NodeKind::lowest_order, "../classics/heavy_top.toml");
  n.other = "../classics/heavy_top.toml";
  const NodeResult r = run(n);
  EXPECT_EQ(r.status, NodeStatus::open);
  EXPECT_THAT(r.summary, HasSubstr("weights"));
}

TEST(CaseStep, ThePassedTestProvesNothing) {
  TheoremNode n = node(NodeKind::case_file, "lemma3.toml");
  n.where = {{"A", "1"}, {"C", "1"}};
  n.expect = "no-obstruction";
  EXPECT_THAT(run(n).summary, HasSubstr("nothing follows about integrability"));
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
  const TheoremResult r = prove(alone(n, cases + "sliding_top/"));
  EXPECT_THAT(r.conclusion(), HasSubstr("NO OBSTRUCTION"));
  EXPECT_THAT(r.conclusion(), testing::Not(HasSubstr("PROVED")));
  EXPECT_THAT(r.nodes[0].summary, HasSubstr("no-obstruction"));
}
