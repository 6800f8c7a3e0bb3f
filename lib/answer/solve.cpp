#include "answer/solve.hpp"

#include "answer/by_basis.hpp"
#include "answer/notation.hpp"
#include "decide/afterwards.hpp"
#include "decide/certificate.hpp"
#include "elementary/homogeneous.hpp"
#include "elementary/read.hpp"
#include "exact/joined.hpp"
#include "exact/tried.hpp"
#include "galois/exponential_form.hpp"
#include "linode/centre.hpp"
#include "strata/domain.hpp"
#include "strata/formula_certificate.hpp"

#include <algorithm>

namespace kov::answer {
namespace {

RationalFunction gauge_of(const RationalFunction& p) {
  return p * RationalFunction(Rational(-1, 2));
}

// An equation that only a formula decides: the rule for classical equations proves the identity component.
void certify_formula(Decision& d, const Budget& budget) {
  if (!d.certificate.empty() || !d.places || !std::holds_alternative<ByFormula>(d.because)) return;
  std::optional<Judged> opinion;
  const bool in_time = tried<OutOfBudget>([&] { // else it is said already that there is none
    const std::string failed =
        failure_of("the certificate", [&] { opinion = strata::formula_certificate(d, budget); });
    if (!failed.empty()) d.no_certificate += "; " + failed;
  });
  if (!in_time || !opinion) return;
  const bool accepted = opinion->refusal.empty();
  take(d, *std::move(opinion));
  if (!accepted) return;
  d.no_certificate.clear();
  d.undecided = Unable{Unable::Why::budget, "the certificate is about the identity component only"};
}

} // namespace

Decidable in_its_variable(const GivenEquation& e) {
  return {e.normal_form, e.variable, gauge_of(e.p)};
}

Decidable in_small_numbers(const GivenEquation& e) {
  const auto there = centred(e.normal_form);
  if (!there) return in_its_variable(e);
  return {there->equation, centred_variable(e.variable, there->centre),
          gauge_of(there->equation.p)};
}

Decision decided(const Decidable& equation, Options options) {
  options.variable = equation.variable;
  Decision d = decide(equation.form, options);
  if (options.want_certificate) certify_formula(d, options.budget);
  return d;
}

GaugeFactor factor_of(const GivenEquation& e, const Budget& budget) {
  using Kind = GaugeFactor::Kind;
  if (is_zero(e.p)) return {"1", Kind::rational};
  try {
    const LogarithmicParts parts = logarithmic_parts(gauge_of(e.p), budget);
    const auto order = radical_order(parts);
    return {exponential_text(Poly(1), parts, e.variable), !order ? Kind::transcendental
                                                          : *order == Integer(1) ? Kind::rational
                                                                                 : Kind::algebraic};
  } catch (const OutOfBudget&) { // the integral is an answer, too
    return {"exp(-1/2*int(" + to_string(e.p, e.variable) + "))", Kind::unknown};
  }
}

// ----- the whole equation

elementary::WholeAnswer whole_of(const AskedEquation& asked, const std::vector<Expression>& shown) {
  using elementary::NotElementary;
  const elementary::WholeEquation& e = *asked.whole;
  // what is shown, where that is elementary; else the second solution with an integral
  const auto known = [&](const elementary::LettersPtr& letters) {
    return tried<NotElementary, DomainError>([&]() -> std::optional<elementary::Basis> {
      if (shown.size() != 2) return std::nullopt;
      const auto first = elementary::element(shown[0], letters);
      const auto second = tried<NotElementary>(
          [&] { return std::optional(elementary::element(shown[1], letters)); });
      if (second) return elementary::Basis{first, *second};
      const auto linear = e.riccati
                              ? linear_equation(e.riccati->linear, e.riccati->unknown, letters)
                              : linear_equation(e.ode, e.unknown, letters);
      return elementary::Basis{first, second_solution(linear, first)};
    });
  };
  elementary::WholeAnswer all = whole_answer(e, known);
  if (!all.general && shown.size() == 2 && !e.bernoulli) answer_by_basis(all, e, shown);
  const ReadBackEquation equation{e.ode, e.unknown, e.variable, {}, {}};
  const auto is_wrong = [&](const std::string& y) {
    if (read_back(for_programs(parse_expression(y, "a solution")), equation) != ReadBack::differs)
      return false;
    all.failed.push_back("the formula " + y +
                         " was found, and does not solve the given equation: it is left out");
    return true;
  };
  for (auto* y : {&all.particular, &all.general, &all.with_values})
    if (*y && is_wrong(**y)) y->reset();
  std::erase_if(all.special, is_wrong);
  return all;
}

// ----- a classical equation

void ensure_agreement(const ClosedAnswer& closed, const Decision& d) {
  const bool agree = (closed.abelian == Truth::unknown || d.abelian == Truth::unknown ||
                      closed.abelian == d.abelian) &&
                     (!closed.group || !d.group || describe(*closed.group) == describe(*d.group)) &&
                     (!closed.component || !d.component || *closed.component == *d.component);
  if (!agree)
    throw Contradiction("the answer and the formula for the classical equation contradict each "
                        "other");
}

DecidedTwice decided_twice(ClosedAnswer closed, const RationalFunction& r, const Options& options) {
  DecidedTwice both{std::move(closed), decide({.r = r, .p = RationalFunction()}, options)};
  ensure_agreement(both.closed, both.decision);
  return both;
}

Truth DecidedTwice::abelian() const {
  return decision.abelian != Truth::unknown ? decision.abelian : closed.abelian;
}

std::optional<GaloisGroup> DecidedTwice::group() const {
  return decision.group ? decision.group : closed.group;
}

// ----- all values of the parameters

std::string in_words(const EquationPart& part) {
  return joined(part.where, [](const auto& condition) { return condition.first; });
}

std::vector<strata::Stratum> Family::strata() const {
  std::vector<strata::Stratum> all;
  for (const FamilyPart& p : parts)
    if (p.answer)
      std::ranges::move(strata::on_domain(*p.answer).told_apart(), std::back_inserter(all));
  return all;
}

bool Family::is_complete() const {
  return whole && std::ranges::all_of(parts, [](const FamilyPart& p) {
           return p.answer ? p.answer->unvisited.empty() && !p.answer->contradictory
                           : !p.part.none.empty();
         });
}

const std::string& Family::refusal() const {
  static const std::string none;
  const auto refused = std::ranges::find_if(
      parts, [](const FamilyPart& p) { return p.answer && !p.answer->refusal.empty(); });
  return refused == parts.end() ? none : refused->answer->refusal;
}

namespace {

// A value that all strata share.
template <class T, class Of> T shared(const Family& f, const T& otherwise, const Of& of) {
  const auto all = f.strata();
  if (!f.is_complete() || all.empty()) return otherwise;
  const T first = of(all.front().leaf);
  const bool same =
      std::ranges::all_of(all, [&](const strata::Stratum& s) { return of(s.leaf) == first; });
  return same ? first : otherwise;
}

// The classical equation, where its formula holds for all values and the strata contradict nothing.
const strata::GenericForm* formula(const Family& f) {
  const bool holds = f.known && f.known->generic.empty() && f.whole && f.parts.size() == 1 &&
                     f.refusal().empty() &&
                     !(f.parts.front().answer && f.parts.front().answer->contradictory);
  return holds ? &*f.known : nullptr;
}

} // namespace

Truth Family::abelian() const {
  const Truth all =
      shared(*this, Truth::unknown, [](const strata::Leaf& leaf) { return leaf.abelian; });
  const strata::GenericForm* classical = formula(*this);
  return all == Truth::unknown && classical != nullptr ? classical->abelian() : all;
}

std::optional<GaloisGroup> Family::group() const {
  auto all = shared(*this, std::optional<GaloisGroup>(),
                    [](const strata::Leaf& leaf) { return leaf.group; });
  if (const strata::GenericForm* classical = formula(*this); !all && classical != nullptr)
    if (const auto& parts = classical->answer.parts; parts.size() == 1) all = parts.front().group;
  return all;
}

Family decide_family(const EquationText& text, strata::StrataLimits limits,
                     const std::optional<Style>& solutions,
                     const std::function<void(const Family&)>& told) {
  limits.decide.ask_the_judge = limits.decide.want_group = true;
  const std::vector<EquationPart> parts = read_parts(text);
  Family all;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    FamilyPart here{parts[i], given_equation(text)};
    if (i > 0 && text.change) {
      here.given->ode = text.change->elsewhere;
      here.given->change = std::nullopt;
    }
    all.whole = i + 1 == parts.size();
    if (const auto& equation = parts[i].equation) {
      limits.decide.variable = equation->variable;
      if (i == 0)
        (void)tried<OutOfBudget>([&] { // the strata are the answer
          here.failed = failure_of("the search for a classical family", [&] {
            const strata::Question& q = equation->question;
            all.known = strata::generic_form(q.r, q.z, ParametrisedSet(q.r.ring(), q.assumptions),
                                             limits.decide.budget);
          });
        });
      here.answer = strata::decide_strata(equation->question, limits);
    }
    if (i == 0 && here.answer && here.answer->unvisited.empty() &&
        strata::on_domain(*here.answer).strata.empty())
      all.known.reset(); // there is no equation
    const bool only = all.whole && all.parts.empty();
    if (here.answer && here.answer->contradictory && !only) { // no values here
      if (i == 0) all.first_is_left_out = true;
      continue;
    }
    all.parts.push_back(std::move(here));
    FamilyPart& part = all.parts.back();
    if (!part.answer) continue;
    if (!all.refusal().empty()) return all;
    if (told) told(all);
    if (!solutions) continue;
    std::string failed = failure_of("the solutions", [&] {
      part.solutions = solutions_of(*part.given, *parts[i].equation, *part.answer, *solutions,
                                    limits.decide.budget);
    });
    if (!failed.empty()) part.failed = std::move(failed);
  }
  return all;
}

} // namespace kov::answer
