#include "integrability/special_strata.hpp"

#include "decide/words.hpp"
#include "exact/error.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "exact/variables.hpp"
#include "integrability/check.hpp"
#include "integrability/integral_class.hpp"
#include "integrability/parameters.hpp"
#include "integrability/specialise.hpp"
#include "strata/decide_leaf.hpp"

#include <algorithm>

namespace kov {
namespace {

using strata::Stratum;

// Moves values by name, from the ring of the parameters to that of the system.
Substitution in_ring(const Substitution& values, const Ring& from, const Ring& to) {
  Substitution moved;
  for (const auto& [i, value] : values)
    moved[to->index(from->name(i))] = transfer(value, to);
  return moved;
}

// The strata of the special system, as strata of the given one.
std::vector<Stratum> inside(const Stratum& outer, const BlockReport& block) {
  std::vector<Stratum> all;
  if (block.decision) {
    all.push_back({outer.conditions, strata::leaf_of(*block.decision), outer.solved});
  } else if (block.strata) {
    for (const auto& x : block.strata->strata) {
      Stratum both{outer.conditions, x.leaf, outer.solved};
      const Ring& ring = outer.conditions.front().p.ring();
      for (const auto& c : x.conditions)
        both.conditions.push_back({transfer(MFraction(c.p), ring).num(), c.sign});
      all.push_back(std::move(both));
    }
  }
  for (auto& x : all) {
    x.leaf.parts.clear(); // they speak of this block alone
    if (x.leaf.open && std::holds_alternative<strata::ByParts>(*x.leaf.open))
      x.leaf.open = strata::NotStudied{"abelian under conditions that are not looked at"};
    x.leaf.because.insert(x.leaf.because.begin(),
                          strata::OfEquation{block.ode->unknown, block.ode->r});
  }
  return all;
}

// The conditions of a stratum as assumptions of the special system.
void assume(System& s, const Stratum& x, const Substitution& values) {
  for (const auto& c : x.conditions) {
    if (c.sign == Sign::nonzero)
      s.assumptions.push_back({c.sign, substitute(transfer(MFraction(c.p), s.ring()), values)});
  }
}

std::string names_of(const BlockReport& block) {
  std::string names = joined(block.unknowns);
  return "block (" + names + ")";
}

// One answer for the whole stratum, from what its blocks are there.
Stratum whole(const Stratum& x, Truth abelian, const ManifoldReport& here, const std::string& why) {
  Stratum same{x.conditions, {}, x.solved};
  same.leaf.abelian = abelian;
  same.leaf.by = strata::Conclusion::other_blocks;
  const bool regular = here.by && here.by->integrals.near == IntegralClass::Near::curve;
  same.leaf.because.emplace_back(strata::OtherBlocks{why, !regular});
  return same;
}

// A block that there is not elsewhere has no strata of its own in which this one is looked at.
Truth of_new_blocks(const ManifoldReport& here, const std::vector<BlockReport>& generic,
                    std::string& why) {
  Truth all = Truth::yes;
  for (const auto& b : here.blocks) {
    if (b.abelian == Truth::yes || std::ranges::any_of(generic, [&](const BlockReport& g) {
          return g.unknowns == b.unknowns;
        }))
      continue;
    if (b.abelian == Truth::no) {
      why = "; " + names_of(b) + " is not abelian";
      if (b.decision) why += ": " + reason(*b.decision);
      return Truth::no;
    }
    all = Truth::unknown;
  }
  return all;
}

// Abelian blocks that are not all of the variational equations here.
void leave_open(Stratum& x, const std::string& not_studied) {
  x.leaf.abelian = Truth::unknown;
  x.leaf.open = strata::NotStudied{not_studied};
}

// The strata inside x when the block is still one there.
std::vector<Stratum> same_block(const Stratum& x, const BlockReport& block,
                                const ManifoldReport& here,
                                const std::vector<BlockReport>& generic) {
  auto parts = inside(x, block);
  if (std::ranges::none_of(parts, [](const Stratum& p) { return p.leaf.abelian == Truth::yes; }))
    return parts;
  std::string why;
  const Truth others = of_new_blocks(here, generic, why);
  if (others == Truth::no) return {whole(x, Truth::no, here, why)};
  if (others == Truth::unknown) return {}; // stays open
  const std::string open = !here.by        ? "a limit came before the other blocks"
                           : here.left_out ? sentence(*here.left_out)
                                           : "";
  if (!open.empty())
    for (Stratum& p : parts)
      if (p.leaf.abelian == Truth::yes) leave_open(p, open);
  return parts;
}

// The block falls apart: the verdict on what there is instead.
std::vector<Stratum> other_blocks(const Stratum& x, const ManifoldReport& here) {
  std::string why;
  for (const auto& reason : reasons(here))
    why += "; " + reason;
  if (here.verdict == Verdict::non_integrable) return {whole(x, Truth::no, here, why)};
  if (here.verdict == Verdict::no_obstruction) return {whole(x, Truth::yes, here, why)};
  const bool abelian = std::ranges::all_of(
      here.blocks, [](const BlockReport& b) { return b.abelian == Truth::yes; });
  if (!here.by || !abelian || !here.left_out)
    return {}; // no curve here, a limit, or it depends on the parameters that are left
  Stratum answer = whole(x, Truth::yes, here, why);
  leave_open(answer, sentence(*here.left_out));
  return {answer};
}

// A coordinate that nothing contains here, and something elsewhere: the class of integrals that is
// said for all strata speaks of it (docs/theory/mechanics.md 6).
bool leaves_more_out(const Study& generic, const System& special, const ManifoldReport& here) {
  if (!here.manifold) return false;
  std::vector<MFraction> all(generic.system.field.components);
  for (const auto* equations : {&generic.manifold.equations, &generic.manifold.levels})
    for (const Equation& e : *equations)
      all.push_back(e.difference);
  const auto left_out = moving_and_left_out(special, *here.manifold);
  return std::ranges::any_of(left_out, [&](std::size_t i) { return any_uses(all, i); });
}

std::vector<Stratum> again(const Study& study, const std::vector<BlockReport>& generic,
                           const std::vector<std::string>& unknowns, const Stratum& x,
                           strata::StrataAnswer& answer, SpecialStudies& studies) {
  const System& s = study.system;
  const Ring& ring = x.conditions.front().p.ring();
  try {
    const Substitution values = with_functions(s, in_ring(x.solved, ring, s.ring()));
    System special = at_values(s, values);
    assume(special, x, values);
    for (auto& r : special.reductions)
      r.energy.clear();
    const ManifoldSpec manifold = at_values(study.manifold, values);
    const auto claims = at_values(study.claims, values);
    const ManifoldReport here = check_manifold(special, manifold, claims, study.options);
    if (leaves_more_out(study, special, here)) return {};
    if (here.matrices) // the way to r is said of the whole
      add_each_once(answer.trusted, trusted_steps(here));
    const auto same = std::ranges::find_if(
        here.blocks, [&](const auto& b) { return b.unknowns == unknowns && b.ode; });
    if (same != here.blocks.end() && same->strata)
      answer.special.push_back(std::make_shared<strata::StrataAnswer>(*same->strata));
    auto parts =
        same != here.blocks.end() ? same_block(x, *same, here, generic) : other_blocks(x, here);
    if (!parts.empty()) studies.push_back(std::make_shared<const ManifoldReport>(here));
    return parts;
  } catch (const DomainError&) {
    return {}; // stays open
  } catch (const OutOfBudget&) {
    return {};
  }
}

// The system does not exist there.
bool is_outside_of_the_domain(const System& s, const Stratum& x) {
  if (x.conditions.empty()) return false;
  const Ring& ring = x.conditions.front().p.ring();
  return s.domain.excludes([&](const MPoly& p) {
    for (const std::size_t i : used_variables(p))
      if (!ring->find(s.ring()->name(i))) return false;
    const MFraction here = substitute(transfer(MFraction(p), ring), x.solved);
    return is_zero(here) || std::ranges::any_of(x.conditions, [&](const auto& c) {
             return c.sign == Sign::zero && divides(c.p, here.num());
           });
  });
}

} // namespace

void decide_special_strata(const Study& study, const std::vector<BlockReport>& generic,
                           const std::vector<std::string>& unknowns, strata::StrataAnswer& answer,
                           SpecialStudies& studies) {
  std::vector<Stratum> all;
  for (auto& x : answer.strata) {
    if (is_outside_of_the_domain(study.system, x)) continue;
    std::vector<Stratum> parts;
    if (x.leaf.no_equation() && !x.solved.empty())
      parts = again(study, generic, unknowns, x, answer, studies);
    if (parts.empty()) parts.push_back(std::move(x));
    std::move(parts.begin(), parts.end(), std::back_inserter(all));
  }
  answer.strata = std::move(all);
}

} // namespace kov
