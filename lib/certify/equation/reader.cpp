// JSON -> Certificate.  Each rule has one function that lists its keys in the order of
// docs/theory/certificates.md; unknown, missing and doubled keys are errors.

#include "exact/error.hpp"
#include "proof/text/json_node.hpp"
#include "proof/text/limits.hpp"

namespace kov::certify {

namespace {

LogWitness read_log(const Node& n) {
  Keys k(n);
  LogWitness w;
  w.prime = k.prime();
  if (const auto roots = k.find("roots")) w.roots = roots->residues();
  k.done();
  return w;
}

LocalPlace read_place(const Node& n) {
  Keys k(n);
  LocalPlace x;
  x.q = k.at("q").poly();
  x.order = k.at("order").count();
  x.delta2 = k.find_poly("delta2");
  x.eps2 = k.find_poly("eps2");
  if (const auto v = k.find("irrational")) x.irrational = v->prime();
  if (const auto v = k.find("log")) x.log = read_log(*v);
  x.annihilator = k.find_poly("annihilator");
  k.done();
  return x;
}

Rule read_local(Keys& k) {
  Local x;
  x.prime = k.at("prime").prime();
  for (const Node& n : k.at("places").items())
    x.places.push_back(read_place(n));
  Keys inf(k.at("infinity"));
  x.infinity_eps2 = inf.find_poly("eps2");
  if (const auto v = inf.find("log")) x.infinity_log = read_log(*v);
  x.infinity_annihilator = inf.find_poly("annihilator");
  inf.done();
  return x;
}

Rule read_exponential(Keys& k) {
  return Exponential{k.at("p").poly(), k.at("num").poly(), k.at("den").poly()};
}

Rule read_invariant(Keys& k) {
  Invariant x;
  x.prime = k.at("prime").prime();
  x.m = k.at("m").count();
  x.p = k.at("p").poly();
  for (const Node& n : k.at("factors").items()) {
    Keys f(n);
    x.factors.push_back({f.at("q").poly(), f.at("e").rational()});
    f.done();
  }
  return x;
}

Rule read_no_exponential(Keys& k) {
  const Node by = k.at("by");
  if (by.text() == "parity") return NoExponential{ByParity{}};
  if (by.text() == "degree") return NoExponential{ByDegree{}};
  if (by.text() != "series") by.fail("parity, degree or series is expected");
  BySeries x;
  const Node place = k.at("place");
  if (place.text() != "infinity") x.place = place.count();
  x.prime = k.prime();
  x.root = k.at("root").residue();
  x.delta = k.at("delta").residue();
  x.terms = k.at("terms").count();
  for (const Node& n : k.at("lines").items()) {
    Keys l(n);
    x.lines.push_back({l.at("length").count(), l.at("approximant").residues()});
    l.done();
  }
  return NoExponential{x};
}

Rule read_p_curvature(Keys& k) { return PCurvature{k.prime(), k.at("shows").text()}; }

Rule read_no_invariant(Keys& k) {
  NoInvariant x;
  x.m = k.at("m").count();
  const Node by = k.at("by");
  if (by.text() == "degree")
    x.by = ByDegree{};
  else if (by.text() == "series")
    x.by = RankModP{k.prime(), k.at("x0").residue(), k.at("terms").count()};
  else
    by.fail("degree or series is expected");
  return x;
}

Rule read_torsion_function(Keys& k) {
  TorsionFunction x;
  x.n = k.at("n").count();
  x.a = k.at("a").poly();
  x.b = k.at("b").poly();
  x.den = k.at("den").poly();
  for (const Node& n : k.at("minimal").items()) {
    Keys t(n);
    x.minimal.push_back({t.at("l").count(), t.prime(), t.at("w").residue(), t.at("x1").residue(),
                         t.at("s1").residue(), t.at("x2").residue(), t.at("s2").residue()});
    t.done();
  }
  return x;
}

Rule read_rule(const Node& rule, const Node& data) {
  Keys k(data);
  const std::string name = rule.text();
  const auto read = [&]() -> Rule {
    if (name == "local") return read_local(k);
    if (name == "exponential") return read_exponential(k);
    if (name == "invariant") return read_invariant(k);
    if (name == "no-exponential") return read_no_exponential(k);
    if (name == "p-curvature") return read_p_curvature(k);
    if (name == "no-invariant") return read_no_invariant(k);
    if (name == "torsion-function") return read_torsion_function(k);
    if (name == "good-reduction") return GoodReduction{k.prime()};
    if (name == "conclude") {
      const Node by = k.at("theorem");
      if (const auto theorem = theorem_of(by.text())) return Conclude{*theorem};
      by.fail("unknown theorem");
    }
    if (name == "apply-theorem")
      return ApplyTheorem{k.at("theorem").text(), k.at("statement").text()};
    rule.fail("unknown rule");
  };
  Rule r = read();
  k.done();
  return r;
}

Claim read_claim(const Node& n) {
  Keys k(n);
  Claim c;
  if (const Node v = k.at("group"); !v.is_null()) c.group = v.text();
  if (const Node v = k.at("n"); !v.is_null()) c.n = v.integer();
  if (const Node v = k.at("component"); !v.is_null()) c.component = v.text();
  if (const Node v = k.at("abelian"); !v.is_null()) {
    if (!v.json().truth()) v.fail("true, false or null is expected");
    c.abelian = *v.json().truth();
  }
  k.done();
  return c;
}

} // namespace

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

Certificate read_certificate(const Node& n) {
  Certificate c;
  Keys top(n);
  const Node format = top.at("format");
  if (format.text() != "kovacic-certificate/1") format.fail("not kovacic-certificate/1");
  c.field = read_field(top.at("field"));
  const Node r = top.at("r");
  Keys fraction(Node(r.json(), r.path(), c.field));
  c.num = fraction.at("num").poly();
  c.den = fraction.at("den").poly();
  fraction.done();
  c.claim = read_claim(top.at("claim"));
  const auto steps = top.at("steps").items();
  if (steps.empty() || steps.size() > max_steps) format.fail("1 to 1000 steps are expected");
  for (const Node& step : steps) {
    Keys k(Node(step.json(), step.path(), c.field));
    Step s;
    s.id = k.at("id").text();
    for (const Node& p : k.at("premises").items())
      s.premises.push_back(p.text());
    s.rule = read_rule(k.at("rule"), k.at("data"));
    k.done();
    c.steps.push_back(std::move(s));
  }
  top.done();
  return c;
}

Certificate read_certificate(std::string_view text) {
  if (text.size() > max_text) throw InvalidArgument("the certificate is longer than 2^28 bytes");
  const Json json = parse_json(text);
  return read_certificate(Node(json, "certificate", rationals()));
}

} // namespace kov::certify
