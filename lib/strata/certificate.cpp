#include "strata/certificate.hpp"

#include "certify/strata/check.hpp"
#include "decide/afterwards.hpp"
#include "exact/lists.hpp"
#include "exact/tried.hpp"
#include "proof/text/json_node.hpp"
#include "strata/leaf_certificate.hpp"
#include "strata/words.hpp"

#include <algorithm>

namespace kov::strata {
namespace {

using certify::EmptyStratum;
using certify::Fraction;
using certify::OpenStratum;
using certify::OutsideStratum;
using certify::StrataNode;
using certify::Subtree;
using certify::TrustedStratum;
using certify::WhereZero;
using Kind = ProofTree::Kind;

template <class Node> Subtree node_of(Node n) {
  return std::make_unique<const StrataNode>(StrataNode{std::move(n)});
}

std::vector<std::vector<MPoly>> groups(const Question& q) {
  return mapped<std::vector<MPoly>>(q.generic, [&](const auto& g) { return g.not_all_zero; });
}

struct State {
  KnownFacts facts;
  Fraction r; ///< on the stratum, as the checker rewrites it; den = 0: r has no value
};

// The checker's objection to the text, if it has one.
std::optional<certify::Rejected> refused(const std::string& json) {
  try {
    const auto opinion = certify::check_strata(certify::read_strata_certificate(json));
    if (const auto* no = std::get_if<certify::Rejected>(&opinion)) return *no;
    return {};
  } catch (const InvalidArgument& e) {
    return certify::Rejected{{e.what(), true}};
  }
}

class Writer {
public:
  Writer(const StrataAnswer& a, const Budget& budget) : a_(a), q_(*a.question), budget_(budget) {}

  StrataCertificate write() {
    for (const auto& name : q_.r.ring()->names())
      if (!certify::is_name(name))
        throw InvalidArgument("the format has no algebraic constants like " + name +
                              " beside parameters");
    whole_.ring = q_.r.ring();
    whole_.variable = q_.z;
    whole_.r = {q_.r.num(), q_.r.den()};
    take_assumptions();
    whole_.tree = node(*a_.tree, {KnownFacts(q_.r.ring(), q_.assumptions, groups(q_)), whole_.r});
    if (said_.size() == 1 && !open_) whole_.abelian = said_.front() == Truth::yes;
    result_.json = certify::write_strata_certificate(whole_);
    result_.says_anything = result_.says_anything || !said_.empty();
    if (const auto no = refused(result_.json)) {
      result_.refusal = (no->step.empty() ? "" : no->step + ": ") + no->why;
      result_.limit = no->limit;
    }
    return std::move(result_);
  }

private:
  void take_assumptions() {
    const auto marked = [&](const std::vector<std::size_t>& some) {
      std::vector<bool> all(q_.r.ring()->size(), false);
      for (const std::size_t i : some)
        all[i] = true;
      return all;
    };
    whole_.real = marked(q_.assumptions.real);
    whole_.rational = marked(q_.assumptions.rational);
    whole_.assumptions = q_.assumptions.conditions;
    for (const auto& [value, integral] : q_.assumptions.memberships) {
      const Fraction f{value.num(), value.den()};
      KOV_ENSURE(MFraction(f.num) / MFraction(f.den) == value);
      whole_.memberships.push_back({f, integral});
    }
    whole_.generic = groups(q_);
    for (auto& group : whole_.generic)
      std::erase_if(group, [](const MPoly& p) { return is_zero(p); });
  }

  void say(Truth t) { add_once(said_, t); }

  static Subtree with_lemmas(std::vector<Lemma> lemmas, Subtree then) {
    if (lemmas.empty()) return then;
    return node_of(certify::LemmasNode{std::move(lemmas), std::move(then)});
  }

  OpenStratum open(const std::string& why) {
    open_ = true;
    return {why};
  }
  // The decided strata of this tree are not written.
  void leave_out(const ProofTree& t, Gap gap) {
    if (t.leaf && t.leaf->abelian != Truth::unknown)
      result_.left_out.push_back({gap, t.leaf->by, {Trusted::Step::gap, to_string(gap)}});
    for (const ProofTreePtr& child : {t.nonzero, t.zero})
      if (child) leave_out(*child, gap);
  }
  OpenStratum open(const ProofTree& there, Gap gap) {
    leave_out(there, gap);
    return open(to_string(gap));
  }
  TrustedStratum trusted(const Leaf& leaf, const NoProof& why) {
    const std::string statement = reason(leaf) + " (" + why.what() + ")";
    result_.trusted.push_back({why.gap, leaf.by, {Trusted::Step::solver, statement}});
    return {leaf.abelian == Truth::yes ? "yes" : "no", "the solver", statement};
  }
  TrustedStratum trusted_empty(const ProofTree& t) {
    std::string why = to_string(t.ended);
    if (const auto* by_z3 = std::get_if<Trusted>(&t.ended)) {
      result_.trusted.push_back({Gap::emptiness, Conclusion::none, *by_z3});
      return {"empty", "Z3", why};
    }
    if (why.empty()) why = "the assumptions contradict each other";
    result_.trusted.push_back({Gap::rule, Conclusion::none, {Trusted::Step::solver, why}});
    return {"empty", "the solver", why};
  }

  Subtree node(const ProofTree& t, State state) {
    budget_.check();
    switch (t.kind) {
    case Kind::split:
    case Kind::assumed:
      return split(t, std::move(state));
    case Kind::leaf:
      return leaf(t, std::move(state));
    case Kind::empty:
      return empty(t, state);
    default:
      return node_of(open(to_string(t.ended)));
    }
  }

  Subtree leaf(const ProofTree& t, State state) {
    const Leaf& l = *t.leaf;
    if (l.no_equation())
      if (auto outside = no_points(state)) return node_of(*outside);
    std::vector<Lemma> lemmas;
    if (l.abelian == Truth::unknown) return parts(t, state, lemmas);
    say(l.abelian);
    try {
      const MFraction r(state.r.num, state.r.den);
      auto n = leaf_certificate(l, r, *t.region, state.facts, lemmas, budget_);
      return with_lemmas(std::move(lemmas), node_of(std::move(n)));
    } catch (const NoProof& why) {
      return node_of(trusted(l, why));
    }
  }

  // The parts of an open stratum: a closed criterion tells where it is abelian.
  Subtree parts(const ProofTree& t, State& state, std::vector<Lemma>& lemmas) {
    const Leaf& l = *t.leaf;
    if (is_zero(state.r.den)) return node_of(open(open_condition(l)));
    const MFraction r(state.r.num, state.r.den);
    auto n = tried<NoProof>([&] { // else nothing is said of the parts
      return criterion_certificate(l, r, *t.region, state.facts, lemmas, budget_);
    });
    if (!n) return node_of(open(open_condition(l)));
    open_ = result_.says_anything = true; // more than one verdict
    return with_lemmas(std::move(lemmas), node_of(*std::move(n)));
  }

  // No admitted points: r has no value, or all polynomials of a group are 0.
  [[nodiscard]] static std::optional<OutsideStratum> no_points(const State& state) {
    if (is_zero(state.r.den)) return OutsideStratum{};
    const auto& generic = state.facts.generic();
    for (std::size_t i = 0; i < generic.size(); ++i)
      if (std::ranges::all_of(generic[i], [](const MPoly& p) { return is_zero(p); }))
        return OutsideStratum{i};
    return std::nullopt;
  }

  Subtree split(const ProofTree& t, State state) {
    const bool both = t.kind == Kind::split;
    const auto condition = both ? std::nullopt : assumed(t.p, state.facts);
    if (!both && !condition) return node_of(open(t, Gap::assumption));
    // what the branches need is proved before the split
    std::vector<Lemma> lemmas;
    const auto x = solvable(t, state.facts, lemmas);
    if (!both)
      return with_lemmas(std::move(lemmas), node_of(certify::AssumedNode{
                                                *condition, t.p, zero(t, std::move(state), x)}));
    State other(state);
    other.facts.assume_nonzero(t.p);
    Subtree nonzero = node(*t.nonzero, std::move(other));
    return with_lemmas(
        std::move(lemmas),
        node_of(certify::SplitNode{t.p, std::move(nonzero), zero(t, std::move(state), x)}));
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

  WhereZero zero(const ProofTree& t, State state, const std::optional<std::size_t>& x) {
    const ProofTree& there = *t.zero;
    if (there.kind == Kind::root) return root(there, state);
    if (there.kind == Kind::related) return open(there, Gap::relation);
    if (!x) {
      if (there.kind == Kind::empty) return trusted_empty(there);
      return open(there, Gap::division);
    }
    certify::SolvedStratum solved;
    solved.variable = *x;
    solved.r = substituted(state.r, coefficients(t.p, *x), *x);
    state.facts.solve(t.p, *x);
    state.r = *solved.r;
    if (is_zero(solved.r->den)) solved.r.reset();
    solved.then = there.kind == Kind::empty ? empty(there, state) : node(there, std::move(state));
    return solved;
  }

  // r where line[1] x + line[0] = 0.
  static Fraction substituted(const Fraction& r, const std::vector<MPoly>& line, std::size_t x) {
    const long n = std::max({0L, degree(r.num, x), degree(r.den, x)});
    Fraction f{on_line(r.num, x, line[1], line[0], n), on_line(r.den, x, line[1], line[0], n)};
    if (is_zero(f.den)) return f;
    const MFraction reduced(f.num, f.den);
    return {reduced.num(), reduced.den()};
  }

  Subtree empty(const ProofTree& t, const State& state) {
    const auto& all = state.facts.conditions();
    const bool plainly =
        state.facts.contains_zero() || std::ranges::any_of(all, [&](const Condition& c) {
          if (c.sign == Sign::positive) return is_zero(c.p);
          if (c.sign != Sign::zero || is_zero(c.p)) return false;
          return is_constant(state.facts.without_known_factors(c.p));
        });
    if (plainly) return node_of(EmptyStratum{});
    if (const auto v = state.facts.violation()) return node_of(EmptyStratum{{}, v});
    if (auto terms = state.facts.contradiction()) return node_of(EmptyStratum{std::move(terms)});
    return node_of(trusted_empty(t));
  }

  // No admitted points with p = 0.
  [[nodiscard]] std::optional<OutsideStratum> outside(const MPoly& p, const State& state) const {
    const auto divisible = [&](const std::vector<MPoly>& all) {
      return std::ranges::all_of(all, [&](const MPoly& f) { return is_zero(f) || divides(p, f); });
    };
    if (divisible(coefficients(state.r.den, q_.z))) return OutsideStratum{};
    const auto& generic = state.facts.generic();
    for (std::size_t i = 0; i < generic.size(); ++i)
      if (divisible(generic[i])) return OutsideStratum{i};
    return std::nullopt;
  }

  WhereZero root(const ProofTree& t, const State& state) {
    const Leaf& l = *t.leaf;
    if (l.no_equation())
      if (const auto none = outside(t.p, state)) return *none;
    const auto* number = evidence<Number>(l);
    if (l.abelian == Truth::unknown || number == nullptr) return open(open_condition(l));
    say(l.abelian);
    try {
      return certify::RootStratum{used_variables(t.p).front(), number_certificate(number->decision),
                                  l.abelian == Truth::yes};
    } catch (const NoProof& why) {
      return trusted(l, why);
    }
  }

  const StrataAnswer& a_;
  const Question& q_;
  const Budget& budget_;
  certify::StrataCertificate whole_;
  StrataCertificate result_;
  std::vector<Truth> said_;
  bool open_ = false;
};

} // namespace

std::string objection(const StrataCertificate& c) {
  return (c.limit ? "it is beyond a limit of our own checker: " : "our own checker refuses it: ") +
         c.refusal;
}

StrataCertificate certificate(const StrataAnswer& a, const Budget& budget) {
  if (a.certificate) return *a.certificate;
  KOV_ENSURE(a.tree && a.question);
  return Writer(a, budget).write();
}

namespace {

void trust_without_certificate(StrataAnswer& a, const std::string& why) {
  const bool somewhere_decided = std::ranges::any_of(
      a.strata, [](const Stratum& x) { return x.leaf.abelian != Truth::unknown; });
  if (somewhere_decided) add_each_once(a.trusted, {{Trusted::Step::uncertified_strata, why}});
}

// Adds the steps that the checker believes, or does not hear of.
void trust_what_is_not_checked(StrataAnswer& a) {
  for (const auto* list : {&a.certificate->trusted, &a.certificate->left_out})
    for (const Uncertified& u : *list)
      if (u.gap != Gap::emptiness || a.trusted.empty()) // Z3, listed already
        add_each_once(a.trusted, {u.told});
}

} // namespace

void certify(StrataAnswer& a, const Budget& budget) {
  try {
    a.certificate = std::make_shared<StrataCertificate>(certificate(a, budget));
  } catch (const Contradiction&) {
    throw;
  } catch (const InternalError& why) {
    return trust_without_certificate(a, failure_of("the certificate", why.what()));
  } catch (const InvalidArgument& why) {
    return trust_without_certificate(a, why.what());
  } catch (const OutOfBudget& why) {
    return trust_without_certificate(a, why.what());
  }
  if (a.certificate->limit) return trust_without_certificate(a, objection(*a.certificate));
  if (a.certificate->refusal.empty()) return trust_what_is_not_checked(a);
  a.refusal = a.certificate->refusal;
  for (Stratum& s : a.strata) {
    if (s.leaf.abelian == Truth::unknown && s.leaf.parts.empty()) continue;
    s.leaf = open_leaf(RefusedByChecker{a.refusal});
  }
}

} // namespace kov::strata
