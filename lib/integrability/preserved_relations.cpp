#include "integrability/preserved_relations.hpp"

#include <algorithm>
#include <set>

namespace kov {
namespace {

bool all_zero(const std::vector<MFraction>& f) {
  return std::ranges::all_of(f, [](const MFraction& x) { return is_zero(x); });
}

} // namespace

VectorField with_preserved_relations(VectorField v) {
  std::set<std::size_t> solved; // functions whose gradient an earlier relation has given
  for (const MPoly& relation : v.relations) {
    const auto change = gradient(v, MFraction(relation));
    if (all_zero(change)) continue;
    const auto last =
        std::find_if(v.functions.rbegin(), v.functions.rend(), [&](const FunctionSymbol& s) {
          return uses(relation, s.variable) && solved.count(s.variable) == 0;
        });
    if (last == v.functions.rend()) continue; // the checkers will say so
    solved.insert(last->variable);
    const MFraction slope(derivative(relation, last->variable));
    for (std::size_t j = 0; j < change.size(); ++j)
      last->gradient[j] -= change[j] / slope;
  }
  if (!solved.empty() && v.poisson && v.hamiltonian)
    v.components = hamiltonian_field(v, *v.poisson, *v.hamiltonian);
  return v;
}

} // namespace kov
