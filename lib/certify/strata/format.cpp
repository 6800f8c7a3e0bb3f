// StrataCertificate <-> JSON, keys in the order of docs/theory/strata_certificates.md.

#include "certify/strata/certificate.hpp"
#include "certify/strata/classical.hpp"
#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "exact/overloaded.hpp"
#include "proof/text/fields.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>

namespace kov::certify {

/// The names, and how deep the node is that is read.
struct StrataSetting {
  const Ring* ring = nullptr;
  std::size_t nodes = 0;
  int depth = 0;
};

namespace {

constexpr int strata_json_depth = 4 * max_node_depth;

constexpr Words<8> node_words{"split", "assumed", "lemmas", "leaf",
                              "empty", "outside", "open",   "trusted"};
constexpr Words<6> zero_words{"solve", "root", "empty", "outside", "open", "trusted"};

constexpr Between lemma_exponent{1, static_cast<long>(max_exponent) - 1,
                                 "an exponent from 1 to 9999 is expected"};

/// A parameter, by its name.
struct Parameter {
  static void read(const Node& n, std::size_t& x, const StrataSetting& s) {
    const auto i = (*s.ring)->find(n.text());
    if (!i || *i == 0) n.fail("a parameter is expected");
    x = *i;
  }
  static Json write(std::size_t x, const StrataSetting& s) { return {(*s.ring)->name(x)}; }
};
/// A list of the parameters that are marked.
struct Marked {
  static void read(const Node& n, std::vector<bool>& x, const StrataSetting& s) {
    x.assign((*s.ring)->size(), false);
    for (const Node& one : n.items()) {
      std::size_t i = 0;
      Parameter::read(one, i, s);
      if (x[i]) one.fail("the parameter occurs twice");
      x[i] = true;
    }
  }
  static Json write(const std::vector<bool>& x, const StrataSetting& s) {
    Json::Array names;
    for (std::size_t i = 0; i < x.size(); ++i)
      if (x[i]) names.push_back(Parameter::write(i, s));
    return {std::move(names)};
  }
};
/// The sign that a lemma shows.
struct PositiveOrNonzero {
  static void read(const Node& n, bool& x, const StrataSetting&) {
    const Sign s = read_sign(n);
    if (s != Sign::positive && s != Sign::nonzero) n.fail("a lemma shows positive or nonzero");
    x = s == Sign::positive;
  }
  static Json write(bool x, const StrataSetting&) {
    return {to_string(x ? Sign::positive : Sign::nonzero)};
  }
};
struct YesNoOrWhere {
  static void read(const Node& n, std::optional<bool>& x, const StrataSetting& s) {
    x.reset();
    if (n.text() != "where") yes_or_no.read(n, x.emplace(), s);
  }
  static Json write(const std::optional<bool>& x, const StrataSetting& s) {
    return x ? yes_or_no.write(*x, s) : Json{std::string("where")};
  }
};
/// The kind of proof of a leaf; its entries stand beside it.
struct ProofOfLeaf {
  using By = decltype(LeafNode::by);
  static void read(const Node& n, By& x, const StrataSetting&) {
    const std::string by = n.text();
    if (is_classical_rule(by))
      x.emplace<ByClassical>().family = by;
    else if (by == "number")
      x.emplace<ByNumber>();
    else if (by == "invariant")
      x.emplace<ByInvariant>();
    else if (is_places_theorem(by))
      x.emplace<ByPlaces>().theorem = by;
    else
      n.fail("unknown theorem");
  }
  static Json write(const By& x, const StrataSetting&) {
    return {std::visit(Overloaded{[](const ByNumber&) { return std::string("number"); },
                                  [](const ByInvariant&) { return std::string("invariant"); },
                                  [](const ByPlaces& y) { return y.theorem; },
                                  [](const ByClassical& y) { return y.family; }},
                       x)};
  }
};

} // namespace

void read_entry(const Node& n, Sign& x, StrataSetting&) { x = read_sign(n); }
Json write_entry(Sign x, StrataSetting&) { return {to_string(x)}; }

template <class IO> void describe(IO& io, In<IO, Condition>& x) { io("p", x.p)("sign", x.sign); }
template <class IO> void describe(IO& io, In<IO, Fraction>& x) { io("num", x.num)("den", x.den); }
template <class IO> void describe(IO& io, In<IO, Membership>& x) {
  describe(io, x.value);
  io("integral", x.integral);
}

// ---- lemmas

void read_entry(const Node& n, LemmaTerm& x, StrataSetting& s) {
  const auto parts = n.items();
  if (parts.empty()) n.fail("a coefficient is expected");
  x.c = parts[0].rational();
  if (kov::sign(x.c) <= 0) parts[0].fail("a positive number is expected");
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const auto f = parts[i].items();
    const std::string kind = f.size() == 3 ? f[0].text() : "";
    if (kind == "square") {
      auto& [q, e] = x.squares.emplace_back(read_poly(*s.ring, f[1]), 0);
      lemma_exponent.read(f[2], e, s);
    } else if (kind == "condition") {
      auto& [index, e] = x.powers.emplace_back();
      any_natural.read(f[1], index, s);
      lemma_exponent.read(f[2], e, s);
    } else {
      parts[i].fail("[\"condition\", i, e] or [\"square\", Q, e] is expected");
    }
  }
}
Json write_entry(const LemmaTerm& x, StrataSetting&) {
  Json::Array term{{to_string(x.c)}};
  const auto add = [&](const std::string& kind, std::string of, unsigned long e) {
    term.push_back({Json::Array{{kind}, {std::move(of)}, {std::to_string(e)}}});
  };
  for (const auto& [i, e] : x.powers)
    add("condition", std::to_string(i), e);
  for (const auto& [q, e] : x.squares)
    add("square", to_string(q), e);
  return {std::move(term)};
}
template <class IO> void describe(IO& io, In<IO, Violation>& x) {
  io("membership", x.membership, any_natural)("value", x.value);
}
template <class IO> void describe(IO& io, In<IO, Lemma>& x) {
  io("p", x.p)("times", x.times)("sign", x.positive, PositiveOrNonzero{})("terms", x.terms);
  io.within("membership", x.violation)("prime", x.prime, Modulus{});
  const int proofs = (x.terms || x.times ? 1 : 0) + (x.violation ? 1 : 0) + (x.prime ? 1 : 0);
  io.check(proofs == 1 && (!x.positive || x.terms), "p", "one proof of the lemma is expected");
}

// ---- leaves

template <class IO> void describe(IO& io, In<IO, ByNumber>& x) { io("certificate", x.certificate); }
template <class IO> void describe(IO& io, In<IO, InvariantPlace>& x) {
  io("q", x.q)("order", x.order)("e", x.e);
}
template <class IO> void describe(IO& io, In<IO, ByInvariant>& x) {
  io("content", x.content)("places", x.places)("m", x.m)("p", x.p);
}
template <class IO> void describe(IO& io, In<IO, StratumPlace>& x) {
  io.unless_empty("chi", x.chi)("irrational", x.irrational);
  io.check(!io.has("chi") || x.chi.size() > 1, "chi", "chi has degree 1 at least");
  io.if_true("log", x.log)("bound", x.bound);
}
template <class IO> void describe(IO& io, In<IO, Minor>& x) {
  io("rows", x.rows, Each<Between>{any_natural})("times", x.times);
}
template <class IO> void describe(IO& io, In<IO, AbsentInvariant>& x) {
  io("m", x.m)("minors", x.minors)("prime", x.prime, Modulus{});
}
template <class IO> void describe(IO& io, In<IO, Growth>& x) {
  io("factor", x.factor)("shift", x.shift);
}
template <class IO> void describe(IO& io, In<IO, ByPlaces>& x) {
  const Described finite{[](auto& o, auto& place) {
    o.always("q", place.q, Stated{})("order", place.order);
    describe(o, place);
  }};
  io("content", x.content)("places", x.places, Each{finite})("infinity", x.infinity);
  io.unless_empty("absent", x.absent)("growth", x.growth);
  for (const AbsentInvariant& one : x.absent)
    io.check(std::ranges::count(x.absent, one.m, &AbsentInvariant::m) == 1, "absent",
             "the degree occurs twice");
}
template <class IO> void describe(IO& io, In<IO, SquaredNumber>& x) {
  io("square", x.square)("root", x.root);
}
template <class IO> void describe(IO& io, In<IO, MultipleOfMembership>& x) {
  io("times", x.times)("membership", x.membership, any_natural);
}
template <class IO> void describe(IO& io, In<IO, ShownMembership>& x) {
  io("value", x.value)("integral", x.integral)("times", x.times);
  io("membership", x.membership, any_natural).unless_empty("with", x.with);
}
template <class IO> void describe(IO& io, In<IO, ByClassical>& x) {
  io("change", x.change)("equation", x.equation).unless_empty("factors", x.factors);
  io("numbers", x.numbers).unless_empty("shown", x.shown);
  io.check(!x.numbers.empty() && (x.family != "whittaker" || x.numbers.size() == 2), "numbers",
           "these are not the numbers of the family");
}
template <class IO> void describe(IO& io, In<IO, LeafNode>& x) {
  io.always("abelian", x.abelian, YesNoOrWhere{})("by", x.by, ProofOfLeaf{});
  const bool classical = std::holds_alternative<ByClassical>(x.by);
  io.check(classical || x.abelian, "abelian", "yes or no is expected");
  io.check(!std::holds_alternative<ByInvariant>(x.by) || *x.abelian, "by",
           "an invariant proves 'yes'");
  io.check(!std::holds_alternative<ByPlaces>(x.by) || !*x.abelian, "by",
           "this theorem proves 'no'");
  describe_kind(io, x.by);
}

// ---- nodes

void read_entry(const Node& n, Subtree& x, StrataSetting& s) {
  if (++s.nodes > max_nodes) n.fail("more than 10000 nodes");
  if (++s.depth > max_node_depth) n.fail("nodes are nested more than 64 deep");
  auto node = std::make_unique<StrataNode>();
  one_of("node", node_words).read(n, node->kind, s);
  x = std::move(node);
  --s.depth;
}
Json write_entry(const Subtree& x, StrataSetting& s) {
  return one_of("node", node_words).write(x->kind, s);
}

template <class IO> void describe(IO& io, In<IO, EmptyStratum>& x) {
  io("terms", x.terms).within("membership", x.violation);
  io.check(!x.terms || !x.violation, "terms", "one proof is expected");
}
template <class IO> void describe(IO& io, In<IO, OutsideStratum>& x) {
  io("generic", x.generic, any_natural);
}
template <class IO> void describe(IO& io, In<IO, OpenStratum>& x) { io("reason", x.reason); }
template <class IO> void describe(IO& io, In<IO, TrustedStratum>& x) {
  io("abelian", x.abelian)("theorem", x.theorem)("statement", x.statement);
  io.check(x.abelian == "yes" || x.abelian == "no" || x.abelian == "empty", "abelian",
           "yes, no or empty is expected");
}
template <class IO> void describe(IO& io, In<IO, SolvedStratum>& x) {
  io("variable", x.variable, Parameter{})("r", x.r)("then", x.then);
}
template <class IO> void describe(IO& io, In<IO, RootStratum>& x) {
  io("variable", x.variable, Parameter{})("certificate", x.certificate);
  io("abelian", x.abelian, yes_or_no);
}
template <class IO> void describe(IO& io, In<IO, SplitNode>& x) {
  io("p", x.p)("nonzero", x.nonzero)("zero", x.zero, one_of("zero", zero_words));
}
template <class IO> void describe(IO& io, In<IO, AssumedNode>& x) {
  io("condition", x.condition, any_natural)("p", x.p)("zero", x.zero, one_of("zero", zero_words));
}
template <class IO> void describe(IO& io, In<IO, LemmasNode>& x) {
  io("lemmas", x.lemmas)("then", x.then);
}

template <class IO> void describe(IO& io, In<IO, StrataCertificate>& x) {
  std::string variable;
  std::vector<std::string> names;
  if constexpr (!IO::reads) {
    names = x.ring->names();
    variable = names.at(x.variable);
    names.erase(names.begin() + static_cast<long>(x.variable));
  }
  io.format("kovacic-strata/1")("variable", variable);
  io("parameters", names, Each<>{{}, max_parameters, "parameters"});
  if constexpr (IO::reads) {
    names.insert(names.begin(), variable);
    x.ring = io.ring_of("parameters", names);
  }
  io.setting.ring = &x.ring;
  io("real", x.real, Marked{})("assumptions", x.assumptions)("generic", x.generic);
  for (const auto& group : x.generic)
    io.check(!group.empty(), "generic", "a group is empty");
  io("r", x.r).object("claim", [&](auto& o) { o.always("abelian", x.abelian, OrNull{}); });
  std::optional<std::vector<bool>> rational;
  if (is_among(true, x.rational)) rational = x.rational;
  io("tree", x.tree)("rational", rational, Marked{}).unless_empty("memberships", x.memberships);
  if constexpr (IO::reads) {
    x.rational = rational.value_or(std::vector<bool>(names.size(), false));
    for (std::size_t i = 0; i < names.size(); ++i)
      x.real[i] = x.real[i] || x.rational[i];
  }
}

StrataCertificate read_strata_certificate(const Node& n) {
  return read_whole<StrataCertificate, StrataSetting>(n);
}
StrataCertificate read_strata_certificate(std::string_view text) {
  return read_whole<StrataCertificate, StrataSetting>(text, strata_json_depth);
}
Json to_json(const StrataCertificate& c) { return whole_json<StrataSetting>(c); }
std::string write_strata_certificate(const StrataCertificate& c) { return to_string(to_json(c)); }

std::optional<std::string> format_of(std::string_view text) {
  if (text.size() > max_text) return std::nullopt;
  const Json json = parse_json(text, strata_json_depth);
  const auto* o = json.object();
  for (std::size_t i = 0; o && i < o->size(); ++i)
    if ((*o)[i].first == "format" && (*o)[i].second.text()) return *(*o)[i].second.text();
  return std::nullopt;
}

} // namespace kov::certify
