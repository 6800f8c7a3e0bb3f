#include "integrability/check.hpp"

#include "exact/error.hpp"
#include "integrability/block.hpp"
#include "integrability/components.hpp"
#include "integrability/conclude.hpp"
#include "integrability/levels.hpp"
#include "integrability/linearise.hpp"
#include "integrability/matrices.hpp"
#include "integrability/parameters.hpp"
#include "integrability/special_strata.hpp"
#include "integrability/way.hpp"

#include <algorithm>
#include <chrono>

namespace kov {
namespace {

// A limit leaves this block as it is, and the others are studied.
template <class Stage> void within_limits(BlockReport& block, Stage stage) {
  try {
    stage();
  } catch (const OutOfBudget& limit) {
    block.note += (block.note.empty() ? "" : "; ") + std::string(limit.what());
  }
}

void decide_blocks(const Study& study, ManifoldReport& report) {
  const System& s = study.system;
  const auto parts = blocks_to_study(report.reduced.system, *report.manifold);
  auto whole = coupling(s, report, parts);
  report.not_studied = std::move(whole.missing);
  report.coupling_divisors = whole.divisors;
  auto divisors = divisors_of(study, report);
  divisors.insert(divisors.end(), whole.divisors.begin(), whole.divisors.end());
  for (const auto& members : parts) {
    BlockReport& block = report.blocks.emplace_back();
    within_limits(block, [&] { study_on_the_leaf(study, report, divisors, members, block); });
    find_way(study, report, block);
  }
  if (std::none_of(report.blocks.begin(), report.blocks.end(),
                   [](const BlockReport& b) { return b.ode.has_value(); }))
    for (const auto& all : {whole.divisors, early_divisors(report)})
      for (const MPoly& d : all) // nothing else asks where they vanish
        if (may_vanish_identically(s, d))
          report.not_studied =
              "the parameters for which " + to_string(d) + " is zero were not studied";
}

// Where the generic answer is not the whole one: single levels, and strata without the reduction.
void decide_exceptions(const Study& study, std::vector<BlockReport>& all) {
  const ReduceSpec* reduce = reduction_for(study.system, study.manifold.name);
  if (reduce && reduce->energy == "auto")
    for (auto& block : all)
      if (block.ode) within_limits(block, [&] { study_levels(study, *reduce, all, block); });
  for (auto& block : all) {
    if (!block.strata) continue;
    decide_special_strata(study, all, block.unknowns, *block.strata, block.special_studies);
    block.abelian = some_level_is_not_abelian(study.system, *block.strata)
                        ? Truth::no
                        : block.strata->abelian();
  }
}

} // namespace

ManifoldReport check_manifold(const System& s, const ManifoldSpec& spec,
                              const std::vector<ClaimReport>& claims, const CheckOptions& options) {
  const Study study{s, spec, claims, options};
  ManifoldReport report;
  report.name = spec.name;
  try {
    auto proved = prove_invariant(s.field, spec, options.decide.budget);
    if (auto* failure = std::get_if<ManifoldFailure>(&proved)) {
      report.failure = *failure;
      report.reasons.push_back(failure->message);
      return report;
    }
    report.manifold = std::get<InvariantManifold>(std::move(proved));
    linearise(study, report);
    decide_blocks(study, report);
    decide_exceptions(study, report.blocks);
    if (!options.stop_at_r && verdict_of(report) == VerdictKind::no_obstruction) {
      report.not_studied = component_left_out(study, report);
      const std::string open = components_not_checked(study, report);
      report.not_checked += (report.not_checked.empty() || open.empty() ? "" : "; ") + open;
    }
    if (!options.stop_at_r && verdict_of(report) == VerdictKind::undecided)
      ask_the_matrices(study, report);
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

std::vector<const ManifoldSpec*> manifolds_to_check(const System& s, const CheckOptions& options) {
  const std::string& only = options.only_manifold;
  std::vector<const ManifoldSpec*> all;
  std::string names;
  for (const auto& spec : s.manifolds) {
    names += (names.empty() ? "" : ", ") + spec.name;
    if (only.empty() || only == spec.name) all.push_back(&spec);
  }
  if (!only.empty() && all.empty())
    throw InvalidArgument("there is no manifold '" + only +
                          "'; manifolds: " + (names.empty() ? "none" : names));
  return all;
}

std::vector<ClaimReport> decide_claims(const System& s, const CheckOptions& options) {
  std::vector<ClaimReport> all;
  for (const auto& claim : s.claims)
    all.push_back({claim, decide_claim(s, claim, options.decide.budget)});
  return all;
}

namespace {

// An equal share, so that one manifold does not take the time of the others.
CheckOptions for_one_of(std::size_t manifolds, CheckOptions options) {
  options.decide.budget =
      part_of_the_time(options.decide.budget, 1 / static_cast<double>(manifolds));
  return options;
}

} // namespace

Budget part_of_the_time(Budget budget, double part) {
  const auto now = Budget::Clock::now();
  if (budget.deadline && *budget.deadline > now)
    budget.deadline =
        now + std::chrono::duration_cast<Budget::Clock::duration>(part * (*budget.deadline - now));
  return budget;
}

CheckReport check_system(const System& s, const CheckOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  CheckReport report;
  report.system = s;
  report.claims = decide_claims(s, options);
  auto left = manifolds_to_check(s, options);
  for (; !left.empty(); left.erase(left.begin()))
    report.manifolds.push_back(
        check_manifold(s, *left.front(), report.claims, for_one_of(left.size(), options)));
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

} // namespace kov
