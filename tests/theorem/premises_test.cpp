// A theorem file with one line changed: nothing false is proved, and nothing is proved without its premises.

#include "certify/theorem/check.hpp"
#include "exact/error.hpp"
#include "support/points.hpp"
#include "support/random.hpp"
#include "written.hpp"

#include <gmock/gmock.h>

#include <sstream>

namespace kov {
namespace {

using namespace test;
using testing::HasSubstr;
using testing::StartsWith;

// ---- what a theorem says at a point

bool holds(const Condition& c, const Rational& a) {
  const MFraction value =
      substitute(MFraction(c.p), {{c.p.ring()->index("a"), MFraction(c.p.ring(), a)}});
  const Rational p = to_rational(value);
  switch (c.sign) {
  case Sign::zero:
    return is_zero(p);
  case Sign::nonzero:
    return !is_zero(p);
  case Sign::positive:
    return sign(p) > 0;
  case Sign::nonnegative:
    return sign(p) >= 0;
  default:
    return true;
  }
}
bool holds(const Assumptions& region, const Rational& a) {
  return std::ranges::all_of(region.conditions, [&](const Condition& c) { return holds(c, a); });
}

// "excluded", "integrable", or nothing, by the steps that are proved.
std::set<std::string> said_at(const TheoremResult& r, const Rational& a) {
  std::set<std::string> all;
  for (const NodeResult& n : r.nodes) {
    if (n.node.kind == NodeKind::cover || n.says == Conclusion::none || n.on_trust || n.is_word ||
        n.status != NodeStatus::proved)
      continue;
    const bool there =
        n.regions.empty()
            ? holds(n.region, a)
            : std::ranges::any_of(n.regions, [&](const auto& region) { return holds(region, a); });
    if (there) all.insert(n.says == Conclusion::not_integrable ? "excluded" : "integrable");
  }
  return all;
}

const std::vector<Rational>& points() {
  static const std::vector<Rational> all{
      0, 1, -1, 2, 3, 6, 12, 16, Rational(1, 2), Rational(-7, 3)};
  return all;
}

const std::string cubic = "(u^2 + v^2)/2 + x^2*y + a*y^3/3";
const std::string quartic = "(u^2 + v^2)/2 + x^4 + a*x^2*y^2 + y^4";

const std::vector<Found>& theorems() {
  static const std::vector<Found> all = [] {
    std::vector<Found> found;
    std::size_t k = 0;
    for (const std::string& system :
         {planar(even, axis), planar(cubic, axis), planar(quartic, axis),
          planar("(u^2 + v^2 + x^2 + y^2)/2 + a*x*y", ""),
          planar(even, "[assume]\na = 'positive'\n" + axis),
          planar(even, "[assume]\na = 'real'\n" + axis)})
      found.emplace_back(system, "premises" + std::to_string(k++) + ".toml");
    return found;
  }();
  return all;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> all;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    all.push_back(line);
  return all;
}
std::string text_of(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines)
    text += line + "\n";
  return text;
}

// Unset: the file is refused, with its place.
std::optional<TheoremResult> proved(const std::string& text) {
  try {
    return prove(read_theorem(parse_document(text, own_folder() + "changed.toml")));
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), HasSubstr(".toml"));
    return std::nullopt;
  }
}

void expect_nothing_false(const Found& honest, const TheoremResult& r, const std::string& what) {
  for (const Rational& a : points()) {
    const std::string truth = status_at(honest.c, {{"a", a}});
    for (const std::string& said : said_at(r, a))
      EXPECT_TRUE(said == truth || truth == "open" || truth.empty())
          << said << truth << what << " at a = " << to_string(a);
  }
}

TEST(Premises, AnHonestTheoremSaysWhatTheSearchSays) {
  for (const Found& found : theorems()) {
    const TheoremResult r = prove(found.read());
    expect_nothing_false(found, r, found.text);
    for (const Rational& a : points()) {
      const std::string truth = status_at(found.c, {{"a", a}});
      const bool is_word = truth == "open" || (truth == "excluded" && r.words_of_the_file() > 0);
      EXPECT_TRUE(is_word || truth.empty() || said_at(r, a) == std::set<std::string>{truth})
          << found.text << to_string(a);
    }
  }
}

// A line less is a premise less, or a word less.
TEST(Premises, WithoutALineNothingMoreIsProved) {
  std::map<std::string, TheoremResult> honest;
  random_rounds(40, [&](Random& random) {
    const Found& found = random.one_of(theorems());
    if (!honest.contains(found.text)) honest.emplace(found.text, prove(found.read()));
    const TheoremResult& before = honest.at(found.text);
    auto lines = lines_of(found.text);
    const auto k = random.between(0, static_cast<long>(lines.size()) - 1);
    const std::string line = lines[static_cast<std::size_t>(k)];
    lines.erase(lines.begin() + k);
    const auto r = proved(text_of(lines));
    if (!r || line.empty()) return;
    expect_nothing_false(found, *r, line);
    if (!r->complete()) return;
    EXPECT_TRUE(before.complete()) << line;
    EXPECT_GE(r->trusted_steps().size(), before.trusted_steps().size()) << line;
    EXPECT_EQ(sentence(root(*r).excluded), sentence(root(before).excluded)) << line;
  });
}

// A number, a sign or a letter is another one.
TEST(Premises, AChangedLineProvesNothingFalse) {
  const std::vector<std::pair<std::string, std::string>> changes{
      {"0", "1"},      {"1", "2"},   {"2", "3"}, {"+", "-"}, {"-", "+"},       {"!=", "="},
      {"=\"", "!=\""}, {"*u", "*v"}, {"x", "y"}, {"v", "u"}, {" = 0", " = 1"}, {"a", "2*a"}};
  long proved_anyway = 0, asked = 0;
  random_rounds(150, [&](Random& random) {
    const Found& found = random.one_of(theorems());
    auto lines = lines_of(found.text);
    std::string& line =
        lines[static_cast<std::size_t>(random.between(0, static_cast<long>(lines.size()) - 1))];
    const auto& [from, to] = random.one_of(changes);
    const auto value = line.find("= ");
    const auto at = value == std::string::npos ? value : line.find(from, value + 2);
    if (at == std::string::npos || line.starts_with("title") || line.starts_with("system")) return;
    const std::string before = line;
    line.replace(at, from.size(), to);
    const auto r = proved(text_of(lines));
    if (!r) return;
    ++asked;
    proved_anyway += r->complete() ? 1 : 0;
    expect_nothing_false(found, *r, before + " -> " + line);
  });
  EXPECT_LT(proved_anyway, asked);
}

// ---- by hand

std::string node(const std::string& id, const std::string& kind, const std::string& rest) {
  return "[[node]]\nid = \"" + id + "\"\nkind = \"" + kind + "\"\n" + rest;
}
std::string covered_by(const std::vector<std::string>& needs, const std::string& rest = {}) {
  return "system = \"family.toml\"\n" + node("main", "cover", "needs = " + quoted(needs) + "\n") +
         rest;
}
const std::string separable = "[[node.integral]]\nname = \"F\"\nvalue = \"u^2/2 + x^2/2\"\n"
                              "[[node.integral]]\nname = \"G\"\nvalue = \"v^2/2 + y^2/2\"\n";
const std::string not_at_zero =
    node("excluded", "case", "file = \"positive.toml\"\nif = [\"a != 0\"]\n");
const std::string at_zero = node("integrable", "claims",
                                 "file = \"family.toml\"\nwhere = { a = \"0\" }\nat = { a = \"0\" "
                                 "}\nintegrable = true\n" +
                                     separable);
void write_family() {
  write("family.toml",
        planar(even, "[assume]\na = 'real'\nh = 'real'\nconditions = ['a >= 0']\n" + axis));
  write("positive.toml", planar(even, "[assume]\nconditions = ['a > 0']\nh = 'real'\n" + axis));
}

TEST(ByHand, TwoStepsProveWhatNeitherDoes) {
  write_family();
  const TheoremResult both =
      prove(theorem(covered_by({"excluded", "integrable"}, not_at_zero + at_zero)));
  EXPECT_TRUE(both.complete()) << both.conclusion() << root(both).summary;
  EXPECT_THAT(both.statement(), HasSubstr("a = 0"));
  for (const auto& [id, one] : {std::pair("excluded", not_at_zero), {"integrable", at_zero}}) {
    const TheoremResult r = prove(theorem(covered_by({id}, one)));
    EXPECT_FALSE(r.complete()) << one;
    EXPECT_EQ(r.statement(), "") << one;
    EXPECT_THAT(r.conclusion(), StartsWith("NOT PROVED")) << one;
  }
}

// The goal is more than what the steps say.
TEST(ByHand, AGoalThatIsStrongerIsRefused) {
  write_family();
  const std::string whole = covered_by({"excluded", "integrable"}, not_at_zero + at_zero);
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
           {"if = [\"a != 0\"]\n", ""},                         // also of a = 0
           {"if = [\"a != 0\"]\n", "if = [\"a != 1\"]\n"},      // and not of a = 1
           {"where = { a = \"0\" }\nat = { a = \"0\" }\n", ""}, // integrable for all a
           {"at = { a = \"0\" }", "at = { a = \"1\" }"},        // of another value
           {"where = { a = \"0\" }", "where = { a = \"1\" }"},  // shown for another value
           {"u^2/2 + x^2/2", "u^2/2 + y^2/2"},                  // no integral
           {"u^2/2 + x^2/2", "v^2 + y^2"},                      // the other again
           {"u^2/2 + x^2/2", "1"},                              // a constant
           {"file = \"positive.toml\"\nif", "file = \"nothing.toml\"\nif"}, // no such file
           {"kind = \"case\"", "kind = \"open\""}}) {
    std::string text = whole;
    const auto at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    try {
      const TheoremResult r = prove(theorem(text));
      EXPECT_FALSE(r.complete()) << from << to << r.conclusion();
      EXPECT_TRUE(r.words_of_the_file() > 0 || r.statement().empty()) << from << to;
      EXPECT_TRUE(r.words_of_the_file() > 0 || r.bundle.empty()) << from << to;
    } catch (const InputError& e) {
      EXPECT_THAT(e.what(), HasSubstr(".toml")) << from << to;
    }
  }
}

// Regions that touch, overlap, or are written with multiple roots.
TEST(ByHand, ARegionIsItsPoints) {
  write_family();
  const auto with = [](const std::string& excluded) {
    return prove(theorem(
        covered_by({"excluded", "integrable"},
                   node("excluded", "case", "file = \"positive.toml\"\nif = [" + excluded + "]\n") +
                       at_zero)));
  };
  const TheoremResult plain = with("\"a != 0\"");
  for (const std::string same : {"\"a > 0\"", "\"a^2 != 0\"", "\"a^3 > 0\"", "\"3*a != 0\"",
                                 "\"a != 0\", \"a >= 0\"", "\"a*(a + 1) != 0\""}) {
    const TheoremResult r = with(same);
    EXPECT_TRUE(r.complete()) << same << r.conclusion();
    EXPECT_EQ(sentence(root(r).excluded), sentence(root(plain).excluded)) << same;
    EXPECT_EQ(root(r).integrals, root(plain).integrals) << same;
  }
  for (const std::string less : {"\"a > 1\"", "\"a*(a - 1) != 0\"", "\"a != 0\", \"a < 5\"",
                                 "\"a > 0\", \"a < 0\"", "\"(a - 2)^2 > 0\", \"a != 0\""}) {
    const TheoremResult r = with(less);
    EXPECT_FALSE(r.complete()) << less;
    EXPECT_EQ(r.statement(), "") << less;
  }
}

// One step twice, a step more, steps in another order: the same theorem, each trust once.
TEST(ByHand, RepetitionAddsNothing) {
  write_family();
  const TheoremResult plain =
      prove(theorem(covered_by({"excluded", "integrable"}, not_at_zero + at_zero)));
  std::string again = not_at_zero;
  again.replace(again.find("\"excluded\""), 10, "\"again\"");
  const TheoremResult more = prove(
      theorem(covered_by({"integrable", "again", "excluded"}, at_zero + not_at_zero + again)));
  EXPECT_TRUE(more.complete()) << more.conclusion();
  EXPECT_EQ(sentence(root(more).excluded), sentence(root(plain).excluded));
  EXPECT_EQ(root(more).integrals, root(plain).integrals);
  EXPECT_THROW((void)theorem(covered_by({"excluded", "excluded"}, not_at_zero + not_at_zero)),
               InputError);
}

// ---- the certificate

// Another statement, system or class in the certificate: the judge refuses it, or says no more than before.
TEST(Judge, NoChangeOfACertificateProvesMore) {
  std::vector<std::string> bundles;
  for (const Found& found : theorems())
    if (auto r = proved_again(found.read()); !r.bundle.empty())
      bundles.push_back(std::move(r.bundle));
  long refused = 0, accepted_again = 0;
  random_rounds(60, [&](Random& random) {
    const std::string& bundle = random.one_of(bundles);
    std::string text = bundle;
    const auto at = static_cast<std::size_t>(random.between(0, static_cast<long>(text.size()) - 1));
    const std::string signs = "0123456789+-*xyuva";
    const auto place = text.find_first_of(signs, at);
    if (place == std::string::npos) return;
    const char before = text[place];
    text[place] =
        signs[static_cast<std::size_t>(random.between(0, static_cast<long>(signs.size()) - 1))];
    if (text[place] == before) return;
    const auto honest = certify::check_theorem(bundle);
    try {
      const auto judged = certify::check_theorem(text);
      if (!std::holds_alternative<certify::TheoremAccepted>(judged)) {
        ++refused;
        return;
      }
      ++accepted_again;
      const auto& one = std::get<certify::TheoremAccepted>(honest);
      const auto& other = std::get<certify::TheoremAccepted>(judged);
      EXPECT_GE(other.open + other.trusted, one.open + one.trusted)
          << text.substr(place < 60 ? 0 : place - 60, 120);
    } catch (const Error&) {
      ++refused;
    }
  });
  EXPECT_GT(refused, accepted_again);
}

// ---- what a symmetry is said to have carried

// Nothing was carried here, whatever the node says.  Without a certificate that is a step on trust; the certificate has
// no image, studies the curve, and has none.
TEST(Carried, WithoutACertificateIsOnTrust) {
  const Found found(planar("(u^2 + v^2)/2 + x^2*y + a*y^3/3", axis), "carried.toml");
  Theorem t = found.theorem();
  std::size_t carried = 0;
  for (TheoremNode& n : t.nodes)
    if (n.kind == NodeKind::case_file && !n.found.studies.empty()) {
      n.found.studies.clear();
      n.found.carried = true;
      ++carried;
    }
  ASSERT_GT(carried, 0U);
  ProveOptions options;
  options.found = true;
  const TheoremResult with = prove(t, options);
  options.with_bundle = false;
  const TheoremResult without = prove(t, options);
  const auto is_moved = [](const std::string& step) {
    return step.find("moved by a symmetry") != std::string::npos;
  };
  const auto steps = without.trusted_steps();
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count_if(steps, is_moved)), carried);
  ASSERT_FALSE(with.bundle.empty()) << with.no_bundle;
  EXPECT_LT(with.trusted_steps().size(), without.trusted_steps().size());
  EXPECT_TRUE(std::ranges::none_of(with.trusted_steps(), is_moved));
}

} // namespace
} // namespace kov
