// How many decided strata have no certificate, and for want of which rule: counted over equations
// with parameters of every kind that lib/strata decides, and printed.

#include "equation/assumptions.hpp"
#include "equation/parametric_equation.hpp"
#include "strata/certificate.hpp"
#include "strata/leaf_certificate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>

namespace kov {
namespace {

using strata::Gap;
using strata::Uncertified;

struct Equation {
  const char* r;
  std::vector<const char*> assume;
};

// Texts as in `kovacic solve -r R --assume ...`; every parameter has a sentence.
const std::vector<Equation> equations{
    // one irregular place
    {"z + c", {"c complex"}},
    {"a*z + b", {"a complex", "b complex"}},
    {"z^2 + a", {"a complex"}},
    {"a^2*z^2 + b", {"a complex", "b complex"}},
    {"a*z^2 + b*z + c", {"a complex", "b complex", "c complex"}},
    {"z^2/4 - 1/2 - n", {"n not an integer"}},
    {"z^2/4 - 1/2 - n", {"n integer"}},
    {"z^3 + a*z + b", {"a complex", "b complex"}},
    {"z^4 + a", {"a complex"}},
    {"a*z^5 + 1", {"a complex"}},
    {"(a^2 + 1)*z^2 + a", {"a real"}},
    // the family of Bessel
    {"(4*nu^2 - 1)/(4*z^2) - 1", {"nu complex"}},
    {"(4*nu^2 - 1)/(4*z^2) - 1", {"nu not in 1/2 + Z"}},
    {"(4*nu^2 - 1)/(4*z^2) - 1", {"2*nu odd integer"}},
    {"(4*nu^2 - 1)/(4*z^2) - 1", {"3*nu - 1/2 integer", "5*nu - 1/2 integer"}},
    {"(4*nu^2 - 1)/(4*z^2) - 1", {"6*nu integer", "10*nu + 1/2 not an integer"}},
    {"(4*nu^2 - 1)/(4*z^2) - 1",
     {"3*nu/2 integer", "5*nu/7 integer", "7*nu/9 integer", "8*nu/5 integer"}},
    {"(4*m^2 - 1)/(4*z^2) + 1/4 - k/z", {"2*k integer", "m - 1/4 integer"}},
    {"(4*m^2 - 1)/(4*z^2) + 1/4 - k/z", {"k + 3*m integer", "k - m - 1/4 integer"}},
    {"n*(n + 1)/z^2 + 1/4 - k/z", {"n integer", "k integer", "k > n", "n >= 0"}},
    {"n*(n + 1)/z^2 + 1/4 - k/z", {"n integer", "k integer", "n >= k", "k > 0"}},
    {"2/z^2 + a", {"a complex"}},
    {"6/z^2 + a", {"a complex"}},
    {"-3/(16*z^2) + a/z", {"a complex"}},
    {"3/(4*z^2) + a*z", {"a complex"}},
    {"a/z^2 + 1", {"a < -1"}},
    // an irregular place and others
    {"a/z^2 + b/z + 1/4", {"a complex", "b complex"}},
    {"-1/(4*z^2) + a/z", {"a complex"}},
    {"15/(4*z^2) + a/z^4", {"a complex"}},
    {"(a - 1)/z^2 + 1/z^3", {"a complex"}},
    {"2*a/(z - a)^3", {"a complex"}},
    {"z + a/z^2 + 1/(z - 1)^2", {"a > 0"}},
    // regular places
    {"a/z^2", {"a complex"}},
    {"a/z^2", {"a < -1"}},
    {"a/z^2 + b/(z - 1)^2", {"a complex", "b complex"}},
    {"(a*z^2 + b)/(z^2 - 1)^2", {"a complex", "b complex"}},
    {"-(a + 1)/z^2 + 1/(z - 1)^2", {"a > 0"}},
    {"-(a + 1)/z^2 + 1/(z - 1)^2 - 1/(z - 2)^2", {"a > 0"}},
    {"-3/16*(1/z^2 + 1/(z - 1)^2) + a/(z*(z - 1))", {"a complex"}},
    {"-5/36/z^2 - 3/16/(z - 1)^2 + a/(z*(z - 1))", {"a complex"}},
    {"2/z^2 + 2/(z - 1)^2 + a/(z*(z - 1))", {"a complex"}},
    {"2/z^2 + a/(z - 1)^2", {"a complex"}},
    {"3/4/z^2 + 3/4/(z - 1)^2 + a/(z*(z - 1))", {"a complex"}},
    {"2/(z - a)^2 + 2/(z - b)^2", {"a complex", "b complex"}},
    {"1/(z^2 - a)", {"a complex"}},
    {"1/(z^3 - a)", {"a complex"}},
    {"a/(z*(z - 1)*(z - 2))", {"a complex"}},
    // relations between parameters
    {"a/z^2 + b/(z - 1)^2 + z", {"a^2 + b^2 = 1"}},
    {"z^3 + a*z + b", {"a^3 = b^2"}},
};

strata::StrataAnswer decided(const Equation& e) {
  EquationText text;
  text.r = parse_expression(e.r, "r");
  text.variable = "z";
  for (const char* sentence : e.assume) {
    text.assume.push_back({sentence, nullptr, ""});
    for (const auto& name : names_in_assumption(text.assume.back()))
      if (std::find(text.parameters.begin(), text.parameters.end(), name) == text.parameters.end())
        text.parameters.push_back(name);
  }
  strata::StrataLimits limits;
  limits.decide.want_certificate = true;
  limits.decide.want_solutions = false;
  return strata::decide_strata(read_parametric_equation(text).question, limits);
}

// What is missing is a rule by its name, never a proof that the rules could have carried.
bool is_a_missing_rule(const Uncertified& u) {
  return u.gap == Gap::rule || u.gap == Gap::relation;
}

// The missing rule or lemma by its name: "the family of Bessel".
std::string missing(const Uncertified& u) {
  return u.gap == Gap::rule ? "rule: " + strata::rule_name(u.theorem) : to_string(u.gap);
}

TEST(Uncertified, StrataWaitForANamedRule) {
  std::size_t strata = 0, uncertified = 0;
  std::map<std::string, std::size_t> rules;
  for (const Equation& e : equations) {
    const auto answer = decided(e);
    EXPECT_TRUE(answer.refusal.empty()) << e.r << ": " << answer.refusal;
    for (const auto& s : answer.strata)
      if (s.leaf.abelian != Truth::unknown) ++strata;
    const auto certificate = strata::certificate(answer);
    for (const auto* all : {&certificate.trusted, &certificate.left_out})
      for (const Uncertified& u : *all) {
        EXPECT_TRUE(is_a_missing_rule(u)) << e.r << ": " << missing(u) << ", " << sentence(u.told);
        ++uncertified;
        ++rules[missing(u)];
      }
  }
  std::cout << "strata without a certificate: " << uncertified << " of " << strata << '\n';
  for (const auto& [rule, n] : rules)
    std::cout << "  " << n << "  " << rule << '\n';
  EXPECT_LE(uncertified, 3U);
}

// Each stratum is abelian exactly where a closed criterion holds, or has a verdict; none is trusted.
TEST(Uncertified, ClosedFamiliesHaveACertificate) {
  const std::vector<Equation> closed{
      {"(4*nu^2 - 1)/(4*z^2) - 1", {"nu complex"}},
      {"(4*nu^2 - 1)/(4*z^2) - 1", {"nu in 1/2 + Z"}},
      {"(4*nu^2 - 1)/(4*z^2) - 1", {"nu not in 1/2 + Z"}},
      {"1/4 - k/z + (4*m^2 - 1)/(4*z^2)", {"k complex", "m complex"}},
      {"1/4 - k/z + (4*m^2 - 1)/(4*z^2)",
       {"k + m - 1/2 not an integer", "k - m - 1/2 not an integer"}},
      {"1/z^4 - 4*k/z^3 + (4*m^2 - 1)/(4*z^2)", {"k complex", "m complex"}},
      {"l*(l + 1)/z^2 - 2*e/z - 1", {"l complex", "e complex"}},
      {"b/z + (m^2 - 1)/(4*z^2)", {"m complex", "b complex"}},
      {"(m^2 - 1)/(4*z^2) + b*z^4", {"m complex", "b complex"}},
      {"(l^2 - 1)/(4*z^2) + (m^2 - 1)/(4*(z - 1)^2) + (1 - l^2 - m^2 + n^2)/(4*z*(z - 1))",
       {"l complex", "m complex", "n complex"}},
      {"(n*(n + 1)*(z^2 - 1) - 1)/(z^2 - 1)^2", {"n complex"}},
      {"(n*(n + 1)*(z^2 - 1) - 1)/(z^2 - 1)^2", {"n integer"}},
      {"(n*(n + 1)*(z^2 - 1) - 1)/(z^2 - 1)^2", {"n not an integer"}},
      {"(n*(n + 1)*(z^2 - 1) + m^2 - 1)/(z^2 - 1)^2", {"n complex", "m complex"}},
      {"24*z/(4*(4*z^3 - 4*z)) - 3*(12*z^2 - 4)^2/(16*(4*z^3 - 4*z)^2) + (n*(n + 1)*z + B)/(4*z^3 "
       "- 4*z)",
       {"n complex", "B complex"}},
      {"24*z/(4*(4*z^3 - 4*z)) - 3*(12*z^2 - 4)^2/(16*(4*z^3 - 4*z)^2) + (n*(n + 1)*z + B)/(4*z^3 "
       "- 4*z)",
       {"n integer", "B complex"}}};
  for (const Equation& e : closed) {
    const auto answer = decided(e);
    EXPECT_EQ(answer.refusal, "") << e.r;
    const auto c = strata::certificate(answer);
    EXPECT_TRUE(c.says_anything) << e.r;
    EXPECT_TRUE(c.trusted.empty() && c.left_out.empty()) << e.r << "\n" << c.json;
    EXPECT_EQ(c.json.find("\"reason\""), std::string::npos) << e.r << "\n" << c.json;
  }
}

} // namespace
} // namespace kov
