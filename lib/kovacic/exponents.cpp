#include "kovacic/exponents.hpp"

#include "exact/joined.hpp"
#include "kovacic/necessary.hpp"
#include "kovacic/residue_field.hpp"

#include <algorithm>

namespace kov::kovacic {
namespace {

// (shift + sign * difference)/2
Poly exponent(long shift, const Poly& difference, int sign) {
  const Poly signed_difference = sign > 0 ? difference : -difference;
  return scale(Poly(shift) + signed_difference, NfElem(Rational(1, 2)));
}

std::vector<LocalForm> regular_forms(const Singularity& place, const Budget& budget) {
  const Poly none(0);
  const int log_free = place.at_infinity ? -1 : 1; // exponent (1 + Delta)/2, growth (1 - Delta)/2
  if (place.delta && is_integer(*place.delta)) {
    // one class: the log-free exponent, or the one from which the other is reached by P
    const int sign = certainly(place.log) ? log_free : -log_free;
    return {{exponent(1, Poly(*place.delta), sign), none}};
  }
  std::optional<Poly> delta;
  if (place.delta)
    delta = Poly(*place.delta);
  else
    delta = square_root(place.delta_squared, place.at_infinity ? Poly::z() : place.place, budget);
  if (!delta) return {};
  return {{exponent(1, *delta, 1), none}, {exponent(1, *delta, -1), none}};
}

std::vector<LocalForm> irregular_forms(const Singularity& place, const Budget& budget) {
  const Poly& q = place.at_infinity ? Poly::z() : place.place;
  const auto a = square_root(place.leading, q, budget);
  if (!a) return {};
  const Poly eps = place.beta * inverse_mod(*a, q) % q;
  const long shift = place.at_infinity ? -place.nu() : place.nu();
  return {{exponent(shift, eps, 1), *a}, {exponent(shift, eps, -1), -*a}};
}

} // namespace

std::vector<LocalForm> local_forms(const Singularity& place, const Budget& budget) {
  switch (place.kind) {
  case PlaceKind::ordinary: // growth z^0 and z^1: one class
    return {{Poly(1), Poly(0)}};
  case PlaceKind::simple:
    return {{Poly(place.at_infinity ? 0 : 1), Poly(0)}};
  case PlaceKind::regular:
    return regular_forms(place, budget);
  case PlaceKind::irregular:
    return irregular_forms(place, budget);
  case PlaceKind::ramified:
    return {};
  }
  return {};
}

std::vector<Rational> exponents(const Singularity& place, long m) {
  if (place.kind == PlaceKind::irregular || place.kind == PlaceKind::ramified)
    return {Rational(m * place.order, 4)};
  const Rational middle(m, 2);
  if (!place.delta) return {middle};
  if (certainly(place.log)) // the m-th power of the log-free solution
    return {place.at_infinity ? middle * (Rational(1) - *place.delta)
                              : middle * (Rational(1) + *place.delta)};
  std::vector<Rational> found;
  for (long k = -m / 2; k <= m / 2; ++k)
    found.push_back(middle + Rational(k) * *place.delta);
  return found;
}

std::vector<Rational> classes(const Singularity& place, long m, long N) {
  std::vector<Rational> found;
  std::vector<Rational> all = exponents(place, m);
  if (place.at_infinity) std::ranges::reverse(all);
  for (const Rational& e : all) {
    if (!is_integer(e * Rational(N))) continue;
    const bool known =
        std::ranges::any_of(found, [&](const Rational& f) { return is_integer(e - f); });
    if (!known) found.push_back(e);
  }
  return found;
}

std::string exponent_set_text(const Singularity& place, long m, long N, long scale) {
  std::vector<Rational> all = exponents(place, m);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  std::erase_if(all, [&](const Rational& e) { return !is_integer(e * Rational(N)); });
  return "{" + joined(all, [&](const Rational& e) { return to_string(e * Rational(scale)); }) + "}";
}

} // namespace kov::kovacic
