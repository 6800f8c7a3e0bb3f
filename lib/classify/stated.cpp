#include "classify/stated.hpp"

#include "classify/shares.hpp"
#include "exact/lists.hpp"
#include "exact/share.hpp"
#include "exact/variables.hpp"
#include "integrability/one_level.hpp"
#include "integrability/parameters.hpp"
#include "strata/words.hpp"
#include "study/pieces.hpp"
#include "study/study.hpp"
#include "study/together.hpp"

#include <algorithm>
#include <chrono>

namespace kov {
namespace {

using Lists = std::vector<std::vector<MPoly>>;

// "h real", or "c h + d > 0" with numbers: satisfied whatever the parameters are, and it says nothing
// of them.
bool is_of_the_level_alone(const Assumption& a) {
  return used_variables(a.value).size() == 1 && is_constant(MFraction(a.value.den()));
}

// For which parameters there is a level as the file assumes it; unset: that is not known.
std::optional<Lists> some_level_is_admitted(const System& s) {
  const auto levels = level_parameters(s);
  Lists some;
  for (const Assumption& a : s.assumptions) {
    if (!uses_any(a.value, levels)) continue;
    if (a.is(Sign::nonzero) && is_constant(MFraction(a.value.den())))
      some.push_back(nonzero_coefficients(a.value.num(), levels));
    else if (!is_of_the_level_alone(a))
      return std::nullopt;
  }
  if (free_levels(s).size() != levels.size()) return std::nullopt;
  return some;
}

// "h > 0", of the levels; "h != 0" holds for all but special ones.
std::vector<std::string> assumed_of_levels(const System& s) {
  std::vector<std::string> all;
  for (const Assumption& a : s.assumptions)
    if (!a.is(Sign::nonzero) && uses_any(a.value, level_parameters(s))) all.push_back(a.text);
  return all;
}

System without_assumptions_on_levels(System s) {
  for (const std::size_t h : level_parameters(s))
    forget_assumptions(h, s);
  return s;
}

// The limit that ended the question on a stratum before there was an answer; empty: nothing did.
std::string limit_of(const strata::StrataAnswer& answer) {
  if (!answer.unvisited.empty())
    return "the first variational equation is undecided for " + answer.unvisited.front();
  for (const strata::Stratum& s : answer.strata)
    if (s.leaf.open && (std::holds_alternative<strata::OpenNumber>(*s.leaf.open) ||
                        std::holds_alternative<strata::TooManyUnknowns>(*s.leaf.open) ||
                        std::holds_alternative<strata::LargeDenominator>(*s.leaf.open) ||
                        std::holds_alternative<strata::RefusedByChecker>(*s.leaf.open)))
      return strata::reason_in_brief(s.leaf);
  return "";
}

class StatedStudy {
public:
  StatedStudy(const System& s, const ClassifyOptions& options)
      : s_(s), file_(s), told_(without_assumptions_on_levels(s)), options_(options),
        admitted_(some_level_is_admitted(s)), assumed_(assumed_of_levels(s)) {
    options_.check.decide.budget = part_of_the_work(options.check.decide.budget, share::stated);
  }

  StatedSolutions run() {
    StatedSolutions result{file_.claims(options_.check), {}};
    if (!admitted_) return result;
    for (std::size_t k = 0; k < s_.manifolds.size(); ++k) {
      const ManifoldSpec& m = s_.manifolds[k];
      const std::string stage = m.name + ", as the file states it";
      if (options_.so_far) tell(stage);
      const auto& skip = options_.skip;
      if (!is_among(stage, skip)) result.all.push_back(study(k));
    }
    result.decided = known().status() == Verdict::non_integrable;
    return result;
  }

private:
  [[nodiscard]] SystemClassification known() const {
    return together(told_, exclusions_, options_.check.decide.budget.stop);
  }

  void tell(const std::string& stage) const {
    SystemClassification so_far = known();
    so_far.at_work = stage;
    so_far.complete = false;
    const Unmetered words;
    options_.so_far(so_far);
  }

  StatedSolution study(std::size_t k) {
    const auto start = std::chrono::steady_clock::now();
    const double work = meter();
    study::StudyOptions share{options_.check};
    share.check.only_manifold.clear();
    share.check.decide.budget = part_of_the_work(share.check.decide.budget,
                                                 1 / static_cast<double>(s_.manifolds.size() - k));
    const study::CurveStudy& found = file_.manifold(k, share);
    StatedSolution one{found.name(), found.exclusions, outcome(found.first)};
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    one.spent = {"along " + one.name + ", as the file states it", meter() - work, time.count()};
    one.finished =
        !found.first.failure && found.headline.complete && !share.check.decide.budget.is_spent();
    const auto from = std::make_shared<const study::Evidence>(file_.studied(share.check), found);
    for (Exclusion& e : one.exclusions) {
      e.from = from;
      e.not_all_zero.insert(e.not_all_zero.end(), admitted_->begin(), admitted_->end());
      e.by.level.fixed.insert(e.by.level.fixed.end(), assumed_.begin(), assumed_.end());
    }
    exclusions_.insert(exclusions_.end(), one.exclusions.begin(), one.exclusions.end());
    return one;
  }

  const System& s_;
  study::FileStudy file_; ///< as `check` studies it
  System told_;           ///< of which the theorem speaks: nothing is assumed of levels
  ClassifyOptions options_;
  std::optional<Lists> admitted_;
  std::vector<std::string> assumed_;
  std::vector<Exclusion> exclusions_;
};

} // namespace

StatedSolutions stated_solutions(const System& s, const ClassifyOptions& options) {
  return StatedStudy(s, options).run();
}

Exclusion in_ring(Exclusion e, const Ring& ring) {
  static_cast<Cut&>(e) = moved(e, [&](const MFraction& f) { return transfer(f, ring); });
  return e;
}

std::string outcome(const ManifoldReport& report) {
  if (report.failure) return report.failure->message;
  if (report.verdict == Verdict::no_obstruction)
    return "the first variational equation has an abelian identity component";
  for (const BlockReport& b : report.blocks)
    if (b.abelian == Truth::unknown && !b.strata && !b.missing.empty()) return note(b.missing);
  for (const BlockReport& b : report.blocks)
    if (b.strata)
      if (std::string limit = limit_of(*b.strata); !limit.empty()) return limit;
  if (report.blocks.empty())
    if (const auto why = reasons(report); !why.empty()) return why.front();
  return "the first variational equation excludes no more";
}

} // namespace kov
