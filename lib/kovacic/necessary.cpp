#include "kovacic/necessary.hpp"

#include "linode/degree_bounds.hpp"

namespace kov::kovacic {
namespace {

const Singularity* find_place(const Singularities& s, bool (*has)(const Singularity&)) {
  for (const Singularity& place : s.finite)
    if (has(place)) return &place;
  return has(s.infinity) ? &s.infinity : nullptr;
}

std::string at(const Singularity& place) { return "at " + place_name(place); }

std::string exclude_case1(const Singularities& s) {
  const auto* place =
      find_place(s, [](const Singularity& p) { return p.kind == PlaceKind::ramified; });
  if (place == nullptr) return "";
  return place->at_infinity
             ? "The order at infinity, " + std::to_string(place->order) + ", is odd and at most 2."
             : "The pole " + at(*place) + " has odd order " + std::to_string(place->order) +
                   " > 1.";
}

std::string exclude_by_logarithm(const Singularities& s) {
  const auto* place = find_place(s, [](const Singularity& p) { return certainly(p.log); });
  if (place == nullptr) return "";
  return "The local solutions " + at(*place) +
         " have a logarithm, so that an irreducible group is SL(2, C).";
}

std::string exclude_case2(const Singularities& s) {
  for (const Singularity& p : s.finite)
    if (p.order == 2 || p.kind == PlaceKind::ramified) return exclude_by_logarithm(s);
  return "No pole has order 2 or odd order > 2.";
}

std::string exclude_case3(const Singularities& s) {
  if (const auto* place = find_place(s, [](const Singularity& p) {
        return p.kind == PlaceKind::irregular || p.kind == PlaceKind::ramified;
      }))
    return "The place " + place_name(*place) + " is irregular.";
  if (const auto* place = find_place(s, [](const Singularity& p) { return !p.delta; }))
    return "The exponent difference " + at(*place) + " is not rational.";
  if (const auto* place =
          find_place(s, [](const Singularity& p) { return p.delta->den() > Integer(5); }))
    return "The exponent difference " + to_string(*place->delta) + " " + at(*place) +
           " has a denominator > 5, the order of no element of A4, S4 or A5.";
  return exclude_by_logarithm(s);
}

} // namespace

bool has_denominator_dividing(const Singularity& place, long n) {
  if (place.kind == PlaceKind::irregular || place.kind == PlaceKind::ramified) return false;
  return place.delta && is_integer(*place.delta * Rational(n));
}

Conditions necessary_conditions(const Singularities& s) {
  Conditions c;
  c.why_not1 = exclude_case1(s);
  c.why_not2 = exclude_case2(s);
  c.why_not3 = exclude_case3(s);
  c.case1 = c.why_not1.empty();
  c.case2 = c.why_not2.empty();
  c.case3 = c.why_not3.empty();
  return c;
}

} // namespace kov::kovacic
