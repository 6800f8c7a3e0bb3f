// A logarithm whose coefficient has parameters, beside an invariant with many unknowns: the set
// without the logarithm is told apart first, and the other one needs no invariant.

#include "equation/parametric_equation.hpp"
#include "strata/decide_strata.hpp"
#include "strata/words.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

strata::StrataAnswer strata_of(const std::string& r, const std::vector<std::string>& parameters) {
  EquationText text;
  text.r = parse_expression(r, "r");
  text.parameters = parameters;
  return decide_strata(read_parametric_equation(text).question, {});
}

std::string shown(const strata::StrataAnswer& a) {
  std::string text;
  for (const auto& s : a.strata)
    text += to_string(s.conditions) + ": " +
            (s.leaf.abelian == Truth::no ? "no, " : "yes or open, ") + strata::reason(s.leaf) +
            "\n";
  return text;
}

// H = (u^2 + v^2)/2 + 3 (x^2 + y^2)/2 + a (x^2 y - y^3/3) + (x^2 + y^2)^2 on x = u = 0, H = 3 and,
// with b in the place of a, another energy.
TEST(LogarithmFirst, NoInvariantIsSearchedWhereItIsNotNeeded) {
  for (const char* r :
       {"3*(96*z^6 + 16*z^5*a - 17*z^4*a^2 + 252*z^4 + 54*z^3*a - 639*z^2 - 72*z*a - 324)/"
        "(4*(6*z^4 - 2*z^3*a + 9*z^2 - 18)^2)",
        "3*(96*z^6 + 32*z^5*a - 68*z^4*a^2 + 252*z^4 + 108*z^3*a - 639*z^2 - 144*z*a - 324)/"
        "(4*(6*z^4 - 4*z^3*a + 9*z^2 - 18)^2)"}) {
    const auto answer = strata_of(r, {"a"});
    EXPECT_TRUE(answer.unvisited.empty()) << shown(answer);
    bool by_logarithm = false;
    for (const auto& s : answer.strata) {
      EXPECT_NE(s.leaf.abelian, Truth::unknown) << shown(answer);
      by_logarithm = by_logarithm || s.leaf.by == strata::Conclusion::irreducible_log;
    }
    EXPECT_TRUE(by_logarithm) << shown(answer);
  }
}

// Where the logarithm vanishes the answer is another one: at a = 0 and where 7 a^2 = 18.
TEST(LogarithmFirst, TheSetWithoutItIsDecidedByItself) {
  const auto answer =
      strata_of("3*(96*z^6 + 16*z^5*a - 17*z^4*a^2 + 252*z^4 + 54*z^3*a - 639*z^2 - 72*z*a - 324)/"
                "(4*(6*z^4 - 2*z^3*a + 9*z^2 - 18)^2)",
                {"a"});
  int abelian = 0;
  for (const auto& s : answer.strata)
    abelian += s.leaf.abelian == Truth::yes ? 1 : 0;
  EXPECT_EQ(abelian, 2) << shown(answer);
  EXPECT_EQ(strata_of("3*(96*z^6 + 252*z^4 - 639*z^2 - 324)/(4*(6*z^4 + 9*z^2 - 18)^2)", {})
                .strata.front()
                .leaf.abelian,
            Truth::yes);
}

} // namespace
} // namespace kov
