#include "verdict/decide.hpp"

#include "exact/error.hpp"
#include "galois/classify.hpp"
#include "galois/solutions.hpp"
#include "kovacic/solve.hpp"
#include "special/recognize.hpp"
#include "verdict/certificate.hpp"

#include <algorithm>

namespace kov {
namespace {

Solution printed(const LiouvillianSolution& s, const std::string& variable) {
  Solution out;
  out.note = s.note;
  if (s.exponential) {
    out.kind = "exponential";
    out.y = s.text;
    const auto& [theta, p] = *s.exponential;
    out.omega = to_string(theta, variable);
    if (degree(p) > 0)
      out.omega = (is_zero(theta) ? "" : out.omega + " + ") +
                  to_string(RationalFunction::from_coprime(derivative(p), p), variable);
  } else {
    out.kind = "minimal-polynomial";
    for (const RationalFunction& c : s.minimal_polynomial)
      out.minimal_polynomial.push_back(to_string(c, variable));
  }
  return out;
}

const char* step_name(int number) {
  switch (number) {
  case 0:
    return "necessary conditions";
  case 1:
    return "step 1, exponent sets";
  case 2:
    return "step 2, families";
  default:
    return "step 3, polynomials";
  }
}

std::vector<TraceStep> printed(const kovacic::Trace& trace) {
  std::vector<TraceStep> steps;
  for (const kovacic::Step& s : trace)
    steps.push_back({s.kovacic_case == 0
                         ? step_name(s.number)
                         : "case " + std::to_string(s.kovacic_case) + ", " + step_name(s.number),
                     s.text});
  return steps;
}

void fill(Decision& d, const Classification& c, const NormalForm& equation,
          const Options& options) {
  d.group = c.group;
  d.component = c.component;
  d.abelian = c.abelian;
  d.reason = c.reason;
  d.undecided = c.undecided;
  if (c.group) d.kovacic_case = kovacic_case(*c.group);
  if (!options.want_solutions) return;
  try {
    for (const LiouvillianSolution& s : solutions(c, equation.r, d.variable, options.budget))
      d.solutions.push_back(printed(s, d.variable));
  } catch (const OutOfBudget& limit) {
    d.reason += "; solutions not printed: " + std::string(limit.what());
  }
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
  d.trace = printed(trace);
  const auto* unable = std::get_if<Unable>(&outcome);
  return {kovacic::case_of(outcome), unable ? unable->detail : ""};
}

void forget_answer(Decision& d, const std::string& why, Unable::Why kind) {
  d.group.reset();
  d.component.reset();
  d.abelian = Truth::unknown;
  d.kovacic_case.reset();
  d.solutions.clear();
  d.certificate.clear();
  d.undecided = Unable{kind, why};
  d.reason = "undecided: " + why;
}

// The group was found after the certificate was written, which says less or does not exist.
void mark_as_uncertified(Decision& d, const Options& options) {
  if (!options.want_certificate) return;
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
  d.reason = "Kovacic's algorithm excludes its cases 1, 2 and 3";
  mark_as_uncertified(d, options);
}

// Still nothing: a classical equation may have a formula that asks for no polynomial at all.
void closed_formula(Decision& d, const Options& options) {
  std::optional<Recognized> known;
  try {
    Budget little = options.budget;
    if (d.places) little.deadline.reset(); // the places are there, and time may be over
    known = recognize(d.r, little, d.places ? &*d.places : nullptr);
  } catch (const OutOfBudget&) { // what stopped the engines is said already
  }
  if (!known || !known->answer || known->answer->abelian == Truth::unknown) return;
  const ClosedAnswer& answer = *known->answer;
  const std::string limit = d.undecided ? d.undecided->detail : "";
  KOV_ENSURE(d.abelian == Truth::unknown || d.abelian == answer.abelian);
  d.abelian = answer.abelian;
  d.reason = "by the formula for " + known->family + "'s equation: " + answer.reason;
  if (!limit.empty()) d.reason += " (no search: " + limit + ")";
  if (!answer.group) return;
  d.group = answer.group;
  d.component = identity_component(*answer.group);
  d.kovacic_case = kovacic_case(*answer.group);
  d.undecided.reset();
  mark_as_uncertified(d, options);
}

void withdraw(Decision& d, const std::string& refusal) {
  const std::string found = d.group ? ", G = " + describe(*d.group) : "";
  forget_answer(d,
                "an answer was found" + found +
                    ", and our own checker refuses its certificate: " + refusal,
                Unable::Why::methods_disagree);
  d.no_certificate = refusal;
}

bool is_withdrawn(const Decision& d) {
  return d.undecided && d.undecided->why == Unable::Why::methods_disagree;
}

void certify_it(Decision& d, const Classification& c, const Options& options) {
  if (!d.group && d.abelian == Truth::unknown) {
    d.no_certificate = "nothing is proved";
    return;
  }
  try {
    Judged j = judged(certificate(c, d.r, options.budget));
    if (j.refusal.empty()) {
      d.certificate = std::move(j.json);
    } else if (j.limit) {
      d.no_certificate = "the judge refuses it: " + j.refusal;
    } else {
      d.refused = std::move(j.json);
      return withdraw(d, j.refusal);
    }
  } catch (const RefusedByChecker& why) {
    return withdraw(d, why.what());
  } catch (const OutOfBudget& limit) {
    d.no_certificate = limit.what();
  }
  if (d.certificate.empty() && !d.undecided)
    d.undecided = Unable{Unable::Why::budget, "no certificate: " + d.no_certificate};
}

// A third opinion: the certificate is written and judged, and not kept.
void ask_the_judge(Decision& d, const Classification& c, const Options& options) {
  Decision judged = d;
  certify_it(judged, c, options);
  if (is_withdrawn(judged)) {
    d = std::move(judged);
    return;
  }
  d.reason += judged.certificate.empty() ? "; no certificate: " + judged.no_certificate
                                         : "; the judge accepts its certificate";
}

} // namespace

void compare(Decision& d, const SecondOpinion& other) {
  if (!other.kovacic_case)
    forget_answer(d, "Kovacic's algorithm stopped: " + other.limit, Unable::Why::budget);
  else if (d.kovacic_case && *d.kovacic_case != *other.kovacic_case)
    forget_answer(d,
                  "the methods disagree: the engines find case " + std::to_string(*d.kovacic_case) +
                      ", Kovacic's algorithm finds case " + std::to_string(*other.kovacic_case),
                  Unable::Why::methods_disagree);
  else
    d.reason += "; Kovacic's algorithm agrees: case " + std::to_string(*other.kovacic_case);
}

namespace {

// Above this degree a formula, where there is one, is better than a search: the polynomial takes
// minutes and gigabytes.
constexpr long comfortable_degree = 20000;

Classification engines(Decision& d, const NormalForm& equation, const Options& options) {
  d = Decision{};
  d.r = equation.r;
  d.variable = options.variable;
  Classification c = classify(equation.r, options.budget);
  d.places = c.local;
  fill(d, c, equation, options);
  return c;
}

} // namespace

Decision decide(const NormalForm& equation, const Options& options) {
  const auto start = Budget::Clock::now();
  Decision d;
  Options quick = options;
  const bool formulas = options.method != Method::engines && !options.want_certificate;
  if (formulas) quick.budget.max_degree = std::min(quick.budget.max_degree, comfortable_degree);
  Classification c = engines(d, equation, quick);
  if (!d.group && quick.budget.max_degree < options.budget.max_degree) {
    if (!is_zero(d.r)) closed_formula(d, options);
    if (!d.group) c = engines(d, equation, options);
  }
  if (options.want_certificate)
    certify_it(d, c, options);
  else if (options.method == Method::all)
    ask_the_judge(d, c, options);
  const bool others = options.method != Method::engines && !is_withdrawn(d);
  if (!d.group && d.abelian != Truth::yes && others) second_chance(d, equation, options);
  if (!d.group && others && !is_zero(d.r)) closed_formula(d, options);
  const bool asked = options.method == Method::kovacic || options.method == Method::all;
  if (!is_withdrawn(d) && (asked || options.want_trace)) {
    const SecondOpinion other = classical(d, equation, options);
    // Only to look at the steps: a limit of the classical algorithm is no news then.
    if (asked || (other.kovacic_case && d.kovacic_case && *other.kovacic_case != *d.kovacic_case))
      compare(d, other);
  }
  if (options.only_case && d.kovacic_case && *options.only_case != *d.kovacic_case)
    d.reason = "case " + std::to_string(*options.only_case) +
               " does not occur, the equation belongs to case " + std::to_string(*d.kovacic_case) +
               ": " + d.reason;
  d.seconds = std::chrono::duration<double>(Budget::Clock::now() - start).count();
  return d;
}

} // namespace kov
