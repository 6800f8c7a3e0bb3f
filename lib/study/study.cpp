#include "study/study.hpp"

#include "decide/afterwards.hpp"
#include "exact/share.hpp"
#include "integrability/eigenvalue.hpp"
#include "integrability/one_level.hpp"
#include "integrability/parameters.hpp"
#include "study/contradiction.hpp"
#include "study/curve.hpp"
#include "study/together.hpp"
#include "system/assumed_values.hpp"

#include <algorithm>
#include <chrono>
#include <exception>

namespace kov::study {
namespace {

constexpr double work_for_eigenvalues = 6e8; // some seconds

Verdict verdict_of_first(const ManifoldReport& m) {
  switch (m.verdict) {
  case VerdictKind::non_integrable:
    return Verdict::non_integrable;
  case VerdictKind::no_obstruction:
    return Verdict::no_obstruction;
  case VerdictKind::depends:
    return Verdict::depends;
  default:
    return Verdict::undecided;
  }
}

Headline of_first_order(const ManifoldReport& m) {
  Headline h;
  h.refused = m.failure ? 1 : 0;
  h.verdict = m.failure ? Verdict::failed : verdict_of_first(m);
  if (!m.by) return h;
  if (!m.statement.empty()) h.excluded = {m.by->integrals};
  h.trusted = trusted_steps(m).size();
  h.unchecked = m.not_checked.empty() ? 0 : 1;
  return h;
}

// An obstruction with exceptions leaves open there what the first order leaves open.
Headline with_exceptions(const Headline& first, const SystemClassification& both) {
  Headline h = headline_of(both);
  if (h.verdict != Verdict::non_integrable)
    h.verdict = first.verdict == Verdict::undecided ? Verdict::undecided : Verdict::depends;
  return h;
}

void take_higher_orders(const System& s, HigherOrders found, const StudyOptions& options,
                        CurveStudy& m) {
  if (found.excluded) {
    std::vector<Exclusion> all = m.exclusions;
    all.push_back(*found.excluded);
    if (!found.exceptions.empty()) {
      m.orders_together = kov::together(s, all, options.check.decide.budget.stop);
      m.headline = with_exceptions(m.headline, *m.orders_together);
    } else {
      const ExclusionReason& by = found.excluded->by;
      m.headline = {Verdict::non_integrable,
                    {by.integrals},
                    by.trusted.size(),
                    std::size_t{by.unchecked.empty() ? 0U : 1U}};
    }
    m.exclusions = std::move(all);
  }
  m.higher = std::move(found);
}

// Behind the verdict of the first order: a limit or an error costs this part only.
void ask_higher_orders(const System& s, const ManifoldSpec& spec, const StudyOptions& options,
                       CurveStudy& m) {
  constexpr const char* part = "the higher orders";
  std::string missing;
  try {
    missing = failure_of(part, [&] {
      take_higher_orders(s, higher_orders(s, spec, options.order, options.check.decide), options,
                         m);
    });
  } catch (const OutOfBudget& limit) {
    missing = std::string(part) + ": " + limit.what();
  }
  if (!missing.empty()) m.failed.push_back(missing);
}

// The claims of the file are proved by other code than that which excludes.
void look_for_contradictions(const System& s, const std::vector<ClaimReport>& claims,
                             CurveStudy& m) {
  if (m.exclusions.empty() || claims.empty()) return;
  try {
    const std::string missing = failure_of("the look for contradictions", [&] {
      if (const auto known = known_integrals(s, claims))
        for (const Exclusion& e : m.exclusions)
          refuse_contradiction(s, e, *known);
    });
    if (!missing.empty()) m.failed.push_back(missing);
  } catch (const OutOfBudget&) { // none is known
  }
}

} // namespace

FileStudy::FileStudy(const Entry& document, ParameterValues set)
    : document_(document), set_(std::move(set)), system_(read_system_as_assumed(document, set_)) {
  require_consistent(system_);
}

FileStudy::FileStudy(System s) : system_(std::move(s)), studied_(system_) {}

const System& FileStudy::studied(const CheckOptions& options) {
  if (studied_) return *studied_;
  CheckOptions search = options;
  search.decide.budget = at_most(options.decide.budget, work_for_eigenvalues);
  studied_ = with_eigenvalues(system_, search);
  return *studied_;
}

const std::vector<ClaimReport>& FileStudy::claims(const CheckOptions& options) {
  if (!claims_) claims_ = decide_claims(system_, options);
  return *claims_;
}

// Values can turn a curve into points; then they are the reason, and the file is not wrong.
bool FileStudy::is_fine_without_values(const std::string& manifold, const Budget& budget) const {
  if (set_.empty()) return false;
  const System file = read_system(*document_, {});
  for (const auto& spec : file.manifolds)
    if (spec.name == manifold)
      return std::holds_alternative<InvariantManifold>(prove_invariant(file.field, spec, budget));
  return false;
}

const CurveStudy& FileStudy::manifold(std::size_t k, const StudyOptions& options,
                                      bool with_claims) {
  const System& s = studied(options.check);
  const ManifoldSpec& spec = *manifolds_to_check(s, options.check).at(k);
  if (const auto done = manifolds_.find(spec.name); done != manifolds_.end()) return done->second;
  CurveStudy m;
  const auto known = with_claims ? claims_of(s, claims(options.check)) : std::vector<ClaimReport>{};
  m.first = study_curve(s, spec, known, options.check);
  if (m.first.failure && is_fine_without_values(spec.name, options.check.decide.budget)) {
    m.first.reasons = {"at these values " + m.first.failure->message};
    m.first.failure.reset();
  }
  if (!m.first.failure) m.exclusions = exclusions_of_verdict(s, m.first, free_levels(s));
  m.headline = of_first_order(m.first);
  if (options.order > 1 && m.first.manifold && m.headline.verdict != Verdict::non_integrable)
    ask_higher_orders(s, spec, options, m);
  look_for_contradictions(s, known, m);
  m.headline.complete = m.failed.empty() && !options.check.decide.budget.is_cut_short();
  return manifolds_.emplace(spec.name, std::move(m)).first->second;
}

SystemClassification FileStudy::together(const std::vector<std::size_t>& of,
                                         const StudyOptions& options, bool with_claims) {
  std::vector<Exclusion> all;
  for (const std::size_t k : of) {
    const auto& one = manifold(k, options, with_claims).exclusions;
    all.insert(all.end(), one.begin(), one.end());
  }
  return kov::together(studied(options.check), all, options.check.decide.budget.stop);
}

namespace {

/// All manifolds of one file, one after the other.
class WholeStudy {
public:
  WholeStudy(const Entry& document, const ParameterValues& set, const StudyOptions& options)
      : file_(document, set), options_(options),
        manifolds_(manifolds_to_check(file_.system(), options.check)),
        of_several_(options.check.decide.budget) {
    if (manifolds_.size() > 1 && !of_several_.work_end)
      of_several_.give(60 * std::max(of_several_.max_work, 1e8)); // a minute or more
  }

  SystemStudy run() {
    const auto start = std::chrono::steady_clock::now();
    all_.claims = file_.claims(options_.check);
    all_.system = file_.studied(options_.check);
    for (std::size_t k = 0; k < manifolds_.size(); ++k)
      one(k);
    std::vector<Headline> each;
    for (const CurveStudy& m : all_.manifolds)
      each.push_back(m.headline);
    if (manifolds_.size() > 1) together();
    const std::optional<Headline> common =
        all_.together ? std::optional(headline_of(*all_.together)) : std::nullopt;
    all_.headline = headline(each, common ? &*common : nullptr);
    all_.headline.complete = all_.headline.complete && (manifolds_.size() < 2 || common);
    if (error_ && all_.headline.verdict != Verdict::non_integrable) std::rethrow_exception(error_);
    all_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return std::move(all_);
  }

private:
  void one(std::size_t k) {
    StudyOptions share = options_;
    share.check.decide.budget =
        part_of_the_work(of_several_, 1 / static_cast<double>(manifolds_.size() - k));
    try {
      all_.manifolds.push_back(file_.manifold(k, share));
      studied_.push_back(k);
    } catch (const Contradiction&) {
      throw;
    } catch (const InternalError& error) {
      if (!error_) error_ = std::current_exception();
      CurveStudy& m = all_.manifolds.emplace_back();
      m.first.name = manifolds_[k]->name;
      m.first.reasons = {failure_of("the study of " + m.name(), error.what())};
      m.headline.complete = false;
    }
  }

  void together() {
    try {
      all_.together = file_.together(studied_, options_);
    } catch (const OutOfBudget&) { // each by itself: the headline is not complete
    }
  }

  FileStudy file_;
  const StudyOptions& options_;
  std::vector<const ManifoldSpec*> manifolds_;
  Budget of_several_; ///< shared by them
  std::vector<std::size_t> studied_;
  std::exception_ptr error_;
  SystemStudy all_;
};

} // namespace

SystemStudy study(const Entry& document, const ParameterValues& set, const StudyOptions& options) {
  return WholeStudy(document, set, options).run();
}

std::vector<ParameterValues> rounds(const System& file, const ParameterValues& given) {
  std::vector<ParameterValues> all;
  for (const SystemExpectation& x : file.expectations)
    if (given.empty() && std::find(all.begin(), all.end(), x.where) == all.end())
      all.push_back(x.where);
  if (all.empty()) all.push_back(given);
  return all;
}

std::vector<NamedCertificate> certificates(const System& s, const CurveStudy& m) {
  std::vector<NamedCertificate> all = kov::certificates(s, m.first);
  if (m.higher && m.higher->planes.obstruction) {
    const jets::HigherObstruction& o = *m.higher->planes.obstruction;
    all.push_back({m.name() + "-order-" + std::to_string(o.logarithm.order), o.certificate,
                   o.no_certificate});
  }
  return all;
}

} // namespace kov::study
