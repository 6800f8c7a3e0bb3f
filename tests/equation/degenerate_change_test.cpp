// Where a change of variable does not exist: the given equation is asked there.
//
// The answers for all parameters at once are compared with those at points, which are put into the given equation
// before any variable is chosen.

#include "decide/decide.hpp"
#include "equation/parametric_equation.hpp"
#include "equation/understood.hpp"
#include "support/random.hpp"
#include "system/formula.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov {
namespace {

using test::Random;
using testing::ElementsAre;
using testing::IsEmpty;

using Point = std::map<std::string, Rational>;

EquationText asked(const std::string& ode, const std::vector<std::string>& parameters,
                   const std::vector<std::string>& assume = {}) {
  EquationText text;
  text.variable = "x";
  text.parameters = parameters;
  text = understood(ode, "-e", text).text;
  for (const std::string& sentence : assume)
    text.assume.push_back({sentence, nullptr, ""});
  return text;
}

// "a != 0: t, SL2": the parts with their variables and, where they have one stratum, its group.
std::vector<std::string> parts(const std::string& ode, const std::vector<std::string>& parameters,
                               const std::vector<std::string>& assume = {}) {
  std::vector<std::string> all;
  for (const EquationPart& part : read_parts(asked(ode, parameters, assume))) {
    std::string text;
    for (const auto& [here, elsewhere] : part.where)
      text += (text.empty() ? "" : ", ") + here;
    if (!part.equation) {
      all.push_back(text + (part.none.empty() ? ": open" : ": none"));
      continue;
    }
    const auto answer = strata::decide_strata(part.equation->question);
    if (answer.contradictory) continue;
    text += ": " + part.equation->variable;
    const auto strata = answer.told_apart();
    if (strata.size() == 1 && strata.front().leaf.group)
      text += ", " + to_string(strata.front().leaf.group->type);
    all.push_back(text);
  }
  return all;
}

// What divides by 0, or has no second derivative, is no mistake of the text on that part; the error says so itself.
TEST(DegenerateChange, WhatHasNoValueIsATypeOfError) {
  for (const char* ode : {"y'' = y/(a - a)", "y'' = (x - x)^(-1)*y", "(a - a)*y'' + y = 0",
                          "y'' = y/(sqrt(2)*sqrt(2) - 2)", "y'' = y/(1/(x - x))"})
    EXPECT_THROW(static_cast<void>(read_parametric_equation(asked(ode, {"a"}))), NoValue) << ode;
  for (const char* ode : {"y'' = b*y", "y'' = y^2", "y'' = x^(1/2 + a)*y"})
    try {
      static_cast<void>(read_parametric_equation(asked(ode, {"a"})));
      ADD_FAILURE() << ode;
    } catch (const NoValue& e) {
      ADD_FAILURE() << e.what();
    } catch (const Error&) {
    }
}

TEST(DegenerateChange, AParameterThatCancelsIsAskedWhereItIsZero) {
  for (const char* ode : {"y'' = a^2*exp(2*a*x)*y", "y'' + a^2*sin(a*x)*y = 0",
                          "y'' = a^2*cosh(a*x)^2*y", "y'' = a^2*(a*x + 1)^(1/2)*y"})
    EXPECT_THAT(parts(ode, {"a"}), ElementsAre("a != 0: t, SL2", "a = 0: x, cyclic")) << ode;
  EXPECT_THAT(parts("y'' = exp(a*x)*y", {"a"}), ElementsAre("a != 0: t, SL2", "a = 0: x, Gm"));
}

TEST(DegenerateChange, ItsConditionIsWhatTheArgumentsHaveInCommon) {
  EXPECT_THAT(parts("y'' = exp((a - b)*x)*y", {"a", "b"}),
              ElementsAre("b != a: t, SL2", "b = a: x, Gm"));
  EXPECT_THAT(parts("y'' = exp(a^2*x)*y", {"a"}), ElementsAre("a != 0: t, SL2", "a = 0: x, Gm"));
  EXPECT_THAT(parts("y'' = exp((a^2 + 1)*x)*y", {"a"}),
              ElementsAre("a^2 != -1: t, SL2", "a^2 = -1: x, Gm"));
  EXPECT_THAT(parts("y'' = exp(a*b*x)*y", {"a", "b"}), testing::SizeIs(3));
  EXPECT_THAT(parts("y'' = exp((a^2 + 1)*x)*y", {"a"}, {"a real"}), ElementsAre(": t, SL2"));
  EXPECT_THAT(parts("y'' = exp(a*x)*y", {"a"}, {"a > 0"}), ElementsAre(": t, SL2"));
  EXPECT_THAT(parts("y'' = exp(2*x)*y + a*y", {"a"}), testing::SizeIs(1));
}

TEST(DegenerateChange, WhatIsAssumedChoosesThePart) {
  EXPECT_THAT(parts("y'' = a^2*exp(2*a*x)*y", {"a"}, {"a = 0"}), ElementsAre("a = 0: x, cyclic"));
  EXPECT_THAT(parts("y'' = exp(a*x)*y", {"a"}, {"a = 0"}), ElementsAre("a = 0: x, Gm"));
}

TEST(DegenerateChange, ThereMayBeNoEquation) {
  for (const char* ode : {"y'' = y/sin(a*x)", "y'' = coth(a*x)*y", "y'' = y/sinh(a*x)^2"})
    EXPECT_EQ(parts(ode, {"a"}).back(), "a = 0: none") << ode;
  EXPECT_EQ(parts("y'' = (a*x + b)^(1/3)*y", {"a", "b"}).back(), "a = 0: open");
  EXPECT_NE(parts("y'' = (a*x + b)^(1/2)*y", {"a", "b"}).back(), "a = 0: open");
}

std::string value_of(const std::string& ode, const std::string& a) {
  EquationText text;
  text.variable = "x";
  text.set.emplace_back("a", parse_expression(a, "--set"));
  const GivenEquation e = read_equation(understood(ode, "-e", text).text);
  return e.variable + ": " + to_string(e.normal_form.r, e.variable);
}

TEST(DegenerateChange, AValueIsPutInBeforeAVariableIsChosen) {
  EXPECT_EQ(value_of("y'' = exp(a*x)*y", "0"), "x: 1");
  EXPECT_EQ(value_of("y'' = a^2*exp(2*a*x)*y", "0"), "x: 0");
  EXPECT_EQ(value_of("y'' = sin(a*x)*y + y", "0"), "x: 1");
  EXPECT_EQ(value_of("y'' = exp(a*x)*y", "sqrt(2)^2 - 2"), "x: 1");
  EXPECT_EQ(value_of("y'' = x^a*y", "2"), "x: x^2");
  EXPECT_THROW((void)value_of("y'' = y/sinh(a*x)", "0"), InputError);
}

// What was divided by is not 0, though p and q do not show it.
std::vector<std::string> domain_of(const std::string& ode) {
  const auto f = read_parametric_equation(asked(ode, {"a"}));
  std::vector<std::string> all;
  for (const auto& g : f.question.generic)
    for (const MPoly& p : g.not_all_zero)
      if (to_string(p) == "a") all = {"a"};
  return all;
}

TEST(DegenerateChange, WhatCancelsIsNotZero) {
  for (const char* ode :
       {"a*y'' = a*exp(x)*y", "a*y'' = a*sqrt(x)*y", "a*y' = a*y^2 + a*x", "y'/a = y^2/a + x/a",
        "y' = a*y^2 + x", "y'' = (a*x/a)*y", "a*y'' = a*x*y", "y'' = exp(x)*y*a/a"})
    EXPECT_THAT(domain_of(ode), ElementsAre("a")) << ode;
  for (const char* ode : {"y'' = a*exp(x)*y", "y'' = a*x*y", "y' = y^2 + a*x"})
    EXPECT_THAT(domain_of(ode), IsEmpty()) << ode;
}

// ---- at random

bool holds(const Condition& c, const Point& point) {
  Substitution values;
  for (const auto& [name, value] : point)
    if (const auto i = c.p.ring()->find(name)) values[*i] = MFraction(c.p.ring(), value);
  const MFraction f = substitute(c.p, values);
  return c.sign == Sign::zero ? is_zero(f) : !is_zero(f);
}

// The verdict of the answer for all parameters at a point; unset where it is open.
std::optional<bool> for_all(const std::vector<std::pair<EquationPart, strata::StrataAnswer>>& all,
                            const Point& point, bool& found) {
  for (const auto& [part, answer] : all) {
    const auto& q = part.equation->question;
    if (!std::all_of(q.assumptions.conditions.begin(), q.assumptions.conditions.end(),
                     [&](const Condition& c) { return holds(c, point); }))
      continue;
    std::map<std::size_t, Rational> here;
    for (const auto& [name, value] : point)
      if (const auto i = q.r.ring()->find(name)) here[*i] = value;
    const strata::Stratum* s = strata::stratum_at(answer, here);
    if (s == nullptr || s->leaf.abelian == Truth::unknown) return std::nullopt;
    found = true;
    return s->leaf.abelian == Truth::yes;
  }
  return std::nullopt;
}

TEST(DegenerateChange, AgreesWithThePointsOfRandomFamilies) {
  Random random(4711);
  const auto one_of = [&](const std::vector<std::string>& all) { return random.one_of(all); };
  long compared = 0, degenerate = 0;
  for (int round = 0; round < 40; ++round) {
    const std::string g = one_of({"a", "(a - b)", "a^2", "(a + 1)", "a*b", "2*b"});
    const std::string f =
        one_of({"exp(" + g + "*x)", "cosh(" + g + "*x)", "sin(" + g + "*x)", "cos(" + g + "*x)^2",
                "sqrt(" + g + "*x + 1)", "(" + g + "*x + 4)^(3/2)", "1/cosh(" + g + "*x)^2"});
    const std::string c = one_of({"1", "2", g + "^2", "b", "b*" + g + "^2", "1/4"}),
                      rest = one_of({"0", "0", "1", "b", g + "^2", g});
    const std::string p = one_of({"", "", " + " + g + "*y'", " + 2*y'"});
    const std::string ode = "y''" + p + " = (" + c + "*" + f + " + " + rest + ")*y";
    std::vector<std::pair<EquationPart, strata::StrataAnswer>> all;
    for (const EquationPart& part : read_parts(asked(ode, {"a", "b"})))
      if (part.equation) all.emplace_back(part, strata::decide_strata(part.equation->question));
    for (const auto& [a, b] :
         std::vector<std::pair<long, long>>{{0, 1}, {1, 1}, {1, 0}, {-1, 2}, {2, 3}, {0, 0}}) {
      bool found = false;
      const auto said = for_all(all, {{"a", Rational(a)}, {"b", Rational(b)}}, found);
      if (!said) continue;
      EquationText text;
      text.variable = "x";
      for (const auto& [name, value] : {std::pair("a", a), std::pair("b", b)})
        if (ode.find(name) != std::string::npos)
          text.set.emplace_back(name, parse_expression(std::to_string(value), "--set"));
      const EquationText there = understood(ode, "-e", text).text;
      const Decision d = decide(read_equation(there).normal_form, {});
      if (d.abelian == Truth::unknown) continue;
      EXPECT_EQ(*said, d.abelian == Truth::yes) << ode << " at " << a << ", " << b;
      ++compared;
      degenerate += there.change ? 0 : 1;
    }
  }
  EXPECT_GT(compared, 100);
  EXPECT_GT(degenerate, 15);
}

} // namespace
} // namespace kov
