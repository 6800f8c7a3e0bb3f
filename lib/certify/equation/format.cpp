// Certificate <-> JSON: each rule has one function that lists its keys in the order of
// docs/theory/certificates.md.

#include "certify/equation/certificate.hpp"
#include "exact/error.hpp"
#include "proof/text/fields.hpp"
#include "proof/text/limits.hpp"

namespace kov::certify {

namespace {

constexpr Words<10> rule_words{"local",       "exponential",  "invariant",        "no-exponential",
                               "p-curvature", "no-invariant", "torsion-function", "good-reduction",
                               "conclude",    "apply-theorem"};
constexpr Words<3> no_exponential_words{"parity", "degree", "series"};
constexpr Words<2> no_invariant_words{"degree", "series"};

/// The number of a place, or "infinity".
struct PlaceNumber {
  static void read(const Node& n, std::optional<long>& x, NoSetting&) {
    if (n.text() != "infinity") x = n.count();
  }
  static Json write(const std::optional<long>& x, NoSetting&) {
    return {x ? std::to_string(*x) : "infinity"};
  }
};

} // namespace

void read_entry(const Node& n, Field& x, NoSetting&) { x = read_field(n); }
Json write_entry(const Field& x, NoSetting&) { return to_json(*x); }

template <class IO> void describe(IO& io, In<IO, LogWitness>& x) {
  describe(io, x.prime);
  io.unless_empty("roots", x.roots, Each<Residue>{});
}
template <class IO> void describe(IO& io, In<IO, LocalPlace>& x) {
  io("q", x.q)("order", x.order)("delta2", x.delta2)("eps2", x.eps2);
  io("irrational", x.irrational)("log", x.log)("annihilator", x.annihilator);
}
template <class IO> void describe(IO& io, In<IO, Local>& x) {
  io("prime", x.prime)("places", x.places);
  io.object("infinity", [&](auto& o) {
    o("eps2", x.infinity_eps2)("log", x.infinity_log)("annihilator", x.infinity_annihilator);
  });
}
template <class IO> void describe(IO& io, In<IO, Exponential>& x) {
  io("p", x.p)("num", x.num)("den", x.den);
}
template <class IO> void describe(IO& io, In<IO, InvariantFactor>& x) { io("q", x.q)("e", x.e); }
template <class IO> void describe(IO& io, In<IO, Invariant>& x) {
  io("prime", x.prime)("m", x.m)("p", x.p)("factors", x.factors);
}
template <class IO> void describe(IO& io, In<IO, ApproximantLine>& x) {
  io("length", x.length)("approximant", x.approximant, Each<Residue>{});
}
template <class IO> void describe(IO& io, In<IO, BySeries>& x) {
  io.always("place", x.place, PlaceNumber{});
  describe(io, x.prime);
  io("root", x.root, Residue{})("delta", x.delta, Residue{})("terms", x.terms)("lines", x.lines);
}
template <class IO> void describe(IO& io, In<IO, NoExponential>& x) {
  io.one_of("by", x.by, no_exponential_words);
}
template <class IO> void describe(IO& io, In<IO, PCurvature>& x) {
  describe(io, x.prime);
  io("shows", x.shows);
}
template <class IO> void describe(IO& io, In<IO, RankModP>& x) {
  describe(io, x.prime);
  io("x0", x.x0, Residue{})("terms", x.terms);
}
template <class IO> void describe(IO& io, In<IO, NoInvariant>& x) {
  io("m", x.m).one_of("by", x.by, no_invariant_words);
}
template <class IO> void describe(IO& io, In<IO, NotAPower>& x) {
  io("l", x.l);
  describe(io, x.prime);
  io("w", x.w, Residue{})("x1", x.x1, Residue{})("s1", x.s1, Residue{});
  io("x2", x.x2, Residue{})("s2", x.s2, Residue{});
}
template <class IO> void describe(IO& io, In<IO, TorsionFunction>& x) {
  io("n", x.n)("a", x.a)("b", x.b)("den", x.den)("minimal", x.minimal);
}
template <class IO> void describe(IO& io, In<IO, GoodReduction>& x) { describe(io, x.prime); }
template <class IO> void describe(IO& io, In<IO, Conclude>& x) {
  io("theorem", x.theorem).check(is_theorem(x.theorem), "theorem", "unknown theorem");
}
template <class IO> void describe(IO& io, In<IO, ApplyTheorem>& x) {
  io("theorem", x.theorem)("statement", x.statement);
}
template <class IO> void describe(IO& io, In<IO, Step>& x) {
  io("id", x.id).kind("rule", x.rule, rule_words)("premises", x.premises);
  io.object("data", [&](auto& o) { describe_kind(o, x.rule); });
}
template <class IO> void describe(IO& io, In<IO, Claim>& x) {
  io.always("group", x.group, OrNull{}).always("n", x.n, OrNull{});
  io.always("component", x.component, OrNull{}).always("abelian", x.abelian, OrNull{});
}
template <class IO> void describe(IO& io, In<IO, Certificate>& x) {
  io.format("kovacic-certificate/1")("field", x.field).over(x.field);
  io.object("r", [&](auto& o) { o("num", x.num)("den", x.den); });
  io("claim", x.claim)("steps", x.steps, Each{.most = max_steps, .entries = "steps"});
  io.check(!x.steps.empty(), "steps", "1 to 1000 steps are expected");
}

Field read_field(const Node& n) {
  Keys k(n);
  const std::string name = k.at("name").text();
  const Node minpoly = k.at("minpoly");
  std::vector<Integer> m;
  Integer squares;
  for (const Node& c : minpoly.items()) {
    m.push_back(c.integer());
    squares += m.back() * m.back();
    if (fmpz_bits(squares.raw()) / 2 + m.size() >= 76)
      minpoly.fail("the coefficients are too large");
  }
  k.done();
  if (m.size() < 2 || m.size() > 25 || m.back() != Integer(1) || (m.size() == 2 && !is_zero(m[0])))
    minpoly.fail("a monic polynomial of degree 1 (z itself) to 24 is expected");
  return m.size() == 2 ? rationals() : make_field(m, name);
}

Json to_json(const NumberField& k) {
  NoSetting none;
  return {Json::Object{{"name", {k.name()}},
                       {"minpoly", ByType{}.write(k.minpoly_coefficients(), none)}}};
}

std::string rule_name(const Rule& rule) { return rule_words.at(rule.index()); }

Certificate read_certificate(const Node& n) { return read_whole<Certificate>(n); }
Certificate read_certificate(std::string_view text) { return read_whole<Certificate>(text); }
Json to_json(const Certificate& c) { return whole_json(c); }
std::string write_certificate(const Certificate& c) { return to_string(to_json(c)); }

} // namespace kov::certify
