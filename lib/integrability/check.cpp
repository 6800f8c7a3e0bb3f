#include "integrability/check.hpp"

#include "decide/afterwards.hpp"
#include "exact/tried.hpp"
#include "integrability/along_the_curve.hpp"
#include "integrability/block.hpp"
#include "integrability/components.hpp"
#include "integrability/conclude.hpp"
#include "integrability/decoupling.hpp"
#include "integrability/eigenvalue.hpp"
#include "integrability/levels.hpp"
#include "integrability/linearise.hpp"
#include "integrability/matrices.hpp"
#include "integrability/one_level.hpp"
#include "integrability/parameters.hpp"
#include "integrability/special_strata.hpp"
#include "integrability/translations.hpp"
#include "integrability/way.hpp"

#include <algorithm>
#include <exception>

namespace kov {
namespace {

/// The first error of the program; the answer, where there is no verdict without the part that failed.
class Failure {
public:
  void remember() {
    if (!error_) error_ = std::current_exception();
  }
  void rethrow_if_there_is_one() const {
    if (error_) std::rethrow_exception(error_);
  }

private:
  std::exception_ptr error_;
};

// A limit or an error of the program leaves this block as it is, and the others are studied.
template <class Stage> void within_limits(BlockReport& block, Failure& failure, Stage stage) {
  try {
    stage();
  } catch (const OutOfBudget& limit) {
    block.missing.push_back({Missing::What::limit, limit.what()});
  } catch (const Contradiction&) {
    throw;
  } catch (const InternalError& error) {
    failure.remember();
    block.missing.push_back(
        {Missing::What::program_error, failure_of("the study of this block", error.what())});
  }
}

// Only a certificate needs it.
void find_way_if_possible(const Study& study, const ManifoldReport& report, BlockReport& block) {
  const std::string failed =
      failure_of("the way to the equation", [&] { find_way(study, report, block); });
  if (failed.empty()) return;
  block.way.reset();
  block.no_way = NoWay{NoWay::Why::failed, failed};
}

void decide_blocks(const Study& study, ManifoldReport& report, Failure& failure) {
  const System& s = study.system;
  const auto parts = blocks_to_study(report.reduced.system, *report.manifold);
  auto whole = coupling(s, report, parts);
  if (!whole.missing.empty())
    report.left_out = LeftOut{LeftOut::What::coupling, std::move(whole.missing)};
  report.coupling_divisors = whole.divisors;
  auto divisors = divisors_of(study, report);
  divisors.insert(divisors.end(), whole.divisors.begin(), whole.divisors.end());
  for (const auto& members : parts) {
    BlockReport& block = report.blocks.emplace_back();
    within_limits(block, failure,
                  [&] { study_on_the_leaf(study, report, divisors, members, block); });
    find_way_if_possible(study, report, block);
  }
  if (std::ranges::none_of(report.blocks, [](const BlockReport& b) { return b.ode.has_value(); }))
    for (const auto& all : {whole.divisors, early_divisors(report)})
      for (const MPoly& d : all) // nothing else asks where they vanish
        if (may_vanish_identically(s, d))
          report.left_out = LeftOut{LeftOut::What::parameters, to_string(d)};
}

// Decides what the normal part does not see: blocks of order one that are coupled to the curve.
void decide_along_the_curve(const Study& study, ManifoldReport& report, Failure& failure) {
  const auto extended = extended_system(study.system, report);
  if (!extended) return;
  for (const auto& members : pairs_with_the_curve(*extended, *report.manifold)) {
    BlockReport block;
    within_limits(block, failure, [&] {
      study_block(study.system, *report.manifold, extended->system, extended->divisors, members,
                  study.options, block);
    });
    if (block.ode) report.blocks.push_back(std::move(block));
  }
}

// Decides where the generic answer is not the whole one: single levels, and strata without the
// reduction.
void decide_exceptions(const Study& study, std::vector<BlockReport>& all, Failure& failure) {
  const ReduceSpec* reduce = reduction_for(study.system, study.manifold.name);
  if (reduce && reduce->energy == "auto")
    for (auto& block : all)
      if (block.ode)
        within_limits(block, failure, [&] { study_levels(study, *reduce, all, block); });
  for (auto& block : all) {
    if (!block.strata) continue;
    within_limits(block, failure, [&] {
      decide_special_strata(study, all, block.unknowns, *block.strata, block.special_studies);
      const auto level = level_that_decides(study.system, *block.strata);
      block.abelian = level ? Truth::no : block.strata->abelian();
      if (level && !sentence(*level).empty()) block.level = *level; // else a general one
    });
  }
}

void ask_matrices(const Study& study, ManifoldReport& report, Failure& failure,
                  void (*ask)(const Study&, ManifoldReport&) = ask_the_matrices) {
  try {
    ask(study, report);
  } catch (const Contradiction&) {
    throw;
  } catch (const InternalError& error) {
    failure.remember();
    report.matrices.reset();
    report.missing.push_back(
        {Missing::What::program_error, failure_of("the monodromy matrices", error.what())});
  }
}

// "No obstruction" means that everything was looked at.
bool proves_something(const ManifoldReport& report) {
  return report.verdict == Verdict::non_integrable || !statement(report).empty();
}

bool has_large_block(const ManifoldReport& report) {
  const auto parts = blocks(report.reduced.system, *report.manifold);
  return std::ranges::any_of(parts, [](const auto& b) { return b.size() > 2; });
}

// The same set by equations whose variations fall apart, as long as a block is too large.
void fall_apart(const Study& study, ManifoldSpec& spec, ManifoldReport& report) {
  const ReduceSpec* asked = reduction_for(study.system, spec.name);
  if (asked != nullptr && (asked->unknown || !asked->normal.empty())) return;
  const Budget& budget = study.options.decide.budget;
  for (std::size_t k = 0; k < spec.equations.size() && has_large_block(report); ++k) {
    auto better = decoupled(study.system, spec, report, budget);
    if (!better) return;
    auto proved = prove_invariant(study.system.field, *better, budget);
    if (!std::holds_alternative<InvariantManifold>(proved)) return;
    spec = *std::move(better);
    report.manifold = std::get<InvariantManifold>(std::move(proved));
    linearise(study, report);
  }
}

} // namespace

std::optional<WithEigenvalue> over_an_eigenvalue(const System& s, const ManifoldSpec& given,
                                                 const std::vector<ClaimReport>& claims,
                                                 const CheckOptions& options) {
  ManifoldSpec spec = adapted_to_translations(s, given, claims);
  const Study study{s, spec, claims, options};
  ManifoldReport report;
  using Found = std::optional<WithEigenvalue>;
  return tried<OutOfBudget, DomainError, InvalidArgument>([&]() -> Found {
    auto proved = prove_invariant(s.field, spec, options.decide.budget);
    if (!std::holds_alternative<InvariantManifold>(proved)) return std::nullopt;
    report.manifold = std::get<InvariantManifold>(std::move(proved));
    linearise(study, report);
    fall_apart(study, spec, report);
    if (!has_large_block(report)) return std::nullopt;
    return with_eigenvalue(s, spec, report, options.decide.budget);
  });
}

ManifoldReport check_manifold(const System& s, const ManifoldSpec& given,
                              const std::vector<ClaimReport>& claims, const CheckOptions& options) {
  ManifoldSpec spec = adapted_to_translations(s, given, claims);
  const Study study{s, spec, claims, options};
  ManifoldReport report;
  Failure failure;
  report.name = spec.name;
  try {
    auto proved = prove_invariant(s.field, spec, options.decide.budget);
    if (auto* failure = std::get_if<ManifoldFailure>(&proved)) {
      report.failure = *failure;
      return report;
    }
    report.manifold = std::get<InvariantManifold>(std::move(proved));
    linearise(study, report);
    fall_apart(study, spec, report);
    // no algebra decides a large block, and beside it the small ones may take long
    if (!options.stop_at_r && has_large_block(report)) ask_matrices(study, report, failure);
    if (report.matrices) {
      conclude(s, options, report);
      return report;
    }
    decide_blocks(study, report, failure);
    if (options.along_the_curve) decide_along_the_curve(study, report, failure);
    decide_exceptions(study, report.blocks, failure);
    withdraw_refused(report.blocks);
    if (!options.stop_at_r && verdict_of(report) == Verdict::no_obstruction) {
      report.left_out = component_left_out(study, report);
      report.components_open = may_fall_apart(study, report);
      if (!options.along_the_curve) ask_matrices(study, report, failure, ask_with_the_casimir);
    }
    if (!options.stop_at_r && verdict_of(report) == Verdict::undecided && !has_large_block(report))
      ask_matrices(study, report, failure);
    conclude(s, options, report);
    if (!proves_something(report)) failure.rethrow_if_there_is_one();
  } catch (const OutOfBudget& e) {
    report.missing.push_back({Missing::What::limit, e.what()});
  } catch (const DomainError& e) {
    report.missing.push_back({Missing::What::undefined, e.what()});
  } catch (const InvalidArgument& e) {
    report.missing.push_back({Missing::What::undefined, e.what()});
  }
  return report;
}

} // namespace kov
