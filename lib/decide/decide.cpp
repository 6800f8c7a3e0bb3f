#include "decide/decide.hpp"

#include "closed/whittaker_pull_back.hpp"
#include "decide/afterwards.hpp"
#include "decide/certificate.hpp"
#include "decide/words.hpp"
#include "exact/error.hpp"
#include "exact/tried.hpp"
#include "kovacic/solve.hpp"

#include <algorithm>

namespace kov {
namespace {

void fill(Decision& d, const std::shared_ptr<const Classification>& c) {
  d.group = c->group;
  d.component = c->component;
  d.abelian = c->abelian;
  d.because = ByEngines{c};
  d.undecided = c->undecided;
  if (c->group) d.kovacic_case = kovacic_case(*c->group);
}

// All or none: a limit or an error here is no news about the group.
void add_solutions(Decision& d, const Classification& c, const Options& options) {
  if (!options.want_solutions) {
    d.no_solutions = SolutionsMissing{};
    return;
  }
  std::string missing;
  try {
    missing = failure_of("the solutions", [&] { d.solutions = solutions(c, d.r, options.budget); });
  } catch (const OutOfBudget& limit) {
    missing = limit.what();
  }
  if (missing.empty()) return;
  d.solutions.clear();
  d.no_solutions = SolutionsMissing{SolutionsMissing::Why::limit, missing};
}

// The classical algorithm, for its steps, as a second opinion, or as the only one.
SecondOpinion classical(Decision& d, const NormalForm& equation, const Options& options) {
  kovacic::Trace trace;
  kovacic::Outcome outcome = Unable{Unable::Why::budget, ""};
  try {
    outcome = kovacic::solve(equation, options.budget, options.want_trace ? &trace : nullptr);
  } catch (const OutOfBudget& e) {
    outcome = Unable{Unable::Why::budget, e.what()};
  }
  d.trace = trace;
  const auto* unable = std::get_if<Unable>(&outcome);
  return {kovacic::case_of(outcome), unable ? unable->detail : ""};
}

void forget_answer(Decision& d, Withdrawn why) {
  d.group.reset();
  d.component.reset();
  d.abelian = Truth::unknown;
  d.kovacic_case.reset();
  d.solutions.clear();
  d.certificate.clear();
  d.undecided = Unable{Unable::Why::methods_disagree, to_string(why)};
  d.withdrawn = std::move(why);
}

// The group was found by other means than those that certificates are written from.
void mark_as_uncertified(Decision& d, const Options& options, const std::string& source) {
  if (!options.want_certificate) return;
  if (d.certificate.empty())
    d.no_certificate = "the group is known " + source +
                       ", for which the format has no rule; the engines that proofs are written "
                       "from stopped: " +
                       d.no_certificate;
  const std::string why = d.certificate.empty()
                              ? "no certificate: " + d.no_certificate
                              : "the certificate is about the identity component only";
  d.undecided = Unable{Unable::Why::budget, why};
}

// Exponents too large for the engines: that no sum of exponents is a natural number can be seen
// without a polynomial of that degree.
void second_chance(Decision& d, const NormalForm& equation, const Options& options) {
  Decision other;
  if (classical(other, equation, options).kovacic_case != 4) return;
  d.group = GaloisGroup{GroupType::SL2, {}};
  d.component = Connected::sl2;
  d.abelian = Truth::no;
  d.kovacic_case = 4;
  d.undecided.reset();
  d.because = ByKovacic{};
  mark_as_uncertified(d, options, "from Kovacic's algorithm");
}

// Still nothing: a classical equation may have a formula that asks for no polynomial at all.
void closed_formula(Decision& d, const Options& options) {
  std::optional<Recognized> known;
  tried<OutOfBudget>([&] { // what stopped the engines is said already
    Budget little = options.budget;
    if (d.places) { // then little is left to do, and the limits may be reached
      little.work_end.reset();
      little.deadline.reset();
    }
    known = recognize(d.r, little, d.places ? &*d.places : nullptr);
    if (d.places && (!known || !known->answer || !known->answer->group))
      if (auto behind = recognize_pull_back(*d.places, d.variable, little);
          behind && behind->answer)
        known = std::move(behind);
  });
  if (!known || !known->answer || known->answer->abelian == Truth::unknown) return;
  const ClosedAnswer& answer = *known->answer;
  if (d.abelian != Truth::unknown && d.abelian != answer.abelian)
    throw Contradiction(std::string("the engines and the formula for ") + to_string(known->family) +
                        "'s equation contradict each other");
  d.abelian = answer.abelian;
  d.because = ByFormula{*known, d.undecided};
  if (!answer.group) return;
  d.group = answer.group;
  d.component = identity_component(*answer.group);
  d.kovacic_case = kovacic_case(*answer.group);
  d.undecided.reset();
  mark_as_uncertified(
      d, options, std::string("from the formula for ") + to_string(known->family) + "'s equation");
}

// Returns what failed, as failure_of does.
std::string certify_it(Decision& d, const Classification& c, const Options& options) {
  if (!d.group && d.abelian == Truth::unknown) {
    d.no_certificate = d.undecided ? d.undecided->detail : "nothing is proved";
    return {};
  }
  std::string failed;
  try {
    Judged opinion;
    failed = failure_of("the certificate",
                        [&] { opinion = judged(certificate(c, d.r, options.budget)); });
    if (failed.empty()) take(d, std::move(opinion));
    d.no_certificate += failed;
  } catch (const RefusedByChecker& why) {
    take(d, Judged{"", why.what(), false});
  } catch (const OutOfBudget& limit) {
    d.no_certificate = limit.what();
  }
  if (d.certificate.empty() && !d.undecided)
    d.undecided = Unable{Unable::Why::budget, "no certificate: " + d.no_certificate};
  return failed;
}

// A third opinion: the certificate is written and judged, and not kept.
void ask_the_judge(Decision& d, const Classification& c, const Options& options) {
  if (!d.proof()) return; // by a formula: there is nothing to judge
  Decision judged = d;
  const std::string failed = certify_it(judged, c, options);
  if (judged.withdrawn) {
    d = std::move(judged);
    return;
  }
  d.checked = judged.checked;
  if (options.method == Method::all || !failed.empty())
    d.third_opinion = ThirdOpinion{!judged.certificate.empty(), judged.no_certificate};
}

} // namespace

void take(Decision& d, Judged opinion) {
  if (opinion.refusal.empty()) {
    d.certificate = std::move(opinion.json);
    d.checked = true;
    return;
  }
  d.no_certificate = "the judge refuses it: " + opinion.refusal;
  if (opinion.limit) return;
  forget_answer(d, CertificateRefused{d.group, opinion.refusal});
  d.no_certificate = opinion.refusal;
  d.refused = std::move(opinion.json);
}

void compare(Decision& d, const SecondOpinion& other) {
  if (!other.kovacic_case)
    d.undecided = Unable{Unable::Why::budget, "Kovacic's algorithm stopped: " + other.limit};
  else if (d.kovacic_case && *d.kovacic_case != *other.kovacic_case)
    forget_answer(d, MethodsDisagree{*d.kovacic_case, *other.kovacic_case});
  else
    d.second_opinion = other.kovacic_case;
}

namespace {

// Above this degree a formula, where there is one, is better than a search: the polynomial takes
// minutes and gigabytes.
constexpr long comfortable_degree = 1500;

using Proof = std::shared_ptr<const Classification>;

Proof engines(Decision& d, const NormalForm& equation, const Options& options) {
  d = Decision{};
  d.r = equation.r;
  d.variable = options.variable;
  const auto c = std::make_shared<const Classification>(classify(equation.r, options.budget));
  d.places = c->local;
  fill(d, c);
  return c;
}

bool asked_to_compare(const Options& options) {
  return options.method == Method::kovacic || options.method == Method::all;
}

// Tells the caller what is proved so far; what was asked for beside it is still open.
void announce(const Decision& d, const Options& options) {
  if (!options.proved || (!d.group && d.abelian == Truth::unknown)) return;
  if (!asked_to_compare(options)) return options.proved(d);
  Decision so_far = d;
  so_far.undecided = Unable{Unable::Why::budget, "Kovacic's algorithm did not come to its end"};
  options.proved(so_far);
}

// More about the group.  Where nothing is proved yet an error is the answer; else it is told beside it.
void behind(Decision& d, const std::function<void()>& search) {
  if (!d.group && d.abelian == Truth::unknown) return search();
  const std::string failed = failure_of("the search for the group", search);
  if (failed.empty() || d.group) return;
  if (d.undecided)
    d.undecided->detail += "; " + failed;
  else
    d.undecided = Unable{Unable::Why::budget, failed};
}

// The engines; where they would need a polynomial of an uncomfortable degree, formulas first.
Proof prove(Decision& d, const NormalForm& equation, const Options& options) {
  Options quick = options;
  const bool formulas = options.method != Method::engines && !options.want_certificate;
  if (formulas) quick.budget.max_degree = std::min(quick.budget.max_degree, comfortable_degree);
  Proof c = engines(d, equation, quick);
  if (d.group || quick.budget.max_degree == options.budget.max_degree) return c;
  behind(d, [&] {
    if (!is_zero(d.r)) closed_formula(d, options);
  });
  if (d.group) return c;
  behind(d, [&] {
    Decision whole;
    c = engines(whole, equation, options);
    d = std::move(whole);
  });
  return c;
}

// The judge's opinion and what is known without the engines.
void support(Decision& d, const Classification& c, const NormalForm& equation,
             const Options& options) {
  if (options.want_certificate)
    (void)certify_it(d, c, options);
  else if (options.ask_the_judge || options.method == Method::all)
    ask_the_judge(d, c, options);
  if (d.withdrawn) return;
  behind(d, [&] {
    if (!d.group && d.abelian != Truth::yes && options.method != Method::engines)
      second_chance(d, equation, options);
    if (!d.group && options.method != Method::engines && !is_zero(d.r)) closed_formula(d, options);
  });
}

// Only to look at the steps: a limit of the classical algorithm is no news then.
void compare_methods(Decision& d, const NormalForm& equation, const Options& options) {
  if ((!asked_to_compare(options) && !options.want_trace) || d.withdrawn) return;
  SecondOpinion other;
  const std::string failed =
      failure_of("Kovacic's algorithm", [&] { other = classical(d, equation, options); });
  if (!failed.empty()) {
    other = {{}, failed};
    d.trace.push_back({0, whole_algorithm, failed});
  }
  if (asked_to_compare(options) ||
      (other.kovacic_case && d.kovacic_case && *other.kovacic_case != *d.kovacic_case))
    compare(d, other);
}

} // namespace

Decision decide(const NormalForm& equation, const Options& options) {
  const auto start = Budget::Clock::now();
  Decision d;
  const Proof c = prove(d, equation, options);
  announce(d, options);
  const bool was_known = d.group.has_value();
  support(d, *c, equation, options);
  if (!was_known || !d.certificate.empty()) announce(d, options);
  compare_methods(d, equation, options);
  d.only_case = options.only_case;
  if (!d.withdrawn) add_solutions(d, *c, options);
  d.seconds = std::chrono::duration<double>(Budget::Clock::now() - start).count();
  return d;
}

} // namespace kov
