#include "kovacic/invariant_families.hpp"

#include "exact/error.hpp"
#include "kovacic/exponents.hpp"
#include "kovacic/family_log.hpp"
#include "linode/degree_bounds.hpp"

namespace kov::kovacic {
namespace {

std::string sets_text(const Singularities& s, const ProductSearch& search) {
  std::string text;
  for (const Singularity& place : s.finite)
    text += "E = " + exponent_set_text(place, search.m, search.N, search.scale) + " at " +
            place_name(place) + "; ";
  return text + "E = " + exponent_set_text(s.infinity, search.m, search.N, search.scale) +
         " at infinity";
}

std::string family_text(const ProductSearch& search,
                        const std::vector<std::vector<Rational>>& classes, const Family& family) {
  std::string text = search.name + ": e = (";
  for (std::size_t i = 0; i < classes.size(); ++i) {
    if (i > 0) text += i + 1 == classes.size() ? "; " : ", ";
    text += to_string(classes[i][family.choice[i]] * Rational(search.scale));
  }
  return text + ") at the finite places and at infinity";
}

std::vector<std::vector<NfElem>> contributions(const Singularities& s,
                                               const std::vector<std::vector<Rational>>& classes) {
  std::vector<std::vector<NfElem>> all;
  for (std::size_t i = 0; i < classes.size(); ++i) {
    auto& place = all.emplace_back();
    const bool finite = i < s.finite.size();
    for (const Rational& e : classes[i])
      place.emplace_back(finite ? -e * Rational(s.finite[i].degree()) : e);
  }
  return all;
}

RationalFunction logarithmic_derivative(const Singularities& s, const std::vector<Rational>& e) {
  RationalFunction theta;
  for (std::size_t i = 0; i < s.finite.size(); ++i)
    theta +=
        RationalFunction(scale(derivative(s.finite[i].place), NfElem(e[i])), s.finite[i].place);
  return theta;
}

} // namespace

RationalFunction RadicalProduct::phi() const { return theta + RationalFunction(derivative(P), P); }

Poly common_denominator(const Singularities& s) {
  Poly S(Rational(1));
  for (const Singularity& place : s.finite)
    S *= pow(place.place, static_cast<unsigned long>(std::max(1L, (place.order + 1) / 2)));
  return S;
}

std::vector<RadicalProduct> products(const Singularities& s, const ProductSearch& search,
                                     const Budget& budget, Trace* trace) {
  const int c = search.kovacic_case;
  std::vector<std::vector<Rational>> classes;
  for (const Singularity& place : s.finite)
    classes.push_back(search.classes(place));
  classes.push_back(search.classes(s.infinity));
  note(trace, c, 1, [&] { return search.name + ": " + sets_text(s, search) + "."; });
  const Families families = admissible_families(contributions(s, classes), budget);
  note_families(trace, c, search.name, families);
  std::vector<RadicalProduct> found;
  if (search.all || families.admissible.empty()) families.require_all(budget);
  if (families.admissible.empty()) return found;
  PolynomialStep step(search.m, common_denominator(s), s.r);
  FamilyLog log(trace, c);
  for (const Family& family : families.admissible) {
    budget.check();
    std::vector<Rational> e;
    for (std::size_t i = 0; i < s.finite.size(); ++i)
      e.push_back(classes[i][family.choice[i]]);
    if (search.wanted && !search.wanted(e)) continue;
    const RationalFunction theta = logarithmic_derivative(s, e);
    const Poly H = step.times_S(theta);
    const auto solutions = step.solutions(H, family.degree, budget);
    log.tried(solutions, family.degree, [&] { return family_text(search, classes, family); });
    for (const Poly& P : solutions) {
      found.push_back({e, theta, P, step.chain(P, H), step.S()});
      if (!search.all) return found;
    }
  }
  families.require_all(budget);
  return found;
}

std::vector<RadicalProduct> rational_products(const Singularities& s, long m, int kovacic_case,
                                              std::string name, const Budget& budget,
                                              Trace* trace) {
  ProductSearch search;
  search.kovacic_case = kovacic_case;
  search.m = m;
  search.N = 1;
  search.scale = m == 2 ? 2 : 12 / m;
  search.classes = [m](const Singularity& place) { return kovacic::classes(place, m, 1); };
  search.all = true;
  search.name = std::move(name);
  return products(s, search, budget, trace);
}

RationalFunction rational_value(const Singularities& s, const RadicalProduct& v) {
  RationalFunction value(v.P);
  for (std::size_t i = 0; i < s.finite.size(); ++i) {
    KOV_ENSURE(is_integer(v.exponent[i]));
    value *= pow(RationalFunction(s.finite[i].place), to_long(v.exponent[i].num()));
  }
  return value;
}

} // namespace kov::kovacic
