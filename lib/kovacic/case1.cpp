#include "kovacic/case1.hpp"

#include "exact/error.hpp"
#include "kovacic/exponents.hpp"
#include "kovacic/invariant_families.hpp"
#include "kovacic/necessary.hpp"
#include "kovacic/residue_field.hpp"
#include "linode/degree_bounds.hpp"

namespace kov::kovacic {
namespace {

const RationalFunction half(Rational(1, 2));

bool solves_riccati(const RationalFunction& omega, const RationalFunction& r) {
  return is_zero(derivative(omega) + omega * omega - r);
}

Exponential verified(Exponential y, const RationalFunction& r) {
  KOV_ENSURE(solves_riccati(y.omega, r));
  return y;
}

// v''' = 4 r v' + 2 r' v, and w^2 is constant
ExponentialPair verified(ExponentialPair pair, const RationalFunction& r) {
  const RationalFunction dv = derivative(pair.v);
  const RationalFunction d3v = derivative(derivative(dv));
  KOV_ENSURE(d3v == RationalFunction(4) * r * dv + RationalFunction(2) * derivative(r) * pair.v);
  KOV_ENSURE(wronskian_squared(pair.v, r) == pair.w_squared && !is_zero(pair.w_squared));
  return pair;
}

// ----- (b) v = y1 y2 rational -------------------------------------------------------------------

// The space of rational v has dimension 0, 1 or 3; 3 belongs to the groups {1} and {+-1}.
std::optional<Outcome> from_second_power(const Singularities& s, const Budget& budget,
                                         Trace* trace) {
  const auto found =
      rational_products(s, 2, 1, "both lines at once, v = y1 y2 rational", budget, trace);
  if (found.empty()) return std::nullopt;
  KOV_ENSURE(found.size() == 1 || found.size() == 3);
  const RationalFunction v = rational_value(s, found.front());
  const NfElem w_squared = wronskian_squared(v, s.r);
  if (is_zero(w_squared)) { // v = y^2
    KOV_ENSURE(found.size() == 1);
    const RationalFunction omega = derivative(v) / v * half;
    note(trace, 1, 3,
         "v = " + to_string(v) + " is the square of a solution: y'/y = " + to_string(omega) +
             ", the only exponential line.");
    return verified(Exponential{omega}, s.r);
  }
  KOV_ENSURE(found.size() == 1);
  note(trace, 1, 3,
       "v = " + to_string(v) + ", w^2 = " + to_string(w_squared) +
           ": y'/y = (v' +- w)/(2v) are the two exponential lines.");
  return verified(ExponentialPair{v, w_squared, false}, s.r);
}

// ----- (a), (c) families for y itself -----------------------------------------------------------

// The principal part at one place of the omega that a local form prescribes.
RationalFunction principal_part(const Singularity& place, const LocalForm& form) {
  if (place.at_infinity) { // the polynomial part [sqrt r]_infinity
    std::vector<NfElem> c;
    for (auto i = place.sqrt_tail.rbegin(); i != place.sqrt_tail.rend(); ++i)
      c.push_back((form.root * *i).coeff(0));
    return RationalFunction(Poly::from_coefficients(c));
  }
  const Poly& q = place.place;
  RationalFunction part = sum_over_roots(form.exponent, q, 1);
  for (std::size_t i = 0; i < place.sqrt_tail.size(); ++i)
    part +=
        sum_over_roots(form.root * place.sqrt_tail[i] % q, q, place.nu() - static_cast<long>(i));
  return part;
}

// What a local form adds to d.
NfElem contribution(const Singularity& place, const LocalForm& form) {
  return place.at_infinity ? form.exponent.coeff(0) : -trace(form.exponent, place.place);
}

struct LocalChoices {
  std::vector<std::vector<RationalFunction>> parts;
  std::vector<std::vector<NfElem>> contributions;
};

// Step 1.  Nothing when a place leaves no choice over its residue field.
std::optional<LocalChoices> local_choices(const Singularities& s, const Budget& budget,
                                          Trace* trace) {
  LocalChoices all;
  bool possible = true;
  for_each_place(s, [&](const Singularity& place) {
    if (!possible) return;
    auto& parts = all.parts.emplace_back();
    auto& sums = all.contributions.emplace_back();
    std::string text;
    for (const LocalForm& form : local_forms(place, budget)) {
      parts.push_back(principal_part(place, form));
      sums.push_back(contribution(place, form));
      text += (text.empty() ? "" : " or ") + to_string(form.exponent, "c");
    }
    if (trace != nullptr)
      note(trace, 1, 1,
           "At " + place_name(place) + ": " +
               (text.empty()
                    ? "the exponents are not in the residue field, so that a single "
                      "exponential line, which is defined over the field of r, is excluded."
                    : (place.at_infinity ? "growth exponent " : "exponent ") + text + "."));
    possible = !parts.empty();
  });
  return possible ? std::optional(std::move(all)) : std::nullopt;
}

// Steps 2 and 3.
std::optional<Outcome> from_families(const Singularities& s, const Budget& budget, Trace* trace) {
  const auto local = local_choices(s, budget, trace);
  if (!local) return std::nullopt;
  const Families families = admissible_families(local->contributions, budget);
  note(trace, 1, 2,
       std::to_string(families.admissible.size()) + " of " + to_string(families.total) +
           " families (up to integers) give a natural number d.");
  if (families.admissible.empty()) return std::nullopt;
  PolynomialStep step(1, common_denominator(s), s.r);
  std::vector<std::vector<Poly>> numerators; // S times each principal part
  for (const auto& parts : local->parts) {
    auto& place = numerators.emplace_back();
    for (const RationalFunction& part : parts)
      place.push_back(step.times_S(part));
  }
  for (const Family& family : families.admissible) {
    budget.check();
    Poly H(0);
    for (std::size_t i = 0; i < numerators.size(); ++i)
      H += numerators[i][family.choice[i]];
    const auto P = step.solutions(H, family.degree, budget);
    const RationalFunction theta(H, step.S());
    if (trace != nullptr)
      note(trace, 1, 3,
           "theta = " + to_string(theta) + ", degree of P at most " +
               std::to_string(family.degree) +
               (P.empty() ? ": no polynomial." : ": P = " + to_string(P.front()) + "."));
    if (P.empty()) continue;
    const RationalFunction omega = theta + RationalFunction(derivative(P[0]), P[0]);
    if (P.size() == 1) return verified(Exponential{omega}, s.r);
    // two solutions in one family: v = y1 y2 is rational, every solution is exponential
    const RationalFunction other = theta + RationalFunction(derivative(P[1]), P[1]);
    KOV_ENSURE(solves_riccati(omega, s.r) && solves_riccati(other, s.r));
    const RationalFunction v = RationalFunction(1) / (omega - other);
    return verified(ExponentialPair{v, wronskian_squared(v, s.r), true}, s.r);
  }
  return std::nullopt;
}

// All solutions are exponential only if every local monodromy is +-1.
bool may_be_scalar(const Singularities& s) {
  return !any_place(s, [](const Singularity& place) {
    return certainly(place.log) || !has_denominator_dividing(place, 1);
  });
}

} // namespace

NfElem wronskian_squared(const RationalFunction& v, const RationalFunction& r) {
  const RationalFunction dv = derivative(v);
  const RationalFunction w2 =
      dv * dv - RationalFunction(2) * v * derivative(dv) + RationalFunction(4) * r * v * v;
  KOV_ENSURE(degree(w2.num()) < 1 && degree(w2.den()) == 0);
  return w2.num().coeff(0);
}

std::optional<Outcome> case1(const Singularities& s, const Budget& budget, Trace* trace) {
  if (may_be_scalar(s)) {
    // one family; it finds one line, or all of them
    note(trace, 1, 0,
         "All exponent differences are integers, and no logarithm is known: there is "
         "one family up to integers.");
    return from_families(s, budget, trace);
  }
  if (auto lines = from_second_power(s, budget, trace)) return lines;
  return from_families(s, budget, trace);
}

} // namespace kov::kovacic
