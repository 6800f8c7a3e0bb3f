#include "classify/solutions.hpp"

#include "exact/error.hpp"
#include "manifold/find.hpp"
#include "system/in_ring.hpp"

#include <algorithm>

namespace kov {
namespace {

// The first of name, name1, name2, ... that nothing is called.
std::string free_name(const std::vector<std::string>& taken, const std::string& name) {
  const auto is_taken = [&](const std::string& n) {
    return std::find(taken.begin(), taken.end(), n) != taken.end();
  };
  std::string candidate = name;
  for (int k = 1; is_taken(candidate); ++k)
    candidate = name + std::to_string(k);
  return candidate;
}

struct NamedIntegral {
  std::string name;
  MFraction value;
  std::optional<std::size_t> claim;
};

std::vector<NamedIntegral> known_integrals(const System& s,
                                           const std::vector<ClaimReport>& claims) {
  std::vector<NamedIntegral> all;
  if (s.field.hamiltonian) all.push_back({"H", *s.field.hamiltonian, {}});
  for (std::size_t k = 0; k < claims.size(); ++k) {
    const ClaimReport& c = claims[k];
    const bool usable =
        c.result.proved && c.claim.on.empty() &&
        (c.claim.kind == SystemClaim::Kind::integral || c.claim.kind == SystemClaim::Kind::casimir);
    const bool known = std::any_of(
        all.begin(), all.end(), [&](const NamedIntegral& i) { return i.value == c.claim.value; });
    if (usable && !known)
      all.push_back({c.claim.name.empty() ? c.claim.text : c.claim.name, c.claim.value, k});
  }
  return all;
}

} // namespace

LevelledSystem with_levels(const System& s, std::vector<ClaimReport> claims) {
  const auto integrals = known_integrals(s, claims);
  auto names = s.ring()->names();
  const std::size_t first = names.size();
  for (const NamedIntegral& i : integrals)
    names.push_back(free_name(names, i.name == "H" ? "E" : "c"));
  LevelledSystem all{in_ring(s, make_ring(names)), std::move(claims), {}};
  KOV_ENSURE(all.claims.size() == s.claims.size());
  for (std::size_t k = 0; k < all.claims.size(); ++k) {
    all.claims[k].claim = all.system.claims[k];
    for (MPoly& g : all.claims[k].result.generic)
      g = transfer(MFraction(g), all.system.ring()).num();
  }
  for (std::size_t k = 0; k < integrals.size(); ++k) {
    all.system.field.parameters.push_back(first + k);
    all.levels.push_back({transfer(integrals[k].value, all.system.ring()), first + k,
                          integrals[k].name, integrals[k].claim});
  }
  return all;
}

namespace {

std::string text_of(const std::vector<Equation>& equations) {
  std::string text;
  for (const Equation& e : equations)
    text += (text.empty() ? "" : ", ") + e.text;
  return text;
}

// The set itself, whatever its equations.
std::string set_of(const System& s, const std::vector<Equation>& equations, const Budget& budget) {
  const Ideal ideal = relation_ideal(s.field, set_generators(equations), {}, budget);
  std::string key;
  for (const KPoly& g : ideal.basis())
    key += to_string(ideal.from_kpoly(g)) + ";";
  return key;
}

ManifoldSpec with_its_levels(const System& s, const FoundManifold& m,
                             const std::vector<KnownLevel>& levels) {
  ManifoldSpec spec;
  spec.name = text_of(m.equations);
  spec.equations = m.equations;
  for (const std::size_t k : m.independent) {
    const KnownLevel& known = levels[k];
    spec.levels.push_back({known.integral - MFraction::variable(s.ring(), known.level),
                           known.text + " = " + s.ring()->name(known.level)});
  }
  return spec;
}

} // namespace

ParticularSolutions particular_solutions(const System& s, const std::vector<KnownLevel>& levels,
                                         bool search, const Budget& budget) {
  ParticularSolutions all{s.manifolds, {}};
  if (!search) return all;
  try {
    std::vector<std::string> known;
    for (const ManifoldSpec& m : s.manifolds)
      known.push_back(set_of(s, m.equations, budget));
    std::vector<MFraction> integrals;
    for (const KnownLevel& l : levels)
      integrals.push_back(l.integral);
    FoundManifolds found = find_manifolds(s.field, integrals, budget);
    all.left_out = std::move(found.left_out);
    for (const FoundManifold& m : found.proved) {
      if (m.equilibria || m.leaf_dimension() != 1) continue;
      if (std::find(known.begin(), known.end(), set_of(s, m.equations, budget)) == known.end())
        all.manifolds.push_back(with_its_levels(s, m, levels));
    }
  } catch (const OutOfBudget& limit) {
    all.left_out.push_back(std::string("the search for invariant manifolds ended: ") +
                           limit.what());
  }
  return all;
}

} // namespace kov
