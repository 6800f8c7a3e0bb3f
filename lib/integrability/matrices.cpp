#include "integrability/matrices.hpp"

#include "exact/error.hpp"
#include "integrability/loops_certificate.hpp"
#include "integrability/parameters.hpp"
#include "integrability/specialise.hpp"

#include <algorithm>

namespace kov {
namespace {

constexpr long digits = 30;
constexpr std::chrono::seconds longest{15};

// Level parameters in the equations of the manifold, all at one value.
Substitution at_level(const System& s, const ManifoldSpec& spec, const Rational& value) {
  Substitution level;
  for (const std::size_t i : level_parameters(s))
    if (std::any_of(spec.levels.begin(), spec.levels.end(),
                    [&](const Equation& e) { return uses(e.difference, i); }))
      level[i] = MFraction(s.ring(), value);
  return level;
}

// Parameters that are no choice of a level have values: the matrices may not show them, but what
// was divided by does.
bool has_only_levels(const System& s) {
  const auto levels = level_parameters(s);
  return std::all_of(s.field.parameters.begin(), s.field.parameters.end(), [&](std::size_t i) {
    return std::find(levels.begin(), levels.end(), i) != levels.end();
  });
}

// The level is one that the file admits, and so are those near it.
bool is_admitted(const System& s, const Substitution& level) {
  using Relation = Assumption::Relation;
  return std::all_of(s.assumptions.begin(), s.assumptions.end(), [&](const Assumption& a) {
    if (!a.value.ring() || std::none_of(level.begin(), level.end(),
                                        [&](const auto& x) { return uses(a.value, x.first); }))
      return true;
    if (a.relation == Relation::real || a.relation == Relation::rational) return true;
    const MFraction there = substitute(a.value, level);
    if (!is_zero(there) && !is_constant(there)) return false;
    const int sign_there = is_zero(there) ? 0 : sign(to_rational(there));
    return (a.relation == Relation::nonzero && sign_there != 0) ||
           ((a.relation == Relation::positive || a.relation == Relation::nonnegative) &&
            sign_there > 0);
  });
}

std::optional<MatrixEvidence> matrices_at(const Study& study, const Substitution& level,
                                          const Budget& budget) {
  const System s = at_values(study.system, level);
  auto proved = prove_invariant(s.field, at_values(study.manifold, level), budget);
  const auto* manifold = std::get_if<InvariantManifold>(&proved);
  if (manifold == nullptr) return std::nullopt;
  const auto v =
      numerical_variation(s, *manifold, variational_equations(s.field, *manifold), budget);
  const auto m = monodromy::monodromy(v.system, {digits, {}, budget});
  auto proof = prove_non_abelian(v.system, m, budget);
  if (!proof) return std::nullopt;
  MatrixEvidence found{*std::move(proof), v.system.size(), v.names, v.change, {}, {}, {}};
  const LoopsProof written = not_abelian_certificate(
      found.proof, "the variational equation of " + s.file + " along " + manifold->name, v.system,
      m, budget);
  found.certificate = written.certificate;
  found.no_certificate = written.none;
  for (const auto& [i, value] : level)
    found.level += (found.level.empty() ? "" : ", ") + s.ring()->name(i) + " = " + to_string(value);
  return found;
}

} // namespace

void ask_the_matrices(const Study& study, ManifoldReport& report) {
  // Of a Poisson system the variation on the leaf would be needed.
  const bool whole = study.system.kind == SystemKind::hamiltonian || !study.system.field.poisson;
  if (!report.manifold || !whole || !has_only_levels(study.system)) return;
  Budget budget = part_of_the_time(study.options.decide.budget, 0.5); // what is known must be told
  const auto end = Budget::Clock::now() + longest;
  budget.deadline = budget.deadline ? std::min(*budget.deadline, end) : end;
  for (const Rational& value : {Rational(1), Rational(2), Rational(-1, 3)}) {
    const Substitution level = at_level(study.system, study.manifold, value);
    try {
      if (!is_admitted(study.system, level)) continue;
      if (auto found = matrices_at(study, level, budget)) {
        report.matrices = std::make_shared<const MatrixEvidence>(*std::move(found));
        return;
      }
    } catch (const OutOfBudget&) { // what could not be computed proves nothing
    } catch (const InvalidArgument&) {
    } catch (const DomainError&) {
    }
    if (level.empty()) return;
  }
}

std::string reason(const MatrixEvidence& by) {
  return "the monodromy matrices of the whole variational equation (size " +
         std::to_string(by.size) + ", " + by.change +
         (by.level.empty() ? "" : ", at the level " + by.level) + ") prove that its identity " +
         "component is not abelian: " +
         (by.proof.unipotent ? std::string("two unipotent elements of the group do not commute")
                             : "a diagonal block is dense in SL(2, C), up to scalars") +
         " (enclosures with " + std::to_string(digits) + " digits)";
}

} // namespace kov
