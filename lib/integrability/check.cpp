#include "integrability/check.hpp"

#include "exact/error.hpp"
#include "exact/factor.hpp"

#include <algorithm>
#include <chrono>

namespace kov {

std::string to_string(VerdictKind v) {
  return v == VerdictKind::non_integrable   ? "non-integrable"
         : v == VerdictKind::no_obstruction ? "no-obstruction"
                                            : "undecided";
}

std::string first_integral_class(const RationalFunction& r) {
  bool irregular = !is_zero(r) && order_at_infinity(r) < 2;
  if (!is_zero(r) && degree(r.den()) > 0)
    for (const auto& f : squarefree_factors(r.den()))
      if (f.exponent > 2) irregular = true;
  return irregular ? "meromorphic, also at the points at infinity of the phase curve"
                   : "meromorphic";
}

namespace {

const ReduceSpec* reduction_for(const System& s, const std::string& manifold) {
  for (const auto& r : s.reductions)
    if (r.manifold.empty() || r.manifold == manifold) return &r;
  return nullptr;
}

std::vector<Claim> usable_integrals(const System& s, const std::vector<ClaimReport>& claims) {
  std::vector<Claim> all;
  for (const auto& c : claims)
    if (c.result.proved && c.claim.on.empty() &&
        (c.claim.kind == Claim::Kind::casimir || c.claim.kind == Claim::Kind::integral))
      all.push_back(c.claim);
  if (s.field.hamiltonian) {
    Claim h;
    h.name = "H";
    h.value = *s.field.hamiltonian;
    all.push_back(std::move(h));
  }
  return all;
}

/// Tries every change for every cyclic vector and keeps the equation with the fewest singular
/// places.
void algebraize_block(const System& s, const InvariantManifold& m, const ReduceSpec* reduce,
                      const Budget& budget, BlockReport& block) {
  std::vector<MFraction> changes;
  if (reduce && reduce->change)
    changes.push_back(*reduce->change);
  else
    changes = propose_changes(s.field, m);
  std::vector<MPoly> divisors;
  for (const auto& e : block.scalar)
    divisors.insert(divisors.end(), e.divisors.begin(), e.divisors.end());
  std::string failures;
  for (const auto& phi : changes) {
    budget.check();
    auto field = FunctionField::make(s.field, m, s.z, phi, divisors, budget);
    if (const auto* failure = std::get_if<ChangeFailure>(&field)) {
      failures += (failures.empty() ? "" : "; ") + failure->message;
      continue;
    }
    for (const auto& e : block.scalar) {
      auto result = algebraize(std::get<FunctionField>(field), s.z, phi, e);
      if (const auto* failure = std::get_if<ChangeFailure>(&result)) {
        failures += (failures.empty() ? "" : "; ") + failure->message;
        continue;
      }
      auto& ode = std::get<AlgebraicOde>(result);
      if (!block.ode || ode.singular_places < block.ode->singular_places)
        block.ode = std::move(ode);
    }
  }
  if (block.ode) return;
  block.note = changes.empty() ? "no change of variable was found" : failures;
}

std::string parameter_names(const MFraction& f, const System& s) {
  std::string names;
  for (const std::size_t i : used_variables(f))
    if (std::find(s.field.parameters.begin(), s.field.parameters.end(), i) !=
        s.field.parameters.end())
      names += (names.empty() ? "" : ", ") + s.ring()->name(i);
  return names;
}

void decide_block(const System& s, const CheckOptions& options, BlockReport& block) {
  const AlgebraicOde& ode = *block.ode;
  const std::string names = parameter_names(ode.r, s);
  if (!names.empty()) {
    block.note = "r depends on the parameter(s) " + names +
                 "; give values with --set to decide single equations";
    return;
  }
  const ConstantField constants = ConstantField::make(s.field);
  NormalForm equation;
  equation.r = constants.convert(ode.r, ode.z);
  if (ode.p) {
    equation.p = constants.convert(*ode.p, ode.z);
    const NormalForm again = normal_form(equation.p, constants.convert(*ode.q, ode.z));
    KOV_ENSURE(again.r == equation.r); // two ways to r
  }
  block.equation = equation;
  if (options.stop_at_r) return;
  Options how = options.decide;
  how.variable = s.ring()->name(ode.z);
  block.decision = decide(equation, how);
  block.abelian = block.decision->abelian;
}

/// The diagonal blocks; two of order 1 that are coupled with each other and with nothing else are
/// studied together, because a triangular system of order 2 may have a non-abelian group.
std::vector<std::vector<std::size_t>> blocks_to_study(const LinearSystem& r,
                                                      const InvariantManifold& m) {
  auto parts = blocks(r, m);
  const auto coupled = [&](std::size_t i, std::size_t j) {
    return !m.vanishes_on_curve(r.a[i][j]) || !m.vanishes_on_curve(r.a[j][i]);
  };
  const auto neighbours = [&](std::size_t i) {
    std::vector<std::size_t> all;
    for (std::size_t j = 0; j < r.a.size(); ++j)
      if (j != i && coupled(i, j)) all.push_back(j);
    return all;
  };
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (parts[k].size() != 1) continue;
    const auto mine = neighbours(parts[k][0]);
    if (mine.size() != 1 || neighbours(mine[0]) != parts[k]) continue;
    const auto other = std::find(parts.begin(), parts.end(), mine);
    if (other == parts.end()) continue;
    parts[k] = {std::min(parts[k][0], mine[0]), std::max(parts[k][0], mine[0])};
    parts.erase(other);
    k = 0;
  }
  return parts;
}

Truth both(Truth a, Truth b) {
  if (a == Truth::no || b == Truth::no) return Truth::no;
  return a == Truth::yes && b == Truth::yes ? Truth::yes : Truth::unknown;
}

} // namespace

void study_energies(const System& s, const ReduceSpec& reduce, const CheckOptions& options,
                    BlockReport& block); // energies.cpp

namespace {

BlockReport study_block(const System& s, const InvariantManifold& m, const LinearSystem& reduced,
                        const std::vector<std::size_t>& members, const CheckOptions& options) {
  BlockReport block;
  for (const std::size_t i : members)
    block.unknowns.push_back(reduced.names[i]);
  if (members.size() == 1) {
    block.abelian = Truth::yes; // a first-order equation: its group is in the multiplicative group
    return block;
  }
  if (members.size() > 2) {
    block.note = "a normal block of order " + std::to_string(members.size()) +
                 ": not reducible to second order by the invariant manifold, linear first "
                 "integrals or block structure";
    return block;
  }
  const ReduceSpec* reduce = reduction_for(s, m.name);
  for (const std::size_t i : members) {
    if (reduce && reduce->unknown &&
        std::find(block.unknowns.begin(), block.unknowns.end(), s.ring()->name(*reduce->unknown)) !=
            block.unknowns.end() &&
        reduced.names[i] != s.ring()->name(*reduce->unknown))
      continue;
    if (auto e = scalar_equation(s.field, m, reduced, members, i))
      block.scalar.push_back(*std::move(e));
  }
  if (block.scalar.empty()) {
    block.note = "the unknown asked for is not a cyclic vector of its block";
    return block;
  }
  algebraize_block(s, m, reduce, options.decide.budget, block);
  if (!block.ode) return block;
  decide_block(s, options, block);
  if (reduce && reduce->energy == "auto") study_energies(s, *reduce, options, block);
  return block;
}

void conclude(const System& s, const CheckOptions& options, ManifoldReport& report) {
  Truth all = Truth::yes;
  for (const auto& block : report.blocks) {
    all = both(all, block.abelian);
    std::string name;
    for (const auto& u : block.unknowns)
      name += (name.empty() ? "" : ", ") + u;
    if (!block.note.empty()) report.reasons.push_back("block (" + name + "): " + block.note);
    if (block.decision) report.reasons.push_back("block (" + name + "): " + block.decision->reason);
    for (const auto& e : block.energies)
      if (e.decision) report.reasons.push_back("at " + e.condition + ": " + e.decision->reason);
  }
  if (options.stop_at_r) return;
  report.verdict = all == Truth::no    ? VerdictKind::non_integrable
                   : all == Truth::yes ? VerdictKind::no_obstruction
                                       : VerdictKind::undecided;
  if (report.verdict == VerdictKind::no_obstruction && report.blocks.size() > 1)
    report.reasons.emplace_back(
        "the diagonal blocks of the normal part were studied, not what couples them");
  report.theorem = s.field.poisson ? "Morales-Ramis" : "Ayoul-Zung";
  report.function_class = "meromorphic";
  for (const auto& block : report.blocks) {
    if (block.equation && block.abelian == Truth::no)
      report.function_class = first_integral_class(block.equation->r);
    for (const auto& e : block.energies)
      if (e.r && e.decision && e.decision->abelian == Truth::no)
        report.function_class = first_integral_class(*e.r);
  }
}

} // namespace

ManifoldReport check_manifold(const System& s, const ManifoldSpec& spec,
                              const std::vector<ClaimReport>& claims, const CheckOptions& options) {
  ManifoldReport report;
  report.name = spec.name;
  try {
    auto proved = prove_invariant(s.field, spec);
    if (auto* failure = std::get_if<ManifoldFailure>(&proved)) {
      report.failure = *failure;
      report.reasons.push_back(failure->message);
      return report;
    }
    report.manifold = std::get<InvariantManifold>(std::move(proved));
    const InvariantManifold& m = *report.manifold;
    report.variational = variational_equations(s.field, m);
    report.variational_blocks = blocks(report.variational, m);
    report.normal = normal_system(s.field, m, usable_integrals(s, claims));
    const ReduceSpec* reduce = reduction_for(s, m.name);
    std::vector<std::string> keep;
    if (reduce && reduce->unknown) keep.push_back(s.ring()->name(*reduce->unknown));
    report.reduced = reduce_by_integrals(s.field, m, report.normal, keep);
    for (const auto& members : blocks_to_study(report.reduced.system, m))
      report.blocks.push_back(study_block(s, m, report.reduced.system, members, options));
    conclude(s, options, report);
  } catch (const OutOfBudget& e) {
    report.reasons.emplace_back(e.what());
  } catch (const DomainError& e) {
    report.reasons.emplace_back(e.what());
  } catch (const InvalidArgument& e) {
    report.reasons.emplace_back(e.what());
  }
  return report;
}

CheckReport check_system(const System& s, const CheckOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  CheckReport report;
  report.system = s;
  for (const auto& claim : s.claims)
    report.claims.push_back({claim, check_claim(s, claim)});
  for (const auto& spec : s.manifolds)
    if (options.only_manifold.empty() || options.only_manifold == spec.name)
      report.manifolds.push_back(check_manifold(s, spec, report.claims, options));
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

} // namespace kov
