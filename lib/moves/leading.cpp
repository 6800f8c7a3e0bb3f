#include "moves/leading.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "exact/variables.hpp"
#include "integrability/parameters.hpp"
#include "literature/literature.hpp"
#include "moves/e3.hpp"

#include <algorithm>

namespace kov {
namespace {

constexpr std::pair<long, long> to_try[] = {{1, 2}, {1, 1}, {2, 1}, {2, 3}, {3, 2}, {1, 3}, {3, 1}};

// The polynomial that must not vanish for H to be analytic at the origin; 0: it has a pole there.
MPoly denominator_at_origin(const System& s) {
  Substitution origin;
  for (const std::size_t i : s.field.coordinates)
    origin[i] = MFraction(s.ring());
  return substitute(s.field.hamiltonian->den(), origin).num();
}

bool uses_some(const MFraction& f, const std::vector<std::size_t>& x, std::size_t from) {
  return std::any_of(x.begin() + static_cast<long>(from), x.begin() + static_cast<long>(from + 3),
                     [&](std::size_t i) { return uses(f, i); });
}

System with_hamiltonian(const System& s, const MFraction& h) {
  System t = s;
  t.kind = SystemKind::poisson;
  t.lagrangian.reset();
  t.velocities.clear();
  t.velocity_values.clear();
  t.field.hamiltonian = h;
  t.field.components = hamiltonian_field(t.field, *t.field.poisson, h);
  t.named["H"] = h;
  std::erase_if(t.claims,
                [](const SystemClaim& c) { return c.kind != SystemClaim::Kind::casimir; });
  t.manifolds.clear();
  t.reductions.clear();
  t.expectations.clear();
  t.weights.clear();
  const auto levels = level_parameters(s);
  std::erase_if(t.field.parameters, [&](std::size_t p) { return is_among(p, levels); });
  return t;
}

// Gamma^2 is a number there that is not 0: both Casimir functions are regular.
bool is_on_a_regular_leaf(const System& s, const ManifoldSpec& m) {
  MFraction square(s.ring());
  for (std::size_t k = 3; k < 6; ++k) {
    const MFraction x = MFraction::variable(s.ring(), s.field.coordinates[k]);
    square += x * x;
  }
  return std::ranges::any_of(m.levels, [&](const Equation& level) {
    const auto used = used_variables(level.difference);
    if (!std::ranges::all_of(used, [&](std::size_t i) {
          return s.ring()->find(level.difference.ring()->name(i)).has_value();
        }))
      return false;
    const MFraction value = square - transfer(level.difference, s.ring());
    return is_constant(value) && !is_zero(value);
  });
}

} // namespace

std::optional<LeadingPart> leading_part(const System& s, Order order) {
  if (!has_bracket_of_e3(s.field) || !s.field.hamiltonian || !s.field.functions.empty() ||
      !s.field.relations.empty() || !s.field.constants.empty())
    return std::nullopt;
  const MPoly at_origin = denominator_at_origin(s);
  if (is_zero(at_origin)) return std::nullopt; // a pole
  const auto& x = s.field.coordinates;
  if (order == Order::highest && uses_any(s.field.hamiltonian->den(), x)) return std::nullopt;
  for (const auto& [of_momentum, of_gamma] : to_try) {
    Weights weights;
    for (std::size_t k = 0; k < 6; ++k)
      weights[x[k]] = k < 3 ? of_momentum : of_gamma;
    const MFraction h = order == Order::lowest
                            ? weight_expansion(*s.field.hamiltonian, weights, 1).front().value
                            : MFraction(highest_part(s.field.hamiltonian->num(), weights),
                                        s.field.hamiltonian->den());
    if (!uses_some(h, x, 0) || !uses_some(h, x, 3) || h == *s.field.hamiltonian) continue;
    return LeadingPart{order, of_momentum, of_gamma, with_hamiltonian(s, h),
                       is_constant(at_origin) ? MPoly(s.ring(), Integer(1))
                                              : squarefree_part(at_origin)};
  }
  return std::nullopt;
}

std::optional<Preimage> said_by(const System& s, const LeadingPart& part,
                                const ClassifiedStratum& x) {
  if (x.status != StratumStatus::excluded || !x.constants.empty() || !x.along ||
      !has_rational_functions(x.by.front().integrals) ||
      (x.by.front().integrals.on_leaf && !is_on_a_regular_leaf(s, *x.along)))
    return std::nullopt;
  Preimage c{{}, x};
  try {
    static_cast<Cut&>(c) =
        moved(cut_of(x.where), [&](const MFraction& f) { return transfer(f, s.ring()); });
  } catch (const Error&) { // it speaks of a variable that the system does not have
    return std::nullopt;
  }
  c.not_all_zero.insert(c.not_all_zero.begin(), {part.nonzero});
  c.stratum.along.reset();
  if (part.order == Order::lowest)
    c.stratum.lowest = {part.of_momentum, part.of_gamma};
  else
    c.stratum.from.reset();
  ExclusionReason& by = c.stratum.by.front();
  c.stratum.by.resize(1);
  const std::string order = part.order == Order::lowest ? "lowest" : "highest";
  by.solution += " of the system of " + order + " order";
  by.reason = "with weights " + std::to_string(part.of_momentum) + " for M and " +
              std::to_string(part.of_gamma) + " for Gamma the " + order + " part of H is " +
              brief(*part.system.field.hamiltonian, 120) +
              ", and its system is not integrable: " + by.reason;
  by.integrals = part.order == Order::lowest ? IntegralClass{.near = IntegralClass::Near::origin}
                                             : IntegralClass{.kind = IntegralClass::Kind::rational};
  by.rule = Rule::leading_part;
  const LiteratureTheorem* lemma = &ziglin_1982();
  add_once(by.theorems, lemma);
  by.trusted.push_back({Trusted::Step::part_of_h, order});
  return c;
}

} // namespace kov
