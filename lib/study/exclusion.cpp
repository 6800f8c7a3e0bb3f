#include "study/exclusion.hpp"

#include "decide/words.hpp"
#include "exact/error.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "exact/tried.hpp"
#include "exact/variables.hpp"
#include "integrability/conclude.hpp"
#include "integrability/integral_class.hpp"
#include "integrability/matrices.hpp"
#include "jets/words.hpp"
#include "strata/needed.hpp"
#include "strata/words.hpp"
#include "study/general_level.hpp"
#include "study/necessary.hpp"

#include <algorithm>

namespace kov {
namespace {

using strata::Stratum;

// The conditions of a stratum with the levels eliminated.
class Projection {
public:
  Projection(const System& s, const std::vector<std::size_t>& levels) : s_(s), levels_(levels) {}

  // False: nothing is concluded.
  bool take(const std::vector<Condition>& conditions) {
    std::vector<MPoly> equations;
    for (const Condition& c : conditions) {
      if (c.sign != Sign::zero && c.sign != Sign::nonzero) return false;
      const auto p = in_system(MFraction(c.p));
      if (!p) return false;
      (c.sign == Sign::zero ? equations : nonzero_).push_back(p->num());
    }
    return eliminate(std::move(equations));
  }

  /// f for the levels that were chosen; unset: it has another variable, or no value there.
  [[nodiscard]] std::optional<MFraction> value(const MFraction& f) const {
    const auto moved = in_system(f);
    if (!moved) return std::nullopt;
    return tried<DomainError>([&] { return std::optional(substitute(*moved, chosen_)); });
  }

  [[nodiscard]] bool has_level(const MFraction& f) const { return uses_any(f, levels_); }
  [[nodiscard]] const std::vector<std::size_t>& levels() const { return levels_; }

  [[nodiscard]] Exclusion result() const {
    Exclusion e;
    e.zero = zero_;
    for (const MPoly& p : nonzero_)
      e.not_all_zero.push_back(nonzero_coefficients(p, levels_));
    e.by.level = levels_at(choice());
    return e;
  }

private:
  [[nodiscard]] std::optional<MFraction> in_system(const MFraction& f) const {
    for (const std::size_t i : used_variables(f)) {
      const auto place = s_.ring()->find(f.ring()->name(i));
      if (!place || !is_constant_of_the_system(*place)) return std::nullopt;
    }
    return transfer(f, s_.ring());
  }
  [[nodiscard]] bool is_constant_of_the_system(std::size_t i) const {
    const auto in = [i](const std::vector<std::size_t>& all) { return is_among(i, all); };
    return in(s_.field.parameters) || in(s_.field.constants);
  }

  // Equations with a level are solved for it: that is the level which is chosen.
  bool eliminate(std::vector<MPoly> equations) {
    while (!equations.empty()) {
      const auto linear =
          std::ranges::find_if(equations, [&](const MPoly& p) { return solvable(p).has_value(); });
      if (linear == equations.end()) break;
      const std::size_t h = *solvable(*linear);
      const auto line = coefficients(*linear, h);
      const MFraction root = -(MFraction(line[0]) / MFraction(line[1]));
      equations.erase(linear);
      nonzero_.push_back(line[1]);
      if (!choose(h, root, equations)) return false;
    }
    zero_ = std::move(equations);
    return std::ranges::none_of(zero_, [&](const MPoly& p) { return has_level(MFraction(p)); });
  }
  [[nodiscard]] std::optional<std::size_t> solvable(const MPoly& p) const {
    for (const std::size_t h : levels_)
      if (degree(p, h) == 1 && !is_assumed(h)) return h;
    return std::nullopt;
  }
  // The value that is chosen may be none of those for which the conditions were proved.
  [[nodiscard]] bool is_assumed(std::size_t h) const {
    return std::ranges::any_of(s_.assumptions,
                               [h](const Assumption& a) { return uses(a.value, h); });
  }
  bool choose(std::size_t h, const MFraction& root, std::vector<MPoly>& equations) {
    const Substitution step{{h, root}};
    for (auto& [other, value] : chosen_)
      value = substitute(value, step);
    chosen_[h] = root;
    for (MPoly& p : equations)
      p = substitute(p, step).num();
    std::erase_if(equations, [](const MPoly& p) { return is_zero(p); });
    for (MPoly& p : nonzero_) {
      p = substitute(p, step).num();
      if (is_zero(p)) return false; // no such level
    }
    return true;
  }

  [[nodiscard]] LevelChoice choice() const {
    LevelChoice all;
    for (const auto& [h, value] : chosen_)
      all.push_back({s_.ring()->name(h), to_factored_string(value)});
    return all;
  }

  const System& s_;
  const std::vector<std::size_t>& levels_;
  Substitution chosen_;
  std::vector<MPoly> zero_, nonzero_;
};

/// A condition "abelian only if ..." in the parameters and levels.
struct OnlyIf {
  std::vector<MPoly> vanish;        ///< these all do; empty: not required
  std::optional<SomeIn> difference; ///< or this
};

// The parts of a classical criterion, read as: outside `condition` the group is `otherwise` for some
// level, if all that is said to change does so.
struct CriterionAnswer {
  std::optional<SomeIn> condition; ///< unset: everywhere
  strata::Leaf otherwise;
  std::vector<MFraction> changing;
};

// The same numbers in the ring of the system; unset: one has no value there.
std::optional<Statement> in_system(Statement c, const Projection& p) {
  for (MFraction& x : squares_of(c.says)) {
    auto here = p.value(x);
    if (!here) return std::nullopt;
    x = *std::move(here);
  }
  return c;
}

// Some part is not abelian, and on all others one and the same difference is special.
std::optional<CriterionAnswer> closed_answer(const Stratum& x, const Projection& p) {
  std::vector<std::vector<Statement>> others;
  std::optional<strata::Leaf> otherwise;
  for (const Stratum& part : strata::told_apart(x)) {
    if (part.leaf.abelian == Truth::no) {
      otherwise = part.leaf;
      continue;
    }
    others.emplace_back();
    for (const Statement& c : part.arithmetic)
      if (auto here = in_system(c, p)) others.back().push_back(*std::move(here));
  }
  if (!otherwise || others.empty()) return std::nullopt;
  AtGeneralLevel general = at_general_level(std::move(others), p.levels());
  CriterionAnswer answer{std::nullopt, *std::move(otherwise), std::move(general.changing)};
  if (general.parts.empty()) return answer;
  answer.condition = necessary_condition(general.parts);
  if (!answer.condition) return std::nullopt;
  return answer;
}

// The statement that an undecided leaf makes all the same; unset: none.
std::optional<OnlyIf> only_if(const strata::Leaf& leaf) {
  const auto or_difference = [](std::vector<MPoly> vanish,
                                std::optional<SomeIn> c) -> std::optional<OnlyIf> {
    if (!c) return std::nullopt;
    if (c->or_all_rational && c->squares.size() == 1) { // then the other says less
      c->classes.reset();
      c->or_all_rational = false;
    }
    return OnlyIf{std::move(vanish), std::move(c)};
  };
  if (auto c = strata::needed(leaf)) return or_difference({}, std::move(c));
  if (const auto* form = strata::evidence<strata::ClassicalForm>(leaf);
      form != nullptr && form->family == Classical::bessel)
    return or_difference({}, SomeIn{{form->squares.front().second}, Classes{half_integers}});
  if (const auto* open = std::get_if<strata::MinorsVanish>(&*leaf.open)) {
    if (std::holds_alternative<long>(open->otherwise)) return std::nullopt;
    if (const auto* or_this = std::get_if<strata::SomeDifference>(&open->otherwise))
      return or_difference(open->together, strata::needed(leaf, *or_this));
    return OnlyIf{open->together, {}};
  }
  return std::nullopt;
}

// Not all of them vanish, for some level.
bool require_some(Exclusion& e, const Projection& p, const std::vector<MPoly>& vanish) {
  if (vanish.empty()) return true;
  std::vector<MPoly> parts;
  for (const MPoly& f : vanish) {
    const auto here = p.value(MFraction(f));
    if (!here) return false;
    if (is_zero(*here)) continue;
    std::ranges::move(nonzero_coefficients(here->num(), p.levels()), std::back_inserter(parts));
  }
  e.not_all_zero.push_back(std::move(parts)); // empty: they do vanish, and nothing is excluded
  return true;
}

// f has a value for some level, and is not the same for all.
void require_change(Exclusion& e, const Projection& p, const MFraction& f) {
  std::vector<MPoly> changes;
  for (const std::size_t h : p.levels())
    if (const MFraction slope = derivative(f, h); !is_zero(slope))
      std::ranges::move(nonzero_coefficients(slope.num(), p.levels()), std::back_inserter(changes));
  e.not_all_zero.push_back(std::move(changes));
  e.not_all_zero.push_back(nonzero_coefficients(f.den(), p.levels()));
}

// Differences that depend on the level are not special for some level.
bool require_no_difference(Exclusion& e, const Projection& p, const SomeIn& c) {
  SomeIn left = c;
  left.squares.clear();
  for (const MFraction& square : c.squares) {
    const auto here = p.value(square);
    if (!here) return false;
    if (!p.has_level(*here)) {
      left.squares.push_back(*here);
      continue;
    }
    left.or_all_rational = false;
    require_change(e, p, *here);
  }
  for (const MFraction& square : left.squares) // it says something where they have values
    e.not_all_zero.push_back({square.den()});
  if (!left.squares.empty()) e.statements.push_back({std::move(left), false});
  return true;
}

// The smaller class where the places or the group are not known.
IntegralClass class_of(const System& s, const ManifoldReport& report, const strata::Leaf& leaf) {
  const bool known = leaf.scheme || strata::evidence<strata::Number>(leaf) != nullptr;
  const bool regular = known && !strata::has_irregular_place(leaf);
  const bool is_sl2 = leaf.abelian == Truth::no && leaf.group && leaf.group->type == GroupType::SL2;
  return excluded_integrals(
      s, report, regular ? IntegralClass::Near::curve : IntegralClass::Near::closed_curve, is_sl2);
}

std::optional<Exclusion> exclusion(const System& s, const ManifoldReport& report, const Stratum& x,
                                   const std::vector<std::size_t>& levels) {
  const strata::Leaf& leaf = x.leaf;
  std::optional<OnlyIf> open;
  if (leaf.abelian == Truth::yes) return std::nullopt;
  Projection p(s, levels);
  if (!p.take(x.conditions)) return std::nullopt;
  std::optional<CriterionAnswer> closed;
  if (leaf.abelian == Truth::unknown) {
    closed = closed_answer(x, p);
    if (closed)
      open = OnlyIf{{}, closed->condition};
    else if (leaf.open)
      open = only_if(leaf);
    if (!open) return std::nullopt;
  }
  Exclusion e = p.result();
  if (closed)
    for (const MFraction& f : closed->changing)
      require_change(e, p, f);
  if (open) {
    if (!require_some(e, p, open->vanish)) return std::nullopt;
    if (open->difference && !require_no_difference(e, p, *open->difference)) return std::nullopt;
  }
  const bool necessary = open && !closed;
  if (closed) e.by.trusted.push_back({Trusted::Step::closed_answer});
  e.by.reason =
      necessary ? strata::open_condition(leaf) : strata::reason(closed ? closed->otherwise : leaf);
  if (necessary) e.by.trusted.push_back({Trusted::Step::necessary_conditions});
  e.by.integrals = class_of(s, report, leaf);
  return e;
}

std::string names(const BlockReport& block) { return joined(block.unknowns); }

std::vector<Exclusion> of_block(const System& s, const ManifoldReport& report,
                                const BlockReport& block, const std::vector<std::size_t>& levels) {
  std::vector<Exclusion> all;
  if (block.strata) {
    for (const Stratum& x : block.strata->strata)
      if (auto e = exclusion(s, report, x, levels)) all.push_back(*std::move(e));
  } else if (block.decision && block.abelian == Truth::no) {
    Exclusion e;
    e.by.reason = reason(*block.decision);
    e.by.integrals = excluded_integrals(s, report,
                                        block.equation ? integrals_near(block.equation->r)
                                                       : IntegralClass::Near::closed_curve,
                                        block.decision->component == Connected::sl2);
    all.push_back(std::move(e));
  }
  for (Exclusion& e : all)
    e.by.reason = "variation of " + names(block) + ": " + e.by.reason;
  return all;
}

// The exclusion by the whole variational equation: all parameters but levels have values there.
Exclusion by_matrices(const ManifoldReport& report) {
  Exclusion e;
  e.by.reason = reason(*report.matrices);
  e.by.level = levels_at(report.matrices->level);
  e.by.integrals = report.by->integrals;
  return e;
}

bool is_free(const Equation& level, const std::vector<std::size_t>& levels) {
  return uses_any(level.difference, levels);
}
bool has_free_level(const ManifoldReport& report, const std::vector<std::size_t>& levels) {
  if (!report.manifold) return !levels.empty();
  const auto& all = report.manifold->levels;
  return std::ranges::any_of(all, [&](const Equation& e) { return is_free(e, levels); });
}
// "G1^2 + G2^2 + G3^2 = 1"
std::vector<std::string> fixed_levels(const ManifoldReport& report,
                                      const std::vector<std::size_t>& levels) {
  std::vector<std::string> all;
  if (report.manifold)
    for (const Equation& e : report.manifold->levels)
      if (!is_free(e, levels)) all.push_back(e.text);
  return all;
}

// Why the block is not abelian, and at which level; empty: at all but special ones.
void explain(const BlockReport& block, ExclusionReason& by) {
  by.reason = "not abelian";
  for (const EnergyResult& level : block.energies) {
    const bool decided = level.decision && level.decision->abelian == Truth::no;
    if (!decided && !(level.strata && level.strata->abelian() == Truth::no)) continue;
    by.level = levels_at({level.at});
    by.reason =
        decided ? reason(*level.decision) : strata::reason(level.strata->strata.front().leaf);
    return;
  }
  if (block.decision && block.decision->abelian == Truth::no) by.reason = reason(*block.decision);
  if (!block.strata) return;
  for (const Stratum& x : block.strata->strata)
    if (x.leaf.abelian == Truth::no) {
      by.reason = strata::reason(x.leaf);
      return;
    }
}

// All parameters at once, as the verdict has it.
Exclusion by_verdict(const ManifoldReport& report) {
  if (report.matrices) return by_matrices(report);
  Exclusion e;
  const auto block = std::ranges::find_if(
      report.blocks, [](const BlockReport& b) { return b.abelian == Truth::no; });
  KOV_ENSURE(block != report.blocks.end());
  explain(*block, e.by);
  e.by.reason = "variation of " + names(*block) + ": " + e.by.reason;
  e.by.integrals = report.by->integrals;
  return e;
}

const LiteratureTheorem& theorem(const System& s) {
  return s.field.poisson ? morales_ramis() : ayoul_zung();
}

// Sets the members that are the same for all of one report.
std::vector<Exclusion> with_its_solution(const System& s, const ManifoldReport& report,
                                         const std::vector<std::size_t>& levels,
                                         std::vector<Exclusion> all) {
  for (Exclusion& e : all) {
    e.by.solution = report.name;
    e.by.unchecked = not_checked(report);
    e.by.theorems = {&theorem(s)};
    add_each_once(e.by.trusted, trusted_steps(report));
    if (e.by.level.empty() && has_free_level(report, levels))
      e.by.level.which = Levels::Which::all_but_special;
    e.by.level.fixed = fixed_levels(report, levels);
  }
  // those without exceptions first: fewer conditions are left to be shown
  std::stable_sort(all.begin(), all.end(), [](const Exclusion& a, const Exclusion& b) {
    return a.statements.empty() && !b.statements.empty();
  });
  return all;
}

} // namespace

std::vector<Exclusion> exclusions(const System& s, const ManifoldReport& report,
                                  const std::vector<std::size_t>& levels) {
  std::vector<Exclusion> all;
  for (const BlockReport& block : report.blocks)
    std::ranges::move(of_block(s, report, block, levels), std::back_inserter(all));
  if (report.matrices && report.by) all.push_back(by_matrices(report)); // else a limit came before
  return with_its_solution(s, report, levels, std::move(all));
}

std::vector<Exclusion> exclusions_of_verdict(const System& s, const ManifoldReport& report,
                                             const std::vector<std::size_t>& levels) {
  if (report.verdict != Verdict::non_integrable) return exclusions(s, report, levels);
  return with_its_solution(s, report, levels, {by_verdict(report)});
}

std::optional<Exclusion> exclusion_of(const System& s, const ManifoldSpec& m,
                                      const jets::HigherOrders& orders) {
  if (!orders.obstruction) return std::nullopt;
  const jets::HigherObstruction& o = *orders.obstruction;
  Exclusion e;
  for (const auto& list : o.not_all_zero) {
    e.not_all_zero.emplace_back();
    for (const MPoly& p : list)
      e.not_all_zero.back().push_back(transfer(MFraction(p), s.ring()).num());
  }
  e.by.solution = m.name;
  e.by.level = jets::level(o);
  e.by.order = o.logarithm.order;
  e.by.rule = Rule::higher_order;
  e.by.integrals.curves = {m.name};
  e.by.reason = jets::reason(orders);
  e.by.theorems = {&morales_ramis_simo()};
  e.by.trusted = jets::trusted(o);
  return e;
}

// The exclusion is for all parameters: they have values.
Exclusion exclusion_of(const ManifoldSpec& m, const QuadratureObstruction& o) {
  Exclusion e;
  e.by.solution = m.name;
  e.by.level = levels_at(o.level);
  e.by.order = o.order;
  e.by.rule = Rule::quadratures;
  e.by.reason = reason(o);
  e.by.integrals = o.integrals;
  e.by.unchecked = o.unchecked;
  e.by.theorems = {&morales_ramis_simo()};
  e.by.trusted = {{Trusted::Step::quadratures, m.name}};
  return e;
}

} // namespace kov
