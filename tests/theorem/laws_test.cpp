// Laws of theorems: what adds up over needs, what rests on something open, which regions cover, and theorems that a
// classification has written.

#include "certify/theorem/check.hpp"
#include "support/random.hpp"
#include "written.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

namespace kov {
namespace {

using namespace test;
using test::Random;
using test::random_rounds;
using testing::HasSubstr;
using testing::StartsWith;

// ---- random trees of steps, of which nothing is computed

bool is_missing(NodeStatus s) {
  return s == NodeStatus::open || s == NodeStatus::refuted || s == NodeStatus::unbound;
}
bool is_ours(NodeStatus s) { return s == NodeStatus::proved || s == NodeStatus::partial; }

// Step k needs some of those after it.
TheoremResult random_theorem(Random& random) {
  static const std::vector<NodeStatus> statuses{
      NodeStatus::proved,  NodeStatus::proved,   NodeStatus::proved,  NodeStatus::proved,
      NodeStatus::proved,  NodeStatus::trusted,  NodeStatus::trusted, NodeStatus::open,
      NodeStatus::refuted, NodeStatus::reasoned, NodeStatus::unbound};
  TheoremResult r;
  const long size = random.between(1, 9);
  for (long k = 0; k < size; ++k) {
    NodeResult n;
    n.node.id = n.node.title = "n" + std::to_string(k);
    for (long below = k + 1; below < size; ++below)
      if (random.once_in(3)) n.node.needs.push_back("n" + std::to_string(below));
    n.node.kind = NodeKind::case_file;
    n.status = random.one_of(statuses);
    for (long i = random.between(-1, 2); i > 0; --i)
      n.trusted.push_back({Trusted::Step::by_author, "step " + std::to_string(i)});
    if (random.once_in(4) && !n.trusted.empty()) n.trusted.push_back(n.trusted.front());
    r.nodes.push_back(std::move(n));
  }
  return r;
}

// The step and all below it, each once.
std::set<std::string> rests_on(const TheoremResult& r, const std::string& id) {
  std::set<std::string> all{id};
  for (bool grown = true; grown;) {
    const std::size_t before = all.size();
    for (const NodeResult& n : r.nodes)
      if (all.contains(n.node.id)) all.insert(n.node.needs.begin(), n.node.needs.end());
    grown = all.size() != before;
  }
  return all;
}

using Statuses = std::map<std::string, std::pair<NodeStatus, std::size_t>>;
Statuses settled(const TheoremResult& r) {
  Statuses all;
  for (const NodeResult& n : r.nodes)
    all[n.node.id] = {n.status, n.steps_on_trust};
  return all;
}

TEST(TreeLaws, StatusAndTrustAreThoseOfAllBelow) {
  random_rounds(300, [](Random& random) {
    const TheoremResult before = random_theorem(random);
    TheoremResult r = before;
    settle_statuses(r);
    for (std::size_t k = 0; k < r.nodes.size(); ++k) {
      const NodeResult& n = r.nodes[k];
      std::size_t trusted = 0;
      bool open = false;
      for (const std::string& id : rests_on(r, n.node.id)) {
        const NodeResult& one = *node_with(before, id);
        trusted += std::set<Trusted>(one.trusted.begin(), one.trusted.end()).size();
        open = open || (id != n.node.id && is_missing(one.status));
      }
      EXPECT_EQ(n.steps_on_trust, trusted) << n.node.id;
      EXPECT_EQ(n.rests_on_open, open) << n.node.id;
      EXPECT_EQ(n.status, !is_ours(before.nodes[k].status) ? before.nodes[k].status
                          : open                           ? NodeStatus::partial
                                                           : NodeStatus::proved);
    }
  });
}

TEST(TreeLaws, SettlingTwiceOrInAnotherOrderIsTheSame) {
  random_rounds(200, [](Random& random) {
    TheoremResult r = random_theorem(random), other = r;
    settle_statuses(r);
    std::shuffle(other.nodes.begin(), other.nodes.end(), random.bits());
    for (NodeResult& n : other.nodes)
      std::shuffle(n.node.needs.begin(), n.node.needs.end(), random.bits());
    settle_statuses(other);
    EXPECT_EQ(settled(other), settled(r));
    settle_statuses(other);
    EXPECT_EQ(settled(other), settled(r));
  });
}

// One step that is proved after all: no other step loses anything.
TEST(TreeLaws, AProofMoreTakesNothingBack) {
  random_rounds(200, [](Random& random) {
    TheoremResult r = random_theorem(random);
    settle_statuses(r);
    TheoremResult more = r;
    more.nodes[static_cast<std::size_t>(random.between(0, static_cast<long>(r.nodes.size()) - 1))]
        .status = NodeStatus::proved;
    settle_statuses(more);
    for (std::size_t k = 0; k < r.nodes.size(); ++k) {
      if (r.nodes[k].status == NodeStatus::proved) {
        EXPECT_EQ(more.nodes[k].status, NodeStatus::proved);
      }
      EXPECT_EQ(more.nodes[k].steps_on_trust, r.nodes[k].steps_on_trust);
    }
    EXPECT_TRUE(more.complete() || !r.complete());
  });
}

// "PROVED" is said of a theorem only if the root is, and nothing is missing anywhere.
TEST(TreeLaws, TheVerdictIsThatOfTheWholeTree) {
  random_rounds(300, [](Random& random) {
    TheoremResult r = random_theorem(random);
    settle_statuses(r);
    const bool missing = std::ranges::any_of(r.nodes, [](const NodeResult& n) {
      return is_missing(n.status) || n.status == NodeStatus::reasoned ||
             n.status == NodeStatus::partial;
    });
    EXPECT_EQ(r.complete(), !missing && r.nodes.front().status == NodeStatus::proved);
    EXPECT_EQ(r.verdict().starts_with("PROVED"), r.complete()) << r.verdict();
    EXPECT_EQ(r.conclusion().starts_with("PROVED"), r.complete()) << r.conclusion();
    std::size_t own = 0;
    for (const NodeResult& n : r.nodes)
      own += std::set<Trusted>(n.trusted.begin(), n.trusted.end()).size();
    EXPECT_EQ(r.trusted_steps().size(), own) << "each step counts once, also where two rest on it";
    EXPECT_GE(own, r.nodes.front().steps_on_trust);
  });
}

// ---- which regions cover

// Steps on trust in these regions: a conjunction each.
TheoremResult cover(const std::string& system,
                    const std::vector<std::vector<std::string>>& regions) {
  std::string nodes, needs;
  for (std::size_t k = 0; k < regions.size(); ++k) {
    const std::string id = "part-" + std::to_string(k);
    needs += (needs.empty() ? "\"" : ", \"") + id + "\"";
    nodes += "[[node]]\nid = \"" + id + "\"\nkind = \"trusted\"\nstep = \"s" + std::to_string(k) +
             "\"\nregions = [" + quoted(regions[k]) + "]\n";
  }
  ProveOptions options;
  options.with_bundle = false;
  return prove(theorem("system = \"" + system +
                       "\"\n[[node]]\nid = \"main\"\nkind = \"cover\"\nneeds = [" + needs + "]\n" +
                       nodes),
               options);
}

// Of complex a: sets of few numbers and their complements.
TEST(CoverLaws, EquationsAndInequationsCoverAsTheirPointsDo) {
  write("complex.toml", planar(even, ""));
  random_rounds(25, [](Random& random) {
    std::vector<std::vector<std::string>> regions;
    std::set<long> covered; // of 0, 1, 2, 3, and 9 for all others
    for (long k = random.between(1, 4); k > 0; --k) {
      std::set<long> here;
      std::string product = "1";
      for (long v = 0; v <= 3; ++v)
        if (random.once_in(2)) {
          here.insert(v);
          product += "*(a - " + std::to_string(v) + ")";
        }
      if (here.empty()) continue;
      const bool zero = random.once_in(2);
      for (const long v : {0, 1, 2, 3, 9})
        if (here.contains(v) == zero) covered.insert(v);
      regions.push_back({product + (zero ? " = 0" : " != 0")});
    }
    if (regions.empty()) return;
    const TheoremResult r = cover("complex.toml", regions);
    EXPECT_EQ(root(r).status == NodeStatus::proved, covered.size() == 5) << root(r).summary;
    EXPECT_EQ(r.statement().empty(), covered.size() < 5);
    EXPECT_FALSE(r.complete()) << "steps of the file are not proved";
  });
}

// Of real a: intervals, with and without their ends.
TEST(CoverLaws, IntervalsThatLeaveAPointDoNotCover) {
  write("interval.toml", planar(even, "[assume]\na = 'real'\nconditions = ['a >= 0', 'a <= 4']\n"));
  long proved = 0;
  random_rounds(25, [&](Random& random) {
    std::vector<std::vector<std::string>> regions;
    std::set<long> covered; // halves: 0, 1/2, 1, ..., 4 for the integers and what is between
    for (long k = random.between(1, 4); k > 0; --k) {
      const long low = random.between(0, 3), high = random.between(low + 1, 5);
      const bool with_low = random.once_in(2), with_high = random.once_in(2);
      for (long half = 0; half <= 8; ++half)
        if ((half > 2 * low || (with_low && half == 2 * low)) &&
            (half < 2 * high || (with_high && half == 2 * high)))
          covered.insert(half);
      regions.push_back({std::string("a >") + (with_low ? "= " : " ") + std::to_string(low),
                         std::string("a <") + (with_high ? "= " : " ") + std::to_string(high)});
    }
    const TheoremResult r = cover("interval.toml", regions);
    EXPECT_TRUE(root(r).status != NodeStatus::proved || covered.size() == 9) << root(r).statement;
    proved += root(r).status == NodeStatus::proved ? 1 : 0;
  });
  EXPECT_EQ(root(cover("interval.toml", {{"a >= 0", "a <= 4"}, {"a = 7"}})).status,
            NodeStatus::proved);
  EXPECT_GT(proved, 0);
}

// The regions in another order, one that lies in another, one that is empty.
TEST(CoverLaws, IdleRegionsChangeNothing) {
  write("complex.toml", planar(even, ""));
  const TheoremResult plain = cover("complex.toml", {{"a = 0"}, {"a != 0"}});
  ASSERT_EQ(root(plain).status, NodeStatus::proved);
  for (const std::vector<std::vector<std::string>>& regions :
       {std::vector<std::vector<std::string>>{{"a != 0"}, {"a = 0"}},
        {{"a = 0"}, {"a != 0"}, {"a = 1"}},
        {{"a = 0"}, {"a != 0"}, {"a = 1", "a = 2"}},
        {{"a = 0", "a^2 = 0"}, {"a != 0", "2*a != 0"}},
        {{"a = 0"}, {"a*(a - 1) != 0"}, {"a = 1"}}}) {
    const TheoremResult r = cover("complex.toml", regions);
    EXPECT_EQ(root(r).status, NodeStatus::proved) << root(r).summary;
    EXPECT_EQ(root(r).excluded, root(plain).excluded);
    EXPECT_EQ(r.trusted_steps().size(), regions.size());
  }
  for (const std::vector<std::vector<std::string>>& regions :
       {std::vector<std::vector<std::string>>{{"a != 0"}},
        {{"a != 0"}, {"a = 0", "a = 1"}},
        {{"a^2 + 1 = 0"}, {"a != 0"}},
        {{"a = 0"}, {"a*(a - 1) != 0"}}}) {
    const TheoremResult r = cover("complex.toml", regions);
    EXPECT_EQ(root(r).status, NodeStatus::open);
    EXPECT_EQ(r.statement(), "");
  }
}

// ---- regions of real parameters by cases

TheoremResult by_cases(const std::string& system, const std::vector<std::string>& whole,
                       const std::vector<std::vector<std::string>>& parts,
                       const std::string& more = "") {
  std::string nodes, needs;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const std::string id = "part-" + std::to_string(k);
    needs += (needs.empty() ? "\"" : ", \"") + id + "\"";
    nodes += "[[node]]\nid = \"" + id + "\"\nkind = \"case\"\nfile = \"" + system +
             "\"\nif = " + quoted(parts[k]) + "\n" + more;
  }
  return prove(theorem("system = \"" + system +
                       "\"\n[[node]]\nid = \"main\"\nkind = \"cover\"\nif = " + quoted(whole) +
                       "\nneeds = [" + needs + "]\n" + nodes));
}

TEST(CaseLaws, ASmallerRegionLosesNothing) {
  write("positive.toml", planar(even, "[assume]\nconditions = ['a > 0']\nh = 'real'\n" + axis));
  for (const auto& [whole, part, proved] :
       std::vector<std::tuple<std::vector<std::string>, std::vector<std::string>, bool>>{
           {{}, {}, true},
           {{"a > 1"}, {}, true},
           {{"a > 1"}, {"a > 1"}, true},
           {{"a > 2"}, {"a > 1", "a > 0"}, true},
           {{"a > 1", "a < 1"}, {"a = 7"}, false}, // of nothing, nothing is said
           {{"a > 1"}, {"a >= 1"}, true},
           {{"a >= 1"}, {"a > 1"}, false},
           {{}, {"a > 1"}, false},
           {{"a = 3"}, {"a > 1"}, true},
           {{"a > 1"}, {"a = 3"}, false}}) {
    const TheoremResult r = by_cases("positive.toml", whole, {part});
    EXPECT_EQ(r.complete(), proved) << quoted(whole) << quoted(part) << r.conclusion();
    EXPECT_EQ(r.statement().empty(), !proved);
  }
}

// A case that is open in a part of its file proves nothing, though it does at most of its points.
TEST(CaseLaws, WhatRestsOnAnOpenCaseIsNotProved) {
  write("some.toml", planar(even, "[assume]\na = 'real'\nh = 'real'\n" + axis));
  const TheoremResult r = by_cases("some.toml", {}, {{}});
  EXPECT_NE(root(r).status, NodeStatus::proved);
  EXPECT_THAT(r.conclusion(), StartsWith("NOT PROVED"));
  EXPECT_EQ(r.statement(), "");
  EXPECT_TRUE(r.bundle.empty());
}

// Two steps rest on one: what is on trust there is counted once, and what is open is open for both.
TEST(CaseLaws, ANeedThatIsShared) {
  write("positive.toml", planar(even, "[assume]\nconditions = ['a > 0']\nh = 'real'\n" + axis));
  write("some.toml", planar(even, "[assume]\na = 'real'\nh = 'real'\n" + axis));
  const auto shared = [](const std::string& file) {
    const TheoremResult r = prove(theorem(
        "system = \"positive.toml\"\n"
        "[[node]]\nid = \"main\"\nkind = \"cover\"\nneeds = [\"left\", \"right\"]\n"
        "[[node]]\nid = \"left\"\nkind = \"case\"\nfile = \"positive.toml\"\nneeds = [\"low\"]\n"
        "[[node]]\nid = \"right\"\nkind = \"case\"\nfile = \"positive.toml\"\nneeds = [\"low\"]\n"
        "[[node]]\nid = \"low\"\nkind = \"case\"\nfile = \"" +
        file + "\"\n"));
    EXPECT_EQ(r.nodes[1].status, r.nodes[2].status);
    EXPECT_EQ(r.nodes[1].rests_on_open, r.nodes[2].rests_on_open);
    std::size_t own = 0;
    for (const NodeResult& n : r.nodes)
      own += n.trusted.size();
    EXPECT_EQ(root(r).steps_on_trust, own);
    return r;
  };
  EXPECT_TRUE(shared("positive.toml").complete());
  const TheoremResult open = shared("some.toml");
  EXPECT_EQ(open.nodes[1].status, NodeStatus::partial);
  EXPECT_NE(root(open).status, NodeStatus::proved);
}

// ---- theorems that a classification has written

// For no a all curves have special exponent differences at once.
const std::string cyclic = "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y', 'z']\n"
                           "momenta = ['u', 'v', 'w']\nparameters = ['a']\n"
                           "hamiltonian = '(u^2 + v^2 + w^2)/2 + x*y*z + a*(x^3 + y^3 + z^3)/3'\n";
const std::vector<std::string>& systems() {
  static const std::vector<std::string> all{
      planar(even, axis),
      planar("(u^2 + v^2)/2 + x^2*y + a*y^3/3", axis),
      planar("(u^2 + v^2)/2 + x^2*y/2 + a*x^3/3 + y^3/3", ""), // a case that is not found again
      planar("(u^2 + v^2)/2 + x^4 + a*x^2*y^2 + y^4", axis),
      planar("(u^2 + v^2 + x^2 + y^2)/2 + a*x*y", ""),
      planar("(u^2 + v^2 + x^2 + y^2)/2 + x^2*y^2/(a - 1)", axis),
      planar(even, "[assume]\na = 'positive'\n" + axis),
      planar(even, "[assume]\nconditions = ['a^2 = 4']\n" + axis),
      planar("(u^2 + v^2 + x^2 + y^2)/2 + h*x^2*y^2", axis),
      "[system]\nkind = 'vector-field'\ncoordinates = ['x', 'y']\nparameters = ['a']\n"
      "[system.field]\nx = 'a*y'\ny = '-x'\n",
      cyclic};
  return all;
}

// The rule that carries a step says by which theorem, not a word of the file.
TEST(FoundTheorem, NamesItsTheoremsWhateverTheFileSays) {
  const auto theorems = [](const std::string& text) {
    std::set<std::string> ids;
    const Theorem t = read_theorem(parse_document(text, test::own_folder() + "points.toml"));
    for (const TheoremUsed& u : proved_again(t).uses())
      ids.insert(u.id());
    return ids;
  };
  const Found found(planar("(u^2 + v^2)/2 + x^2*y + a*y^3/3", axis));
  std::istringstream lines(found.text);
  std::string other, without;
  for (std::string line; std::getline(lines, line);) {
    const bool of_points = line.starts_with("darboux = ");
    other += of_points ? "darboux = \"multiple\"\n" : line + "\n";
    if (!of_points && !line.starts_with("part = ")) without += line + "\n";
  }
  ASSERT_NE(other, found.text);
  EXPECT_FALSE(theorems(found.text).empty());
  EXPECT_EQ(theorems(other), theorems(found.text));
  EXPECT_EQ(theorems(without), theorems(found.text));
}

// A charge in the field of a monopole: Jacobi's identity holds by r^2 = x^2 + y^2 + z^2, which the format has no
// cofactors for.  The answer stands without a certificate, and says why.
TEST(FoundTheorem, MayBeAboutASystemThatNoCertificateStates) {
  const std::string r3 = "/(x^2 + y^2 + z^2)^(3/2)";
  const Found found("[system]\nkind = 'poisson'\ncoordinates = ['x', 'y', 'z', 'u', 'v', "
                    "'w']\nparameters = ['m']\n"
                    "hamiltonian = '(u^2 + v^2 + w^2)/2'\nbracket = [\n"
                    "['0', '0', '0', '1', '0', '0'], ['0', '0', '0', '0', '1', '0'], ['0', '0', "
                    "'0', '0', '0', '1'],\n"
                    "['-1', '0', '0', '0', 'm*z" +
                        r3 + "', '-m*y" + r3 +
                        "'],\n"
                        "['0', '-1', '0', '-m*z" +
                        r3 + "', '0', 'm*x" + r3 +
                        "'],\n"
                        "['0', '0', '-1', 'm*y" +
                        r3 + "', '-m*x" + r3 + "', '0']]\n",
                    "monopole.toml", 1e8);
  const TheoremResult r = proved_again(found.read());
  EXPECT_TRUE(r.complete_but_for_open_parts()) << r.conclusion();
  EXPECT_TRUE(r.bundle.empty());
  EXPECT_THAT(r.no_bundle, HasSubstr("Jacobi"));
}

// The curves are studied where A = 1 and L = 1, and, with a term of higher order, in the system of lowest order.
TEST(FoundTheorem, CurvesAtAnotherScaleAreCarriedOver) {
  for (const auto& [more, most] : {std::pair("", 0U), std::pair(" + M2*G2*G3", 2U)}) {
    const Found found("[system]\nkind = 'euler-poisson'\n"
                      "coordinates = ['M1', 'M2', 'M3', 'G1', 'G2', 'G3']\n"
                      "parameters = ['A', 'C', 'L']\n"
                      "hamiltonian = '(M1^2 + M2^2)/(2*A) + M3^2/(2*C) + L*G1" +
                          std::string(more) +
                          "'\n[assume]\nA = 'positive'\nC = 'positive'\nL = 'real'\n"
                          "[[casimir]]\nname = 'F1'\nvalue = 'G1^2 + G2^2 + G3^2'\n"
                          "[[casimir]]\nname = 'F2'\nvalue = 'M1*G1 + M2*G2 + M3*G3'\n",
                      "top.toml");
    const TheoremResult r = proved_again(found.theorem());
    ASSERT_FALSE(r.bundle.empty()) << r.no_bundle;
    EXPECT_LE(r.trusted_steps().size(), most) << more;
  }
}

void expect_no_trust(const std::string& system) {
  const TheoremResult r = proved_again(Found(system).theorem());
  ASSERT_FALSE(r.bundle.empty()) << system << r.no_bundle;
  EXPECT_EQ(r.trusted_steps(), std::vector<std::string>{}) << system;
  EXPECT_TRUE(std::holds_alternative<certify::TheoremAccepted>(certify::check_theorem(r.bundle)))
      << system;
}

// Some eigenvalues are admissible at a = 16 (-8, 16/5): there the exponent difference of a curve is a number.
TEST(FoundTheorem, ValuesThatDarbouxPointsLeaveAreThoseOfCurves) {
  for (const std::string potential :
       {"(x^2 + y^2)/2 + x^2*y + a*y^3/3", "(x^2 + y^2)/2 - 2*x^2*y + a*y^3/3",
        "x^2 + y^2 + 5*x^2*y + a*y^3/3"})
    expect_no_trust(planar("(u^2 + v^2)/2 + " + potential, ""));
}

// The axes of the body are those of the coordinates after a rotation by the numbers 3, 4, 5.
TEST(FoundTheorem, CurvesOfABodyThatIsTurnedAreCarriedOver) {
  const std::string turned = "((3*M1 + 4*M2)/5)^2/2 + ((3*M2 - 4*M1)/5)^2/2";
  for (const auto& [more, parameter] :
       {std::pair(" + ((3*M1 + 4*M2)/5)^2 + M3^2/2 + (3*G1 + 4*G2)/5 + G3", ""),
        std::pair(" + ((3*M1 + 4*M2)/5)^2 + M3^2/2 + p*(3*G1 + 4*G2)/5 + p*G3",
                  "parameters = ['p']\n[assume]\np = 'positive'\n")}) {
    const std::string head = "[system]\nkind = 'euler-poisson'\n"
                             "coordinates = ['M1', 'M2', 'M3', 'G1', 'G2', 'G3']\n";
    expect_no_trust(head + "hamiltonian = '" + turned + more + "'\n" + parameter);
  }
}

// The equation of the curve does not contain the root: no relation is needed.
TEST(FoundTheorem, ARootThatNoEquationContainsIsNoRelation) {
  expect_no_trust(planar("(u^2 + v^2)/2 + x^3/3 - x*y^2 + a*(sqrt(3)*x + y)^2", ""));
  expect_no_trust(planar("(u^2 + v^2)/2 + x^3/3 - x*y^2 + a*(y - sqrt(3)*x)^2", ""));
}

// z/x is kappa along a curve, with kappa^2 = 2 - a: the certificate has it as a parameter.
TEST(FoundTheorem, AConstantThatDependsOnAParameterIsAParameter) {
  const TheoremResult r =
      proved_again(Found("[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y', 'z']\n"
                         "momenta = ['u', 'v', 'w']\nparameters = ['a']\n"
                         "hamiltonian = '(u^2 + v^2 + w^2)/2 + x^2*z + y^2*z + a*z^3/3'\n")
                       .theorem());
  ASSERT_FALSE(r.bundle.empty()) << r.no_bundle;
  EXPECT_THAT(r.bundle, HasSubstr("a + kappa^2 - 2"));
  EXPECT_TRUE(std::holds_alternative<certify::TheoremAccepted>(certify::check_theorem(r.bundle)));
}

// The matrices are known at E = 1.  An assumption that other units change, and real parameters, leave the step on trust.
TEST(FoundTheorem, MatricesAtOneValueAreCarriedToAllUnits) {
  struct Case {
    std::string assumed;
    std::size_t trusted;
  };
  for (const Case& x : {Case{"", 0}, Case{"[assume]\nconditions = ['E != 3']\n", 1},
                        Case{"[assume]\nE = 'real'\n", 1}}) {
    const Found found("[system]\nkind = 'hamiltonian'\ncoordinates = ['a', 'b']\n"
                      "momenta = ['A', 'B']\nparameters = ['E', 'c']\nconstants = ['i']\n"
                      "relations = ['i^2 = -1']\n"
                      "hamiltonian = 'A*B/2 - a*b*i*(a*A - b*B)/2 - "
                      "a*b*(3*a^4 + 2*a^2*b^2 + 3*b^4)/8 - E*a*b'\n" +
                          x.assumed +
                          "[[manifold]]\nname = 'plane'\nequations = ['a = 0', 'B = 0']\n"
                          "level = 'A^2/4 - b^6/16 - E*b^2/2 = c'\n",
                      "hill.toml");
    const TheoremResult r = proved_again(found.theorem());
    ASSERT_FALSE(r.bundle.empty()) << x.assumed << r.no_bundle;
    EXPECT_EQ(r.trusted_steps().size(), x.trusted) << x.assumed;
    EXPECT_EQ(r.bundle.find("\"scale\"") != std::string::npos, x.trusted == 0) << x.assumed;
    EXPECT_TRUE(std::holds_alternative<certify::TheoremAccepted>(certify::check_theorem(r.bundle)))
        << x.assumed;
  }
}

// A factor of the potential that is not 0 is a change of units: the same is proved, and nothing more is on trust.
TEST(FoundTheorem, AFactorOfThePotentialAddsNoTrust) {
  const auto proved = [](const std::string& potential, const std::string& parameters) {
    const Found found("[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\n"
                      "momenta = ['u', 'v']\n" +
                          parameters + "hamiltonian = '(u^2 + v^2)/2 + " + potential + "'\n",
                      "potential.toml");
    return std::pair{found.c, proved_again(found.theorem())};
  };
  // The factor, and where it is 0: there the system is integrable.  a + 1 is not homogeneous, and is
  // studied with its parameter.
  const std::pair<std::string, std::string> factors[] = {
      {"a", "a"}, {"a^2", "a"}, {"(a + 1)", "a + 1"}, {"(2*a - 3)", "2*a - 3"}};
  for (const std::string potential : {"x^2*y + y^3", "x^2*y - 2*y^3", "x^3*y + y^4"}) {
    const auto [alone, theorem] = proved("(" + potential + ")", "");
    EXPECT_EQ(alone.status(), Verdict::non_integrable) << potential;
    ASSERT_FALSE(theorem.bundle.empty()) << potential << theorem.no_bundle;
    for (const auto& [factor, zero] : factors) {
      const std::string about = factor + "*(" + potential + ")";
      const auto [family, all] = proved(about, "parameters = ['a']\n");
      ASSERT_FALSE(all.bundle.empty()) << about << all.no_bundle;
      EXPECT_LE(all.trusted_steps().size(), theorem.trusted_steps().size()) << about;
      for (const ClassifiedStratum& x : family.strata) {
        if (!x.where.is_algebraic()) continue;
        const auto& equations = x.where.equations();
        const bool at_zero = equations.size() == 1 && to_string(equations.front()) == zero;
        EXPECT_EQ(x.status, at_zero ? StratumStatus::integrable : StratumStatus::excluded) << about;
      }
      EXPECT_EQ(family.status(), Verdict::depends) << about;
      for (const std::string& bundle : {theorem.bundle, all.bundle})
        EXPECT_TRUE(
            std::holds_alternative<certify::TheoremAccepted>(certify::check_theorem(bundle)))
            << about;
    }
  }
}

// The judge says as much as the theorem, trusts as many steps, and leaves as much open.
TEST(FoundTheorem, IsAcceptedWithTheSameStatement) {
  for (const std::string& system : systems()) {
    const Found found(system);
    const TheoremResult r = proved_again(found.read());
    EXPECT_TRUE(r.complete_but_for_open_parts()) << system << r.conclusion();
    ASSERT_FALSE(r.bundle.empty()) << system << r.no_bundle;
    const auto judged = certify::check_theorem(r.bundle);
    ASSERT_TRUE(std::holds_alternative<certify::TheoremAccepted>(judged)) << system;
    const auto& accepted = std::get<certify::TheoremAccepted>(judged);
    EXPECT_EQ(accepted.trusted, r.trusted_steps().size()) << system;
    EXPECT_EQ(accepted.trusted, root(r).steps_on_trust) << system;
    EXPECT_EQ(accepted.open, r.bundle_open) << system;
    EXPECT_EQ(accepted.theorems.empty(), r.uses().empty()) << system << r.given();
    EXPECT_EQ(accepted.open == 0, found.c.status() != Verdict::undecided) << system;
    EXPECT_EQ(sentence(accepted.excluded), sentence(root(r).excluded)) << system;
    EXPECT_FALSE(accepted.statement.empty());
    // it never excludes more than the search did, along curves that its statement names
    for (const IntegralClass& x : accepted.excluded)
      EXPECT_TRUE(std::ranges::any_of(found.c.strata,
                                      [&](const ClassifiedStratum& stratum) {
                                        return std::ranges::any_of(
                                            stratum.by, [&](const ExclusionReason& by) {
                                              IntegralClass found_here = by.integrals;
                                              found_here.curves = x.curves;
                                              return contains(found_here, x) == Truth::yes;
                                            });
                                      }))
          << system << sentence(x);
  }
}

// Nothing goes through a text on the way from a search to its certificate, and nothing is found twice; the text,
// which is for people, says the same.
TEST(FoundTheorem, OfValuesIsThatOfItsText) {
  std::size_t studies = 0;
  for (const std::string& system : systems()) {
    const Found found(system);
    const Theorem t = found.theorem();
    for (const TheoremNode& n : t.nodes)
      studies += n.found.studies.size();
    const TheoremResult by_values = proved_again(t), by_text = proved_again(found.read());
    ASSERT_EQ(by_values.nodes.size(), by_text.nodes.size()) << system;
    for (std::size_t k = 0; k < t.nodes.size(); ++k) {
      const NodeResult &one = by_values.nodes[k], &other = by_text.nodes[k];
      EXPECT_EQ(one.node.id, other.node.id);
      EXPECT_EQ(one.says, other.says) << system << one.node.id;
      EXPECT_EQ(one.status, other.status) << system << one.summary << other.summary;
    }
    EXPECT_EQ(by_values.bundle.empty(), by_text.bundle.empty()) << system << by_values.no_bundle;
    EXPECT_EQ(by_values.bundle_open, by_text.bundle_open) << system;
    EXPECT_LE(by_values.trusted_steps().size(), by_text.trusted_steps().size()) << system;
    EXPECT_EQ(sentence(root(by_values).excluded), sentence(root(by_text).excluded)) << system;
  }
  EXPECT_GT(studies, 0U);
}

TEST(FoundTheorem, ReadAgainHasTheSameNodes) {
  for (const std::string& system : systems()) {
    const Found found(system);
    const Theorem t = found.read();
    const TheoremResult by_search = proved_again(t), by_file = prove(t);
    ASSERT_EQ(by_file.nodes.size(), by_search.nodes.size());
    EXPECT_EQ(root(by_file).node.needs.size() + 1, by_file.nodes.size());
    for (std::size_t k = 0; k < t.nodes.size(); ++k) {
      const NodeResult &one = by_search.nodes[k], &other = by_file.nodes[k];
      EXPECT_EQ(one.node.id, other.node.id);
      EXPECT_EQ(one.says, other.says) << system << one.node.id;
      EXPECT_FALSE(other.status == NodeStatus::refuted || other.status == NodeStatus::unbound)
          << system << other.summary;
      EXPECT_EQ(other.steps_on_trust, one.steps_on_trust) << system << one.node.id;
    }
    EXPECT_EQ(by_file.bundle, by_search.bundle) << system;
    EXPECT_TRUE(by_search.complete() || !by_file.complete()) << system;
    EXPECT_EQ(sentence(root(by_file).excluded), sentence(root(by_search).excluded)) << system;
  }
}

// A node of the text names its curves, and `prove` studies them: what is said of them is no word.
TEST(FoundTheorem, CurvesOfSpecialDifferencesAreStudiedAgain) {
  const Found found(cyclic);
  Theorem t = found.read();
  const auto node = std::ranges::find(t.nodes, NodeKind::trusted, &TheoremNode::kind);
  ASSERT_NE(node, t.nodes.end()) << found.text;
  ASSERT_TRUE(node->tables);
  const TheoremResult r = prove(t);
  EXPECT_EQ(root(r).steps_on_trust, 0U) << r.conclusion();
  EXPECT_TRUE(r.complete());
  const TheoremNode whole = *node;
  const auto one_on_trust = [&](const std::string& why) {
    const TheoremResult without = prove(t);
    EXPECT_EQ(root(without).steps_on_trust, 1U) << why << without.conclusion();
    EXPECT_THAT(without.conclusion(), HasSubstr("on trust")) << why;
    *node = whole;
  };
  node->file.clear();
  node->tables.reset();
  one_on_trust("without curves");
  node->tables = parse_document("manifold = [{name = 'N', equations = ['x = 0', 'y = 0', 'z = 0', "
                                "'u = 0', 'v = 0', 'w = 0']}]",
                                "equilibrium.toml");
  one_on_trust("an equilibrium");
  node->tables =
      parse_document("manifold = [{name = 'N', equations = ['x = 1']}]", "not invariant.toml");
  one_on_trust("a set that is not invariant");
}

TEST(FoundTheorem, TheOrderOfItsNodesIsNoMatter) {
  random_rounds(3, [](Random& random) {
    const Found found(random.one_of(systems()));
    Theorem t = found.read();
    const TheoremResult plain = proved_again(t);
    std::shuffle(t.nodes.begin() + 1, t.nodes.end(), random.bits());
    std::shuffle(t.nodes.front().needs.begin(), t.nodes.front().needs.end(), random.bits());
    const TheoremResult other = proved_again(t);
    EXPECT_EQ(settled(other), settled(plain)) << found.text;
    EXPECT_EQ(sentence(root(other).excluded), sentence(root(plain).excluded)) << found.text;
    EXPECT_EQ(other.bundle.empty(), plain.bundle.empty()) << found.text;
    EXPECT_EQ(other.bundle_open, plain.bundle_open);
  });
}

// The strata are disjoint: without one of them there is a gap.
TEST(FoundTheorem, WithoutAStratumIsNotProved) {
  for (const std::string& system : systems()) {
    const Found found(system);
    const Theorem whole = found.read();
    if (whole.nodes.size() < 3) continue;
    for (std::size_t k = 1; k < whole.nodes.size(); ++k) {
      Theorem t = whole;
      std::erase(t.nodes.front().needs, t.nodes[k].id);
      t.nodes.erase(t.nodes.begin() + static_cast<long>(k));
      const TheoremResult r = proved_again(t);
      EXPECT_EQ(root(r).status, NodeStatus::open) << system << whole.nodes[k].id;
      EXPECT_TRUE(r.bundle.empty());
      EXPECT_EQ(r.statement(), "");
    }
  }
}

// A stratum is claimed for more parameters than it was found for.
TEST(FoundTheorem, AStratumThatIsMadeLargerIsNotProved) {
  const Found found(systems().front());
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
           {"where = { a = \"0\" }", "where = { a = \"1\" }"},
           {"where = { a = \"0\" }\nat    = { a = \"0\" }\n", ""},
           {"x*v - y*u", "x*v + y*u"}}) {
    Found forged = found;
    const auto at = forged.text.find(from);
    ASSERT_NE(at, std::string::npos) << from << '\n' << found.text;
    for (auto i = at; i != std::string::npos; i = forged.text.find(from, i + to.size()))
      forged.text.replace(i, from.size(), to);
    const TheoremResult r = prove(forged.read());
    EXPECT_FALSE(r.complete_but_for_open_parts()) << from << r.conclusion();
    EXPECT_THAT(r.conclusion(), StartsWith("NOT PROVED")) << from;
  }
}

// ---- classes along a transport

// H of lowest order is another file's system: what is excluded there is excluded near the origin only.
TEST(Transport, FromTheLowestOrderAClassIsOneNearTheOrigin) {
  const std::string cubic = "(u^2 + v^2)/2 + x^2*y + y^3";
  write("low.toml", planar(cubic, "[assume]\na = 'real'\nh = 'real'\n" + axis));
  write("high.toml", planar(cubic + " + a*x^4*y", "[assume]\na = 'real'\nh = 'real'\n[expansion]\n"
                                                  "weights = { x = 2, y = 2, u = 3, v = 3 }\n"));
  const TheoremResult r = prove(theorem(
      "system = \"high.toml\"\n[[node]]\nid = \"main\"\nkind = \"cover\"\nneeds = [\"ni\"]\n"
      "[[node]]\nid = \"ni\"\nkind = \"case\"\nfile = \"low.toml\"\nof = \"lo\"\n"
      "[[node]]\nid = \"lo\"\nkind = \"lowest-order\"\nfile = \"high.toml\"\nother = "
      "\"low.toml\"\n"));
  ASSERT_EQ(root(r).status, NodeStatus::proved)
      << r.conclusion() << root(r).summary << r.nodes[1].summary;
  const IntegralClass near_origin{.near = IntegralClass::Near::origin};
  EXPECT_EQ(root(r).excluded, std::vector<IntegralClass>{near_origin});
  EXPECT_THAT(r.statement(), HasSubstr("near the origin"));
  EXPECT_EQ(r.uses().size(), 2U) << "Ziglin's lemma as well";
}

// y = S x: the same class, and never a larger one.
TEST(Transport, ByAChangeOfVariablesAClassIsNoLarger) {
  write("plain.toml", planar(even, "[assume]\nconditions = ['a > 0']\nh = 'real'\n" + axis));
  write("other.toml",
        planar("(u^2 + v^2 + x^2 + y^2)/2 + x^2*y^2", "[assume]\na = 'real'\nh = 'real'\n" + axis));
  const auto with = [](const std::string& as) {
    return prove(theorem("system = \"plain.toml\"\n[[node]]\nid = \"main\"\nkind = \"cover\"\n"
                         "needs = [\"ni\"]\n[[node]]\nid = \"ni\"\nkind = \"case\"\n"
                         "file = \"other.toml\"\nroots = { r = \"a\" }\nas = { " +
                         as + ", a = \"a\" }\n"));
  };
  const TheoremResult r = with("x = \"r*x\", y = \"r*y\", u = \"r*u\", v = \"r*v\"");
  ASSERT_EQ(root(r).status, NodeStatus::proved) << r.conclusion() << r.nodes[1].summary;
  const TheoremResult there =
      prove(theorem("system = \"other.toml\"\n[[node]]\nid = \"main\"\nkind = \"case\"\n"
                    "file = \"other.toml\"\n"));
  ASSERT_EQ(root(r).excluded.size(), 1U);
  EXPECT_EQ(contains(root(there).excluded.at(0), root(r).excluded.at(0)), Truth::yes);
  const TheoremResult wrong = with("x = \"r*x\", y = \"r*y\", u = \"r*u\", v = \"2*r*v\"");
  EXPECT_NE(root(wrong).status, NodeStatus::proved);
  EXPECT_EQ(wrong.nodes[1].status, NodeStatus::unbound);
}

} // namespace
} // namespace kov
