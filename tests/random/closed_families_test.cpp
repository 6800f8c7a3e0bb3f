// Closed answers with parameters against the solver without them, group included: members of each
// classical family whose own numbers are given, so that conditions hold identically, behind changes
// of variable with parameters.

#include "closed/kimura.hpp"
#include "exact/error.hpp"
#include "family_attack.hpp"
#include "strata/domain.hpp"
#include "strata/words.hpp"

#include <algorithm>
#include <functional>

namespace kov::test {
namespace {

using strata::Question;
using strata::Stratum;

std::string squared(const std::string& x) { return "(" + x + ")^2"; }

// R(x) as text, in z.
using Family = std::function<std::string(Random&)>;

std::string lame(Random& random) {
  const Texts degrees{"1/4", "3/4", "1/10", "3/10", "1/6", "5/6", "7/10", "5/4",
                      "1/2", "3/2", "0",    "1",    "2",   "1/3", "-1/2", "a"};
  struct Curve {
    std::string b, g2, g3;
  };
  const std::vector<Curve> curves{{"0", "0", "c"}, {"0", "0", "1"},       {"0", "c", "0"},
                                  {"0", "1", "0"}, {"c", "4/3*c^2", "1"}, {"c", "0", "1"},
                                  {"0", "c", "b"}};
  const std::string n = random.one_of(degrees);
  const auto& [b, g2, g3] = random.one_of(curves);
  return replaced("24*z/(4*F) - 3*(12*z^2-G)^2/(16*F^2) + (A*z+B)/F",
                  {{'F', "4*z^3-(" + g2 + ")*z-(" + g3 + ")"},
                   {'G', g2},
                   {'A', "(" + n + ")*(" + n + "+1)"},
                   {'B', b}});
}

// A row of the table with shifts, or numbers that are reducible, dihedral, or nothing.
std::string riemann_with_numbers(Random& random) {
  const auto& row = random.one_of(schwarz_classes());
  std::vector<std::string> x;
  for (const Rational& e : row.exponents)
    x.push_back(to_string(e + Rational(2 * random.between(0, 1))));
  if (random.once_in(3))
    for (std::string& e : x)
      e = random.one_of(Texts{"1", "2", "3", "1/2", "3/2", "1/3", "a", "2*a+1/2"});
  std::shuffle(x.begin(), x.end(), random.bits());
  return replaced(riemann, {{'P', squared(x[0])}, {'Q', squared(x[1])}, {'R', squared(x[2])}});
}

const Texts halves{"1/2", "1", "3/2", "0", "-1/2", "2", "5/2", "1/3", "1/4", "a", "a+1/2", "2*a"};

std::string confluent(Random& random) {
  const std::string p = random.one_of(halves), q = random.one_of(halves);
  return replaced(random.one_of(Texts{"1/4-P/z+(Q-1/4)/z^2", "1+(Q-1/4)/z^2", "1/z+(Q-1)/(4*z^2)",
                                      "(Q-1)/(4*z^2)", "-1/4-(P)*I/z+(Q-1/4)/z^2"}),
                  {{'P', p}, {'Q', squared(q)}});
}

std::string polynomial(Random& random) {
  const Texts all{"z",     "z^2+P",   "z^2/4-P-1/2", "1",     "z^3",
                  "z^4+P", "z^2+2*P", "z^4+2*P*z",   "P*z+1", "z^4+z^2+P*z"};
  return replaced(random.one_of(all), {{'P', random.one_of(halves)}});
}

// r(z) = x'^2 R(x) - S(x)/2
std::string pulled_back(const std::string& r, Random& random) {
  const auto at = [&](const std::string& x) { return "(" + replaced(r, {{'z', x}}) + ")"; };
  switch (random.between(1, 6)) {
  case 1:
    return "c^2*" + at("c*z+b");
  case 2:
    return "c^2*" + at("c*z");
  case 3:
    return "z^(-4)*" + at("1/z");
  case 4:
    return "c^2/(z-b)^4*" + at("c/(z-b)");
  case 5:
    return "4*c^2*z^2*" + at("c*z^2") + "+3/(4*z^2)";
  default:
    return r;
  }
}

TEST(ClosedFamilies, GiveTheGroupsOfThePointwiseSolver) {
  compared = 0;
  random_rounds(72, [](Random& random) {
    const std::vector<Family> families{lame, lame, riemann_with_numbers, confluent, polynomial};
    const Asked asked{
        "-r", pulled_back(random.one_of(families)(random), random), {"a", "b", "c"}, {}};
    attack(asked, {"a-1/2", "2*a-1", "a-1", "a-1/4", "c-2", "c^2+1", "b"}, 4, random);
  });
  report();
}

// c is a scale alone: for c != 0 the group is that at c = 1, and it is told.
TEST(ClosedFamilies, FiniteGroupsOfLameForAllParameters) {
  struct Known {
    std::string alpha, f; ///< n(n+1), f and f'/2
    std::string slope;
    GroupType group;
  };
  using enum GroupType;
  for (const auto& [alpha, f, slope, group] :
       {Known{"5/16", "4*z^3-c", "6*z^2", S4}, Known{"11/100", "4*z^3-c", "6*z^2", A5},
        Known{"7/36", "4*z^3-c^2*z", "6*z^2-c^2/2", S4}}) {
    const Asked asked{"-e", "(" + f + ")*y''+(" + slope + ")*y'-" + alpha + "*z*y=0", {"c"}, {}};
    SCOPED_TRACE(asked.command());
    const auto a = decide_strata(asked.family().question, little_time());
    const auto general = std::find_if(a.strata.begin(), a.strata.end(), [](const Stratum& s) {
      return s.conditions.size() == 1 && s.conditions[0].sign == Sign::nonzero;
    });
    ASSERT_NE(general, a.strata.end());
    EXPECT_EQ(general->leaf.abelian, Truth::yes);
    ASSERT_TRUE(general->leaf.group);
    EXPECT_EQ(general->leaf.group->type, group);
    Random random(1);
    attack(asked, {"c"}, 4, random);
  }
}

// Does some point of the stratum satisfy its arithmetic conditions?  One parameter a.
bool has_point(const Stratum& s, const Question& q) {
  const std::size_t a = q.r.ring()->index("a");
  const auto admitted = [&](const NfElem& v) {
    const auto at = [&](const MFraction& f) {
      if (is_zero(f)) return NfElem(0);
      const RationalFunction g = to_rational_function(f, a); // a in the place of z
      return evaluate(g.num(), v) / evaluate(g.den(), v);
    };
    const auto holds = [&](const Condition& c) {
      const bool zero = is_zero(at(MFraction(c.p)));
      return c.sign == Sign::zero ? zero : !zero;
    };
    try {
      return std::all_of(s.conditions.begin(), s.conditions.end(), holds) &&
             std::all_of(s.arithmetic.begin(), s.arithmetic.end(),
                         [&](const Statement& c) { return is_so(c, at); });
    } catch (const DomainError&) {
      return false;
    }
  };
  const NfElem root = NfElem::generator(make_field({-2, 0, 1}, "w"));
  if (admitted(root) || admitted(root + NfElem(Rational(1, 2)))) return true;
  for (const long d : {2, 12, 60, 36, 7})
    for (long n = -8 * d; n <= 8 * d; ++n) {
      const NfElem v(Rational(n, d));
      if (admitted(v) || (n > 0 && admitted(v * v))) return true;
    }
  return false;
}

TEST(ClosedFamilies, APartThatIsPrintedHasPoints) {
  int parts = 0;
  random_rounds(80, [&](Random& random) {
    const Texts numbers{"a",   "a+1/2", "a+1", "2*a", "a/2", "a-1/3",
                        "1-a", "1",     "2",   "1/2", "3",   "0"};
    const std::string l = random.one_of(numbers), m = random.one_of(numbers),
                      n = random.one_of(numbers);
    const Texts equations{
        replaced(riemann, {{'P', squared(l)}, {'Q', squared(m)}, {'R', squared(n)}}),
        replaced(riemann, {{'P', squared(l)}, {'Q', squared(m)}, {'R', squared(n)}}),
        replaced(riemann, {{'P', squared(random.one_of(Texts{"1", "2", "1/2", "0", "3"}))},
                           {'Q', "a"},
                           {'R', random.one_of(Texts{"a", "4*a", "1/4", "1"})}}),
        replaced("1/4-P/z+(Q-1/4)/z^2", {{'P', l}, {'Q', squared(m)}}),
        replaced("1+(Q-1/4)/z^2", {{'Q', squared(m)}}),
        replaced("z^4+P*z+Q", {{'P', l}, {'Q', m}})};
    const Asked asked{"-r", random.one_of(equations), {"a"}, {}};
    SCOPED_TRACE(asked.command());
    const ParametricEquation f = asked.family();
    const auto used = used_variables(f.question.r);
    if (std::find(used.begin(), used.end(), f.question.r.ring()->index("a")) == used.end()) return;
    const auto a = strata::on_domain(decide_strata(f.question, little_time()));
    for (const Stratum& s : a.told_apart()) {
      ++parts;
      std::string where;
      for (const std::string& c : condition_texts(s))
        where += "[" + c + "] ";
      EXPECT_TRUE(has_point(s, f.question)) << where << reason(s.leaf);
    }
  });
  ::testing::Test::RecordProperty("parts", parts);
}

} // namespace
} // namespace kov::test
