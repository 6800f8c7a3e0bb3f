#include "classify/solutions.hpp"

#include "exact/error.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "exact/share.hpp"
#include "exact/tried.hpp"
#include "exact/variables.hpp"
#include "integrability/eigenvalue.hpp"
#include "integrals/find.hpp"
#include "integrals/independence.hpp"
#include "manifold/find.hpp"
#include "system/in_ring.hpp"

#include <algorithm>

namespace kov {
namespace {

// The first of name, name1, name2, ... that nothing is called.
std::string free_name(const std::vector<std::string>& taken, const std::string& name) {
  const auto is_taken = [&](const std::string& n) { return is_among(n, taken); };
  std::string candidate = name;
  for (int k = 1; is_taken(candidate); ++k)
    candidate = name + std::to_string(k);
  return candidate;
}

std::string name(const SystemClaim& c) { return c.name.empty() ? c.text : c.name; }
std::string name(const System& s, const KnownLevel& l) {
  return l.claim ? name(s.claims.at(*l.claim)) : "H";
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
    const bool known =
        std::ranges::any_of(all, [&](const NamedIntegral& i) { return i.value == c.claim.value; });
    if (usable && !known) all.push_back({name(c.claim), c.claim.value, k});
  }
  return all;
}

SystemClaim claim_of(const FoundIntegral& f) {
  SystemClaim claim;
  claim.kind = f.casimir ? SystemClaim::Kind::casimir : SystemClaim::Kind::integral;
  claim.value = f.value;
  claim.text = to_string(f.value);
  return claim;
}

} // namespace

System with_found_integrals(System s, const Budget& budget) {
  tried<OutOfBudget>([&] { // at a limit what was added is right
    IntegralOptions options;
    options.degree = 2;
    options.until_integrable = true;
    options.darboux = false;
    options.budget = part_of_the_work(budget, 0.9); // the rest: to compare what it finds
    const IntegralSearch search = find_integrals(s, options);
    const PhaseSpace space(s, budget);
    const Set all(s.ring(), space.parameters, budget);
    IndependentRows known(space);
    const auto is_new = [&](const MFraction& f) {
      return known.add(all, gradient(s.field, f), budget).taken;
    };
    if (s.field.hamiltonian) static_cast<void>(is_new(*s.field.hamiltonian));
    for (const SystemClaim& c : s.claims)
      if (c.on.empty() &&
          (c.kind == SystemClaim::Kind::integral || c.kind == SystemClaim::Kind::casimir))
        static_cast<void>(is_new(c.value));
    auto sets = search.sets;
    if (search.elsewhere) sets.push_back(*search.elsewhere);
    for (const IntegralsOfSet& set : sets)
      for (const FoundIntegral& f : set.integrals)
        if (!f.hamiltonian && space.vanishes(all, lie_derivative(s.field, f.value)) &&
            is_new(f.value))
          s.claims.push_back(claim_of(f));
  });
  return s;
}

LevelledSystem with_levels(const System& s, std::vector<ClaimReport> claims) {
  const auto integrals = known_integrals(s, claims);
  auto names = s.ring()->names();
  const std::size_t first = names.size();
  for (const NamedIntegral& i : integrals)
    names.push_back(free_name(names, i.name == "H" ? "E" : "c"));
  LevelledSystem all{in_ring(s, make_ring(names)), {}, {}};
  all.claims = claims_of(all.system, std::move(claims));
  for (std::size_t k = 0; k < integrals.size(); ++k) {
    all.system.field.parameters.push_back(first + k);
    all.levels.push_back(
        {transfer(integrals[k].value, all.system.ring()), first + k, integrals[k].claim});
  }
  return all;
}

namespace {

// The set itself, whatever its equations.
std::string set_of(const System& s, const std::vector<Equation>& equations, const Budget& budget) {
  const Ideal ideal = relation_ideal(s.field, set_generators(equations), {}, budget);
  std::string key;
  for (const KPoly& g : ideal.basis())
    key += to_string(ideal.from_kpoly(g)) + ";";
  return key;
}

// An exponential is 0 nowhere.
bool has_points(const System& s, const std::vector<Equation>& equations) {
  return std::ranges::none_of(equations, [&](const Equation& e) {
    return std::ranges::any_of(s.field.functions, [&](const FunctionSymbol& u) {
      const MPoly x = MPoly::variable(s.ring(), u.variable);
      return e.difference == MFraction(x) &&
             std::ranges::all_of(u.gradient, [&](const MFraction& slope) {
               return is_zero(slope) || divides(x, slope.num());
             });
    });
  });
}

// Adds the poles of an integral: there its level has spurious components.
void add_poles(const System& s, const MFraction& integral, ManifoldSpec& spec) {
  const auto main = s.field.main_variables();
  for (const MFactor& f : factor(integral.den()).second)
    if (uses_any(f.base, main) && !is_among(f.base, spec.nonzero)) spec.nonzero.push_back(f.base);
}

/// One level is enough: that of the Hamiltonian stays free, and others are set to 1 or stay free.
enum class OtherLevels : std::uint8_t { one, free };

bool has_other_levels(const FoundManifold& m, const std::vector<KnownLevel>& levels) {
  const auto of_hamiltonian =
      std::ranges::count_if(m.independent, [&](std::size_t k) { return !levels[k].claim; });
  return of_hamiltonian > 0 && m.independent.size() > 1;
}

ManifoldSpec with_its_levels(const System& s, const FoundManifold& m,
                             const std::vector<KnownLevel>& levels, OtherLevels others) {
  ManifoldSpec spec;
  spec.name =
      joined(m.equations, &Equation::text) + (others == OtherLevels::free ? " (all levels)" : "");
  spec.equations = m.equations;
  for (const std::size_t k : m.independent) {
    const KnownLevel& known = levels[k];
    const bool fixed = others == OtherLevels::one && has_other_levels(m, levels) && known.claim;
    const MFraction value =
        fixed ? MFraction(s.ring(), Rational(1)) : MFraction::variable(s.ring(), known.level);
    spec.levels.push_back({known.integral - value, name(s, known) + " = " + to_string(value)});
    add_poles(s, known.integral, spec);
  }
  return spec;
}

// The components of its phase curves, as far as factors tell them apart; else the set itself.
std::vector<ManifoldSpec> curve_components(const System& s, const ManifoldSpec& whole,
                                           const Budget& budget) {
  const auto proved = prove_invariant(s.field, whole, budget);
  const auto* manifold = std::get_if<InvariantManifold>(&proved);
  if (manifold == nullptr) return {whole};
  std::vector<ManifoldSpec> all;
  for (const MPoly& f : factors_on_components(*manifold)) {
    ManifoldSpec part = whole;
    part.equations.push_back({MFraction(f), to_string(f) + " = 0"});
    part.name += ", " + part.equations.back().text;
    if (const auto there = prove_invariant(s.field, part, budget);
        std::holds_alternative<InvariantManifold>(there))
      std::ranges::move(curve_components(s, part, budget), std::back_inserter(all));
  }
  if (all.empty()) return {whole};
  return all;
}

constexpr std::size_t many_parameters = 3;

// The sets whose energy is free, at one energy.
std::vector<ManifoldSpec> at_energy(const System& s, const std::vector<KnownLevel>& levels,
                                    const std::vector<ManifoldSpec>& manifolds, long energy) {
  std::vector<ManifoldSpec> all;
  const MFraction value(s.ring(), Rational(energy));
  for (ManifoldSpec m : manifolds) {
    bool fixed = false;
    for (Equation& e : m.levels)
      for (const KnownLevel& known : levels) {
        if (known.claim || !uses(e.difference, known.level)) continue;
        e = {substitute(e.difference, {{known.level, value}}), "H = " + std::to_string(energy)};
        fixed = true;
      }
    m.name += " (energy " + std::to_string(energy) + ")";
    if (fixed) all.push_back(std::move(m));
  }
  return all;
}

// Adds solutions at energy 0: if the potential on a line has two terms, this energy has symmetries
// that others have not.
void add_at_energy_zero(const System& s, const std::vector<KnownLevel>& levels,
                        const Budget& budget, ParticularSolutions& all) {
  tried<OutOfBudget>([&] { // at a limit those found are at work
    for (const ManifoldSpec& m : at_energy(s, levels, all.manifolds, 0))
      std::ranges::move(curve_components(s, m, budget), std::back_inserter(all.at_energy_zero));
  });
}

// At most levels more is excluded than at one, but r(z) is larger: for what is left.
void add_at_all_levels(const System& s, const std::vector<KnownLevel>& levels,
                       const std::vector<FoundManifold>& found, const Budget& budget,
                       std::vector<ManifoldSpec>& manifolds) {
  tried<OutOfBudget>([&] { // at a limit those found are at work
    for (const FoundManifold& m : found)
      if (has_other_levels(m, levels))
        for (ManifoldSpec& part :
             curve_components(s, with_its_levels(s, m, levels, OtherLevels::free), budget))
          manifolds.push_back(std::move(part));
  });
}

} // namespace

bool has_many_parameters(const System& s, const std::vector<KnownLevel>& levels) {
  return s.field.parameters.size() >= levels.size() + many_parameters;
}

ParticularSolutions particular_solutions(const System& s, const std::vector<KnownLevel>& levels,
                                         bool search, const Budget& budget) {
  ParticularSolutions all{s.manifolds, {}};
  if (!search) return all;
  try {
    std::vector<std::string> known;
    for (const ManifoldSpec& m : s.manifolds)
      known.push_back(set_of(s, m.equations, budget));
    auto integrals = mapped<MFraction>(levels, &KnownLevel::integral);
    FoundManifolds found = find_manifolds(s.field, integrals, budget);
    all.left_out = std::move(found.left_out);
    all.special = std::move(found.special);
    all.wanted = std::move(found.wanted);
    std::vector<FoundManifold> used;
    for (FoundManifold& m : found.proved) {
      if (m.equilibria || m.leaf_dimension() != 1 || !has_points(s, m.equations)) continue;
      std::string set = set_of(s, m.equations, budget);
      if (is_among(set, known)) continue;
      known.push_back(std::move(set));
      for (ManifoldSpec& part :
           curve_components(s, with_its_levels(s, m, levels, OtherLevels::one), budget))
        all.manifolds.push_back(std::move(part));
      used.push_back(std::move(m));
    }
    add_at_energy_zero(s, levels, budget, all);
    if (has_many_parameters(s, levels)) { // the energy costs much beside them
      auto first = at_energy(s, levels, all.manifolds, 1);
      all.manifolds.insert(all.manifolds.begin(), first.begin(), first.end());
    }
    add_at_all_levels(s, levels, used, budget, all.at_all_levels);
  } catch (const OutOfBudget& limit) {
    all.left_out.push_back(std::string("the search for invariant manifolds ended: ") +
                           limit.what());
  }
  return all;
}

} // namespace kov
