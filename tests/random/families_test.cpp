// Families with parameters against the solver without them, at points where strata differ: on
// nonlinear relations with their singular points, at complex values beside inequalities, and where
// a printed condition says that the identity component may be abelian.

#include "decide/words.hpp"
#include "equation/parameter_scope.hpp"
#include "equation/parametric_equation.hpp"
#include "exact/error.hpp"
#include "parameter_points.hpp"
#include "strata/words.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <iostream>
#include <regex>

namespace kov::test {
namespace {

using strata::Leaf;
using strata::StrataAnswer;
using strata::Stratum;
using Texts = std::vector<std::string>;

struct Asked {
  std::string equation; ///< "-r" or "-e"
  std::string text;
  Texts parameters;
  Texts assumptions = {};

  [[nodiscard]] std::string command() const {
    std::string s = "kovacic solve " + equation + " '" + text + "'";
    for (const auto& p : parameters)
      s += " --parameter " + p;
    for (const auto& a : assumptions)
      s += " --assume '" + a + "'";
    return s;
  }
  [[nodiscard]] ParametricEquation family() const {
    EquationText e;
    (equation == "-r" ? e.r : e.ode) = parse_expression(text, "r", equation != "-r");
    e.parameters = parameters;
    e.variable = "z";
    for (const auto& a : assumptions)
      e.assume.push_back({a, nullptr, ""});
    return read_parametric_equation(e);
  }
};

strata::StrataLimits little_time() {
  strata::StrataLimits limits;
  limits.decide.budget = Budget::of_seconds(1.5);
  limits.decide.want_solutions = false;
  limits.max_strata = 40;
  return limits;
}

int compared = 0; // points with an answer on both sides

void report() {
  ::testing::Test::RecordProperty("compared", compared);
  if (std::getenv("KOV_RANDOM_ROUNDS") != nullptr) std::cout << compared << " points compared\n";
}

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
    std::smatch found;
    if (std::regex_match(text, found, std::regex("abelian exactly where (.*) is an integer")))
      return is_integer_there(found[1]);
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

  /// "the full triangular group where e is an odd integer, SL(2, C) elsewhere"
  [[nodiscard]] std::optional<GroupType> group(const Leaf& leaf) const {
    std::smatch found;
    const std::regex weber("the full triangular group where (.*) is an odd integer, .*");
    const std::string text = group_text(leaf);
    if (!std::regex_match(text, found, weber)) return std::nullopt;
    const NfElem e = value(found[1]);
    const bool odd = is_rational(e) && is_integer((to_rational(e) - Rational(1)) / Rational(2));
    return odd ? GroupType::Borel : GroupType::SL2;
  }

private:
  [[nodiscard]] NfElem value(const std::string& formula) const {
    const ParameterScope scope(f_.question.r.ring(), {});
    return point_.number(evaluate(parse_expression(formula, "printed"), scope));
  }
  // "sqrt(1/4 + a) - 1/2" or "nu - 1/2"
  [[nodiscard]] bool is_integer_there(const std::string& formula) const {
    std::smatch found;
    if (!std::regex_match(formula, found, std::regex("sqrt\\((.*)\\) - 1/2"))) {
      const NfElem v = value(formula);
      return is_rational(v) && is_integer(to_rational(v));
    }
    const auto root = rational_root(value(found[1]));
    return root && is_integer(*root - Rational(1, 2));
  }

  const ParametricEquation& f_;
  const ParameterPoint& point_;
};

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
                     [&](const ArithmeticCondition& c) { return is_so(c, value); }))
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
    }
  }
  EXPECT_EQ(holding, 1) << "parts that contain the point";
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
  if (const auto g = printed.group(s->leaf); g && d.group) {
    EXPECT_EQ(*g, d.group->type) << why;
  }
  if (s->leaf.abelian != Truth::unknown) return;
  const auto possible = printed.possible(s->leaf);
  if (!possible) return;
  if (d.abelian == Truth::yes) {
    EXPECT_TRUE(*possible) << why;
  }
  if (open_condition(s->leaf).find("exactly") != std::string::npos) {
    EXPECT_EQ(*possible, d.abelian == Truth::yes) << why;
  }
}

// Polynomials whose zeros are worth a visit: those that the strata are made of.
std::vector<MPoly> events(const StrataAnswer& a) {
  std::vector<MPoly> all;
  for (const Stratum& s : a.strata)
    for (const auto& c : s.conditions)
      if (std::find(all.begin(), all.end(), c.p) == all.end()) all.push_back(c.p);
  return all;
}

// equations: how many targets a point meets at most
void attack(const Asked& asked, const Texts& also, int points, Random& random, int equations = 1) {
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

std::string replaced(std::string form, const std::map<char, std::string>& pieces) {
  std::string s;
  for (const char c : form)
    s += pieces.contains(c) ? "(" + pieces.at(c) + ")" : std::string(1, c);
  return s;
}

// Riemann's equation with these squares of exponent differences at 0, 1 and infinity.
const std::string riemann = "(P-1)/(4*z^2)+(Q-1)/(4*(z-1)^2)+(1-P-Q+R)/(4*z*(z-1))";

const Texts forms{"P*z^2+Q*z+R",
                  "P*z+Q",
                  "P/z^2+Q/z+R",
                  "P/z^2+Q",
                  "(P*z^2+Q*z+R)/(z^2-1)^2",
                  "(P*z+Q)/(z*(z-1)^2)",
                  "P/z^2+Q/(z-R)^2",
                  "(P*z+Q)/(z^2-R)",
                  riemann};

TEST(RandomFamilies, UnderNonlinearRelations) {
  compared = 0;
  random_rounds(60, [](Random& random) {
    const Texts relations{"a^3=b^2",       "a^2=b^3",     "a^2=2*b^2",   "a^2+b^2=0",
                          "a^3=27*b^2",    "b^2=a^3+a^2", "a^2=b^2*c",   "a^2*b=c^2",
                          "a^2+b^2=1",     "a^2=2",       "a^2*b^2=4",   "a^4=b^2",
                          "(a-1)^3=b^2",   "a*b=0",       "a^3=2*b^3",   "a^2+a*b+b^2=0",
                          "a^2*(a-1)=b^2", "a^2+c^2=b^2", "a^4+b^4=c^2", "(a^2-2)*(b-1)=0"};
    const Texts pieces{"a", "b", "a-b", "a+1", "1", "a*b", "b-1", "2", "0", "-3/16", "b^2", "c"};
    const Asked asked{"-r",
                      replaced(random.one_of(forms), {{'P', random.one_of(pieces)},
                                                      {'Q', random.one_of(pieces)},
                                                      {'R', random.one_of(pieces)}}),
                      {"a", "b", "c"},
                      {random.one_of(relations)}};
    attack(asked, {"a", "b"}, 6, random);
  });
  report();
}

// A relation that falls apart on a stratum: its factors are strata of their own, told apart.
TEST(RandomFamilies, WhereARelationFallsApart) {
  compared = 0;
  random_rounds(6, [](Random& random) {
    const Texts relations{"a^2+a*b+b^2=0", "a^2+b^2=0", "a^4=b^2", "a^2-2*b^2=0", "a^3=b^3"};
    const Asked asked{"-r", "(c*z+(b-1))/(z^2-(a*b))", {"a", "b", "c"}, {random.one_of(relations)}};
    attack(asked, {"a*b*c^2-(b-1)^2", "b+1", "c"}, 12, random);
  });
  report();
}

TEST(RandomFamilies, AtComplexValuesBesideInequalities) {
  compared = 0;
  random_rounds(220, [](Random& random) {
    // A is positive; nothing is said of C and D, nor of the sign of the quotient
    struct Given {
      std::string relation, quotient;
    };
    const std::vector<Given> all{
        {"A = C*D", "C/D"},       {"A = C*D", "D/C"},   {"A = C^3*D", "C/D"},
        {"A = C*D^3", "D/C"},     {"A*C*D = 1", "C/D"}, {"A = C^2*D", "C^2/D"},
        {"A = C^2+D^2", "A/C^2"}, {"A*C = D", "D/C"},   {"A*C = D^2", "C/D^2"},
        {"C != 0", "A/C"},        {"D > A", "A/C"},     {"A = C-D", "C/D"}};
    const Given given = random.one_of(all);
    const Texts differences{"1/3", "1/2", "1/2", "2/3", "1", "1/4", "0", "1/5", "3/2"};
    const Texts scales{"", "4*", "1/9*", "-", "-4*"};
    const auto squared = [](const std::string& x) { return "(" + x + ")^2"; };
    const std::string open =
        squared(random.one_of(differences)) + " - (" + random.one_of(scales) + given.quotient + ")";
    const std::string second = random.one_of(differences), third = random.one_of(differences);
    std::vector<std::string> three{open, squared(second), squared(third)};
    std::shuffle(three.begin(), three.end(), random.bits());
    const Asked asked{"-r",
                      random.once_in(4)
                          ? replaced(random.one_of(forms),
                                     {{'P', open}, {'Q', squared(second)}, {'R', squared(third)}})
                          : replaced(riemann, {{'P', three[0]}, {'Q', three[1]}, {'R', three[2]}}),
                      {"A", "C", "D"},
                      {"A > 0", given.relation}};
    Texts targets;
    for (const char* finite : {"1/2", "1/3", "4/3", "5/3", "5/4", "7/4", "6/5", "8/5", "0"})
      targets.push_back("(" + open + ") - " + squared(finite));
    for (const char* odd : {"1", "-1", "3"}) // where a sum of differences is odd: reducible
      for (const char* sign : {"+", "-"})
        targets.push_back("(" + open + ") - " +
                          squared(odd + ("+(" + second) + ")" + sign + "(" + third + ")"));
    attack(asked, targets, 6, random);
  });
  report();
}

// r = v''/(2v) - (v'/v)^2/4 + c/v^2 has y1 y2 = v: abelian for every c.  v^2 = prod (z - p)^e.
class WithProduct {
public:
  explicit WithProduct(Random& random) {
    const std::vector<std::vector<Integer>> fields{{0, 1}, {-2, 0, 1}, {1, 0, 1}, {1, 1, 1}};
    const auto& minimal = random.one_of(fields);
    field = minimal.size() == 2 ? rationals() : make_field(minimal, "t");
    const MFraction z = x("z");
    MFraction w(ring, Rational(1)), log(ring);
    long total = 0;
    for (const long p : {0L, 1L, -1L}) {
      const long e = random.between(-1, 2);
      total += e;
      const MFraction to = z - MFraction(ring, Rational(p));
      w *= pow(to, e);
      log += Rational(e, 2) * (MFraction(ring, Rational(1)) / to);
    }
    proper = total >= 1;
    MFraction c(ring, Rational(random.between(1, 9), random.between(1, 9)));
    if (!field->is_rational()) c *= x("t");
    r = Rational(1, 2) * derivative(log, 0) + Rational(1, 4) * log * log + c / w;
  }

  /// of 1/(z - p)^2 and 1/(z - p)
  [[nodiscard]] std::pair<MFraction, MFraction> coefficients_at(long p) const {
    const MFraction to = x("z") - MFraction(ring, Rational(p));
    const MFraction local = r * to * to;
    const Substitution there{{0, MFraction(ring, Rational(p))}};
    return {value(substitute(local, there)), value(substitute(derivative(local, 0), there))};
  }

  Ring ring = make_ring({"z", "t"});
  Field field;
  bool proper = false; ///< r is 0 at infinity
  MFraction r;

private:
  [[nodiscard]] MFraction x(const char* name) const { return MFraction::variable(ring, name); }
  [[nodiscard]] MFraction value(const MFraction& f) const {
    return is_zero(f) ? MFraction(ring) : f;
  }
};

TEST(RandomFamilies, PrintedConditionsHoldWhereAProductOfSolutionsIsARadical) {
  compared = 0;
  random_rounds(150, [](Random& random) {
    const WithProduct abelian(random);
    if (!abelian.proper) return;
    Asked asked{"-r", "", {}};
    std::map<std::string, MFraction> values;
    const auto coefficient = [&](const std::string& name, const MFraction& v) {
      if ((is_zero(v) || is_constant(v)) && !random.once_in(3))
        return "(" + to_string(is_zero(v) ? Rational(0) : to_rational(v)) + ")";
      values[name] = v;
      asked.parameters.push_back(name);
      return name;
    };
    for (const auto& [p, at] : std::map<long, std::string>{{0, "z"}, {1, "(z-1)"}, {-1, "(z+1)"}}) {
      const auto [a, b] = abelian.coefficients_at(p);
      const std::string n = std::to_string(p + 1);
      asked.text +=
          "+" + coefficient("a" + n, a) + "/" + at + "^2+" + coefficient("b" + n, b) + "/" + at;
    }
    asked.text = asked.text.substr(1);
    if (asked.parameters.empty()) return;
    SCOPED_TRACE(asked.command());
    const ParametricEquation f = asked.family();
    auto names = f.question.r.ring()->names();
    names.emplace_back("t");
    const Ring larger = make_ring(names);
    Substitution point;
    for (const auto& [name, v] : values)
      point[larger->index(name)] = is_zero(v) ? MFraction(larger) : transfer(v, larger);
    compare_at(asked, f, decide_strata(f.question, little_time()),
               ParameterPoint(f.question.z, names.size() - 1, point, abelian.field));
  });
  report();
}

// Closed answers: points where an arithmetic condition holds, and points beside them.
TEST(RandomFamilies, InsideAndOutsideArithmeticConditions) {
  compared = 0;
  random_rounds(120, [](Random& random) {
    const Texts numbers{"a", "2*a", "a+1", "a/2", "a-1/2", "b", "a+b", "1/2", "1/3", "0", "1", "2"};
    const auto squared = [](const std::string& x) { return "(" + x + ")^2"; };
    const std::string l = random.one_of(numbers), m = random.one_of(numbers),
                      n = random.one_of(numbers);
    const Texts equations{
        replaced(riemann, {{'P', squared(l)}, {'Q', squared(m)}, {'R', squared(n)}}),
        replaced(riemann, {{'P', squared(l)}, {'Q', "a"}, {'R', squared(n)}}),
        replaced("1/4-P/z+(Q-1/4)/z^2", {{'P', l}, {'Q', squared(m)}}),
        replaced("1-P/z+(Q-1/4)/z^2", {{'P', l}, {'Q', "a"}}),
        replaced("1+(Q-1/4)/z^2", {{'Q', squared(m)}}),
        replaced("1+P/z^2", {{'P', l}}),
        replaced("(Q-1)/(4*z^2)+z^R",
                 {{'Q', squared(m)}, {'R', random.one_of(Texts{"1", "2", "4"})}}),
        replaced("(Q-1)/(4*z^2)+3/z", {{'Q', squared(m)}}),
        replaced("z^2/4+P", {{'P', l}}),
        replaced("4*z^2+P*z+Q", {{'P', l}, {'Q', m}}),
        replaced("(Q-1)/(4*z^2)", {{'Q', squared(m)}}),
        replaced("P/(z^2+1)^2", {{'P', l}}),
        replaced("z^2+P+(Q-1/4)/z^2", {{'P', l}, {'Q', squared(m)}}),
        replaced("z^4+P*z+Q", {{'P', l}, {'Q', m}})};
    Texts assumed;
    if (random.once_in(4))
      assumed.push_back(random.one_of(Texts{"a integer", "2*a odd integer", "a real"}));
    const Asked asked{"-r", random.one_of(equations), {"a", "b"}, assumed};
    Texts targets;
    for (const std::string& x : {l, m, n, std::string("a"), std::string("b")}) {
      targets.push_back("(" + x + ")-" +
                        random.one_of(Texts{"1/2", "1", "2", "3/2", "1/3", "2/5", "3"}));
      targets.push_back("(" + x + ")-(" + random.one_of(Texts{l, m, n}) + ")-" +
                        random.one_of(Texts{"1", "1/2", "0", "3", "2"}));
      targets.push_back("(" + x + ")^2-" + random.one_of(Texts{"1/4", "2", "9/4", "1", "4"}));
      targets.push_back("(" + l + ")+(" + m + ")+(" + n + ")-" +
                        random.one_of(Texts{"1", "3", "-1"}));
    }
    attack(asked, targets, 8, random);
  });
  report();
}

// The kinds of equations with parameters that lib/strata knows, at values at which their closed
// conditions bite and beside them; P, Q, R are numbers, S a factor that may vanish.
// KOV_RANDOM_POINTS in the environment: how many points of each family (12).
const std::vector<std::pair<const char*, Texts>> kinds{
    {"Riemann", {riemann}},
    {"Legendre", {"(P*(P+1)*(z^2-1)+Q^2-1)/(z^2-1)^2", "(P*(P+1)*(z^2-1)-1)/(z^2-1)^2"}},
    {"hypergeometric at roots", {"((P^2-1)*z^2+Q)/(4*(z^2-S)^2)"}},
    {"Euler", {"(P^2-1)/(4*z^2)", "(P^2-1)*S/(z^2-S)^2", "(P^2-1)/(4*(z-S)^2)"}},
    {"Bessel", {"(P^2-1/4)/z^2-S", "(P^2-1)/(4*z^2)+S/z"}},
    {"Whittaker", {"1/4-P/z+(Q^2-1/4)/z^2", "S^2/4-S*P/z+(Q^2-1/4)/z^2"}},
    {"Coulomb", {"P*(P+1)/z^2-2*Q/z-1", "P*(P+1)/z^2-2*Q/z+S^2"}},
    {"Weber", {"z^2+P", "S^2*z^2+2*S*P", "z^2/4-P-1/2", "S*z^2+P*z+Q"}},
    {"polynomials", {"z^4+P*z+Q", "z^3+P*z", "S*z^4+P*z", "S*z+P"}},
    {"Lame",
     {"96*z/(16*(z^3-z))-3*(12*z^2-4)^2/(256*(z^3-z)^2)+(P*(P+1)*z+S)/(4*(z^3-z))",
      "-3/16/z^2-3/16/(z-1)^2-3/16/(z-S)^2+(P*(P+1)/4*z+3/8*z+Q)/(z*(z-1)*(z-S))"}},
    {"Mathieu", {"-3/(16*z^2)-3/(16*(z-1)^2)+3/(8*z*(z-1))+(P+S*z)/(z*(z-1))"}},
    {"dihedral", {riemann}},
    {"pulled back",
     {"(16*P^2-1)/(4*z^2)-4*S*z^2", "(36*P^2-1)/(4*z^2)+9*S*z", "(4*P^2-1)/(4*z^2)-S*z^-4",
      "9/4*z^4-9*P*z+(9*Q^2-1/4)/z^2", "(4*P^2-1)/(4*z^2)+(Q^2-1)*z^2/(z^2-1)^2"}},
    {"irregular", {"P/z^3+Q/z^2", "1/z^4+P/z^3+Q/z^2", "S*z+P/z^2", "z^2+P+(Q^2-1/4)/z^2"}},
    {"two irregular places", {"S+P/z+Q/z^2+1/z^4", "z^2+P/z^2+Q/z^4"}},
    {"Heun",
     {"(P^2-1)/(4*z^2)-3/16/(z-1)^2-3/16/(z-2)^2+(Q*z+R)/(z*(z-1)*(z-2))",
      "-3/16*(1/z^2+1/(z-1)^2+1/(z-2)^2)+(P*z+Q)/(z*(z-1)*(z-2))"}},
    {"confluent Heun", {"1/4+P/z+Q/(z-1)+(R^2-1)/(4*z^2)-3/16/(z-1)^2"}}};

TEST(RandomFamilies, SeventeenKinds) {
  compared = 0;
  random_rounds(68, [](Random& random) {
    const Texts numbers{"a",   "a",   "b", "2*a", "a+1", "a/2", "a-1/2", "a+b", "a/3",
                        "a-b", "1/2", "1", "1/3", "0",   "c",   "3/2",   "2/5"};
    const auto& [kind, texts] = random.one_of(kinds);
    const std::string p = random.one_of(numbers), q = random.one_of(numbers),
                      s = random.one_of(Texts{"c", "c", "1", "-1", "c^2+1", "b", "4"});
    const auto with = [&](const std::string& form) {
      return replaced(form, {{'P', p}, {'Q', q}, {'R', random.one_of(numbers)}, {'S', s}});
    };
    const auto squared = [](const std::string& x) { return "(" + x + ")^2"; };
    std::string r = with(random.one_of(texts));
    if (kind == std::string("Riemann"))
      r = replaced(riemann,
                   {{'P', squared(p)}, {'Q', squared(q)}, {'R', squared(random.one_of(numbers))}});
    if (kind == std::string("dihedral"))
      r = replaced(riemann, {{'P', "1/4"}, {'Q', squared(p)}, {'R', squared(q)}});
    Texts assumed;
    if (random.once_in(5))
      assumed.push_back(random.one_of(
          Texts{"a integer", "2*a odd integer", "a real", "a rational", "a not in 1/2+Z"}));
    const Asked asked{"-r", r, {"a", "b", "c"}, assumed};
    Texts targets;
    for (const std::string& x :
         {p, q, std::string("a"), std::string("b"), "(" + p + ")+(" + q + ")"})
      for (const char* at : {"1/2", "1", "3/2", "2", "0", "1/3"})
        targets.push_back("(" + x + ")-" + at);
    for (const char* at : {"1/4", "2", "-1", "3"})
      targets.push_back(squared(p) + "-(" + at + ")");
    targets.push_back("c");
    targets.push_back("c^2-2");
    SCOPED_TRACE(kind);
    attack(asked, targets, static_cast<int>(number_in_environment("KOV_RANDOM_POINTS", 12)), random,
           2);
  });
  report();
}

// Where the coefficient of y'' is 0, or a coefficient has no value, nothing is said of y'' = r y.
TEST(RandomFamilies, ALeadingCoefficientThatVanishesIsAnException) {
  compared = 0;
  random_rounds(40, [](Random& random) {
    const Texts leading{"a", "a*z", "a*z+b", "(a-b)*(z^2+1)", "a^2-b", "a*z^2+a", "1/a", "z/(a-b)"};
    const Texts others{"z", "a*z", "a*z^2+b", "b/z^2", "a/z^2+a", "z+b", "(a-b)*z"};
    const Asked asked{
        "-e", "(" + random.one_of(leading) + ")*y''=(" + random.one_of(others) + ")*y", {"a", "b"}};
    attack(asked, {"a", "b", "a-b", "a^2-b"}, 5, random);
    const ParametricEquation f = asked.family();
    const StrataAnswer a = decide_strata(f.question, little_time());
    SCOPED_TRACE(asked.command());
    if (f.question.generic.empty()) return;
    for (int i = 0; i < 5; ++i) {
      const auto& g = random.one_of(f.question.generic);
      const auto point = random_point(f.question, g.not_all_zero, random);
      if (!point) continue;
      ++compared;
      const Stratum* s = stratum_of(a, *point);
      if (s != nullptr) {
        EXPECT_TRUE(s->leaf.no_equation()) << point->text(f.question.r.ring());
      }
    }
  });
  const ParametricEquation airy = Asked{"-e", "a*y''=a*z*y", {"a"}}.family();
  const StrataAnswer a = decide_strata(airy.question);
  ASSERT_EQ(a.strata.size(), 2U);
  EXPECT_THAT(a.strata, ::testing::Contains(::testing::Truly([](const Stratum& s) {
                return s.leaf.no_equation() && to_string(s.conditions) == "a = 0";
              })));
  report();
}

} // namespace
} // namespace kov::test
