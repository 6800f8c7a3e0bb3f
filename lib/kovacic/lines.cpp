#include "kovacic/lines.hpp"

#include "exact/error.hpp"
#include "kovacic/exponents.hpp"
#include "kovacic/families.hpp"
#include "kovacic/family_log.hpp"
#include "kovacic/invariant_families.hpp"
#include "kovacic/necessary.hpp"
#include "kovacic/plug_back.hpp"
#include "kovacic/residue_field.hpp"
#include "linode/degree_bounds.hpp"

#include <algorithm>

namespace kov::kovacic {
namespace {

// ----- step 1: local forms ----------------------------------------------------------------------

// The principal part at one place of the omega that a local form prescribes.
RationalFunction principal_part(const Singularity& place, const LocalForm& form) {
  if (place.at_infinity) { // the polynomial part [sqrt r]_infinity
    std::vector<NfElem> c;
    for (const Poly& term : place.sqrt_tail)
      c.push_back((form.root * term).coeff(0));
    std::ranges::reverse(c);
    return {Poly::from_coefficients(c)};
  }
  const Poly& q = place.place;
  RationalFunction part = sum_over_roots(form.exponent, q, 1);
  for (std::size_t i = 0; i < place.sqrt_tail.size(); ++i)
    part +=
        sum_over_roots(form.root * place.sqrt_tail[i] % q, q, place.nu() - static_cast<long>(i));
  return part;
}

// The summand that a local form adds to d.
NfElem contribution(const Singularity& place, const LocalForm& form) {
  return place.at_infinity ? form.exponent.coeff(0) : -trace(form.exponent, place.place);
}

// For each place the classes of local forms; N = 1 for y, N > 1 for y^N.
struct LineSearch {
  long N = 1;
  std::vector<std::vector<RationalFunction>> parts; ///< of N omega
  std::vector<std::vector<NfElem>> contributions;   ///< to d
};

void note_forms(const Singularity& place, const std::vector<LocalForm>& forms, Trace* trace) {
  if (trace == nullptr) return;
  std::string text = "At " + place_name(place) + ": ";
  if (forms.empty())
    text += "the exponents do not lie in the residue field, but those of a single exponential line "
            "would; there is none.";
  for (std::size_t i = 0; i < forms.size(); ++i) {
    text += i > 0 ? " or " : place.at_infinity ? "growth exponent " : "exponent ";
    text += to_string(forms[i].exponent, "c");
    if (!is_zero(forms[i].root))
      text += " with [sqrt r] = (" + to_string(forms[i].root, "c") + ") " +
              (place.at_infinity ? "z^" : "(z-c)^-") + std::to_string(place.nu()) + " + ...";
  }
  note(trace, 1, 1, text + (forms.empty() ? "" : "."));
}

// Nothing when a place leaves no choice over its residue field.
std::optional<LineSearch> line_search(const Singularities& s, const Budget& budget, Trace* trace) {
  LineSearch search;
  bool possible = true;
  for_each_place(s, [&](const Singularity& place) {
    if (!possible) return;
    auto& parts = search.parts.emplace_back();
    auto& sums = search.contributions.emplace_back();
    const std::vector<LocalForm> forms = local_forms(place, budget);
    note_forms(place, forms, trace);
    for (const LocalForm& form : forms) {
      parts.push_back(principal_part(place, form));
      sums.push_back(contribution(place, form));
    }
    possible = !parts.empty();
  });
  return possible ? std::optional(std::move(search)) : std::nullopt;
}

// ----- y^N instead of y -------------------------------------------------------------------------

bool is_rational_choice(const Singularity& place) {
  return place.kind == PlaceKind::regular && place.delta && !is_integer(*place.delta);
}

// The common denominator of the rational exponent differences, 1 when one family more or less does
// not matter or N would be large.
long useful_power(const Singularities& s) {
  constexpr long largest_power = 48;
  Integer N(1);
  long count = 0;
  for_each_place(s, [&](const Singularity& place) {
    if (!is_rational_choice(place)) return;
    ++count;
    N = lcm(N, place.delta->den());
  });
  return count > many_choices && N <= Integer(largest_power) ? to_long(N) : 1;
}

// At the places with rational differences the least exponent (at infinity the greatest) of y^N
// stands for all.
void take_power(LineSearch& search, const Singularities& s, long N) {
  search.N = N;
  std::size_t i = 0;
  for_each_place(s, [&](const Singularity& place) {
    auto& parts = search.parts[i];
    auto& sums = search.contributions[i];
    ++i;
    if (is_rational_choice(place)) { // local_forms lists (1 + Delta)/2 first
      const std::size_t keep = place.at_infinity ? 0 : 1;
      parts = {parts[keep]};
      sums = {sums[keep]};
    }
    for (RationalFunction& part : parts)
      part *= RationalFunction(Rational(N));
    for (NfElem& sum : sums)
      sum *= NfElem(N);
  });
}

// ----- steps 2 and 3 ----------------------------------------------------------------------------

// The lines that the solutions of one family stand for.
std::optional<Outcome> lines_of(const std::vector<Poly>& P, const RationalFunction& theta, long N,
                                const RationalFunction& r) {
  if (P.empty()) return std::nullopt;
  const RationalFunction weight(Rational(1, N));
  const RationalFunction omega = (theta + RationalFunction(derivative(P[0]), P[0])) * weight;
  if (N > 1) { // of one dimension if there is one line, and then y^N
    if (P.size() == 1 && solves_riccati(omega, r)) return Exponential{omega};
    return std::nullopt;
  }
  KOV_ENSURE(solves_riccati(omega, r));
  if (P.size() == 1) return Exponential{omega};
  // two solutions in one family: every solution is exponential
  const RationalFunction other = theta + RationalFunction(derivative(P[1]), P[1]);
  KOV_ENSURE(solves_riccati(other, r));
  return ExponentialPair{RationalFunction(1) / (omega - other), NfElem(1), true};
}

std::optional<Outcome> search_families(const Singularities& s, const LineSearch& search,
                                       const Budget& budget, Trace* trace) {
  const Families families = admissible_families(search.contributions, budget);
  note_families(trace, 1, search.N == 1 ? "y" : "y^" + std::to_string(search.N), families);
  if (families.admissible.empty()) {
    families.require_all(budget);
    return std::nullopt;
  }
  PolynomialStep step(search.N, common_denominator(s), s.r);
  std::vector<std::vector<Poly>> numerators; // S times each principal part
  for (const auto& parts : search.parts) {
    auto& place = numerators.emplace_back();
    for (const RationalFunction& part : parts)
      place.push_back(step.times_S(part));
  }
  FamilyLog log(trace, 1);
  for (const Family& family : families.admissible) {
    budget.check();
    Poly H(0);
    for (std::size_t i = 0; i < numerators.size(); ++i)
      H += numerators[i][family.choice[i]];
    const auto P = step.solutions(H, family.degree, budget);
    const RationalFunction theta(H, step.S());
    log.tried(P, family.degree, [&] { return "theta = " + to_string(theta); });
    if (auto found = lines_of(P, theta, search.N, s.r)) return found;
  }
  families.require_all(budget);
  return std::nullopt;
}

} // namespace

std::optional<Outcome> rational_lines(const Singularities& s, const Budget& budget, Trace* trace) {
  auto search = line_search(s, budget, trace);
  if (!search) return std::nullopt;
  const long N = useful_power(s);
  if (N > 1) {
    note(trace, 1, 1,
         "There are many signs to choose: y^" + std::to_string(N) +
             " is looked for, where they make no difference.");
    take_power(*search, s, N);
  }
  return search_families(s, *search, budget, trace);
}

} // namespace kov::kovacic
