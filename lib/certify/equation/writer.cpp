// Certificate -> JSON, keys in the order of docs/theory/certificates.md.

#include "exact/overloaded.hpp"
#include "proof/text/json_node.hpp"

namespace kov::certify {

namespace {

Json text(std::string s) { return {std::move(s)}; }
Json number(long n) { return text(std::to_string(n)); }
Json residue(mp_limb_t n) { return text(std::to_string(n)); }

Json element(const NfElem& e) {
  if (is_rational(e)) return text(to_string(e.coeff(0)));
  Json::Array a;
  for (long i = 0; i <= fmpq_poly_degree(e.raw()); ++i)
    a.push_back(text(to_string(e.coeff(i))));
  return {a};
}

Json poly(const Poly& f) {
  Json::Array a;
  for (long i = 0; i <= degree(f); ++i)
    a.push_back(element(f.coeff(i)));
  return {a};
}

Json residues(const std::vector<mp_limb_t>& c) {
  Json::Array a;
  for (const mp_limb_t x : c)
    a.push_back(residue(x));
  return {a};
}

void put(Json::Object& o, const PrimeIdeal& p) {
  o.emplace_back("p", residue(p.p));
  o.emplace_back("a", residue(p.generator));
}

Json prime(const PrimeIdeal& p) {
  Json::Object o;
  put(o, p);
  return {o};
}

Json log(const LogWitness& w) {
  Json::Object o;
  put(o, w.prime);
  if (!w.roots.empty()) o.emplace_back("roots", residues(w.roots));
  return {o};
}

Json data(const Local& x) {
  Json::Array places;
  for (const LocalPlace& e : x.places) {
    Json::Object o{{"q", poly(e.q)}, {"order", number(e.order)}};
    if (e.delta2) o.emplace_back("delta2", poly(*e.delta2));
    if (e.eps2) o.emplace_back("eps2", poly(*e.eps2));
    if (e.irrational) o.emplace_back("irrational", prime(*e.irrational));
    if (e.log) o.emplace_back("log", log(*e.log));
    if (e.annihilator) o.emplace_back("annihilator", poly(*e.annihilator));
    places.push_back({o});
  }
  Json::Object inf;
  if (x.infinity_eps2) inf.emplace_back("eps2", poly(*x.infinity_eps2));
  if (x.infinity_log) inf.emplace_back("log", log(*x.infinity_log));
  if (x.infinity_annihilator) inf.emplace_back("annihilator", poly(*x.infinity_annihilator));
  return {Json::Object{{"prime", prime(x.prime)}, {"places", {places}}, {"infinity", {inf}}}};
}

Json data(const Exponential& x) {
  return {Json::Object{{"p", poly(x.p)}, {"num", poly(x.num)}, {"den", poly(x.den)}}};
}

Json data(const Invariant& x) {
  Json::Array factors;
  for (const InvariantFactor& f : x.factors)
    factors.push_back({Json::Object{{"q", poly(f.q)}, {"e", text(to_string(f.e))}}});
  return {Json::Object{
      {"prime", prime(x.prime)}, {"m", number(x.m)}, {"p", poly(x.p)}, {"factors", {factors}}}};
}

Json data(const NoExponential& x) {
  if (std::holds_alternative<ByParity>(x.by)) return {Json::Object{{"by", text("parity")}}};
  const auto* s = std::get_if<BySeries>(&x.by);
  if (!s) return {Json::Object{{"by", text("degree")}}};
  Json::Array lines;
  for (const ApproximantLine& l : s->lines)
    lines.push_back(
        {Json::Object{{"length", number(l.length)}, {"approximant", residues(l.approximant)}}});
  Json::Object o{{"by", text("series")},
                 {"place", text(s->place ? std::to_string(*s->place) : "infinity")}};
  put(o, s->prime);
  o.emplace_back("root", residue(s->root));
  o.emplace_back("delta", residue(s->delta));
  o.emplace_back("terms", number(s->terms));
  o.emplace_back("lines", Json{lines});
  return {o};
}

Json data(const PCurvature& x) {
  Json::Object o;
  put(o, x.prime);
  o.emplace_back("shows", text(x.shows));
  return {o};
}

Json data(const NoInvariant& x) {
  Json::Object o{{"m", number(x.m)}};
  const auto* s = std::get_if<RankModP>(&x.by);
  o.emplace_back("by", text(s ? "series" : "degree"));
  if (s) {
    put(o, s->prime);
    o.emplace_back("x0", residue(s->x0));
    o.emplace_back("terms", number(s->terms));
  }
  return {o};
}

Json data(const TorsionFunction& x) {
  Json::Array minimal;
  for (const NotAPower& t : x.minimal) {
    Json::Object o{{"l", number(t.l)}};
    put(o, t.prime);
    o.emplace_back("w", residue(t.w));
    o.emplace_back("x1", residue(t.x1));
    o.emplace_back("s1", residue(t.s1));
    o.emplace_back("x2", residue(t.x2));
    o.emplace_back("s2", residue(t.s2));
    minimal.push_back({o});
  }
  return {Json::Object{{"n", number(x.n)},
                       {"a", poly(x.a)},
                       {"b", poly(x.b)},
                       {"den", poly(x.den)},
                       {"minimal", {minimal}}}};
}

Json data(const GoodReduction& x) { return prime(x.prime); }

Json data(const Conclude& x) { return {Json::Object{{"theorem", text(to_string(x.theorem))}}}; }

Json data(const ApplyTheorem& x) {
  return {Json::Object{{"theorem", text(x.theorem)}, {"statement", text(x.statement)}}};
}

Json claim(const Claim& c) {
  const auto optional = [](const auto& v, auto f) { return v ? f(*v) : Json{}; };
  return {Json::Object{{"group", optional(c.group, text)},
                       {"n", optional(c.n, [](const Integer& n) { return text(to_string(n)); })},
                       {"component", optional(c.component, text)},
                       {"abelian", optional(c.abelian, [](bool b) { return Json{b}; })}}};
}

} // namespace

Json to_json(const NumberField& k) {
  Json::Array m;
  for (const Integer& c : k.minpoly_coefficients())
    m.push_back(text(to_string(c)));
  return {Json::Object{{"name", text(k.name())}, {"minpoly", {m}}}};
}

Json to_json(const Poly& f) { return poly(f); }

std::string rule_name(const Rule& rule) {
  return std::visit(Overloaded{[](const Local&) { return "local"; },
                               [](const Exponential&) { return "exponential"; },
                               [](const Invariant&) { return "invariant"; },
                               [](const NoExponential&) { return "no-exponential"; },
                               [](const PCurvature&) { return "p-curvature"; },
                               [](const NoInvariant&) { return "no-invariant"; },
                               [](const TorsionFunction&) { return "torsion-function"; },
                               [](const GoodReduction&) { return "good-reduction"; },
                               [](const Conclude&) { return "conclude"; },
                               [](const ApplyTheorem&) { return "apply-theorem"; }},
                    rule);
}

Json to_json(const Certificate& c) {
  Json::Array steps;
  for (const Step& s : c.steps) {
    Json::Array premises;
    for (const std::string& p : s.premises)
      premises.push_back(text(p));
    steps.push_back(
        {Json::Object{{"id", text(s.id)},
                      {"rule", text(rule_name(s.rule))},
                      {"premises", {premises}},
                      {"data", std::visit([](const auto& x) { return data(x); }, s.rule)}}});
  }
  return {Json::Object{{"format", text("kovacic-certificate/1")},
                       {"field", to_json(*c.field)},
                       {"r", {Json::Object{{"num", poly(c.num)}, {"den", poly(c.den)}}}},
                       {"claim", claim(c.claim)},
                       {"steps", {steps}}}};
}

std::string write_certificate(const Certificate& c) { return to_string(to_json(c)); }

} // namespace kov::certify
