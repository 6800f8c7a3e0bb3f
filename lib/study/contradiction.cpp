#include "study/contradiction.hpp"

#include "decide/afterwards.hpp"
#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "exact/tried.hpp"
#include "exact/variables.hpp"
#include "integrals/independence.hpp"
#include "study/pieces.hpp"
#include "system/vector_field.hpp"

#include <algorithm>

namespace kov::study {
namespace {

constexpr long most_samples = 40;

// All complex values that the set has.
bool admits_all_values(const System& s) {
  return std::ranges::all_of(s.assumptions,
                             [](const Assumption& a) { return a.is(Sign::nonzero); });
}

bool holds_at(const Assumption& a, const Substitution& point) {
  const MFraction value = substitute(a.value, point);
  return is_constant(value) && a.holds_at(to_rational(value));
}

// Small values, positive ones more often; the same in each run.
Rational sample(long k, std::size_t i) {
  const long n = (k * 7 + static_cast<long>(i) * 5 + k * static_cast<long>(i) * 3) % 23 + 1;
  const Rational v(Integer(n), Integer(1 + (k + static_cast<long>(i)) % 3));
  return k % 4 == 3 ? -v : v;
}

// The parameters of a set that is a graph over some of them.  Unset: it is none.
std::optional<Substitution> point_of(const SolvedSet& graph, const Set& set, long k) {
  Substitution point;
  for (const std::size_t i : set.parameters())
    if (!graph.values.contains(i)) point[i] = MFraction(set.ring(), sample(k, i));
  Substitution all = point;
  for (const auto& [i, value] : graph.values) {
    const MFraction v = substitute(value, point);
    if (!is_constant(v)) return std::nullopt;
    all[i] = v;
  }
  return all;
}

bool is_point_of(const System& s, const Set& set, const Substitution& point) {
  const auto nonzero = [&](const MPoly& p) {
    const MFraction v = substitute(p, point);
    return is_constant(v) && !is_zero(v);
  };
  return std::ranges::all_of(set.inequations(), nonzero) &&
         std::ranges::all_of(s.assumptions,
                             [&](const Assumption& a) { return holds_at(a, point); });
}

bool has_point(const System& s, const Set& set) {
  if (set.is_empty()) return false;
  if (admits_all_values(s)) return true;
  const SolvedSet graph = solve(set);
  if (!graph.left.empty()) return false; // not known
  for (long k = 0; k < most_samples; ++k)
    if (tried<DomainError>([&] {
          const auto point = point_of(graph, set, k);
          return point && is_point_of(s, set, *point);
        }))
      return true;
  return false;
}

// Is f in involution with those before?
bool commutes(const System& s, const std::vector<MFraction>& chosen, const MFraction& f) {
  return std::ranges::all_of(
      chosen, [&](const MFraction& g) { return is_zero(poisson_bracket(s.field, f, g)); });
}

bool is_real_polynomial(const System& s, const MFraction& f) {
  const auto denominator = used_variables(f.den());
  return !uses_any(f, s.field.constants) && std::ranges::none_of(denominator, [&](std::size_t i) {
    const auto& x = s.field.coordinates;
    return is_among(i, x);
  });
}

} // namespace

CompleteIntegrals complete_integrals(const System& s, const std::vector<FoundIntegral>& integrals) {
  const bool rational = s.field.functions.empty();
  CompleteIntegrals all{rational, rational, s.field.poisson.has_value(), ""};
  for (const FoundIntegral& f : integrals) {
    if (!f.logarithms.empty()) all.rational = all.polynomial = false;
    all.polynomial = all.polynomial && is_real_polynomial(s, f.value);
    all.by += (all.by.empty() ? "" : ", ") + to_string(f);
  }
  return all;
}

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
  Integrable all{all_parameters(s, {}, {}, told), {}};
  all.integrals.polynomial = true;
  IndependentRows rows(space);
  std::vector<MFraction> chosen;
  for (const MFraction& f : candidates) {
    FoundIntegral one;
    one.value = f;
    if (!commutes(s, chosen, f) || !rows.add(all.where, gradient(s.field, one)).taken) continue;
    all.integrals.by += (chosen.empty() ? "" : ", ") + to_string(f);
    all.integrals.polynomial = all.integrals.polynomial && is_real_polynomial(s, f);
    chosen.push_back(f);
  }
  if (2 * chosen.size() < s.field.dimension()) return std::nullopt;
  return all;
}

bool excludes(const ExclusionReason& by, const CompleteIntegrals& i) {
  if (!by.unchecked.empty() || !i.rational) return false;
  IntegralClass as{.kind = IntegralClass::Kind::rational, .frame = by.integrals.frame};
  as.liouville = i.liouville;
  if (i.polynomial) {
    as.kind = by.integrals.kind;
    as.near = by.integrals.near;
    as.curves = by.integrals.curves;
  }
  return contains(by.integrals, as) == Truth::yes;
}

bool meet(const System& s, const Set& set, const Cut& conditions) {
  const auto parts = split(set, conditions, may_vanish(s));
  return std::ranges::any_of(parts.inside, [&](const Set& common) {
    return common.is_algebraic() && has_point(s, common);
  });
}

bool contradict(const System& s, const Exclusion& e, const Integrable& i) {
  if (!excludes(e.by, i.integrals)) return false;
  return tried<OutOfBudget>([&] { return meet(s, i.where, e); });
}

void refuse_contradiction(const System& s, const ExclusionReason& by, const CompleteIntegrals& i,
                          const Set& set, const Cut& conditions) {
  if (excludes(by, i) && tried<OutOfBudget>([&] { return meet(s, set, conditions); }))
    throw Contradiction("two results exclude each other: integrable with " + i.by + ", and " +
                        statement(by) + " along " + by.solution + ": " + by.reason);
}

} // namespace kov::study
