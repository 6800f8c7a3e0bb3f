#include "study/contradiction.hpp"

#include "decide/afterwards.hpp"
#include "exact/error.hpp"
#include "integrals/independence.hpp"
#include "study/pieces.hpp"
#include "system/vector_field.hpp"

#include <algorithm>

namespace kov::study {
namespace {

// Equations may leave complex points only, and integers may miss what an inequation leaves.
bool admits_general_points(const System& s) {
  using Relation = Assumption::Relation;
  return std::none_of(s.assumptions.begin(), s.assumptions.end(), [](const Assumption& a) {
    return a.relation == Relation::zero || a.relation == Relation::nonnegative ||
           a.relation == Relation::integer || a.relation == Relation::rational;
  });
}
bool is_real(const System& s) {
  using Relation = Assumption::Relation;
  return std::any_of(s.assumptions.begin(), s.assumptions.end(), [](const Assumption& a) {
    return a.relation == Relation::real || a.relation == Relation::positive;
  });
}

bool meet(const System& s, const Exclusion& e, const ParameterSet& where) {
  if (e.unless || !admits_general_points(s)) return false; // not known
  if (is_real(s) && (!e.zero.empty() || !where.equations().empty())) return false;
  const auto parts = split_set(where, e.zero, e.not_all_zero, may_vanish(s));
  return std::any_of(parts.inside.begin(), parts.inside.end(),
                     [](const ParameterSet& x) { return !x.is_empty(); });
}

// In involution with those before.
bool commutes(const System& s, const std::vector<MFraction>& chosen, const MFraction& f) {
  return std::all_of(chosen.begin(), chosen.end(),
                     [&](const MFraction& g) { return is_zero(poisson_bracket(s.field, f, g)); });
}

} // namespace

std::optional<Integrable> known_integrals(const System& s, const std::vector<ClaimReport>& claims) {
  if (s.kind != SystemKind::hamiltonian || !s.field.functions.empty() ||
      !s.field.relations.empty() || !s.field.hamiltonian)
    return std::nullopt;
  std::vector<MFraction> candidates{*s.field.hamiltonian};
  for (const ClaimReport& c : claims)
    if (c.claim.kind == SystemClaim::Kind::integral && c.claim.on.empty() && c.result.proved &&
        c.result.generic.empty())
      candidates.push_back(c.claim.value);
  const PhaseSpace space(s);
  SystemClassification told;
  Integrable all{all_parameters(s, {}, {}, told), {.kind = IntegralClass::Kind::rational}, ""};
  IndependentRows rows(space);
  std::vector<MFraction> chosen;
  for (const MFraction& f : candidates) {
    FoundIntegral one;
    one.value = f;
    if (!commutes(s, chosen, f) || !rows.add(all.where, gradient(s.field, one)).taken) continue;
    all.by += (chosen.empty() ? "" : ", ") + to_string(f);
    chosen.push_back(f);
  }
  if (2 * chosen.size() < s.field.dimension()) return std::nullopt;
  return all;
}

bool contradict(const System& s, const Exclusion& e, const Integrable& i) {
  if (!e.by.unchecked.empty() || contains(e.by.integrals, i.integrals) != Truth::yes) return false;
  try {
    return meet(s, e, i.where);
  } catch (const OutOfBudget&) {
    return false;
  }
}

void refuse_contradiction(const System& s, const Exclusion& e, const Integrable& i) {
  if (contradict(s, e, i))
    throw Contradiction("two results exclude each other: integrable with " + i.by + ", and " +
                        statement(e.by) + " along " + e.by.solution + ": " + e.by.reason);
}

} // namespace kov::study
