#include "study/study.hpp"

#include "decide/afterwards.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "exact/share.hpp"
#include "integrability/eigenvalue.hpp"
#include "integrability/one_level.hpp"
#include "integrability/parameters.hpp"
#include "study/contradiction.hpp"
#include "study/curve.hpp"
#include "study/together.hpp"
#include "system/assumed_values.hpp"
#include "system/claims.hpp"
#include "system/in_ring.hpp"

#include <algorithm>
#include <chrono>
#include <exception>

namespace kov::study {
namespace {

constexpr double work_for_eigenvalues = 6e8; // some seconds

Step excluded(const Exclusion& e, bool everywhere) {
  Step step{e.by.solution, e.by.rule, Excluded{{e.by.integrals}, everywhere, e}, {},
            e.by.trusted,  {}};
  if (!e.by.unchecked.empty()) step.unchecked = {e.by.unchecked};
  return step;
}

// The steps that the report of the first order proves.
std::vector<Step> steps_of(const CurveStudy& m) {
  std::vector<Step> all;
  const ManifoldReport& r = m.first;
  const bool everywhere = r.verdict == Verdict::non_integrable;
  for (const Exclusion& e : m.exclusions)
    all.push_back(excluded(e, everywhere));
  if (r.verdict != Verdict::no_obstruction && r.verdict != Verdict::depends) return all;
  Step passes{r.name, Rule::first_order, Passes{r.verdict == Verdict::depends}};
  passes.trusted = trusted_steps(r);
  if (std::string open = not_checked(r); !open.empty()) passes.unchecked = {std::move(open)};
  all.push_back(std::move(passes));
  return all;
}

// All that exclude, of one curve or (no name) of all, together.
Step cover(const ProofTree& t, const std::string& curve, const SystemClassification& c) {
  Step step{curve, Rule::cover, Excluded{c.excluded, c.status() == Verdict::non_integrable}};
  for (StepId id = 0; id < t.steps.size(); ++id)
    if (std::holds_alternative<Excluded>(t.steps[id].says) && t.steps[id].rule != Rule::cover &&
        (curve.empty() || t.steps[id].curve == curve))
      step.premises.push_back(id);
  return step;
}

/// One manifold, asked: the steps that it adds to the tree.
class Curve {
public:
  Curve(const System& s, const ManifoldSpec& spec, const StudyOptions& options, ProofTree& tree)
      : s_(s), spec_(spec), options_(options), tree_(tree) {}

  void take(ManifoldReport first) {
    study.first = std::move(first);
    tree_.curves.push_back(spec_.name);
    if (study.first.failure) {
      tree_.refused.push_back(spec_.name);
      return;
    }
    study.exclusions = exclusions_of_verdict(s_, study.first, free_levels(s_));
    std::ranges::move(steps_of(study), std::back_inserter(tree_.steps));
  }

  void ask_higher_orders() {
    if (options_.order < 2 || !study.first.manifold || is_excluded()) return;
    attempt("the higher orders", [&] {
      study.higher = higher_orders(s_, spec_, options_.order, options_.check.decide);
      if (!study.higher->excluded) return;
      const Exclusion& e = *study.higher->excluded;
      study.exclusions.push_back(e);
      tree_.steps.push_back(excluded(e, study.higher->exceptions.empty()));
    });
  }

  // Several exclusions, each on its set, may leave nothing.
  void put_together() {
    if (study.exclusions.size() < 2 || is_excluded()) return;
    attempt("what its exclusions say together", [&] {
      auto c = kov::together(s_, study.exclusions, options_.check.decide.budget.stop);
      if (c.status() != Verdict::non_integrable) return;
      tree_.steps.push_back(cover(tree_, spec_.name, c));
      study.together = std::move(c);
    });
  }

  // The claims of the file are proved by other code than that which excludes.
  void look_for_contradictions(const std::vector<ClaimReport>& claims) {
    if (study.exclusions.empty() || claims.empty()) return;
    attempt("the look for contradictions", [&] {
      ProofTree mine{{}, {}, {}, {}};
      for (const Exclusion& e : study.exclusions)
        mine.steps.push_back(excluded(e, false));
      if (auto known = known_integrals(s_, claims))
        mine.steps.push_back({"", Rule::known_integrals, *std::move(known)});
      refuse_contradictions(s_, mine);
    });
  }

  void finish() {
    if (options_.check.decide.budget.is_cut_short()) tree_.cut_short.push_back(spec_.name);
    study.headline = headline(tree_, spec_.name);
  }

  /// A limit or an error of the program behind the verdict costs this part only.
  void attempt(const char* part, const std::function<void()>& work) {
    const std::string missing = failure_or_limit_of(part, work);
    if (missing.empty()) return;
    study.failed.push_back(missing);
    tree_.cut_short.push_back(spec_.name);
  }

  CurveStudy study;

private:
  [[nodiscard]] bool is_excluded() const {
    return headline(tree_, spec_.name).verdict == Verdict::non_integrable;
  }

  const System& s_;
  const ManifoldSpec& spec_;
  const StudyOptions& options_;
  ProofTree& tree_;
};

} // namespace

std::vector<const ManifoldSpec*> manifolds_to_check(const System& s, const CheckOptions& options) {
  const std::string& only = options.only_manifold;
  std::vector<const ManifoldSpec*> all;
  for (const auto& spec : s.manifolds)
    if (only.empty() || only == spec.name) all.push_back(&spec);
  const std::string names = joined(s.manifolds, &ManifoldSpec::name);
  if (!only.empty() && all.empty())
    throw InvalidArgument("there is no manifold '" + only +
                          "'; manifolds: " + (names.empty() ? "none" : names));
  return all;
}

FileStudy::FileStudy(const Entry& document, ParameterValues set,
                     const std::optional<ManifoldSpec>& along)
    : document_(document), set_(std::move(set)),
      system_(with_known_casimirs(read_system_as_assumed(document, set_))) {
  if (along) system_.manifolds = {in_names_of(system_, *along)};
  require_consistent(system_);
}

FileStudy::FileStudy(System s) : system_(std::move(s)), studied_(system_) {}

const System& FileStudy::studied(const CheckOptions& options) {
  if (studied_) return *studied_;
  CheckOptions search = options;
  const double parts = 1 + static_cast<double>(system_.manifolds.size()); // the others study them
  search.decide.budget =
      at_most(part_of_the_work(options.decide.budget, 1 / parts), work_for_eigenvalues);
  studied_ = with_eigenvalues(system_, search);
  return *studied_;
}

void FileStudy::missing(const std::string& curve) {
  if (!curve.empty() && !is_among(curve, tree_.curves)) tree_.curves.push_back(curve);
  tree_.cut_short.push_back(curve);
}

const std::vector<ClaimReport>& FileStudy::claims(const CheckOptions& options) {
  if (!claims_) claims_ = decide_claims(system_, options.decide.budget);
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
  Curve curve(s, spec, options, tree_);
  const auto known = with_claims ? claims_of(s, claims(options.check)) : std::vector<ClaimReport>{};
  ManifoldReport first = study_curve(s, spec, known, options.check);
  if (first.failure && is_fine_without_values(spec.name, options.check.decide.budget)) {
    first.missing = {{Missing::What::no_curve, first.failure->message}};
    first.failure.reset();
  }
  curve.take(std::move(first));
  curve.ask_higher_orders();
  curve.put_together();
  curve.look_for_contradictions(known);
  curve.finish();
  return manifolds_.emplace(spec.name, std::move(curve.study)).first->second;
}

SystemClassification FileStudy::together(const std::vector<std::size_t>& of,
                                         const StudyOptions& options, bool with_claims) {
  std::vector<Exclusion> all;
  for (const std::size_t k : of) {
    const auto& one = manifold(k, options, with_claims).exclusions;
    all.insert(all.end(), one.begin(), one.end());
  }
  auto c = kov::together(studied(options.check), all, options.check.decide.budget.stop);
  if (!c.excluded.empty()) tree_.steps.push_back(cover(tree_, "", c));
  return c;
}

namespace {

/// All manifolds of one file, one after the other.
class WholeStudy {
public:
  WholeStudy(const Entry& document, const ParameterValues& set, const StudyOptions& options)
      : file_(document, set, options.along), options_(options),
        manifolds_(manifolds_to_check(file_.system(), options.check)),
        of_several_(options.check.decide.budget) {
    if (manifolds_.size() > 1 && !of_several_.work_end)
      of_several_.give(60 * std::max(of_several_.max_work, 1e8)); // a minute or more
  }

  SystemStudy run() {
    const auto start = std::chrono::steady_clock::now();
    all_.claims = file_.claims(options_.check);
    std::erase_if(all_.claims, [](const ClaimReport& c) { return c.claim.line == 0; });
    all_.system = file_.studied(options_.check);
    for (std::size_t k = 0; k < manifolds_.size(); ++k)
      one(k);
    if (manifolds_.size() > 1) together();
    all_.tree = file_.tree();
    all_.headline = headline(all_.tree);
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
      const std::string failed = failure_of("the study of " + m.name(), error.what());
      m.first.missing = {{Missing::What::program_error, failed}};
      m.headline.complete = false;
      file_.missing(m.name());
    }
  }

  void together() {
    try {
      all_.together = file_.together(studied_, options_);
    } catch (const OutOfBudget&) { // each by itself
      file_.missing("");
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
    if (given.empty() && !is_among(x.where, all)) all.push_back(x.where);
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

const std::vector<NamedCertificate>& Evidence::certificates() const {
  if (!written_) written_ = study::certificates(system_, curve_);
  return *written_;
}

} // namespace kov::study
