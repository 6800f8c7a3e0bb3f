// StrataCertificate -> JSON, keys in the order of docs/theory/strata_certificates.md; what
// strata_reader.cpp reads.

#include "certify/strata/certificate.hpp"
#include "exact/lists.hpp"
#include "exact/overloaded.hpp"
#include "proof/text/json_node.hpp"

#include <algorithm>
#include <type_traits>

namespace kov::certify {

namespace {

Json text(std::string s) { return {std::move(s)}; }
Json text(const char* s) { return {std::string(s)}; }
Json text(const MPoly& p) { return text(to_string(p)); }
template <class Number>
requires std::is_integral_v<Number> Json text(Number n) { return text(std::to_string(n)); }
Json yes_or_no(bool b) { return text(b ? "yes" : "no"); }

template <class T, class F> Json listed(const std::vector<T>& all, F entry) {
  Json::Array list;
  for (const T& x : all)
    list.push_back(entry(x));
  return {std::move(list)};
}
Json polys(const std::vector<MPoly>& all) {
  return listed(all, [](const MPoly& p) { return text(p); });
}

Json fraction(const Fraction& r) {
  return {Json::Object{{"num", text(r.num)}, {"den", text(r.den)}}};
}

// ---- lemmas

Json factor(const std::variant<ConditionPower, EvenPower>& f) {
  return std::visit(
      Overloaded{[](const ConditionPower& x) {
                   return Json{Json::Array{text("condition"), text(x.condition), text(x.e)}};
                 },
                 [](const EvenPower& x) {
                   return Json{Json::Array{text("square"), text(x.base), text(x.e)}};
                 }},
      f);
}
Json terms(const std::vector<LemmaTerm>& all) {
  return listed(all, [](const LemmaTerm& t) {
    Json::Array term{text(to_string(t.c))};
    for (const auto& f : t.factors)
      term.push_back(factor(f));
    return Json{std::move(term)};
  });
}
void put(Json::Object& o, const std::optional<Violation>& v) {
  if (!v) return;
  o.emplace_back("membership", text(v->membership));
  o.emplace_back("value", text(to_string(v->value)));
}
Json lemma(const Lemma& l) {
  Json::Object o{{"p", text(l.p)}};
  if (l.times) o.emplace_back("times", text(*l.times));
  o.emplace_back("sign", text(to_string(l.positive ? Sign::positive : Sign::nonzero)));
  if (l.terms) o.emplace_back("terms", terms(*l.terms));
  put(o, l.violation);
  if (l.prime) o.emplace_back("prime", text(*l.prime));
  return {std::move(o)};
}

// ---- leaves

Json place(const StratumPlace& x) {
  Json::Object o;
  if (x.q) o = {{"q", text(*x.q)}, {"order", text(x.order)}};
  if (!x.chi.empty()) o.emplace_back("chi", polys(x.chi));
  if (x.irrational) o.emplace_back("irrational", text(*x.irrational));
  if (x.log) o.emplace_back("log", Json{true});
  if (x.bound) o.emplace_back("bound", text(to_string(*x.bound)));
  return {std::move(o)};
}
Json absent(const AbsentInvariant& x) {
  const Json minors = listed(x.minors, [](const Minor& m) {
    return Json{Json::Object{{"rows", listed(m.rows, [](long row) { return text(row); })},
                             {"times", text(m.times)}}};
  });
  Json::Object o{{"m", text(x.m)}, {"minors", minors}};
  if (x.prime) o.emplace_back("prime", text(*x.prime));
  return {std::move(o)};
}

void put(Json::Object& o, const ByNumber& x) {
  o.emplace_back("by", text("number"));
  o.emplace_back("certificate", to_json(x.certificate));
}
void put(Json::Object& o, const ByInvariant& x) {
  o.emplace_back("by", text("invariant"));
  o.emplace_back("content", text(x.content));
  o.emplace_back("places", listed(x.places, [](const InvariantPlace& p) {
                   return Json{Json::Object{
                       {"q", text(p.q)}, {"order", text(p.order)}, {"e", text(to_string(p.e))}}};
                 }));
  o.emplace_back("m", text(x.m));
  o.emplace_back("p", text(x.p));
}
void put(Json::Object& o, const ByPlaces& x) {
  o.emplace_back("by", text(to_string(x.theorem)));
  o.emplace_back("content", text(x.content));
  o.emplace_back("places", listed(x.places, place));
  o.emplace_back("infinity", place(x.infinity));
  if (!x.absent.empty()) o.emplace_back("absent", listed(x.absent, absent));
  if (x.growth)
    o.emplace_back("growth", Json{Json::Object{{"factor", text(to_string(x.growth->factor))},
                                               {"shift", text(to_string(x.growth->shift))}}});
}

Json number(const SquaredNumber& x) {
  Json::Object o{{"square", fraction(x.square)}};
  if (x.root) o.emplace_back("root", fraction(*x.root));
  return {std::move(o)};
}
Json multiple(const MultipleOfMembership& x) {
  return {Json::Object{{"times", text(to_string(x.times))}, {"membership", text(x.membership)}}};
}
Json shown(const ShownMembership& x) {
  Json::Object o{{"value", fraction(x.value)},
                 {"integral", Json{x.integral}},
                 {"times", text(to_string(x.times))},
                 {"membership", text(x.membership)}};
  if (!x.with.empty()) o.emplace_back("with", listed(x.with, multiple));
  return {std::move(o)};
}
void put(Json::Object& o, const ByClassical& x) {
  o.emplace_back("by", text(x.family));
  o.emplace_back("change", fraction(x.change));
  o.emplace_back("equation", fraction(x.equation));
  if (!x.factors.empty()) o.emplace_back("factors", polys(x.factors));
  o.emplace_back("numbers", listed(x.numbers, number));
  if (!x.shown.empty()) o.emplace_back("shown", listed(x.shown, shown));
}

// ---- nodes: `key` is "node", or "zero" for what becomes of the points with p = 0

Json json_of(const EmptyStratum& n, const char* key) {
  Json::Object o{{key, text("empty")}};
  if (n.terms) o.emplace_back("terms", terms(*n.terms));
  put(o, n.violation);
  return {std::move(o)};
}
Json json_of(const OutsideStratum& n, const char* key) {
  Json::Object o{{key, text("outside")}};
  if (n.generic) o.emplace_back("generic", text(*n.generic));
  return {std::move(o)};
}
Json json_of(const OpenStratum& n, const char* key) {
  return {Json::Object{{key, text("open")}, {"reason", text(n.reason)}}};
}
Json json_of(const TrustedStratum& n, const char* key) {
  return {Json::Object{{key, text("trusted")},
                       {"abelian", text(n.abelian)},
                       {"theorem", text(n.theorem)},
                       {"statement", text(n.statement)}}};
}

class TreeWriter {
public:
  explicit TreeWriter(const Ring& ring) : ring_(ring) {}

  [[nodiscard]] Json operator()(const Subtree& tree) const {
    return std::visit([this](const auto& n) { return node(n); }, tree->kind);
  }

private:
  [[nodiscard]] Json name(std::size_t variable) const { return text(ring_->name(variable)); }

  template <class N> [[nodiscard]] Json node(const N& n) const { return json_of(n, "node"); }
  [[nodiscard]] Json node(const SplitNode& n) const {
    return {Json::Object{{"node", text("split")},
                         {"p", text(n.p)},
                         {"nonzero", (*this)(n.nonzero)},
                         {"zero", zero(n.zero)}}};
  }
  [[nodiscard]] Json node(const AssumedNode& n) const {
    return {Json::Object{{"node", text("assumed")},
                         {"condition", text(n.condition)},
                         {"p", text(n.p)},
                         {"zero", zero(n.zero)}}};
  }
  [[nodiscard]] Json node(const LemmasNode& n) const {
    return {Json::Object{
        {"node", text("lemmas")}, {"lemmas", listed(n.lemmas, lemma)}, {"then", (*this)(n.then)}}};
  }
  [[nodiscard]] static Json node(const LeafNode& n) {
    Json::Object o{{"node", text("leaf")},
                   {"abelian", n.abelian ? yes_or_no(*n.abelian) : text("where")}};
    std::visit([&](const auto& by) { put(o, by); }, n.by);
    return {std::move(o)};
  }

  [[nodiscard]] Json zero(const WhereZero& z) const {
    return std::visit([this](const auto& n) { return where_zero(n); }, z);
  }
  template <class N> [[nodiscard]] Json where_zero(const N& n) const { return json_of(n, "zero"); }
  [[nodiscard]] Json where_zero(const SolvedStratum& n) const {
    Json::Object o{{"zero", text("solve")}, {"variable", name(n.variable)}};
    if (n.r) o.emplace_back("r", fraction(*n.r));
    o.emplace_back("then", (*this)(n.then));
    return {std::move(o)};
  }
  [[nodiscard]] Json where_zero(const RootStratum& n) const {
    return {Json::Object{{"zero", text("root")},
                         {"variable", name(n.variable)},
                         {"certificate", to_json(n.certificate)},
                         {"abelian", yes_or_no(n.abelian)}}};
  }

  const Ring& ring_;
};

Json marked(const std::vector<bool>& variables, const Ring& ring) {
  Json::Array names;
  for (std::size_t i = 0; i < variables.size(); ++i)
    if (variables[i]) names.push_back(text(ring->name(i)));
  return {std::move(names)};
}
Json parameters(const StrataCertificate& c) {
  std::vector<bool> all(c.ring->size(), true);
  all[c.variable] = false;
  return marked(all, c.ring);
}
Json condition(const Condition& c) {
  return {Json::Object{{"p", text(c.p)}, {"sign", text(to_string(c.sign))}}};
}
Json membership(const Membership& m) {
  return {Json::Object{
      {"num", text(m.value.num)}, {"den", text(m.value.den)}, {"integral", Json{m.integral}}}};
}

} // namespace

std::string write_strata_certificate(const StrataCertificate& c) {
  Json::Object whole{
      {"format", text("kovacic-strata/1")},
      {"variable", text(c.ring->name(c.variable))},
      {"parameters", parameters(c)},
      {"real", marked(c.real, c.ring)},
      {"assumptions", listed(c.assumptions, condition)},
      {"generic", listed(c.generic, polys)},
      {"r", fraction(c.r)},
      {"claim", Json{Json::Object{{"abelian", c.abelian ? Json{*c.abelian} : Json{}}}}},
      {"tree", TreeWriter(c.ring)(c.tree)}};
  if (is_among(true, c.rational)) whole.emplace_back("rational", marked(c.rational, c.ring));
  if (!c.memberships.empty()) whole.emplace_back("memberships", listed(c.memberships, membership));
  return to_string(Json{std::move(whole)});
}

} // namespace kov::certify
