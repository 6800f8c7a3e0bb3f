#include "strata/certificate.hpp"

#include "certify/strata_check.hpp"
#include "exact/error.hpp"
#include "strata/leaf_certificate.hpp"

#include <algorithm>
#include <set>

namespace kov::strata {
namespace {

using certify::Json;
using Kind = ProofTree::Kind;

Json text(const std::string& s) { return Json{s}; }
Json text(const MPoly& p) { return Json{to_string(p)}; }
Json text(std::size_t n) { return Json{std::to_string(n)}; }

const char* name_of(Sign s) {
  switch (s) {
  case Sign::zero:
    return "zero";
  case Sign::nonzero:
    return "nonzero";
  case Sign::positive:
    return "positive";
  default:
    return "nonnegative";
  }
}

const char* name_of(Truth t) { return t == Truth::yes ? "yes" : "no"; }

std::vector<std::vector<MPoly>> groups(const Question& q) {
  std::vector<std::vector<MPoly>> all;
  for (const auto& g : q.generic)
    all.push_back(g.not_all_zero);
  return all;
}

bool is_identifier(const std::string& name) {
  const auto letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  return !name.empty() && letter(name.front()) &&
         std::all_of(name.begin(), name.end(),
                     [&](char c) { return letter(c) || (c >= '0' && c <= '9'); });
}

// r on the stratum, as the judge rewrites it.
struct Fraction {
  MPoly num, den; ///< den = 0: r has no value
};

Json to_json(const Fraction& r) {
  return Json{Json::Object{{"num", text(r.num)}, {"den", text(r.den)}}};
}

struct State {
  KnownFacts facts;
  Fraction r;
};

// What the judge has against the text.
std::optional<certify::Rejected> refused(const std::string& json) {
  try {
    const auto opinion = certify::check_strata(certify::read_strata_certificate(json));
    if (const auto* no = std::get_if<certify::Rejected>(&opinion)) return *no;
    return {};
  } catch (const InvalidArgument& e) {
    return certify::Rejected{"", e.what(), true};
  }
}

class Writer {
public:
  Writer(const StrataAnswer& a, const Budget& budget) : a_(a), q_(*a.question), budget_(budget) {}

  StrataCertificate write() {
    for (const auto& name : q_.r.ring()->names())
      if (!is_identifier(name))
        throw InvalidArgument("the format has no algebraic constants like " + name +
                              " beside parameters");
    const State root{KnownFacts(q_.r.ring(), q_.assumptions, groups(q_)), {q_.r.num(), q_.r.den()}};
    Json tree = node(*a_.tree, root);
    Json::Array parameters;
    const auto& names = q_.r.ring()->names();
    for (std::size_t i = 0; i < names.size(); ++i)
      if (i != q_.z) parameters.push_back(text(names[i]));
    const auto listed = [&](const std::vector<std::size_t>& some) {
      Json::Array all;
      for (const std::size_t i : std::set<std::size_t>(some.begin(), some.end()))
        all.push_back(text(names[i]));
      return all;
    };
    Json::Array assumptions;
    for (const auto& c : q_.assumptions.conditions)
      assumptions.push_back(Json{Json::Object{{"p", text(c.p)}, {"sign", text(name_of(c.sign))}}});
    Json::Array generic;
    for (const auto& g : q_.generic) {
      Json::Array group;
      for (const auto& p : g.not_all_zero)
        if (!is_zero(p)) group.push_back(text(p));
      generic.push_back(Json{std::move(group)});
    }
    Json claim;
    if (said_.size() == 1 && !open_) claim = Json{said_.front() == Truth::yes};
    Json::Object whole{{"format", text("kovacic-strata/1")},
                       {"variable", text(names[q_.z])},
                       {"parameters", Json{std::move(parameters)}},
                       {"real", Json{listed(q_.assumptions.real)}},
                       {"assumptions", Json{std::move(assumptions)}},
                       {"generic", Json{std::move(generic)}},
                       {"r", to_json(root.r)},
                       {"claim", Json{Json::Object{{"abelian", std::move(claim)}}}},
                       {"tree", std::move(tree)}};
    if (!q_.assumptions.rational.empty())
      whole.emplace_back("rational", Json{listed(q_.assumptions.rational)});
    if (!q_.assumptions.memberships.empty()) whole.emplace_back("memberships", memberships());
    result_.json = certify::to_string(Json{std::move(whole)});
    result_.says_anything = !said_.empty();
    if (const auto no = refused(result_.json)) {
      result_.refusal = (no->step.empty() ? "" : no->step + ": ") + no->why;
      result_.limit = no->limit;
    }
    return std::move(result_);
  }

private:
  [[nodiscard]] Json memberships() const {
    Json::Array all;
    for (const auto& [value, integral] : q_.assumptions.memberships) {
      const MPoly num = value.num();
      const MPoly den = value.den();
      KOV_ENSURE(MFraction(num) / MFraction(den) == value);
      all.push_back(
          Json{Json::Object{{"num", text(num)}, {"den", text(den)}, {"integral", Json{integral}}}});
    }
    return Json{std::move(all)};
  }

  void say(Truth t) {
    if (std::find(said_.begin(), said_.end(), t) == said_.end()) said_.push_back(t);
  }

  static Json with_lemmas(const std::vector<Lemma>& lemmas, Json then) {
    if (lemmas.empty()) return then;
    Json::Array all;
    for (const auto& l : lemmas)
      all.push_back(strata::to_json(l));
    return Json{Json::Object{
        {"node", text("lemmas")}, {"lemmas", Json{std::move(all)}}, {"then", std::move(then)}}};
  }

  // key: "node" or "zero", by the place of the object.
  Json open(const char* key, const std::string& why) {
    open_ = true;
    return Json{Json::Object{{key, text("open")}, {"reason", text(why)}}};
  }
  Json trusted(const char* key, const char* abelian, const std::string& theorem,
               const std::string& why) {
    ++result_.trusted;
    result_.uncertified.push_back(theorem + ": " + why);
    return Json{Json::Object{{key, text("trusted")},
                             {"abelian", text(abelian)},
                             {"theorem", text(theorem)},
                             {"statement", text(why)}}};
  }

  Json node(const ProofTree& t, State state) {
    budget_.check();
    switch (t.kind) {
    case Kind::split:
    case Kind::assumed:
      return split(t, std::move(state));
    case Kind::leaf:
      return leaf(t, std::move(state));
    case Kind::empty:
      return empty("node", t, state);
    default:
      return open("node", t.why);
    }
  }

  Json leaf(const ProofTree& t, State state) {
    const Leaf& l = *t.leaf;
    if (l.no_equation) {
      if (auto outside = no_points(state)) return *std::move(outside);
      return open("node", l.open_condition);
    }
    if (l.abelian == Truth::unknown) return open("node", l.open_condition);
    say(l.abelian);
    std::vector<Lemma> lemmas;
    try {
      const MFraction r(state.r.num, state.r.den);
      Json n = leaf_certificate(l, r, q_.z, *t.region, state.facts, lemmas, budget_);
      return with_lemmas(lemmas, std::move(n));
    } catch (const NoProof& why) {
      return trusted("node", name_of(l.abelian), "the solver", l.reason + " (" + why.what() + ")");
    }
  }

  // No admitted points: r has no value, or all polynomials of a group are 0.
  [[nodiscard]] static std::optional<Json> no_points(const State& state) {
    Json::Object o{{"node", text("outside")}};
    if (is_zero(state.r.den)) return Json{std::move(o)};
    const auto& generic = state.facts.generic();
    for (std::size_t i = 0; i < generic.size(); ++i)
      if (std::all_of(generic[i].begin(), generic[i].end(),
                      [](const MPoly& p) { return is_zero(p); })) {
        o.emplace_back("generic", text(i));
        return Json{std::move(o)};
      }
    return std::nullopt;
  }

  Json split(const ProofTree& t, State state) {
    std::vector<Lemma> lemmas;
    Json::Object o;
    if (t.kind == Kind::split) {
      o = {{"node", text("split")}, {"p", text(t.p)}};
    } else {
      const auto i = assumed(t.p, state.facts);
      if (!i) return open("node", "an assumed equation is not recognised");
      o = {{"node", text("assumed")}, {"condition", text(*i)}, {"p", text(t.p)}};
    }
    // what the branches need is proved before the split
    const auto x = solvable(t, state.facts, lemmas);
    if (t.kind == Kind::split) {
      State other(state);
      other.facts.assume_nonzero(t.p);
      o.emplace_back("nonzero", node(*t.nonzero, std::move(other)));
    }
    o.emplace_back("zero", zero(t, std::move(state), x));
    return with_lemmas(lemmas, Json{std::move(o)});
  }

  // The condition from which p = 0 follows.
  static std::optional<std::size_t> assumed(const MPoly& p, const KnownFacts& facts) {
    const auto& all = facts.conditions();
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i].sign != Sign::zero || is_zero(all[i].p)) continue;
      MPoly rest = facts.without_known_factors(all[i].p);
      bool divided = false;
      while (auto q = divides(p, rest)) {
        rest = *std::move(q);
        divided = true;
      }
      if (divided && is_constant(rest)) return i;
    }
    return std::nullopt;
  }

  // The parameter that p = 0 is solved for: the solver's, or any where the stratum is empty.
  static std::optional<std::size_t> solvable(const ProofTree& t, KnownFacts& facts,
                                             std::vector<Lemma>& lemmas) {
    const ProofTree& zero = *t.zero;
    if (zero.kind == Kind::root || zero.kind == Kind::related) return std::nullopt;
    for (const std::size_t x : used_variables(t.p)) {
      if (degree(t.p, x) != 1) continue;
      if (zero.kind != Kind::empty && !zero.region->solved().contains(x)) continue;
      if (facts.ensure_nonzero(coefficients(t.p, x)[1], lemmas)) return x;
    }
    return std::nullopt;
  }

  Json zero(const ProofTree& t, State state, const std::optional<std::size_t>& x) {
    const ProofTree& there = *t.zero;
    if (there.kind == Kind::root) return root(there, state);
    if (there.kind == Kind::related)
      return open("zero", "the format has no rule for an equation that is not solved");
    if (!x) {
      if (there.kind == Kind::empty) return trusted("zero", "empty", "Z3", there.why);
      return open("zero", "division by a polynomial without an exact proof that it is not 0");
    }
    const auto line = coefficients(t.p, *x);
    const long n = std::max({0L, degree(state.r.num, *x), degree(state.r.den, *x)});
    const Fraction r{on_line(state.r.num, *x, line[1], line[0], n),
                     on_line(state.r.den, *x, line[1], line[0], n)};
    state.facts.solve(t.p, *x);
    Json::Object o{{"zero", text("solve")}, {"variable", text(q_.r.ring()->name(*x))}};
    state.r = r;
    if (!is_zero(r.den)) {
      const MFraction reduced(r.num, r.den);
      state.r = {reduced.num(), reduced.den()};
      o.emplace_back("r", to_json(state.r));
    }
    Json then =
        there.kind == Kind::empty ? empty("node", there, state) : node(there, std::move(state));
    o.emplace_back("then", std::move(then));
    return Json{std::move(o)};
  }

  Json empty(const char* key, const ProofTree& t, const State& state) {
    Json plain{Json::Object{{key, text("empty")}}};
    const auto& all = state.facts.conditions();
    const bool plainly = state.facts.contains_zero() ||
                         std::any_of(all.begin(), all.end(), [&](const KnownFacts::Fact& c) {
                           if (c.dropped) return false;
                           if (c.sign == Sign::positive) return is_zero(c.p);
                           if (c.sign != Sign::zero || is_zero(c.p)) return false;
                           return is_constant(state.facts.without_known_factors(c.p));
                         });
    if (plainly) return plain;
    if (const auto v = state.facts.violation()) {
      Json::Object o{{key, text("empty")}};
      append(o, *v);
      return Json{std::move(o)};
    }
    if (auto terms = state.facts.contradiction())
      return Json{Json::Object{{key, text("empty")}, {"terms", strata::to_json(*terms)}}};
    return trusted(key, "empty", "Z3", t.why);
  }

  Json root(const ProofTree& t, const State& state) {
    const Leaf& l = *t.leaf;
    if (l.no_equation) {
      Json::Object o{{"zero", text("outside")}};
      const auto divisible = [&](const std::vector<MPoly>& all) {
        return std::all_of(all.begin(), all.end(),
                           [&](const MPoly& f) { return is_zero(f) || divides(t.p, f); });
      };
      if (divisible(coefficients(state.r.den, q_.z))) return Json{std::move(o)};
      const auto& generic = state.facts.generic();
      for (std::size_t i = 0; i < generic.size(); ++i)
        if (divisible(generic[i])) {
          o.emplace_back("generic", text(i));
          return Json{std::move(o)};
        }
    }
    if (l.abelian == Truth::unknown || !l.number) return open("zero", l.open_condition);
    say(l.abelian);
    try {
      return Json{Json::Object{{"zero", text("root")},
                               {"variable", text(q_.r.ring()->name(used_variables(t.p).front()))},
                               {"certificate", number_certificate(*l.number)},
                               {"abelian", text(name_of(l.abelian))}}};
    } catch (const NoProof& why) {
      return trusted("zero", name_of(l.abelian), "the solver", l.reason + " (" + why.what() + ")");
    }
  }

  const StrataAnswer& a_;
  const Question& q_;
  const Budget& budget_;
  StrataCertificate result_;
  std::vector<Truth> said_;
  bool open_ = false;
};

} // namespace

StrataCertificate certificate(const StrataAnswer& a, const Budget& budget) {
  if (a.certificate) return *a.certificate;
  KOV_ENSURE(a.tree && a.question);
  return Writer(a, budget).write();
}

void certify(StrataAnswer& a, const Budget& budget) {
  try {
    a.certificate = std::make_shared<StrataCertificate>(certificate(a, budget));
  } catch (const InvalidArgument&) { // who asks for it is told why there is none
    return;
  } catch (const OutOfBudget&) {
    return;
  }
  if (a.certificate->refusal.empty() || a.certificate->limit) return;
  a.refusal = a.certificate->refusal;
  for (Stratum& s : a.strata) {
    if (s.leaf.abelian == Truth::unknown) continue;
    s.leaf = {};
    s.leaf.open_condition =
        "our own checker refuses the certificate of what was found: " + a.refusal;
    s.leaf.reason = "undecided: " + s.leaf.open_condition;
  }
}

} // namespace kov::strata
