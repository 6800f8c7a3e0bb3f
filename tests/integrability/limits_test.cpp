// Searches end by themselves, and say why.

#include "support/checked.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov::limits_test {
namespace {

using testing::HasSubstr;

// Attracting centres on a line, where the motion along the line is reducible: each distance is
// plus or minus a linear function there.
std::string centres(int n, const std::string& more = "", const std::string& potential = "") {
  std::string relations, functions, h = "(p1^2 + p2^2)/2" + potential;
  for (int k = 0; k < n; ++k) {
    const std::string r = "r" + std::to_string(k);
    const std::string x = "(q1 - " + std::to_string(2 * k) + ")";
    relations += (k ? ", \"" : "\"") + r + "^2 = " + x + "^2 + q2^2\"";
    functions += "[[system.function]]\nname = \"" + r + "\"\nderivative = { q1 = \"" + x + "/" + r +
                 "\", q2 = \"q2/" + r + "\" }\n";
    h += " - " + std::to_string(k + 1) + "/" + r;
  }
  return "[system]\nkind = \"hamiltonian\"\ncoordinates = [\"q1\", \"q2\"]\n"
         "momenta = [\"p1\", \"p2\"]\nparameters = [\"h\"]\nhamiltonian = \"" +
         h + "\"\nrelations = [" + relations + "]\n" + functions +
         "[[manifold]]\nname = \"line\"\nequations = [\"q2 = 0\", \"p2 = 0\"" + more +
         "]\nlevel = [\"H = h\"]\n";
}

ManifoldReport checked(const std::string& text, const Budget& budget = {}) {
  CheckOptions options;
  options.decide.budget = budget;
  return test::checked(text, options);
}

std::string all(const std::vector<std::string>& reasons) {
  std::string text;
  for (const auto& r : reasons)
    text += r + "\n";
  return text;
}

TEST(Limits, AReducibleCurveIsNamed) {
  Budget little;
  little.max_work = 1e5;
  for (const int n : {1, 2, 3}) {
    const ManifoldReport m = checked(centres(n, "", n == 1 ? " + q1" : ""), little);
    EXPECT_EQ(m.verdict, Verdict::undecided) << n;
    EXPECT_THAT(all(reasons(m)), HasSubstr("the phase curve has several components")) << n;
  }
}

TEST(Limits, OneOfItsComponentsIsStudied) {
  const ManifoldReport m =
      checked(centres(2, ", \"r0 = q1\", \"r1 = q1 - 2\"")); // integrable: two centres
  EXPECT_EQ(m.verdict, Verdict::no_obstruction) << all(reasons(m));
  const ManifoldReport three =
      checked(centres(3, ", \"r0 = q1\", \"r1 = q1 - 2\", \"r2 = q1 - 4\""));
  EXPECT_THAT(all(reasons(three)), testing::Not(HasSubstr("several components")));
}

// Whatever the limit is, a result comes back, and never a verdict that more work refutes.
TEST(Limits, OfEverySizeGiveAResult) {
  const std::string text = centres(2, ", \"r0 = q1\", \"r1 = q1 - 2\"");
  for (double most = 1; most < 1e7; most *= 8) {
    Budget budget;
    budget.max_work = most;
    const ManifoldReport m = checked(text, budget);
    if (m.verdict == Verdict::undecided)
      EXPECT_THAT(all(reasons(m)), HasSubstr("work limit")) << most;
    else
      EXPECT_EQ(m.verdict, Verdict::no_obstruction) << most;
  }
}

// The first manifold would need hours; its limit is not that of the second.
TEST(Limits, OfWorkAreShared) {
  const Entry file = parse_document(
      "[system]\nkind = \"hamiltonian\"\ncoordinates = [\"q1\", \"q2\"]\n"
      "momenta = [\"p1\", \"p2\"]\nhamiltonian = \"(p1^2 + p2^2*q2)/2 + q1^2*q2^2\"\n"
      "[[manifold]]\nname = \"hard\"\nequations = [\"(q1+3*p1)^9 = q2+p2^3\", "
      "\"(p1+2*q2)^7 = 5+q1*p2\", \"(p2+q1)^8 = p1+q1*q2\"]\n"
      "[[manifold]]\nname = \"axis\"\nequations = [\"q1 = 0\", \"p1 = 0\"]\n"
      "level = [\"H = 1\"]\n",
      "test.toml");
  CheckOptions options;
  options.decide.budget.max_work = 1e15;
  options.decide.budget.give(4e8);
  const auto manifolds = study::study(file, {}, {.check = options}).manifolds;
  EXPECT_THAT(all(reasons(manifolds.at(0).first)), HasSubstr("work limit of 1.3e+08 reached"));
  EXPECT_EQ(manifolds.at(1).first.verdict, Verdict::non_integrable);
}

TEST(Limits, OfAClaimLeaveItOpen) {
  const System s = read_system(parse_document(
      centres(2) + "[[integral]]\nname = \"H\"\nvalue = \"H\"\n[[integral]]\nname = \"G\"\nvalue = "
                   "\"(q1*p2 - q2*p1)*p2\"\nholds = false\n",
      "test.toml"));
  Budget none;
  none.max_work = 0;
  for (const SystemClaim& claim : s.claims) {
    const ClaimResult open = decide_claim(s, claim, none);
    EXPECT_FALSE(open.proved);
    EXPECT_THAT(open.open, HasSubstr("work limit"));
    EXPECT_FALSE(is_met(claim, open)); // not refuted either
    EXPECT_TRUE(is_met(claim, decide_claim(s, claim))) << claim.name;
  }
}

} // namespace
} // namespace kov::limits_test
