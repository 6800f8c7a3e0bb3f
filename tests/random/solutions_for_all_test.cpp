// Equations made from a solution that exists for all parameters: it is found on every stratum, also
// where places meet.

#include "family_attack.hpp"
#include "strata/domain.hpp"
#include "strata/words.hpp"

namespace kov::test {
namespace {

using strata::Stratum;

// y'/y = w: r = w' + w^2, as text.
std::string from_logarithmic_derivative(const std::string& w, const std::string& slope) {
  return "(" + slope + ")+(" + w + ")^2";
}

// y = (z + c) exp(int q): y'/y = q + 1/(z + c), and others.
TEST(SolutionsForAllParameters, AnExponentialOneIsFound) {
  struct Known {
    std::string w, slope;
  };
  const std::vector<Known> all{{"a*z^3", "3*a*z^2"},
                               {"a*z^2+b*z+1/(z+c)", "2*a*z+b-1/(z+c)^2"},
                               {"z+a/z", "1-a/z^2"},
                               {"a*z^2+b/z", "2*a*z-b/z^2"},
                               {"a+b/z^2+1/(3*z)", "-2*b/z^3-1/(3*z^2)"},
                               {"a*z+1/(3*z)+1/(z-b)", "a-1/(3*z^2)-1/(z-b)^2"},
                               {"a*z+2*z/(z^2+b)", "a+2/(z^2+b)-4*z^2/(z^2+b)^2"},
                               {"b*z^4-a/2", "4*b*z^3"},
                               {"a/(z-b)^2+1/2/(z-b)", "-2*a/(z-b)^3-1/2/(z-b)^2"}};
  for (const auto& [w, slope] : all) {
    const Asked asked{"-r", from_logarithmic_derivative(w, slope), {"a", "b", "c"}};
    SCOPED_TRACE(asked.command());
    const auto a = strata::on_domain(decide_strata(asked.family().question, little_time()));
    bool somewhere = false;
    for (const Stratum& s : a.told_apart()) {
      SCOPED_TRACE(to_string(s.conditions));
      if (s.leaf.abelian != Truth::no) continue;
      somewhere = true;
      if (s.leaf.group) {
        EXPECT_EQ(s.leaf.group->type, GroupType::Borel) << reason(s.leaf);
      } else {
        EXPECT_FALSE(s.arithmetic.empty()) << "the solution is not told: " << reason(s.leaf);
      }
    }
    EXPECT_TRUE(somewhere);
    Random random(1);
    attack(asked, {"a", "b", "c", "b-c"}, 3, random);
  }
}

// 2 P y'' + 3 P' y' + (P'' + l) y = 0 has y = P^(-1/2) exp(+-sqrt(-l/2) int dz/sqrt(P)).
TEST(SolutionsForAllParameters, AnInvariantIsFoundWherePolesMeet) {
  struct Cubic {
    std::string p, first, second;
  };
  const std::vector<Cubic> all{{"z^3+a*z+b", "3*z^2+a", "6*z"},
                               {"z^3+a*z^2+b", "3*z^2+2*a*z", "6*z+2*a"},
                               {"z^4+a*z+b", "4*z^3+a", "12*z^2"},
                               {"z^3+a*z^2+b*z+c", "3*z^2+2*a*z+b", "6*z+2*a"},
                               {"2*z^3+a^2*z+b^2", "6*z^2+a^2", "12*z"}};
  for (const auto& [p, first, second] : all)
    for (const char* l : {"3", "a", "c"}) {
      const Asked asked{"-e",
                        "2*(" + p + ")*y''+3*(" + first + ")*y'+(" + second + "+" + l + ")*y=0",
                        {"a", "b", "c"}};
      SCOPED_TRACE(asked.command());
      const auto a = decide_strata(asked.family().question, little_time());
      EXPECT_EQ(a.abelian(), Truth::yes);
      EXPECT_EQ(a.refusal, "");
      Random random(1);
      attack(asked, {"4*a^3+27*b^2", "a", "b"}, 2, random);
    }
}

} // namespace
} // namespace kov::test
