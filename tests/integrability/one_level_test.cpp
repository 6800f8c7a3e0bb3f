// A level is not a parameter of the system: what one of them shows is enough, for each value of the others.

#include "integrability/one_level.hpp"
#include "integrability/parameters.hpp"
#include "support/checked.hpp"

#include <gtest/gtest.h>

namespace kov::one_level_test {
namespace {

/// A system with the levels h and k, and what is assumed.
System with(const std::string& assumed) {
  return read_system(parse_document(
      "[system]\nkind = \"hamiltonian\"\ncoordinates = [\"x\", \"y\"]\nmomenta = [\"p\", \"q\"]\n"
      "parameters = [\"a\", \"b\", \"h\", \"k\"]\nhamiltonian = \"p^2 + a*x^2 + b*y^2/a\"\n" +
          (assumed.empty() ? "" : "[assume]\nconditions = [" + assumed + "]\n") +
          "[[manifold]]\nname = \"N\"\nequations = [\"x = 0\", \"p = 0\"]\nlevel = \"H = h + k\"\n",
      "test.toml"));
}

struct Known {
  std::vector<std::string> conditions; ///< "h = 0", "a - b != 0"
  Truth abelian;
};

// The strata as they would be found, with their equations solved.
strata::StrataAnswer answer(const System& s, const std::vector<Known>& strata) {
  strata::StrataAnswer a;
  auto question = std::make_shared<strata::Question>();
  question->r = MFraction(s.ring(), Rational(1));
  a.question = question;
  for (const Known& k : strata) {
    strata::Stratum x;
    for (const std::string& c : k.conditions) {
      const bool zero = c.find("!=") == std::string::npos;
      const std::string left = c.substr(0, c.find(zero ? "=" : "!="));
      const std::string right = c.substr(c.find('=') + 1);
      const MFraction f = formula(s, left + "-(" + right + ")");
      x.conditions.push_back({f.num(), zero ? Sign::zero : Sign::nonzero});
      if (zero && left.size() <= 2)
        x.solved[s.ring()->index(left.substr(0, 1))] = formula(s, right);
    }
    x.leaf.abelian = k.abelian;
    a.strata.push_back(std::move(x));
  }
  return a;
}

constexpr Truth no = Truth::no, yes = Truth::yes, open = Truth::unknown;
const std::string nothing = "nothing is proved";

std::string found(const std::vector<Known>& strata, const std::string& assumed = "") {
  const System s = with(assumed);
  const auto level = level_that_decides(s, answer(s, strata));
  return level ? sentence(*level) : nothing;
}

TEST(OneLevel, GeneralOnesOrASpecialOne) {
  EXPECT_EQ(found({{{"h = 0"}, yes}, {{"h != 0"}, no}}), "");
  EXPECT_EQ(found({{{"h = 0"}, no}, {{"h != 0"}, open}}), "h = 0");
  EXPECT_EQ(found({{{"h = 0"}, no}, {{"h != 0"}, yes}}), "h = 0");
  EXPECT_EQ(found({{{"h = b"}, no}, {{"h - b != 0"}, open}}), "h = b");
  EXPECT_EQ(found({{{"h = 0"}, yes}, {{"h != 0"}, open}}), nothing);
  // a parameter of the system is not chosen
  EXPECT_EQ(found({{{"a = 0"}, no}, {{"a != 0"}, open}}), nothing);
  EXPECT_EQ(found({{{"b = 0"}, no}, {{"b != 0"}, open}}), nothing);
  EXPECT_EQ(found({{{"b = h"}, no}, {{"b - h != 0"}, open}}), nothing); // solved for b
}

TEST(OneLevel, EachOfTheOthersMayHaveItsOwn) {
  EXPECT_EQ(found({{{"b = 0"}, no}, {{"b != 0", "h = 0"}, no}, {{"b != 0", "h != 0"}, open}}),
            "h = 0");
  EXPECT_EQ(found({{{"b = 0", "h = 0"}, open},
                   {{"b = 0", "h != 0"}, no},
                   {{"b != 0", "h = 0"}, no},
                   {{"b != 0", "h != 0"}, open}}),
            "a general level or h = 0");
  EXPECT_EQ(found({{{"b = 0"}, open}, {{"b != 0", "h = 0"}, no}, {{"b != 0", "h != 0"}, open}}),
            nothing);
  EXPECT_EQ(found({{{"b = 0", "h = 0"}, no},
                   {{"b = 0", "h != 0"}, open},
                   {{"b != 0", "h = 1"}, no},
                   {{"b != 0", "h - 1 != 0"}, yes}}),
            "h = 0 or h = 1");
  EXPECT_EQ(found({{{"h = 0", "k = 0"}, no}, {{"h = 0", "k != 0"}, yes}, {{"h != 0"}, open}}),
            "h = 0, k = 0");
  // all h where b = 0
  EXPECT_EQ(found({{{"b*h = 0"}, open}, {{"b*h != 0"}, no}}), nothing);
  EXPECT_EQ(found({{{"b*h = 0"}, open}, {{"b*h != 0"}, no}}, "\"b != 0\""), "");
  // a is a denominator of H
  EXPECT_EQ(found({{{"a*h = 0"}, open}, {{"a*h != 0"}, no}}), "");
  EXPECT_EQ(found({{{"a = 0"}, open}, {{"a != 0"}, no}}), "");
}

TEST(OneLevel, IsOneThatTheFileAdmits) {
  const std::vector<Known> at_zero{{{"h = 0"}, no}, {{"h != 0"}, open}};
  EXPECT_EQ(found(at_zero, "\"h > 0\""), nothing);
  EXPECT_EQ(found(at_zero, "\"h >= 0\""), "h = 0");
  EXPECT_EQ(found(at_zero, "\"h > -1\""), "h = 0");
  EXPECT_EQ(found(at_zero, "\"h > b\""), nothing);
  EXPECT_EQ(found(at_zero, "\"h != 0\""), nothing);
  EXPECT_EQ(found(at_zero, "\"h != 1\", \"h < 2\""), "h = 0");
  // a point, and no set of levels, is left
  const std::vector<Known> in_general{{{"h = 0"}, open}, {{"h != 0"}, no}};
  EXPECT_EQ(found(in_general, "\"h >= 0\", \"-h >= 0\""), nothing);
  EXPECT_EQ(found(in_general, "\"-h^2 >= 0\""), nothing);
  EXPECT_EQ(found(in_general, "\"h > 0\", \"h < 1\""), "");
  EXPECT_EQ(found(in_general, "\"h^2 > k\", \"k > 0\""), "");
  EXPECT_EQ(found(in_general, "\"-h^2 - k^2 > 0\""), nothing); // no level at all
  EXPECT_EQ(found(in_general, "\"h > b\""), "");
}

TEST(OneLevel, AZeroLevelDecides) {
  const std::string text =
      "[system]\nkind = \"hamiltonian\"\ncoordinates = [\"q1\", \"q2\"]\nmomenta = [\"p1\", "
      "\"p2\"]\n"
      "parameters = [\"hh\"]\nhamiltonian = \"p1^2/2 - p1*p2 + p2^2 + 7*q1^5/5 + 2*q1^4*q2 + "
      "q1^3*q2^2 + 8*q1^2/3 + 16*q1*q2/3 + 8*q2^2/3\"\n[[manifold]]\nname = \"N\"\n"
      "equations = [\"q1 + q2 = 0\", \"p2 = 0\"]\nlevel = \"H = hh\"\n";
  CheckOptions options;
  options.decide.budget.max_work = 1e7;
  const ManifoldReport report = test::checked(text, options);
  EXPECT_EQ(report.verdict, Verdict::non_integrable);
  EXPECT_EQ(sentence(report.blocks.at(0).level), "hh = 0");
}

} // namespace
} // namespace kov::one_level_test
