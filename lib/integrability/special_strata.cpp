// Strata on which the reduction to y'' = r y breaks down: the whole way again with the parameters
// of the stratum put in.  Another unknown may still be a cyclic vector there.

#include "exact/error.hpp"
#include "integrability/parameters.hpp"
#include "integrability/specialise.hpp"

#include <algorithm>

namespace kov {
namespace {

using strata::Stratum;

// By name, from the ring of the parameters to that of the system.
Substitution in_ring(const Substitution& values, const Ring& from, const Ring& to) {
  Substitution moved;
  for (const auto& [i, value] : values)
    moved[to->index(from->name(i))] = transfer(value, to);
  return moved;
}

// What the strata of the special system are, as strata of the given one.
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
  for (auto& x : all)
    x.leaf.reason = "with the equation for the variation of " + block.ode->unknown +
                    ", r = " + to_factored_string(block.ode->r) + ": " + x.leaf.reason;
  return all;
}

// The conditions of a stratum as assumptions of the special system.
void assume(System& s, const Stratum& x, const Substitution& values) {
  for (const auto& c : x.conditions) {
    if (c.sign != strata::Sign::nonzero) continue;
    Assumption a;
    a.relation = Assumption::Relation::nonzero;
    a.value = substitute(transfer(MFraction(c.p), s.ring()), values);
    s.assumptions.push_back(std::move(a));
  }
}

std::vector<Stratum> again(const System& s, const ManifoldSpec& spec,
                           const std::vector<ClaimReport>& claims, const CheckOptions& options,
                           const std::vector<std::string>& unknowns, const Stratum& x,
                           strata::StrataAnswer& answer) {
  const Ring& ring = x.conditions.front().p.ring();
  try {
    const Substitution values = in_ring(x.solved, ring, s.ring());
    System special = at_values(s, values);
    assume(special, x, values);
    for (auto& r : special.reductions)
      r.energy.clear();
    const ManifoldReport there =
        check_manifold(special, at_values(spec, values), at_values(claims, values), options);
    for (const auto& b : there.blocks)
      if (b.unknowns == unknowns && b.ode) {
        if (b.strata)
          answer.special.push_back(std::make_shared<strata::StrataAnswer>(*b.strata));
        return inside(x, b);
      }
    if (there.verdict != VerdictKind::no_obstruction &&
        there.verdict != VerdictKind::non_integrable)
      return {}; // it may depend on the parameters that are left
    Stratum same{x.conditions, {}, x.solved};
    same.leaf.abelian = truth(there.verdict == VerdictKind::no_obstruction);
    same.leaf.reason = "the normal system has other blocks here";
    for (const auto& why : there.reasons)
      same.leaf.reason += "; " + why;
    return {same};
  } catch (const DomainError&) {
    return {}; // stays open
  }
}

} // namespace

void decide_special_strata(const System& s, const ManifoldSpec& spec,
                           const std::vector<ClaimReport>& claims, const CheckOptions& options,
                           const std::vector<std::string>& unknowns, strata::StrataAnswer& answer) {
  std::vector<Stratum> all;
  for (auto& x : answer.strata) {
    std::vector<Stratum> parts;
    if (x.leaf.no_equation && !x.solved.empty())
      parts = again(s, spec, claims, options, unknowns, x, answer);
    if (parts.empty()) parts.push_back(std::move(x));
    std::move(parts.begin(), parts.end(), std::back_inserter(all));
  }
  answer.strata = std::move(all);
}

} // namespace kov
