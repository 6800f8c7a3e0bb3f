#include "family_attack.hpp"

#include "decide/words.hpp"
#include "exact/error.hpp"
#include "strata/words.hpp"
#include "support/group_bound.hpp"
#include "system/parameter_scope.hpp"

#include <algorithm>
#include <iostream>
#include <regex>

namespace kov::test {
namespace {

using strata::Leaf;
using strata::StrataAnswer;
using strata::Stratum;

std::optional<Rational> rational_root(const NfElem& square) {
  if (!is_rational(square)) return std::nullopt;
  const Rational v = to_rational(square);
  return sign(v) < 0 ? std::nullopt : exact_sqrt(v);
}

// A condition on the parameters as it is printed, at one point.
class Printed {
public:
  Printed(const ParametricEquation& f, const ParameterPoint& point) : f_(f), point_(point) {}

  /// What "abelian only if ..." says; unset where this test does not read the sentence.
  [[nodiscard]] std::optional<bool> possible(const Leaf& leaf) const {
    const std::string text = open_condition(leaf);
    if (text.find("these polynomials all vanish") != std::string::npos) return std::nullopt;
    if (text.rfind("abelian only if ", 0) != 0) return std::nullopt;
    std::vector<std::optional<Rational>> deltas;
    const std::regex square("Delta\\^2 = ([^,]*)");
    for (std::sregex_iterator i(text.begin(), text.end(), square), end; i != end; ++i)
      deltas.push_back(rational_root(value((*i)[1])));
    if (deltas.empty() || text.find("a root T of") != std::string::npos) return std::nullopt;
    const auto rational = [](const auto& d) { return d.has_value(); };
    const auto half = [](const auto& d) { return d && is_integer(Rational(2) * *d); };
    const auto whole = [](const auto& d) { return d && is_integer(*d); };
    const bool all = std::all_of(deltas.begin(), deltas.end(), rational);
    const bool some_half = std::any_of(deltas.begin(), deltas.end(), half);
    const bool some_whole = std::any_of(deltas.begin(), deltas.end(), whole);
    const std::string claim = text.substr(16, text.find(',') - 16);
    const std::map<std::string, bool> known{
        {"every Delta is rational or some 2*Delta is an integer", all || some_half},
        {"some 2*Delta is an integer", some_half},
        {"Delta is rational", all},
        {"2*Delta is a positive integer", some_half},
        {"Delta is a positive integer", some_whole}};
    const auto claimed = known.find(claim);
    if (claimed != known.end()) return claimed->second;
    ADD_FAILURE() << "a printed condition without a test: " << text;
    return std::nullopt;
  }

private:
  [[nodiscard]] NfElem value(const std::string& formula) const {
    const ParameterScope scope(f_.question.r.ring(), {});
    return point_.number(evaluate(parse_expression(formula, "printed"), scope));
  }

  const ParametricEquation& f_;
  const ParameterPoint& point_;
};

// n unset: not the same at all points.
bool agree(const GaloisGroup& a, const GaloisGroup& b) {
  return a.type == b.type && (!a.n || !b.n || *a.n == *b.n);
}

// The point lies in exactly one part of its stratum.
void compare_part(const Stratum& s, const ParameterPoint& point, const Decision& d) {
  const auto value = [&](const MFraction& f) { return point.number(f); };
  int holding = 0;
  for (const Stratum& one : told_apart(s)) {
    if (!std::all_of(one.arithmetic.begin(), one.arithmetic.end(),
                     [&](const Statement& c) { return is_so(c, value); }))
      continue;
    ++holding;
    std::string why = "part";
    for (const std::string& c : condition_texts(one))
      why += " [" + c + "]";
    why += "\n" + reason(one.leaf) + "\nbut " + reason(d);
    if (one.leaf.abelian != Truth::unknown) {
      EXPECT_EQ(one.leaf.abelian, d.abelian) << why;
    }
    if (one.leaf.group && d.group) {
      EXPECT_TRUE(agree(*one.leaf.group, *d.group)) << why << "\n" << describe(*d.group);
    } else if (d.group) {
      EXPECT_TRUE(strata::allows(one.leaf.bound, *d.group)) << why << "\n" << describe(*d.group);
    }
  }
  EXPECT_EQ(holding, 1) << "parts that contain the point";
}

// Polynomials whose zeros are worth a visit: those that the strata are made of.
std::vector<MPoly> events(const StrataAnswer& a) {
  std::vector<MPoly> all;
  for (const Stratum& s : a.strata)
    for (const auto& c : s.conditions)
      if (std::find(all.begin(), all.end(), c.p) == all.end()) all.push_back(c.p);
  return all;
}

} // namespace

std::string Asked::command() const {
  std::string s = "kovacic solve " + equation + " '" + text + "'";
  for (const auto& p : parameters)
    s += " --parameter " + p;
  for (const auto& a : assumptions)
    s += " --assume '" + a + "'";
  return s;
}

ParametricEquation Asked::family() const {
  EquationText e;
  (equation == "-r" ? e.r : e.ode) = parse_expression(text, "r", equation != "-r");
  e.parameters = parameters;
  e.variable = "z";
  for (const auto& a : assumptions)
    e.assume.push_back({a, nullptr, ""});
  return read_parametric_equation(e);
}

strata::StrataLimits little_time() {
  strata::StrataLimits limits;
  limits.decide.budget = Budget::of_seconds(1.5);
  limits.decide.want_solutions = false;
  limits.max_strata = 40;
  return limits;
}

void report() {
  ::testing::Test::RecordProperty("compared", compared);
  if (std::getenv("KOV_RANDOM_ROUNDS") != nullptr) std::cout << compared << " points compared\n";
}

// The stratum of the point; every point has one.
const Stratum* stratum_of(const StrataAnswer& a, const ParameterPoint& point) {
  const Stratum* found = nullptr;
  for (const Stratum& s : a.strata) {
    if (!std::all_of(s.conditions.begin(), s.conditions.end(),
                     [&](const Condition& c) { return point.holds(c); }))
      continue;
    EXPECT_EQ(found, nullptr) << "two strata: " << to_string(found->conditions) << " and "
                              << to_string(s.conditions);
    found = &s;
  }
  EXPECT_TRUE(found != nullptr || !a.unvisited.empty()) << "no stratum contains the point";
  return found;
}

void compare_at(const Asked& asked, const ParametricEquation& f, const StrataAnswer& a,
                const ParameterPoint& point) {
  NormalForm equation;
  try {
    equation.r = point.at(f.question.r);
  } catch (const DomainError&) { // no equation there
    return;
  }
  SCOPED_TRACE(asked.command() + "\nat " + point.text(f.question.r.ring()) +
               ":\nkovacic solve -r '" + to_string(equation.r) + "'" + point.minpoly_option());
  const Stratum* s = stratum_of(a, point);
  if (s == nullptr || s->leaf.no_equation()) return;
  Options options;
  options.budget = Budget::of_seconds(1.5);
  options.want_solutions = false;
  const Decision d = decide(equation, options);
  if (d.abelian == Truth::unknown) return;
  ++compared;
  const std::string why =
      "stratum " + to_string(s->conditions) + "\n" + reason(s->leaf) + "\nbut " + reason(d);
  if (s->leaf.abelian != Truth::unknown) {
    EXPECT_EQ(s->leaf.abelian, d.abelian) << why;
  }
  if (s->leaf.group && d.group) {
    EXPECT_TRUE(agree(*s->leaf.group, *d.group)) << why;
  }
  compare_part(*s, point, d);
  const Printed printed(f, point);
  if (s->leaf.abelian != Truth::unknown) return;
  const auto possible = printed.possible(s->leaf);
  if (!possible) return;
  if (d.abelian == Truth::yes) {
    EXPECT_TRUE(*possible) << why;
  }
}

void attack(const Asked& asked, const Texts& also, int points, Random& random, int equations) {
  SCOPED_TRACE(asked.command());
  const ParametricEquation f = asked.family();
  auto limits = little_time();
  limits.decide.want_certificate = random.once_in(4);
  const StrataAnswer a = decide_strata(f.question, limits);
  EXPECT_EQ(a.refusal, "");
  if (a.contradictory) return;
  std::vector<MPoly> targets = events(a);
  const ParameterScope scope(f.question.r.ring(), {});
  for (const auto& t : also)
    if (const MFraction e = evaluate(parse_expression(t, "target"), scope); !is_zero(e))
      targets.push_back(e.num());
  for (int i = 0; i < points; ++i) {
    std::vector<MPoly> zero;
    for (const auto& c : f.question.assumptions.conditions)
      if (c.sign == Sign::zero) zero.push_back(c.p);
    for (int k = 0; k < equations && !targets.empty() && !random.once_in(3); ++k)
      zero.push_back(random.one_of(targets));
    const auto point = random_point(f.question, zero, random);
    try {
      if (point && point->meets(f.question.assumptions)) compare_at(asked, f, a, *point);
    } catch (const DomainError&) { // a coordinate without a value
    }
  }
}

std::string replaced(const std::string& form, const std::map<char, std::string>& pieces) {
  std::string s;
  for (const char c : form)
    s += pieces.contains(c) ? "(" + pieces.at(c) + ")" : std::string(1, c);
  return s;
}

} // namespace kov::test
