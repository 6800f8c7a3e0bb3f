// What a file assumes is neither more nor less on the way: assumed equations beside inequalities,
// through every door, at complex values that satisfy all that is written.  "A < 0, A = C*D" makes A
// real and says nothing of the kind of C and D.

#include "classify/classify.hpp"
#include "equation/parametric_equation.hpp"
#include "exact/error.hpp"
#include "support/checked.hpp"
#include "support/own_folder.hpp"
#include "support/random.hpp"
#include "system/assumed_values.hpp"
#include "system/parameter_scope.hpp"
#include "theorem/prove.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace kov::test {
namespace {

using Names = std::map<std::string, std::string>; ///< name, value as text over Q(I)

const Ring gauss = make_ring({"z", "I"});
const Field gaussian = make_field({1, 0, 1}, "I");

/// A formula in named numbers; unset: it has no value.
std::optional<NfElem> number(const std::string& formula, const Names& values) {
  std::map<std::string, MFraction> known;
  for (const auto& [name, value] : values)
    known[name] = evaluate(parse_expression(value, "value"), ParameterScope(gauss, {}));
  try {
    const MFraction f =
        evaluate(parse_expression(formula, "formula"), ParameterScope(gauss, known));
    if (is_zero(f)) return NfElem(0);
    const RationalFunction there = to_rational_function(f, 0, AlgebraicConstant{1, gaussian});
    return is_zero(there) ? NfElem(0) : there.num().coeff(0) / there.den().coeff(0);
  } catch (const Error&) { // division by zero
    return std::nullopt;
  }
}

std::optional<Rational> real_number(const std::string& formula, const Names& values) {
  const auto v = number(formula, values);
  if (!v || !is_rational(*v)) return std::nullopt;
  return to_rational(*v);
}

/// "A < 0" and "A = C*D": the quotient is negative where C and D are real.
struct Given {
  std::string sign, a, quotient;
};

const std::vector<Given> all_given{
    {"A < 0", "C*D", "C/D"},         {"A < 0", "C*D", "D/C"},
    {"A > 0", "-C*D", "C/D"},        {"A > 0", "-C^2", "1/C^2"},
    {"A > 0", "-C^2-D^2", "C/D"},    {"A < 0", "C/D", "C*D"},
    {"A < 0", "C/D", "D/C"},         {"-A > 0", "C/D^3", "C*D"},
    {"A < 0", "C^3*D", "C/D"},       {"2*A + 1 < 0", "C*D", "C/D"},
    {"0 > A", "(C+1)*D", "(C+1)/D"}, {"A <= -1", "C*D", "D^3*C"},
    {"A < -1/5", "1/(C*D)", "C/D"},  {"A + 1 < 1", "C*D", "-C^2*D^2-C/D+C^2*D^2+2*C/D"},
    {"A < 0", "(C-D)*D", "(C-D)/D"}};

/// Values of C and D, not both real, that satisfy what is written and make the quotient positive.
std::optional<Names> complex_point(const Given& given, Random& random) {
  const std::vector<std::string> numbers{"1",   "-1",  "2",       "-1/2", "I",     "-I",
                                         "2*I", "I/2", "3*I",     "1+I",  "1-I",   "-1-I",
                                         "2-I", "3/2", "(1+I)/2", "-1+I", "I-1/2", "2+2*I"};
  for (int k = 0; k < 300; ++k) {
    Names point{{"C", random.one_of(numbers)}, {"D", random.one_of(numbers)}};
    if (point["C"].find('I') == std::string::npos && point["D"].find('I') == std::string::npos)
      continue;
    const auto a = number(given.a, point), quotient = number(given.quotient, point);
    if (!a || !quotient || !is_rational(*a) || !is_rational(*quotient)) continue;
    point["A"] = "(" + to_string(to_rational(*a)) + ")";
    const std::size_t at = given.sign.find_first_of("<>");
    const bool less = given.sign[at] == '<', equal = given.sign[at + 1] == '=';
    const std::string right = given.sign.substr(at + (equal ? 2 : 1));
    const auto difference =
        real_number("(" + given.sign.substr(0, at) + ")-(" + right + ")", point);
    if (!difference || (less ? sign(*difference) >= 0 : sign(*difference) <= 0)) continue;
    if (sign(to_rational(*quotient)) > 0) return point;
  }
  return std::nullopt;
}

bool holds(const std::vector<Condition>& all, const Names& point) {
  return std::all_of(all.begin(), all.end(), [&](const Condition& c) {
    const auto v = number(to_string(c.p), point);
    if (!v) return false;
    const int s = is_rational(*v) ? sign(to_rational(*v)) : 2;
    switch (c.sign) {
    case Sign::zero:
      return s == 0;
    case Sign::nonzero:
      return s != 0;
    case Sign::positive:
      return s == 1;
    default:
      return s == 0 || s == 1;
    }
  });
}

// No stratum with the point is said to be not abelian.
void expect_not_excluded(const strata::StrataAnswer& answer, const Names& point) {
  const auto value = [&](const MFraction& f) {
    return number(is_zero(f) ? "0" : to_string(f), point).value_or(NfElem(0));
  };
  for (const strata::Stratum& s : answer.told_apart())
    if (s.leaf.abelian == Truth::no && holds(s.conditions, point))
      EXPECT_FALSE(std::all_of(s.arithmetic.begin(), s.arithmetic.end(),
                               [&](const auto& c) { return is_so(c, value); }))
          << "the stratum " << to_string(s.conditions);
}

std::string text_of(const Names& point) {
  std::string text;
  for (const auto& [name, value] : point)
    text += (text.empty() ? "" : ", ") + name + " = " + value;
  return text;
}

/// What is written, in one of the ways to write it.
class Written {
public:
  Written(const Given& given, bool are_real, Random& random) : given_(given), real_(are_real) {
    by_value_ = random.once_in(3);
    flipped_ = random.once_in(2);
    order_ = random.once_in(2);
  }
  [[nodiscard]] std::vector<std::string> conditions() const {
    std::vector<std::string> all{given_.sign};
    const std::string equation = flipped_ ? "A - (" + given_.a + ") = 0" : "A = " + given_.a;
    if (!by_value_) all.insert(order_ ? all.begin() : all.end(), equation);
    return all;
  }
  /// The Hamiltonian is integrable where the coefficient is 1, 6 or 16.
  [[nodiscard]] std::string file(const std::string& coefficient) const {
    std::string conditions;
    for (const auto& c : this->conditions())
      conditions += (conditions.empty() ? "\"" : ", \"") + c + "\"";
    return "format = \"equation/1\"\n[system]\nkind = \"hamiltonian\"\n"
           "coordinates = [\"x\", \"y\"]\nmomenta = [\"p\", \"q\"]\n"
           "parameters = [\"A\", \"C\", \"D\"]\n"
           "hamiltonian = \"(p^2 + q^2)/2 + x^2*y + (" +
           coefficient + ")*y^3/3\"\n" + (by_value_ ? "[set]\nA = \"" + given_.a + "\"\n" : "") +
           "[assume]\n" + (real_ ? "C = \"real\"\nD = \"real\"\n" : "") + "conditions = [" +
           conditions + "]\n[[manifold]]\nname = \"N\"\nequations = [\"x = 0\", \"p = 0\"]\n" +
           "level = \"H = 1\"\n";
  }
  /// Abelian where the coefficient is the square of an odd half.
  [[nodiscard]] EquationText equation(const std::string& coefficient) const {
    EquationText e;
    e.r = parse_expression("(" + coefficient + "-1/4)/z^2-1", "r");
    e.variable = "z";
    e.parameters = {"A", "C", "D"};
    for (const std::string& c : {given_.sign, "A = " + given_.a}) // --set is for numbers
      e.assume.push_back({c, nullptr, ""});
    if (real_) e.assume.push_back({"C real, D real", nullptr, ""});
    return e;
  }

private:
  const Given& given_;
  bool real_, by_value_ = false, flipped_ = false, order_ = false;
};

Options a_little() {
  Options options;
  options.budget = Budget::of_seconds(3);
  options.want_solutions = false;
  return options;
}

strata::StrataAnswer solved(const EquationText& text) {
  strata::StrataLimits limits;
  limits.decide = a_little();
  return decide_strata(read_parametric_equation(text).question, limits);
}

ManifoldReport with_a_little(const std::string& file) {
  CheckOptions options;
  options.decide = a_little();
  return checked(file, options);
}

bool is_proved(const std::string& file) {
  const std::string path = own_folder() + "assumed.toml";
  std::ofstream(path) << file;
  TheoremNode n;
  n.id = n.title = "n";
  n.kind = NodeKind::case_file;
  n.file = "assumed.toml";
  Theorem t;
  t.file = own_folder() + "test.toml";
  t.title = "T";
  t.system = n.file;
  t.nodes.push_back(n);
  ProveOptions options;
  options.decide = a_little();
  options.with_bundle = false;
  return prove(t, options).nodes.front().status == NodeStatus::proved;
}

SystemClassification classified(const std::string& file) {
  ClassifyOptions options;
  options.check.decide = a_little();
  options.search_solutions = false;
  options.degree = 2;
  options.degree_at_points = 2;
  options.order = 1;
  return classify_system(read_system(parse_document(file, "test.toml")), options);
}

bool contains(const ClassifiedStratum& s, const Names& point) {
  std::vector<Condition> all;
  for (const MPoly& p : s.where.equations())
    all.push_back({p, Sign::zero});
  for (const MPoly& p : s.where.inequations())
    all.push_back({p, Sign::nonzero});
  return holds(all, point);
}

struct Round {
  Given given;
  Names point;
  std::string unit; ///< 1/(the quotient there)

  [[nodiscard]] std::string coefficient(const Rational& there) const {
    return "(" + to_string(there) + ")*" + unit + "*(" + given.quotient + ")";
  }
};

std::optional<Round> a_round(Random& random) {
  const Given given = random.one_of(all_given);
  const auto point = complex_point(given, random);
  if (!point) return std::nullopt;
  const Rational quotient = *real_number(given.quotient, *point);
  return Round{given, *point, "(" + to_string(Rational(1) / quotient) + ")"};
}

TEST(Assumptions, OfAnEquationHoldAtComplexValues) {
  random_rounds(60, [](Random& random) {
    const auto round = a_round(random);
    if (!round) return;
    const Written written(round->given, false, random);
    const Rational half = Rational(2 * random.between(0, 3) + 1, 2);
    const std::string coefficient = round->coefficient(half * half);
    SCOPED_TRACE(coefficient + ", " + round->given.sign + ", A = " + round->given.a + " at " +
                 text_of(round->point));
    expect_not_excluded(solved(written.equation(coefficient)), round->point);
  });
}

TEST(Assumptions, OfASystemHoldAtComplexValues) {
  random_rounds(40, [](Random& random) {
    const auto round = a_round(random);
    if (!round) return;
    const std::string file =
        Written(round->given, false, random)
            .file(round->coefficient(
                random.one_of(std::vector<Rational>{Rational(1), Rational(6), Rational(16)})));
    SCOPED_TRACE("integrable at " + text_of(round->point) + ":\n" + file);
    const ManifoldReport report = with_a_little(file);
    EXPECT_NE(report.verdict, Verdict::non_integrable);
    for (const BlockReport& b : report.blocks)
      if (b.strata) expect_not_excluded(*b.strata, round->point);
    EXPECT_FALSE(is_proved(file));
    if (!random.once_in(4)) return; // the dearest of the doors
    for (const ClassifiedStratum& s : classified(file).strata)
      if (s.status == StratumStatus::excluded && s.where.is_algebraic())
        EXPECT_FALSE(contains(s, round->point));
  });
}

// Nothing is lost: where C and D are said to be real the quotient is negative.
TEST(Assumptions, OfRealParametersAreUsed) {
  random_rounds(12, [](Random& random) {
    const auto round = a_round(random);
    if (!round) return;
    const Written written(round->given, true, random);
    const std::string coefficient = round->coefficient(Rational(1));
    SCOPED_TRACE(written.file(coefficient));
    try {
      EXPECT_EQ(with_a_little(written.file(coefficient)).verdict, Verdict::non_integrable);
    } catch (const InvalidArgument&) { // A = -C^2 > 0 has no real C
    }
  });
}

// What the file of a step says to be real must be real in the theorem, though the inequality in
// which it says so be true there: C*D = 1.
TEST(Assumptions, OfAStepMustFollowInTheTheorem) {
  const std::string head = "[system]\nkind = \"hamiltonian\"\ncoordinates = [\"x\", \"y\"]\n"
                           "momenta = [\"p\", \"q\"]\n";
  const auto objection = [&](const std::string& assumed) {
    const std::string whole = own_folder() + "whole.toml";
    std::ofstream(whole) << head +
                                "parameters = [\"k\"]\nhamiltonian = \"(p^2 + q^2)/2 + x^2*y + "
                                "k*y^3/3 + x^4/k\"\n[assume]\nk = \"" +
                                assumed + "\"\n";
    const System step = read_system(parse_document(
        head + "parameters = [\"C\", \"D\"]\nhamiltonian = \"(p^2 + q^2)/2 + x^2*y + C*y^3/3 + "
               "D*x^4\"\n[assume]\nconditions = [\"C*D > 0\"]\n",
        "step.toml"));
    Place place;
    place.as = {{"C", "k"}, {"D", "1/k"}};
    place.conditions = {"k != 0"};
    return locate(whole, whole, step, place).objection;
  };
  EXPECT_EQ(objection("nonzero"), "it assumes that C is real");
  EXPECT_EQ(objection("real"), "");
}

} // namespace
} // namespace kov::test
