// JSON -> StrataCertificate, in the order of strata_certificates.md; unknown, missing and doubled
// keys are errors.

#include "certify/strata/certificate.hpp"
#include "certify/strata/classical.hpp"
#include "exact/error.hpp"
#include "proof/text/json_node.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>

namespace kov::certify {

namespace {

constexpr int max_json_depth = 4 * max_node_depth;

class StrataReader {
public:
  explicit StrataReader(const Node& n) : top_(n) {}

  StrataCertificate operator()() {
    const Node format = top_.at("format");
    if (format.text() != "kovacic-strata/1") format.fail("not kovacic-strata/1");
    read_names();
    c_.assumptions = read_conditions(c_.ring, top_.at("assumptions"));
    if (const auto all = top_.find("memberships"))
      for (const Node& n : all->items())
        c_.memberships.push_back(membership(n));
    for (const Node& n : top_.at("generic").items()) {
      c_.generic.push_back(polys(n));
      if (c_.generic.back().empty()) n.fail("the group is empty");
    }
    c_.r = fraction(top_.at("r"));
    Keys claim(top_.at("claim"));
    if (const Node v = claim.at("abelian"); !v.is_null()) c_.abelian = truth(v);
    claim.done();
    c_.tree = node(top_.at("tree"), 1);
    top_.done();
    return std::move(c_);
  }

private:
  void read_names() {
    std::vector<std::string> names{top_.at("variable").text()};
    const Node parameters = top_.at("parameters");
    if (parameters.items().size() > max_parameters) parameters.fail("more than 12 parameters");
    for (const Node& n : parameters.items())
      names.push_back(n.text());
    for (const std::string& s : names)
      if (!is_name(s) || std::ranges::count(names, s) != 1)
        parameters.fail("different names of letters, digits and _ are expected");
    c_.ring = make_ring(names);
    c_.real = marked(top_.at("real"));
    const auto rational = top_.find("rational");
    c_.rational = rational ? marked(*rational) : std::vector<bool>(names.size(), false);
    for (std::size_t i = 0; i < names.size(); ++i)
      if (c_.rational[i]) c_.real[i] = true;
  }

  [[nodiscard]] std::vector<bool> marked(const Node& list) const {
    std::vector<bool> all(c_.ring->size(), false);
    for (const Node& n : list.items()) {
      const std::size_t i = parameter(n);
      if (all[i]) n.fail("the parameter occurs twice");
      all[i] = true;
    }
    return all;
  }

  [[nodiscard]] std::size_t parameter(const Node& n) const {
    const auto i = c_.ring->find(n.text());
    if (!i || *i == 0) n.fail("a parameter is expected");
    return *i;
  }
  [[nodiscard]] MPoly poly(const Node& n) const { return read_poly(c_.ring, n); }
  [[nodiscard]] std::vector<MPoly> polys(const Node& n) const {
    std::vector<MPoly> f;
    for (const Node& x : n.items())
      f.push_back(poly(x));
    return f;
  }
  [[nodiscard]] Membership membership(const Node& n) const {
    Keys k(n);
    Membership m{{poly(k.at("num")), poly(k.at("den"))}, truth(k.at("integral"))};
    k.done();
    return m;
  }
  [[nodiscard]] Fraction fraction(const Node& n) const {
    Keys k(n);
    Fraction r{poly(k.at("num")), poly(k.at("den"))};
    k.done();
    return r;
  }
  static bool truth(const Node& n) {
    if (!n.json().truth()) n.fail("true or false is expected");
    return *n.json().truth();
  }
  static long natural(const Node& n) {
    const long i = n.count();
    if (i < 0) n.fail("a natural number is expected");
    return i;
  }
  static std::size_t index(const Node& n) { return static_cast<std::size_t>(natural(n)); }
  static unsigned long exponent(const Node& n) {
    const long e = n.count();
    if (e < 1 || e >= static_cast<long>(max_exponent))
      n.fail("an exponent from 1 to 9999 is expected");
    return static_cast<unsigned long>(e);
  }
  static bool yes(const Node& n) {
    const std::string s = n.text();
    if (s != "yes" && s != "no") n.fail("yes or no is expected");
    return s == "yes";
  }

  // ---- lemmas

  [[nodiscard]] LemmaTerm term(const Node& n) const {
    const auto parts = n.items();
    if (parts.empty()) n.fail("a coefficient is expected");
    LemmaTerm t{parts[0].rational(), {}};
    if (kov::sign(t.c) <= 0) parts[0].fail("a positive number is expected");
    for (std::size_t i = 1; i < parts.size(); ++i) {
      const auto f = parts[i].items();
      const std::string kind = f.size() == 3 ? f[0].text() : "";
      if (kind == "condition")
        t.factors.emplace_back(ConditionPower{index(f[1]), exponent(f[2])});
      else if (kind == "square")
        t.factors.emplace_back(EvenPower{poly(f[1]), exponent(f[2])});
      else
        parts[i].fail("[\"condition\", i, e] or [\"square\", Q, e] is expected");
    }
    return t;
  }
  [[nodiscard]] std::vector<LemmaTerm> terms(const Node& n) const {
    std::vector<LemmaTerm> t;
    for (const Node& x : n.items())
      t.push_back(term(x));
    return t;
  }
  static std::optional<Violation> violation(Keys& k) {
    const auto i = k.find("membership");
    if (!i) return std::nullopt;
    return Violation{index(*i), k.at("value").rational()};
  }
  [[nodiscard]] Lemma lemma(const Node& n) const {
    Keys k(n);
    Lemma x{poly(k.at("p")), {}, false, {}, violation(k), {}};
    if (const auto v = k.find("times")) x.times = poly(*v);
    const Sign s = read_sign(k.at("sign"));
    if (s != Sign::positive && s != Sign::nonzero) n.fail("a lemma shows positive or nonzero");
    x.positive = s == Sign::positive;
    if (const auto v = k.find("terms")) x.terms = terms(*v);
    if (const auto v = k.find("prime")) x.prime = v->modulus();
    k.done();
    const int proofs = (x.terms || x.times ? 1 : 0) + (x.violation ? 1 : 0) + (x.prime ? 1 : 0);
    if (proofs != 1 || (x.positive && !x.terms)) n.fail("one proof of the lemma is expected");
    return x;
  }

  // ---- leaves

  [[nodiscard]] ByInvariant invariant(Keys& k) const {
    ByInvariant x{poly(k.at("content")), {}, {}, k.at("m").count()};
    for (const Node& n : k.at("places").items()) {
      Keys f(n);
      x.places.push_back({poly(f.at("q")), f.at("order").count(), f.at("e").integer()});
      f.done();
    }
    x.p = poly(k.at("p"));
    return x;
  }
  [[nodiscard]] StratumPlace place(const Node& n, bool finite) const {
    Keys k(n);
    StratumPlace x;
    if (finite) {
      x.q = poly(k.at("q"));
      x.order = k.at("order").count();
    }
    if (const auto v = k.find("chi")) {
      x.chi = polys(*v);
      if (x.chi.size() < 2) v->fail("chi has degree 1 at least");
    }
    if (const auto v = k.find("irrational")) x.irrational = v->text();
    if (const auto v = k.find("log")) {
      if (!truth(*v)) v->fail("true is expected");
      x.log = true;
    }
    if (const auto v = k.find("bound")) x.bound = v->rational();
    k.done();
    return x;
  }
  [[nodiscard]] AbsentInvariant absent(const Node& n) const {
    Keys k(n);
    AbsentInvariant x{k.at("m").count(), {}, {}};
    if (const auto v = k.find("prime")) x.prime = v->modulus();
    for (const Node& v : k.at("minors").items()) {
      Keys f(v);
      Minor minor;
      for (const Node& row : f.at("rows").items())
        minor.rows.push_back(natural(row));
      minor.times = poly(f.at("times"));
      f.done();
      x.minors.push_back(std::move(minor));
    }
    k.done();
    return x;
  }
  [[nodiscard]] ByClassical classical(const std::string& family, Keys& k) const {
    ByClassical x{family, fraction(k.at("change")), fraction(k.at("equation")), {}, {}, {}};
    if (const auto v = k.find("factors")) x.factors = polys(*v);
    const Node numbers = k.at("numbers");
    for (const Node& n : numbers.items()) {
      Keys f(n);
      x.numbers.push_back({fraction(f.at("square"))});
      if (const auto v = f.find("root")) x.numbers.back().root = fraction(*v);
      f.done();
    }
    if (x.numbers.empty() || (family == "whittaker" && x.numbers.size() != 2))
      numbers.fail("these are not the numbers of the family");
    if (const auto v = k.find("shown"))
      for (const Node& n : v->items())
        x.shown.push_back(shown(n));
    return x;
  }
  [[nodiscard]] ShownMembership shown(const Node& n) const {
    Keys k(n);
    ShownMembership x{fraction(k.at("value")),
                      truth(k.at("integral")),
                      k.at("times").integer(),
                      index(k.at("membership")),
                      {}};
    if (const auto v = k.find("with"))
      for (const Node& m : v->items()) {
        Keys f(m);
        x.with.push_back({f.at("times").integer(), index(f.at("membership"))});
        f.done();
      }
    k.done();
    return x;
  }
  static Growth growth(const Node& n) {
    Keys k(n);
    Growth g{k.at("factor").rational(), k.at("shift").rational()};
    k.done();
    return g;
  }
  [[nodiscard]] LeafNode leaf(Keys& k) const {
    const Node said = k.at("abelian");
    const Node by = k.at("by");
    if (is_classical_rule(by.text())) {
      const bool where = said.text() == "where";
      return {where ? std::nullopt : std::optional(yes(said)), classical(by.text(), k)};
    }
    const bool abelian = yes(said);
    if (by.text() == "number") return {abelian, ByNumber{read_certificate(k.at("certificate"))}};
    if (by.text() == "invariant") {
      if (!abelian) by.fail("an invariant proves 'yes'");
      return {abelian, invariant(k)};
    }
    if (abelian) by.fail("this theorem proves 'no'");
    ByPlaces x;
    const auto theorem = places_theorem_of(by.text());
    if (!theorem) by.fail("unknown theorem");
    x.theorem = *theorem;
    x.content = poly(k.at("content"));
    for (const Node& n : k.at("places").items())
      x.places.push_back(place(n, true));
    x.infinity = place(k.at("infinity"), false);
    if (const auto v = k.find("absent"))
      for (const Node& n : v->items()) {
        x.absent.push_back(absent(n));
        if (std::ranges::count_if(
                x.absent, [&](const AbsentInvariant& y) { return y.m == x.absent.back().m; }) > 1)
          n.fail("the degree occurs twice");
      }
    if (const auto v = k.find("growth")) x.growth = growth(*v);
    return {abelian, std::move(x)};
  }

  // ---- nodes

  [[nodiscard]] EmptyStratum empty(Keys& k) const {
    const auto v = k.find("terms");
    EmptyStratum e{v ? std::optional(terms(*v)) : std::nullopt, violation(k)};
    if (e.terms && e.violation) v->fail("one proof is expected");
    return e;
  }
  static OutsideStratum outside(Keys& k) {
    const auto v = k.find("generic");
    return {v ? std::optional(index(*v)) : std::nullopt};
  }
  static TrustedStratum trusted(Keys& k) {
    const Node abelian = k.at("abelian");
    if (abelian.text() != "yes" && abelian.text() != "no" && abelian.text() != "empty")
      abelian.fail("yes, no or empty is expected");
    return {abelian.text(), k.at("theorem").text(), k.at("statement").text()};
  }

  // The stated entry of a node; nothing if the name is none of those that both kinds share.
  template <class Into> bool without_children(const std::string& name, Keys& k, Into& into) const {
    if (name == "empty")
      into = empty(k);
    else if (name == "outside")
      into = outside(k);
    else if (name == "open")
      into = OpenStratum{k.at("reason").text()};
    else if (name == "trusted")
      into = trusted(k);
    else
      return false;
    return true;
  }

  void count(const Node& n, int depth) {
    if (++nodes_ > max_nodes) n.fail("more than 10000 nodes");
    if (depth > max_node_depth) n.fail("nodes are nested more than 64 deep");
  }

  WhereZero where_zero(const Node& n, int depth) {
    Keys k(n);
    const Node name = k.at("zero");
    WhereZero z;
    if (name.text() == "solve") {
      SolvedStratum s;
      s.variable = parameter(k.at("variable"));
      if (const auto v = k.find("r")) s.r = fraction(*v);
      s.then = node(k.at("then"), depth + 1);
      z = std::move(s);
    } else if (name.text() == "root") {
      z = RootStratum{parameter(k.at("variable")), read_certificate(k.at("certificate")),
                      yes(k.at("abelian"))};
    } else if (!without_children(name.text(), k, z)) {
      name.fail("solve, root, outside, empty, open or trusted is expected");
    }
    k.done();
    return z;
  }

  Subtree node(const Node& n, int depth) {
    count(n, depth);
    Keys k(n);
    const Node name = k.at("node");
    auto x = std::make_unique<StrataNode>();
    if (name.text() == "split") {
      SplitNode s{poly(k.at("p")), node(k.at("nonzero"), depth + 1), {}};
      s.zero = where_zero(k.at("zero"), depth);
      x->kind = std::move(s);
    } else if (name.text() == "assumed") {
      x->kind =
          AssumedNode{index(k.at("condition")), poly(k.at("p")), where_zero(k.at("zero"), depth)};
    } else if (name.text() == "lemmas") {
      LemmasNode l;
      for (const Node& v : k.at("lemmas").items())
        l.lemmas.push_back(lemma(v));
      l.then = node(k.at("then"), depth + 1);
      x->kind = std::move(l);
    } else if (name.text() == "leaf") {
      x->kind = leaf(k);
    } else if (!without_children(name.text(), k, x->kind)) {
      name.fail("split, assumed, lemmas, leaf, empty, outside, open or trusted is expected");
    }
    k.done();
    return x;
  }

  Keys top_;
  StrataCertificate c_;
  std::size_t nodes_ = 0;
};

} // namespace

StrataCertificate read_strata_certificate(std::string_view text) {
  if (text.size() > max_text) throw InvalidArgument("the certificate is longer than 2^28 bytes");
  const Json json = parse_json(text, max_json_depth);
  return StrataReader(Node(json, "certificate", rationals()))();
}

std::optional<std::string> format_of(std::string_view text) {
  if (text.size() > max_text) return std::nullopt;
  const Json json = parse_json(text, max_json_depth);
  const auto* o = json.object();
  for (std::size_t i = 0; o && i < o->size(); ++i)
    if ((*o)[i].first == "format" && (*o)[i].second.text()) return *(*o)[i].second.text();
  return std::nullopt;
}

} // namespace kov::certify
