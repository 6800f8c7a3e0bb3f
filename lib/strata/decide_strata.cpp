#include "strata/decide_strata.hpp"

#include "decide/afterwards.hpp"
#include "exact/lists.hpp"
#include "exact/tried.hpp"
#include "parameters/signs.hpp"
#include "strata/certificate.hpp"
#include "strata/decide_leaf.hpp"
#include "strata/words.hpp"

#include <algorithm>
#include <exception>

namespace kov::strata {

Truth StrataAnswer::abelian() const {
  if (strata.empty() || !unvisited.empty()) return Truth::unknown;
  const Truth first = strata.front().leaf.abelian;
  for (const auto& s : strata)
    if (s.leaf.abelian != first) return Truth::unknown;
  return first;
}

bool StrataAnswer::decided() const {
  const auto all = told_apart();
  return unvisited.empty() && !all.empty() && std::ranges::all_of(all, [](const Stratum& s) {
           return s.leaf.abelian != Truth::unknown;
         });
}

std::vector<Stratum> told_apart(const Stratum& s) {
  if (s.leaf.parts.empty()) return {s};
  std::vector<Stratum> all;
  for (const Part& p : s.leaf.parts) {
    Stratum one = s;
    one.arithmetic = p.where;
    Leaf& leaf = one.leaf;
    leaf.parts.clear();
    leaf.abelian = p.abelian;
    leaf.group = p.group;
    leaf.bound = p.bound;
    if (p.abelian != Truth::unknown && leaf.open) {
      const bool closed = evidence<ClassicalForm>(leaf) != nullptr;
      leaf.by = closed ? Conclusion::classical : Conclusion::not_special;
      if (!closed) leaf.because.emplace_back(ConditionFails{*leaf.open});
      leaf.open.reset();
    }
    all.push_back(std::move(one));
  }
  return all;
}

std::vector<Stratum> StrataAnswer::told_apart() const {
  std::vector<Stratum> all;
  for (const Stratum& s : strata)
    std::ranges::move(strata::told_apart(s), std::back_inserter(all));
  return all;
}

namespace {

Leaf no_value() { return open_leaf(NoEquation{}); }
Leaf no_reduction(const Genericity& g) {
  return open_leaf(NoEquation{NoEquation::Why::reduction, sentence(g)});
}

bool is_assumed(const Needs& needs) { return needs.why.kind == Event::Kind::assumed; }

// The field of a root of p in its one variable x, and x in it: x = generator/lead; texts show x.
struct RootField {
  std::size_t variable;
  Field field;
  Rational lead;
};
std::optional<RootField> root_field(const MPoly& p) {
  const auto used = used_variables(p);
  if (used.size() != 1) return std::nullopt;
  const auto c = coefficients(p, used[0]);
  const auto n = static_cast<long>(c.size()) - 1;
  const Integer lead = c.back().coefficient(0);
  std::vector<Integer> minimal;
  for (long i = 0; i <= n; ++i) {
    const auto& ci = c[static_cast<std::size_t>(i)];
    const Integer value = is_zero(ci) ? Integer(0) : ci.coefficient(0);
    minimal.push_back(i == n ? Integer(1)
                             : value * pow(lead, static_cast<unsigned long>(n - 1 - i)));
  }
  return RootField{used[0], make_field(minimal, p.ring()->name(used[0]), 0, lead), Rational(lead)};
}

using Kind = ProofTree::Kind;

constexpr std::size_t max_relations = 3; // algebraic equations that are kept on one stratum

ProofTreePtr grown(Kind kind, const ParametrisedSet& region, MPoly p, std::optional<Leaf> leaf,
                   WhyEnded ended = {}, ProofTreePtr nonzero = {}, ProofTreePtr zero = {}) {
  return std::make_shared<ProofTree>(
      ProofTree{kind, std::move(p), std::make_shared<ParametrisedSet>(region), std::move(nonzero),
                std::move(zero), std::move(leaf), std::move(ended)});
}

class Tree {
public:
  Tree(const Question& q, const StrataLimits& limits) : q_(q), limits_(limits) {}

  StrataAnswer grow() {
    const auto start = Budget::Clock::now();
    const ParametrisedSet root(q_.r.ring(), q_.assumptions);
    answer_.question = std::make_shared<Question>(q_);
    answer_.contradictory = root.is_empty();
    trust(root.trusted());
    if (!answer_.contradictory) answer_.tree = node(root, 0);
    if (error_ && !decides_something()) std::rethrow_exception(error_);
    answer_.contradictory = answer_.strata.empty() && answer_.unvisited.empty();
    answer_.seconds = std::chrono::duration<double>(Budget::Clock::now() - start).count();
    return std::move(answer_);
  }

private:
  [[nodiscard]] bool decides_something() const {
    const auto all = answer_.told_apart();
    return std::ranges::any_of(all,
                               [](const Stratum& s) { return s.leaf.abelian != Truth::unknown; });
  }

  void trust(const std::vector<Trusted>& steps) { add_each_once(answer_.trusted, steps); }

  // The conditions of the region, to stand behind "for".
  static std::string place_of(const ParametrisedSet& region) {
    return region.path().empty() ? "all parameters" : to_string(region.path());
  }

  ProofTreePtr unvisited(const ParametrisedSet& region, const WhyEnded& why) {
    const auto* ended = std::get_if<Ended>(&why);
    answer_.unvisited.push_back(place_of(region) + (ended ? " (" + ended->shown + ")" : ""));
    return grown(Kind::open, region, {}, {}, why);
  }

  ProofTreePtr node(const ParametrisedSet& region, int depth) {
    try {
      limits_.decide.budget.check();
      if (answer_.strata.size() >= limits_.max_strata || depth > 60)
        return unvisited(region, TooManyStrata{});
      auto answer = look(region);
      trust(region.trusted());
      if (auto* leaf = std::get_if<Leaf>(&answer)) return add(region, std::move(*leaf));
      return split(region, std::get<Needs>(answer), depth);
    } catch (const OutOfBudget& limit) {
      return unvisited(region, Ended{limit.what()});
    } catch (const Contradiction&) {
      throw;
    } catch (const InternalError& e) {
      return failed(region, e.what());
    } catch (const DomainError& e) {
      return failed(region, e.what());
    }
  }

  // An error of the program costs this part of the parameters only.
  ProofTreePtr failed(const ParametrisedSet& region, const std::string& what) {
    if (!error_) error_ = std::current_exception();
    return unvisited(region, Ended{failure_of("the decision there", what)});
  }

  std::variant<Leaf, Needs> look(const ParametrisedSet& region) const {
    if (const auto p = region.pending()) {
      if (const auto doubt = region.doubtful_factor(*p))
        return Needs{*doubt, {Event::Kind::assumed}};
      return Needs{MPoly(region.ring(), Integer(1)), {Event::Kind::assumed}};
    }
    for (const auto& g : q_.generic)
      if (auto answer = generic(g, region)) return *std::move(answer);
    const auto r = value_on(region);
    if (!r) return no_value();
    if (const auto* relation = only_constant(*r, region))
      return at_root(*r, *relation).value_or(no_value());
    return decide_leaf(*r, q_.z, region, limits_.decide);
  }

  // r in the parameters that are left.
  [[nodiscard]] std::optional<MFraction> value_on(const ParametrisedSet& region) const {
    try {
      MFraction r = region.restrict(q_.r);
      const auto below = coefficients(r.den(), q_.z);
      if (std::ranges::all_of(below, [&](const MPoly& f) { return vanishes(f, region); }))
        return std::nullopt;
      return r;
    } catch (const DomainError&) {
      return std::nullopt;
    }
  }

  // Does f vanish on the region, also by an equation that is kept?
  static bool vanishes(const MPoly& f, const ParametrisedSet& region) {
    const auto& all = region.relations();
    return is_zero(f) || std::ranges::any_of(all, [&](const ParametrisedSet::Relation& r) {
             return divides(r.p, f).has_value();
           });
  }

  // The irreducible equation of the one parameter in r: r is a number but for z.
  [[nodiscard]] const MPoly* only_constant(const MFraction& r,
                                           const ParametrisedSet& region) const {
    std::vector<std::size_t> used = used_variables(r);
    std::erase(used, q_.z);
    if (used.size() != 1) return nullptr;
    for (const auto& relation : region.relations())
      if (used_variables(relation.p) == used) return &relation.p;
    return nullptr;
  }

  // The verdict over Q[x]/(p), p irreducible in one parameter; unset where r has no value.
  [[nodiscard]] std::optional<Leaf> at_root(const MFraction& r, const MPoly& p) const {
    const auto root = root_field(p);
    if (!is_constant(gcd(r.den(), p))) return std::nullopt;
    const MFraction x = MFraction::variable(r.ring(), root->variable);
    const MFraction scaled = substitute(r, {{root->variable, (Rational(1) / root->lead) * x}});
    NormalForm equation;
    equation.r = to_rational_function(scaled, q_.z, AlgebraicConstant{root->variable, root->field});
    return leaf_of(decide(equation, limits_.decide));
  }

  // One of the coefficients is known not to vanish, or they are looked at one after the other.
  static std::optional<std::variant<Leaf, Needs>> generic(const Genericity& g,
                                                          const ParametrisedSet& region) {
    std::optional<Needs> needs;
    for (const auto& p : g.not_all_zero) {
      MFraction there;
      try {
        there = region.restrict(MFraction(p));
      } catch (const DomainError&) {
        continue;
      }
      if (is_zero(there) || vanishes(there.num(), region)) continue;
      const auto doubt = region.doubtful_factor(there.num());
      if (!doubt) return std::nullopt;
      if (!needs) needs = Needs{*doubt, {.kind = Event::Kind::reduction, .shown = sentence(g)}};
    }
    if (needs) return *needs;
    return no_reduction(g);
  }

  ProofTreePtr split(const ParametrisedSet& region, const Needs& needs, int depth) {
    const bool assumed = is_assumed(needs); // p = 0 on one of the two sides only
    if (is_constant(needs.p)) return prune(region, {}, AssumedEquationFails{});
    for (const auto& relation : region.relations()) // true here, and r does not show it
      if (divides(needs.p, relation.p))
        return add(region, open_leaf(NotSolved{needs.p, needs.why}));
    auto zero = region.where_zero(needs.p);
    if (const auto* first = std::get_if<ParametrisedSet::Split>(&zero))
      return split(region, Needs{first->by, {.kind = Event::Kind::divided_by, .solved = needs.p}},
                   depth);
    ProofTreePtr nonzero;
    if (!assumed || has_other_factor(region, needs.p))
      nonzero = other_side(region.where_nonzero(needs.p), needs.p, depth);
    const Kind kind = nonzero ? Kind::split : Kind::assumed;
    return grown(kind, region, needs.p, {}, {}, std::move(nonzero),
                 where_zero(region, needs, zero, depth));
  }

  ProofTreePtr other_side(const ParametrisedSet& there, const MPoly& p, int depth) {
    return there.is_empty_exactly() ? prune(there, p, ContradictsAssumptions{})
                                    : node(there, depth + 1);
  }

  ProofTreePtr where_zero(const ParametrisedSet& region, const Needs& needs,
                          const std::variant<ParametrisedSet, ParametrisedSet::Empty,
                                             ParametrisedSet::Split, ParametrisedSet::Stuck>& zero,
                          int depth) {
    if (const auto* there = std::get_if<ParametrisedSet>(&zero)) {
      trust(there->trusted());
      return node(*there, depth + 1);
    }
    if (const auto* empty = std::get_if<ParametrisedSet::Empty>(&zero)) {
      trust(empty->trusted);
      auto path = region.path();
      path.push_back({needs.p, Sign::zero});
      answer_.pruned.push_back(to_string(path));
      return grown(Kind::empty, region, needs.p, {},
                   empty->trusted.empty() ? WhyEnded{} : empty->trusted.back());
    }
    return stuck(region, needs, depth);
  }

  ProofTreePtr prune(const ParametrisedSet& region, const MPoly& p, const WhyEnded& why) {
    answer_.pruned.push_back(to_string(region.path()) + " (" + to_string(why) + ")");
    return grown(Kind::empty, region, p, {}, why);
  }

  // Has the pending equation p1 p2 = 0 another factor?  It has to be zero where p1 is not.
  static bool has_other_factor(const ParametrisedSet& region, const MPoly& p) {
    return region.where_nonzero(p).pending().has_value() &&
           region.where_nonzero(p).doubtful_factor(*region.pending()).has_value();
  }

  // No parameter is linear in p: numbers, or an open stratum.
  ProofTreePtr stuck(const ParametrisedSet& region, const Needs& needs, int depth) {
    auto path = region.path();
    path.push_back({needs.p, Sign::zero});
    const auto add_here = [&](const Leaf& leaf) {
      answer_.strata.push_back({std::move(path), leaf, region.solved()});
      return grown(Kind::root, region, needs.p, leaf);
    };
    const auto root = root_field(needs.p);
    const auto restricted = value_on(region);
    if (!restricted) return add_here(no_value());
    const MFraction& r = *restricted;
    const auto used = used_variables(r);
    const bool number = root && std::ranges::all_of(used, [&](std::size_t i) {
                          return i == q_.z || i == root->variable;
                        });
    // numbers but for z, and every genericity holds or fails at the roots: at once
    const bool settled =
        number && std::ranges::all_of(q_.generic, [&](const Genericity& g) {
          return holds_at_root(g, region, needs.p) || fails_at_root(g, region, needs.p);
        });
    if (!settled)
      if (auto there = related(region, needs, depth)) return there;
    if (!number) return add_here(open_leaf(NotSolved{needs.p, needs.why}));
    if (region.has_no_real_root(needs.p))
      return prune(region, needs.p, Trusted{Trusted::Step::no_root_by_z3, to_string(needs.p)});
    for (const auto& g : q_.generic)
      if (!holds_at_root(g, region, needs.p))
        return add_here(fails_at_root(g, region, needs.p)
                            ? no_reduction(g)
                            : open_leaf(NotSolved{needs.p, needs.why}));
    return add_here(at_root(r, needs.p).value_or(no_value()));
  }

  // p = 0 is kept as a relation between the parameters; unset where that has no use.
  ProofTreePtr related(const ParametrisedSet& region, const Needs& needs, int depth) {
    if (region.relations().size() >= max_relations) return {};
    for (const std::size_t x : used_variables(needs.p)) {
      const MPoly lead = coefficients(needs.p, x).back();
      if (!is_constant(lead) && region.doubtful_factor(lead)) continue;
      const bool implied = is_assumed(needs) && !has_other_factor(region, needs.p);
      const ParametrisedSet there = region.with_relation(needs.p, x, implied);
      return grown(Kind::related, region, needs.p, {}, {}, {}, node(there, depth + 1));
    }
    return {};
  }

  // One of the coefficients vanishes at no root of p, which is irreducible in one parameter.
  static bool holds_at_root(const Genericity& g, const ParametrisedSet& region, const MPoly& p) {
    return std::ranges::any_of(g.not_all_zero, [&](const MPoly& f) {
      const auto there = restricted_to(f, region);
      if (!there || is_zero(*there)) return false;
      const auto used = used_variables(*there);
      return used.size() <= 1 && is_constant(gcd(there->num(), p)) &&
             (used.empty() || uses(p, used[0]));
    });
  }
  // All of them vanish at every root of p.
  static bool fails_at_root(const Genericity& g, const ParametrisedSet& region, const MPoly& p) {
    return std::ranges::all_of(g.not_all_zero, [&](const MPoly& f) {
      const auto there = restricted_to(f, region);
      return there && (is_zero(*there) || divides(p, there->num()));
    });
  }
  // f in the parameters that are left; unset where it has no value.
  static std::optional<MFraction> restricted_to(const MPoly& f, const ParametrisedSet& region) {
    return tried<DomainError>([&] { return std::optional(region.restrict(MFraction(f))); });
  }

  ProofTreePtr add(const ParametrisedSet& region, const Leaf& leaf) {
    answer_.strata.push_back({simplified(region), leaf, region.solved()});
    return grown(Kind::leaf, region, {}, leaf);
  }

  // Without the inequations that the other conditions imply.
  static std::vector<Condition> simplified(const ParametrisedSet& region) {
    std::vector<Condition> kept;
    for (const auto& c : region.path()) {
      if (c.sign == Sign::nonzero && region.implies_nonzero(c.p)) continue;
      kept.push_back(c);
    }
    return kept;
  }

  const Question& q_;
  const StrataLimits& limits_;
  StrataAnswer answer_;
  std::exception_ptr error_; ///< of the program; the answer, where nothing is decided
};

} // namespace

StrataAnswer decide_strata(const Question& q, const StrataLimits& limits) {
  StrataLimits inner = limits;
  Options& o = inner.decide;
  o.want_certificate = o.want_certificate || o.ask_the_judge; // of strata that are points, too
  StrataAnswer a = Tree(q, inner).grow();
  if (o.want_certificate && a.tree) certify(a, o.budget);
  return a;
}

const Stratum* stratum_at(const StrataAnswer& a, const std::map<std::size_t, Rational>& point) {
  const auto holds = [&](const Condition& c) {
    Substitution values;
    for (const auto& [i, v] : point)
      values[i] = MFraction(c.p.ring(), v);
    const MFraction f = substitute(c.p, values);
    if (!is_zero(f) && !is_constant(f)) return false;
    const int s = is_zero(f) ? 0 : sign(to_rational(f));
    return c.sign == Sign::zero      ? s == 0
           : c.sign == Sign::nonzero ? s != 0
                                     : s > 0 || (s == 0 && c.sign == Sign::nonnegative);
  };
  for (const auto& s : a.strata)
    if (std::ranges::all_of(s.conditions, holds)) return &s;
  return nullptr;
}

} // namespace kov::strata
