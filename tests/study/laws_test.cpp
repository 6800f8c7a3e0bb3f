// Laws of `study` on small systems: a family and its members, one question in other words, more that is
// assumed, and where there is nothing to say.

#include "exact/error.hpp"
#include "study/study.hpp"
#include "support/points.hpp"
#include "support/random.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace kov::study::laws_test {
namespace {

using test::Random;
using test::random_rounds;
using test::status_at;
using testing::AnyOf;

const std::string axis =
    "[[manifold]]\nname = 'N'\nequations = ['x = 0', 'u = 0']\nlevel = ['H = h']\n";
const std::string even = "(u^2 + v^2 + x^2 + y^2)/2 + a*x^2*y^2";

std::string planar(const std::string& hamiltonian, const std::string& more = axis) {
  return "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
         "parameters = ['a', 'h']\nhamiltonian = '" +
         hamiltonian + "'\n" + more;
}
std::string under(const std::string& assumed, const std::string& hamiltonian = even) {
  return planar(hamiltonian, "[assume]\n" + assumed + "\n" + axis);
}

SystemStudy asked(const std::string& text, const ParameterValues& set = {}) {
  return study(parse_document(text, "laws.toml"), set);
}
Verdict verdict(const std::string& text, const ParameterValues& set = {}) {
  return asked(text, set).headline.verdict;
}

// All of the headline, as an answer tells it.
std::string told(const Headline& h) {
  return to_string(h.verdict) + ", " + sentence(h.excluded) + ", " + std::to_string(h.trusted) +
         " on trust, " + std::to_string(h.unchecked) + " not checked" +
         (h.complete ? "" : ", not complete");
}
std::string told(const std::string& text) { return told(asked(text).headline); }

// Where the first manifold of the family excludes.
SystemClassification excluded_by_family(const std::string& text) {
  FileStudy family(parse_document(text, "laws.toml"), {});
  return family.together({0}, {});
}

// With values at which something else may hold.
struct Family {
  std::string text;
  std::vector<Rational> special;
};
const std::vector<Family>& families() {
  static const std::vector<Family> all{
      {planar("(u^2 + v^2)/2 + x^2*y + a*y^3/3"), {0, 1, 6, 2}},
      {planar("(u^2 + v^2)/2 + x^4 + a*x^2*y^2 + y^4"), {0, 2, 6}},
      {planar(even), {0, 1}},
      {planar("(u^2 + v^2 + x^2 + (a - 1)*(a + 2)*x^2*y^2 + y^2)/2"), {1, -2, 0}},
      {planar("(u^2 + v^2 + y^2)/2 + a^2*x^2 + (a^2 - 4)*x^2*y"), {2, -2, 0}},
      {planar("(u^2 + v^2)/2 + a*x^2/y^2 + x^4"), {0, Rational(3, 8)}},
      {planar(even,
              "[[manifold]]\nname = 'N'\nequations = ['x = y', 'u = v']\nlevel = ['H = h']\n"),
       {0, -1}}};
  return all;
}

void expect_agreement(const std::string& family, const SystemClassification& c,
                      const Rational& value) {
  const std::string here = status_at(c, {{"a", value}});
  const Verdict member = verdict(family, {{"a", to_string(value)}});
  EXPECT_THAT(here, AnyOf("excluded", "open")) << "a = " << to_string(value) << '\n' << family;
  EXPECT_EQ(here == "excluded", member == Verdict::non_integrable)
      << "a = " << to_string(value) << ": " << here << ", " << to_string(member) << '\n'
      << family;
}

TEST(FamilyLaws, AFamilyAgreesWithItsMembers) {
  for (const Family& family : families()) {
    const SystemClassification c = excluded_by_family(family.text);
    for (const Rational& value : family.special)
      expect_agreement(family.text, c, value);
  }
}

TEST(FamilyLaws, AFamilyAgreesWithItsMembersAtRandomValues) {
  random_rounds(3, [](Random& random) {
    const Family& family = random.one_of(families());
    const SystemClassification c = excluded_by_family(family.text);
    for (int k = 0; k < 2; ++k)
      expect_agreement(family.text, c, Rational(random.between(-30, 30), random.between(1, 12)));
  });
}

// One level that excludes is enough for the family; no level says the contrary.
TEST(FamilyLaws, ALevelIsNoParameter) {
  const std::string family = planar("(u^2 + v^2)/2 + x^4 + y^4 + a*x^2*y^2");
  for (const std::string a : {"5", "1"}) {
    const Verdict whole = verdict(family, {{"a", a}});
    for (const std::string h : {"1", "-2/3"})
      EXPECT_EQ(verdict(family, {{"a", a}, {"h", h}}), whole) << a << ' ' << h;
  }
}

// The letter of the level stands in H as well: then it may not be chosen.
TEST(FamilyLaws, AParameterThatIsALevelIsNotChosen) {
  const std::string text = planar("(u^2 + v^2 + x^2 + y^2)/2 + h*x^2*y^2");
  const SystemStudy all = asked(text);
  EXPECT_EQ(all.headline.verdict, Verdict::depends);
  const SystemClassification c = excluded_by_family(text);
  EXPECT_EQ(status_at(c, {{"h", 0}}), "open") << "two oscillators";
  EXPECT_EQ(status_at(c, {{"h", 1}}), "excluded");
  EXPECT_NE(verdict(text, {{"h", "0"}}), Verdict::non_integrable);
  EXPECT_EQ(verdict(text, {{"h", "1"}}), Verdict::non_integrable);
}

// ---- other words

// Names of one letter; keys and words are longer.
std::string renamed(const std::string& text, const std::string& from, const std::string& to) {
  const auto is_letter = [&](std::size_t i) {
    return i < text.size() && (std::isalnum(static_cast<unsigned char>(text[i])) != 0);
  };
  std::string result = text;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (const auto at = from.find(text[i]);
        at != std::string::npos && !is_letter(i + 1) && (i == 0 || !is_letter(i - 1)))
      result[i] = to[at];
  return result;
}

TEST(OtherWords, NamesAreNoMatter) {
  for (std::size_t k = 0; k < families().size(); k += 2) {
    const std::string& family = families()[k].text;
    const std::string plain = told(family);
    for (const std::string names : {"yxvuha", "uvxyah", "zwtnms"}) {
      const std::string other = renamed(family, "xyuvah", names);
      EXPECT_EQ(renamed(told(other), names, "xyuvah"), plain) << other;
    }
  }
}

TEST(OtherWords, TheOrderOfEquationsAndNamesIsNoMatter) {
  for (const std::string assumed : {"a = 'real'", "conditions = ['a > 1', 'h > 0']"}) {
    const std::string plain = told(under(assumed));
    for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
             {"['x = 0', 'u = 0']", "['u = 0', 'x = 0']"},
             {"['x = 0', 'u = 0']", "['x = 0', 'u = 0', 'x = 0', 'x*y + u = 0']"},
             {"['x = 0', 'u = 0']", "['2*x = 0', '-u/3 = 0']"},
             {"['a', 'h']", "['h', 'a']"},
             {"['x', 'y']\nmomenta = ['u', 'v']", "['y', 'x']\nmomenta = ['v', 'u']"},
             {"['a > 1', 'h > 0']", "['h > 0', 'a > 1']"},
             {"['H = h']", "'H = h'"},
             {"['H = h']", "['h = H']"},
             {"['H = h']", "['2*H = 2*h']"}}) {
      std::string text = under(assumed);
      if (const auto at = text.find(from); at != std::string::npos) {
        EXPECT_EQ(told(text.replace(at, from.size(), to)), plain) << text;
      }
    }
  }
}

// The set counts, and not how often an equation holds there.
TEST(OtherWords, MultiplicitiesOfEquationsAreNoMatter) {
  const std::string plain = told(planar(even));
  for (const std::string equations :
       {"'x^2 = 0', 'u^2 = 0'", "'x^3 = 0', 'u = 0'", "'x^2*(1 + y^2) - x^2*y^2 = 0', 'u = 0'"}) {
    std::string text = planar(even);
    const std::string from = "'x = 0', 'u = 0'";
    EXPECT_EQ(told(text.replace(text.find(from), from.size(), equations)), plain) << text;
  }
}

// q -> B q with p -> B^-T p, and another unit of time and energy.
TEST(OtherWords, CanonicalCoordinatesAreNoMatter) {
  random_rounds(6, [](Random& random) {
    const std::string k = "(" + std::to_string(random.between(-3, 3)) + ")";
    const std::string m = std::to_string(random.between(2, 5));
    const std::string a = std::to_string(random.between(-4, 6));
    for (const std::string& potential : {"X^2*Y + " + a + "*Y^3/3", "X^4 + " + a + "*X^2*Y^2 + Y^4",
                                         "Y^2 + X^2*Y^2*(" + a + ")"}) {
      // X = x + k y, Y = m y: p_x = P_X, p_y = k P_X + m P_Y
      std::string moved;
      for (const char c : potential)
        moved += c == 'X' ? "(x + " + k + "*y)" : c == 'Y' ? "(" + m + "*y)" : std::string(1, c);
      std::string plain;
      for (const char c : potential)
        plain += static_cast<char>(std::tolower(c));
      const std::string other = planar("(u^2 + ((v - " + k + "*u)/" + m + ")^2)/2 + " + moved,
                                       "[[manifold]]\nname = 'N'\nequations = ['x + " + k +
                                           "*y = 0', 'u = 0']\nlevel = ['H = h']\n");
      EXPECT_EQ(verdict(other), verdict(planar("(u^2 + v^2)/2 + " + plain))) << other;
    }
  });
}

// ---- more assumed

TEST(Assuming, WhatFollowsChangesNothing) {
  for (const auto& [short_one, long_ones] :
       std::vector<std::pair<std::string, std::vector<std::string>>>{
           {"conditions = ['a > 1']",
            {"conditions = ['a > 1', 'a > 0']", "conditions = ['a != 0', 'a > 1']",
             "conditions = ['a > 1', 'a^2 > 1', '2*a > 1']", "a = 'real'\nconditions = ['a > 1']"}},
           {"a = 'nonzero'", {"a = 'nonzero'\nconditions = ['a^2 != 0']"}},
           {"conditions = ['a = 3']",
            {"conditions = ['a = 3', 'a^2 = 9']", "conditions = ['a^2 = 9', 'a > 0', 'a = 3']",
             "conditions = ['a != 0', '2*a = 6']"}},
           {"a = 'real'", {"a = 'real'\nconditions = ['a^2 >= 0', 'a^2 + 1 > 0']"}}}) {
    const std::string plain = told(under(short_one));
    for (const std::string& more : long_ones)
      EXPECT_EQ(told(under(more)), plain) << more;
  }
}

// A smaller set of parameters: what was proved of the larger one holds.
TEST(Assuming, MoreLosesNothing) {
  for (const std::string& family : {even, std::string("(u^2 + v^2)/2 + x^4 + a*x^2*y^2 + y^4"),
                                    std::string("(u^2 + v^2)/2 + x^2*y + a*y^3/3")}) {
    std::optional<Headline> before;
    for (const std::string assumed :
         {"", "a = 'real'", "a = 'positive'", "a = 'positive'\nconditions = ['a > 7']",
          "a = 'positive'\nconditions = ['a > 7', 'a < 8']", "conditions = ['a = 15/2']"}) {
      const Headline now = asked(under(assumed, family)).headline;
      if (before && before->verdict == Verdict::non_integrable) {
        EXPECT_EQ(now.verdict, Verdict::non_integrable) << family << '\n' << assumed;
        ASSERT_EQ(now.excluded.size(), 1U);
        EXPECT_EQ(contains(now.excluded.front(), before->excluded.front()), Truth::yes)
            << family << '\n'
            << assumed;
      }
      before = now;
    }
    EXPECT_EQ(before->verdict, Verdict::non_integrable) << family;
  }
}

TEST(Assuming, NothingIsSaidOfAnEmptySet) {
  for (const std::string assumed :
       {"conditions = ['a > 1', 'a < 0']", "conditions = ['a = 1', 'a = 2']",
        "conditions = ['a = 0', 'a != 0']", "a = 'nonzero'\nconditions = ['a^2 = 0']",
        "a = 'real'\nconditions = ['a^2 + 1 = 0']", "a = 'positive'\nconditions = ['a < 0']",
        "a = 'real'\nconditions = ['a^2 < 0']"})
    EXPECT_THROW((void)asked(under(assumed)), InvalidArgument) << assumed;
}

// i and -i are values of a parameter that is not said to be real.
TEST(Assuming, AnEquationWithoutRealPointsHasComplexOnes) {
  EXPECT_EQ(verdict(under("conditions = ['a^2 + 1 = 0']")), Verdict::non_integrable);
  EXPECT_EQ(verdict(under("conditions = ['a^4 + a^2 = 0']")), Verdict::depends) << "0 is another";
  EXPECT_EQ(verdict(under("conditions = ['a^4 + a^2 = 0', 'a != 0']")), Verdict::non_integrable);
}

TEST(Assuming, NoValueIsGivenThatIsExcluded) {
  const std::string text = under("conditions = ['a > 1']");
  EXPECT_THROW((void)asked(text, {{"a", "1"}}), InputError);
  EXPECT_THROW((void)asked(text, {{"a", "-1/2"}}), InputError);
  EXPECT_EQ(verdict(text, {{"a", "3/2"}}), Verdict::non_integrable);
}

// Where a denominator vanishes there is no system.
TEST(Assuming, ADenominatorThatVanishes) {
  const std::string text = planar("(u^2 + v^2 + x^2 + y^2)/2 + x^2*y^2/(a - 1)");
  EXPECT_EQ(verdict(text), Verdict::non_integrable);
  EXPECT_ANY_THROW((void)asked(text, {{"a", "1"}}));
  const std::string common = planar("(u^2 + v^2 + x^2 + y^2)/2 + a*x^2*y^2/(a^2 - a)");
  EXPECT_NE(verdict(common, {{"a", "2"}}), Verdict::no_obstruction);
}

// ---- several manifolds

std::string both(const std::string& first, const std::string& second) {
  const auto block = [](const std::string& name) {
    const bool x = name == "N";
    return "[[manifold]]\nname = '" + name + "'\nequations = [" +
           (x ? "'x = 0', 'u = 0'" : "'y = 0', 'v = 0'") + "]\nlevel = ['H = h']\n";
  };
  return planar("(u^2 + v^2 + x^2 + y^2)/2 + a*x^2*y^4 + (a - 1)*x^4*y^2",
                block(first) + (second.empty() ? "" : block(second)));
}

// N excludes but for a = 0, M but for a = 1: no value is left.
TEST(SeveralManifolds, ExcludeTogether) {
  for (const std::string one : {"N", "M"})
    EXPECT_EQ(verdict(both(one, "")), Verdict::depends) << one;
  const SystemStudy together = asked(both("N", "M"));
  EXPECT_EQ(together.headline.verdict, Verdict::non_integrable);
  ASSERT_TRUE(together.together);
  EXPECT_EQ(together.together->status(), Verdict::non_integrable);
  for (const auto& [value, by] : {std::pair("0", "M"), std::pair("1", "N")}) {
    const SystemStudy member = asked(both("N", "M"), {{"a", value}});
    EXPECT_EQ(member.headline.verdict, Verdict::non_integrable) << value;
    for (const CurveStudy& m : member.manifolds)
      EXPECT_EQ(m.headline.verdict == Verdict::non_integrable, m.name() == by) << value;
  }
}

TEST(SeveralManifolds, TheirOrderIsNoMatter) {
  const SystemStudy one = asked(both("N", "M")), other = asked(both("M", "N"));
  EXPECT_EQ(one.headline.verdict, other.headline.verdict);
  EXPECT_EQ(one.headline.trusted, other.headline.trusted);
  for (const long a : {0, 1, 3})
    EXPECT_EQ(status_at(*one.together, {{"a", a}}), status_at(*other.together, {{"a", a}}));
  FileStudy backwards(parse_document(both("N", "M"), "laws.toml"), {});
  (void)backwards.manifold(1, {});
  const CurveStudy& first = backwards.manifold(0, {});
  EXPECT_EQ(told(first.headline), told(one.manifolds.at(0).headline));
  const std::size_t steps = backwards.tree().steps.size();
  EXPECT_EQ(&backwards.manifold(0, {}), &first) << "it was kept";
  EXPECT_EQ(backwards.tree().steps.size(), steps) << "and nothing is proved twice";
}

// The same set twice, and one that is not invariant beside one that excludes.
TEST(SeveralManifolds, OneMoreLosesNothing) {
  const std::string once = under("a = 'nonzero'");
  const std::string again = "[[manifold]]\nname = 'again'\nequations = ['u = 0', 'x = 0']\n"
                            "level = ['H = h']\n";
  const std::string wrong = "[[manifold]]\nname = 'wrong'\nequations = ['x = 1', 'u = 0']\n"
                            "level = ['H = h']\n";
  EXPECT_EQ(told(once + again), told(once));
  const Headline beside = asked(once + wrong).headline;
  EXPECT_EQ(beside.verdict, Verdict::non_integrable);
  EXPECT_EQ(beside.refused, 1U);
  EXPECT_EQ(verdict(planar(even, wrong)), Verdict::failed);
}

// ---- less work

// The classes that are excluded, as sentences.
std::set<std::string> classes(const std::string& text, const Budget& budget) {
  FileStudy file(parse_document(text, "laws.toml"), {});
  StudyOptions options;
  options.check.decide.budget = budget;
  const CurveStudy& curve = file.manifold(0, options);
  std::set<std::string> all;
  for (const Exclusion& e : curve.exclusions)
    all.insert(sentence(e.by.integrals));
  return all;
}

// A limit may fall while the leaves around the curve are looked at: what is excluded has a class all the same.
TEST(LessWork, ExcludesTheSameClassesOrThoseOnALeaf) {
  const std::string top =
      "[system]\nkind = 'euler-poisson'\ncoordinates = ['M1', 'M2', 'M3', 'G1', 'G2', 'G3']\n"
      "parameters = ['x', 'h']\nhamiltonian = 'M1^2/2 + M2^2 + 3*M3^2/2 + x*G1'\n"
      "[[manifold]]\nname = 'N'\nequations = ['M1 = 0', 'M2 = 0', 'G3 = 0']\n"
      "level = ['H = h', 'G1^2 + G2^2 + G3^2 = 1']\n";
  const std::string coupled =
      "[system]\nkind = 'hamiltonian'\ncoordinates = ['q1', 'q2', 'q3']\n"
      "momenta = ['p1', 'p2', 'p3']\nparameters = ['h']\n"
      "hamiltonian = 'p1^2/2 + p2*p3 + q1^4/4 + q1^2*q2*q3 + q1^2*q2^2/2'\n"
      "[[manifold]]\nname = 'N'\nequations = ['q2 = 0', 'q3 = 0', 'p2 = 0', 'p3 = 0']\n"
      "level = ['H = h']\n";
  const std::string on_a_leaf = " and independent on the symplectic leaf of the phase curve";
  for (const std::string& text : {top, coupled}) {
    const auto all = classes(text, {});
    ASSERT_THAT(all, testing::SizeIs(1)) << text;
    for (double work = 3e4; work < 3e7; work *= 3) {
      Budget little;
      little.give(work);
      EXPECT_THAT(classes(text, little),
                  testing::Each(AnyOf(*all.begin(), *all.begin() + on_a_leaf)))
          << work;
    }
  }
}

// ---- no false alarm

TEST(NoFalseAlarm, IntegrableSystemsAreNotExcluded) {
  for (const std::string h :
       {"(u^2 + v^2)/2 + x^4 + 6*x^2*y^2 + y^4 + a*(x^2 + y^2)",
        "(u^2 + v^2)/2 + (x^2 + y^2)^2 + a*x^2",
        "(u^2 + v^2)/2 + x^2*y + 16*y^3/3 + a*(x^2 + 16*y^2)/2",
        "(u^2 + v^2)/2 + x^2*y + 2*y^3 + a*x^2", "(u^2 + v^2)/2 + a*x^2 + y^4 - y",
        "(u^2 + v^2)/2 + a/y^2 + x^4 + x^2/2", "(u^2 + v^2)/2 - a/(x^2 + y^2)^2",
        "(u^2 + a*v^2)/2 + x^4 + y^6"}) {
    const SystemStudy found = asked(planar(h));
    EXPECT_THAT(found.headline.excluded, testing::IsEmpty()) << h;
    EXPECT_NE(found.headline.verdict, Verdict::non_integrable) << h;
    for (const std::string a : {"1", "-3/2"})
      EXPECT_NE(verdict(planar(h), {{"a", a}}), Verdict::non_integrable) << h << a;
  }
}

} // namespace
} // namespace kov::study::laws_test
