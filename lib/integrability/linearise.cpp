#include "integrability/linearise.hpp"

#include "exact/error.hpp"
#include "manifold/existence.hpp"

namespace kov {
namespace {

bool is_usable(const ClaimReport& c) {
  return c.result.proved && c.claim.on.empty() &&
         (c.claim.kind == SystemClaim::Kind::casimir ||
          c.claim.kind == SystemClaim::Kind::integral);
}

std::vector<SystemClaim> usable_integrals(const System& s, const std::vector<ClaimReport>& claims) {
  std::vector<SystemClaim> all;
  for (const auto& c : claims)
    if (is_usable(c)) {
      all.push_back(c.claim);
      if (c.claim.name.empty()) all.back().name = "(" + c.claim.text + ")";
    }
  if (s.field.hamiltonian) {
    SystemClaim h;
    h.name = "H";
    h.value = *s.field.hamiltonian;
    all.push_back(std::move(h));
  }
  return all;
}

} // namespace

void linearise(const Study& study, ManifoldReport& report) {
  const System& s = study.system;
  const InvariantManifold& m = *report.manifold;
  if (const std::string wrong = contradicted_function(s.field, m); !wrong.empty())
    throw DomainError("the phase curve has no points: " + wrong);
  report.meant_functions = unchecked_functions(s.field, m);
  report.variational = variational_equations(s.field, m);
  report.variational_blocks = blocks(report.variational, m);
  report.normal = normal_system(s.field, m, usable_integrals(s, study.claims));
  const ReduceSpec* reduce = reduction_for(s, m.name);
  std::vector<std::string> keep;
  if (reduce && reduce->unknown) keep.push_back(s.ring()->name(*reduce->unknown));
  report.reduced = reduce_by_integrals(s.field, m, report.normal, keep);
}

std::vector<MPoly> divisors_of(const Study& study, const ManifoldReport& report) {
  auto divisors = report.reduced.divisors;
  for (const auto& c : study.claims)
    if (is_usable(c))
      divisors.insert(divisors.end(), c.result.generic.begin(), c.result.generic.end());
  return divisors;
}

std::vector<MPoly> early_divisors(const ManifoldReport& report) {
  std::vector<MPoly> all(report.manifold->curve->inverted());
  for (const auto* more : {&report.normal.divisors, &report.reduced.divisors})
    all.insert(all.end(), more->begin(), more->end());
  return all;
}

WholeVariation coupling(const System& s, const ManifoldReport& report,
                        const std::vector<std::vector<std::size_t>>& parts) {
  try {
    return whole_variation(s.field, *report.manifold, report.normal, report.reduced, parts);
  } catch (const OutOfBudget& limit) {
    return {std::string("not studied: the coupling of the blocks: ") + limit.what(), {}};
  }
}

} // namespace kov
