// Families with parameters against the solver without them, at points where strata differ: on
// nonlinear relations with their singular points, at complex values beside inequalities, and where
// a printed condition says that the identity component may be abelian.

#include "exact/error.hpp"
#include "family_attack.hpp"
#include "parameter_points.hpp"
#include "strata/domain.hpp"

#include <gmock/gmock.h>

#include <algorithm>

namespace kov::test {
namespace {

using strata::StrataAnswer;
using strata::Stratum;

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
  random_rounds(60, [](Random& random) {
    const Texts leading{"a",     "a*z",   "a*z+b",     "(a-b)*(z^2+1)", "a^2-b",     "a*z^2+a",
                        "1/a",   "a-b",   "sqrt(2)*a", "I*a",           "a-sqrt(2)", "(a^2-2)*z",
                        "a*z+I", "a*I*z", "z/(a-b)",   "sqrt(2)*a+b*z"};
    const Texts others{"z",         "a*z", "a*z^2+b",     "b/z^2",   "a/z^2+a",  "z+b",
                       "sqrt(2)*z", "I*a", "sqrt(2)*a*z", "(a-b)*z", "I*a/z^2+z"};
    const Asked asked{
        "-e", "(" + random.one_of(leading) + ")*y''=(" + random.one_of(others) + ")*y", {"a", "b"}};
    attack(asked, {"a", "b", "a-b", "a^2-b"}, 5, random);
    const ParametricEquation f = asked.family();
    const StrataAnswer a = decide_strata(f.question, little_time());
    SCOPED_TRACE(asked.command());
    if (f.question.generic.empty()) return;
    for (int i = 0; i < 5; ++i) {
      std::vector<MPoly> zero = random.one_of(f.question.generic).not_all_zero;
      for (const Condition& c : f.question.assumptions.conditions) // sqrt(2)^2 = 2
        zero.push_back(c.p);
      const auto point = random_point(f.question, zero, random);
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

// Constants beside the parameters: what is 0 for a = 0 alone is not 0 for all a.
TEST(RandomFamilies, ALeadingCoefficientBesideAlgebraicConstants) {
  struct Known {
    const char* text;
    GroupType group;
  };
  using enum GroupType;
  for (const auto& [text, group] :
       {Known{"a*y''+sqrt(2)*a*z*y=0", SL2}, Known{"I*a*y''+a*y=0", Gm},
        Known{"a*y''+sqrt(-3)*a*z*y=0", SL2}, Known{"a*y''=sqrt(2)*a*y", Gm},
        Known{"a*b*y''=sqrt(2)*I*a*b*z*y", SL2}, Known{"(a-sqrt(2))*y''=(a-sqrt(2))*I*z*y", SL2}}) {
    const Asked asked{"-e", text, {"a", "b"}};
    SCOPED_TRACE(asked.command());
    const auto a = strata::on_domain(decide_strata(asked.family().question, little_time()));
    ASSERT_EQ(a.strata.size(), 1U);
    EXPECT_TRUE(a.strata[0].conditions.empty()) << to_string(a.strata[0].conditions);
    ASSERT_TRUE(a.strata[0].leaf.group);
    EXPECT_EQ(a.strata[0].leaf.group->type, group);
    EXPECT_EQ(a.refusal, "");
  }
}

} // namespace
} // namespace kov::test
