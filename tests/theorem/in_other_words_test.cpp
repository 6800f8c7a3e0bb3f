// One theorem in other words: other letters, coordinates in another order, another parameter, more that is assumed.  A
// search, the theorem that it writes, and its certificate say the same of the same values.

#include "certify/theorem/check.hpp"
#include "exact/error.hpp"
#include "support/points.hpp"
#include "support/random.hpp"
#include "written.hpp"

#include <gmock/gmock.h>

#include <functional>
#include <map>

namespace kov {
namespace {

using namespace test;
using testing::HasSubstr;

using Letters = std::map<std::string, std::string>;

std::string in_letters(const std::string& formula, const Letters& letters) {
  std::string text;
  for (std::size_t i = 0; i < formula.size();) {
    std::size_t j = i;
    while (j < formula.size() &&
           (std::isalnum(static_cast<unsigned char>(formula[j])) != 0 || formula[j] == '_'))
      ++j;
    const std::string word = formula.substr(i, std::max<std::size_t>(j - i, 1));
    const auto other = letters.find(word);
    text += other == letters.end() ? word : other->second;
    i += word.size();
  }
  return text;
}

// One parameter; values of it at which it is asked.
struct Family {
  std::string hamiltonian; ///< in x, y, u, v, a
  std::vector<Rational> values;
};
const std::vector<Family>& families() {
  static const std::vector<Family> all{
      {"(u^2 + v^2)/2 + x^2*y + a*y^3/3", {0, 1, 2, 3, 6, 16, Rational(1, 2)}},
      {"(u^2 + v^2)/2 + x^4 + a*x^2*y^2 + y^4", {0, 1, 2, 3, 6, 12, -2}},
      {"(u^2 + v^2 + x^2 + y^2)/2 + a*x^2*y^2", {0, 1, -1, Rational(1, 3)}},
      {"(u^2 + v^2)/2 + a*x^2 + x^2*y + 2*y^3", {0, 1, -1, Rational(5, 2)}},
      {"(u^2 + a*v^2)/2 + x^2/2 + y^2/2 + x*y^2", {0, 1, -1, 4}}};
  return all;
}

struct Text {
  std::string hamiltonian;
  std::vector<std::string> coordinates = {"x", "y"}, momenta = {"u", "v"}, parameters = {"a"};
  std::string more = {};
  operator std::string() const { // NOLINT: it is one
    return "[system]\nkind = 'hamiltonian'\ncoordinates = " + quoted(coordinates) +
           "\nmomenta = " + quoted(momenta) + "\nparameters = " + quoted(parameters) +
           "\nhamiltonian = '" + hamiltonian + "'\n" + more;
  }
};

// All that is said: by the search, by the theorem of its text, by the judge.
struct Answer {
  Found found;
  TheoremResult theorem;

  explicit Answer(const std::string& system)
      : found(system, "found.toml", 5e8), theorem(proved_again(found.read())) {
    EXPECT_TRUE(theorem.complete_but_for_open_parts()) << system << theorem.conclusion();
    if (theorem.bundle.empty()) return;
    const auto judged = certify::check_theorem(theorem.bundle);
    const auto* accepted = std::get_if<certify::TheoremAccepted>(&judged);
    EXPECT_NE(accepted, nullptr) << system;
    if (accepted == nullptr) return;
    EXPECT_EQ(accepted->open, theorem.bundle_open) << system;
    EXPECT_EQ(accepted->trusted, theorem.trusted_steps().size()) << system;
  }
  [[nodiscard]] std::vector<std::string> statuses(const std::string& parameter,
                                                  const std::vector<Rational>& values) const {
    std::vector<std::string> all;
    for (const Rational& value : values)
      all.push_back(status_at(found.c, {{parameter, value}}));
    return all;
  }
  [[nodiscard]] std::size_t on_trust() const { return theorem.trusted_steps().size(); }
};

std::string status_at(const Answer& answer, const std::string& parameter, const Rational& value) {
  return test::status_at(answer.found.c, {{parameter, value}});
}
// Nothing is said of a value that is not decided.
void expect_no_contradiction(const std::string& one, const std::string& other,
                             const std::string& why) {
  if (one == "open" || other == "open") return;
  EXPECT_EQ(one, other) << why;
}

const Answer& plain(const Family& family) {
  static std::map<std::string, Answer> all;
  return all.try_emplace(family.hamiltonian, Text{family.hamiltonian}).first->second;
}

// ---- letters

// Also letters that the program gives to what it finds.
TEST(InOtherLetters, TheTheoremIsTheSame) {
  const std::vector<Letters> letters{
      {{"x", "q1"}, {"y", "q2"}, {"u", "p1"}, {"v", "p2"}, {"a", "lambda"}},
      {{"x", "z"}, {"y", "w"}, {"u", "x"}, {"v", "y"}, {"a", "kappa"}},
      {{"x", "kappa"}, {"y", "c1"}, {"u", "s"}, {"v", "r"}, {"a", "root1"}},
      {{"x", "u"}, {"y", "v"}, {"u", "x"}, {"v", "y"}, {"a", "n"}},
      {{"x", "theta"}, {"y", "F1"}, {"u", "L1"}, {"v", "G"}, {"a", "mu"}},
      {{"x", "N"}, {"y", "H1"}, {"u", "Q"}, {"v", "delta"}, {"a", "h"}}};
  random_rounds(8, [&](Random& random) {
    const Family& family = random.one_of(families());
    const Letters& l = random.one_of(letters);
    const Answer& one = plain(family);
    const Answer other(Text{in_letters(family.hamiltonian, l),
                            {l.at("x"), l.at("y")},
                            {l.at("u"), l.at("v")},
                            {l.at("a")}});
    EXPECT_EQ(other.statuses(l.at("a"), family.values), one.statuses("a", family.values));
    EXPECT_EQ(other.theorem.nodes.size(), one.theorem.nodes.size());
    EXPECT_EQ(other.on_trust(), one.on_trust());
    EXPECT_EQ(other.theorem.bundle.empty(), one.theorem.bundle.empty());
    EXPECT_EQ(sentence(root(other.theorem).excluded), sentence(root(one.theorem).excluded));
  });
}

// ---- order of the coordinates

TEST(InAnotherOrder, TheTheoremIsTheSame) {
  for (const Family& family : families()) {
    const Answer& one = plain(family);
    const Answer listed(Text{family.hamiltonian, {"y", "x"}, {"v", "u"}});
    const Answer exchanged(
        Text{in_letters(family.hamiltonian, {{"x", "y"}, {"y", "x"}, {"u", "v"}, {"v", "u"}})});
    for (const Answer* other : {&listed, &exchanged}) {
      EXPECT_EQ(other->statuses("a", family.values), one.statuses("a", family.values))
          << family.hamiltonian;
      EXPECT_EQ(other->on_trust(), one.on_trust()) << family.hamiltonian;
      EXPECT_EQ(sentence(root(other->theorem).excluded), sentence(root(one.theorem).excluded));
    }
  }
}

// (x, u) -> (-x, -u), time backwards, H and 3 H.
TEST(InAnotherOrder, SignsAndAFactorOfHChangeNothing) {
  random_rounds(6, [&](Random& random) {
    const Family& family = random.one_of(families());
    const std::string h =
        random.one_of(std::vector{in_letters(family.hamiltonian, {{"x", "(-x)"}, {"u", "(-u)"}}),
                                  in_letters(family.hamiltonian, {{"u", "(-u)"}, {"v", "(-v)"}}),
                                  "3*(" + family.hamiltonian + ")"});
    EXPECT_EQ(Answer(Text{h}).statuses("a", family.values),
              plain(family).statuses("a", family.values))
        << h;
  });
}

// ---- another parameter

// a = f(b): at b it is the system of f(b), whatever the multiplicity of f - f(b).
TEST(OfAnotherParameter, ItIsTheSystemOfItsValue) {
  struct Change {
    std::string text;
    std::function<Rational(const Rational&)> f;
  };
  const std::vector<Change> changes{
      {"(2*b - 1)", [](const Rational& b) { return Rational(2) * b - Rational(1); }},
      {"b^2", [](const Rational& b) { return b * b; }},
      {"(b - 1)^2", [](const Rational& b) { return (b - Rational(1)) * (b - Rational(1)); }},
      {"(b^3 - b)", [](const Rational& b) { return b * b * b - b; }},
      {"(6 - b)", [](const Rational& b) { return Rational(6) - b; }},
      {"(1/b)", [](const Rational& b) { return Rational(1) / b; }}};
  random_rounds(8, [&](Random& random) {
    const Family& family = random.one_of(families());
    const Change& change = random.one_of(changes);
    const Answer& one = plain(family);
    const Answer other(
        Text{in_letters(family.hamiltonian, {{"a", change.text}}), {"x", "y"}, {"u", "v"}, {"b"}});
    for (const Rational& b : {Rational(1), Rational(2), Rational(-1), Rational(1, 6),
                              Rational(7, 2), Rational(-2), Rational(5)})
      expect_no_contradiction(status_at(other, "b", b), status_at(one, "a", change.f(b)),
                              family.hamiltonian + change.text + to_string(b));
  });
}

// A parameter that the system does not have divides nothing.
TEST(OfAnotherParameter, AnIdleOneIsFree) {
  const Family& family = families().front();
  const Answer other(Text{family.hamiltonian, {"x", "y"}, {"u", "v"}, {"a", "b"}});
  EXPECT_EQ(other.statuses("a", family.values), plain(family).statuses("a", family.values));
  EXPECT_EQ(other.theorem.statement().find('b'), plain(family).theorem.statement().find('b'));
}

// ---- what is assumed

std::string under(const std::string& assumed) { return "[assume]\n" + assumed + "\n"; }

// What holds for complex values holds for real ones and for some of them.
TEST(UnderAssumptions, NothingIsLost) {
  struct Assumed {
    std::string text;
    std::function<bool(const Rational&)> holds;
  };
  const std::vector<Assumed> all{
      {"a = 'real'", [](const Rational&) { return true; }},
      {"a = 'positive'", [](const Rational& a) { return sign(a) > 0; }},
      {"conditions = ['a >= 1']", [](const Rational& a) { return sign(a - Rational(1)) >= 0; }},
      {"conditions = ['a != 1']", [](const Rational& a) { return !(a == Rational(1)); }},
      {"conditions = ['a^2 > 1']",
       [](const Rational& a) { return sign(a * a - Rational(1)) > 0; }}};
  random_rounds(8, [&](Random& random) {
    const Family& family = random.one_of(families());
    const Assumed& assumed = random.one_of(all);
    const Answer& one = plain(family);
    const Answer other(
        Text{family.hamiltonian, {"x", "y"}, {"u", "v"}, {"a"}, under(assumed.text)});
    for (const Rational& a : family.values) {
      if (!assumed.holds(a)) continue;
      const std::string before = status_at(one, "a", a), here = status_at(other, "a", a);
      EXPECT_TRUE(here == before || before == "open")
          << family.hamiltonian << assumed.text << to_string(a) << before << here;
    }
    EXPECT_LE(other.on_trust(), one.on_trust() + 1) << family.hamiltonian << assumed.text;
  });
}

// An equation leaves its roots, each once, however often it has them.
TEST(UnderAssumptions, AnEquationLeavesItsRoots) {
  struct Equation {
    std::string text;
    std::vector<Rational> roots;
  };
  for (const Equation& equation : {Equation{"a = 1", {1}}, Equation{"(a - 6)^2 = 0", {6}},
                                   Equation{"a^2 = a", {0, 1}}, Equation{"a^3 = 4*a", {0, 2, -2}}})
    for (std::size_t k : {0, 1}) {
      const Family& family = families()[k];
      const Answer other(Text{family.hamiltonian,
                              {"x", "y"},
                              {"u", "v"},
                              {"a"},
                              under("conditions = ['" + equation.text + "']")});
      for (const Rational& a : equation.roots) {
        const std::string before = status_at(plain(family), "a", a),
                          here = status_at(other, "a", a);
        EXPECT_TRUE(here == before || before == "open") << equation.text << before << here;
      }
      EXPECT_EQ(status_at(other, "a", Rational(17)), "") << equation.text;
    }
}

// Of no parameters, nothing is said: neither "integrable" nor "not integrable".
TEST(UnderAssumptions, NothingIsSaidOfTheEmptySet) {
  for (const std::string assumed :
       {"conditions = ['a > 1', 'a < 0']", "conditions = ['a = 1', 'a = 2']",
        "a = 'real'\nconditions = ['a^2 + 1 = 0']", "conditions = ['a != 0', 'a^3 = 0']",
        "a = 'positive'\nconditions = ['a <= 0']", "conditions = ['a > 0', '-a^3 >= 0']"})
    try {
      const Answer other(
          Text{families().front().hamiltonian, {"x", "y"}, {"u", "v"}, {"a"}, under(assumed)});
      for (const ClassifiedStratum& s : other.found.c.strata)
        ADD_FAILURE() << assumed << to_string(s.status);
      EXPECT_EQ(other.theorem.statement(), "") << assumed;
    } catch (const Error& e) {
      EXPECT_THAT(std::string(e.what()), HasSubstr("assum")) << assumed;
    }
}

// ---- multiplicities of H

// The system does not know how its Hamiltonian was written.
TEST(WrittenOtherwise, TheTheoremIsTheSame) {
  const std::string h = "(u^2 + v^2)/2 + x^4 + a*x^2*y^2 + y^4";
  const std::vector<Rational>& values = families()[1].values;
  const auto one = plain(families()[1]).statuses("a", values);
  for (const std::string& other :
       {std::string("u^2/2 + v^2/2 + (x^2 + y^2)^2 + (a - 2)*x^2*y^2"),
        std::string("(u + v)^2/4 + (u - v)^2/4 + x^4 + y^4 + a*(x*y)^2"),
        "(a*" + ("(" + h + ")") + " + " + h + ")/(a + 1)", h + " + a^2 + 1"}) {
    const Answer answer(Text{other});
    for (std::size_t k = 0; k < values.size(); ++k)
      EXPECT_EQ(status_at(answer, "a", values[k]), one[k]) << other << to_string(values[k]);
  }
}

} // namespace
} // namespace kov
