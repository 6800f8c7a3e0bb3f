#include "closed/recognize.hpp"

#include "closed/recognize_families.hpp"

namespace kov {
namespace recognition {

std::optional<NfElem> root_in(const NfElem& square) {
  if (square.field()->degree() > 4) return std::nullopt; // a factorisation over the field
  return exact_sqrt(square);
}

std::string root_text(const NfElem& square) {
  if (const auto root = root_in(square)) {
    const bool negative = is_rational(*root) && sign(to_rational(*root)) < 0;
    return to_string(negative ? -*root : *root);
  }
  return "sqrt(" + to_string(square) + ")";
}

Moebius composed(const Moebius& m, const Moebius& n) {
  return {m.a * n.a + m.b * n.c, m.a * n.b + m.b * n.d, m.c * n.a + m.d * n.c,
          m.c * n.b + m.d * n.d};
}

} // namespace recognition

std::optional<Recognized> recognize(const Singularities& s, const Budget& budget) {
  long regular = 0;
  long irregular = 0;
  const auto count = [&](const Singularity& place) {
    if (place.kind == PlaceKind::simple || place.kind == PlaceKind::regular)
      regular += place.degree();
    if (place.kind == PlaceKind::irregular || place.kind == PlaceKind::ramified)
      irregular += place.degree();
  };
  for (const Singularity& place : s.finite)
    count(place);
  count(s.infinity);
  if (irregular == 0 && regular >= 2 && regular <= 4)
    return recognition::regular(s, regular, budget);
  if (irregular == 1) return recognition::irregular(s, regular);
  return std::nullopt;
}

namespace {

// Four double poles; a pole of order 6 and a double one.
constexpr long largest = 8;

bool small(const RationalFunction& r, long bound) {
  return degree(r.den()) <= bound && degree(r.num()) <= bound;
}

bool even(const Poly& f) {
  for (long i = 1; i <= degree(f); i += 2)
    if (!is_zero(f.coeff(i))) return false;
  return true;
}

Poly halved(const Poly& f) {
  std::vector<NfElem> c;
  for (long i = 0; i <= degree(f); i += 2)
    c.push_back(f.coeff(i));
  return Poly::from_coefficients(c);
}

// r(z) = rho((z-c)^2), c the mean of the poles: in w = (z-c)^2 rho/(4w) - 3/(16 w^2).
std::optional<std::pair<RationalFunction, NfElem>> in_the_square(const RationalFunction& r) {
  const long d = degree(r.den());
  if (d < 2) return std::nullopt;
  const NfElem centre = -r.den().coeff(d - 1) / NfElem(d);
  const Poly num = taylor_shift(r.num(), centre);
  const Poly den = taylor_shift(r.den(), centre);
  if (!even(num) || !even(den)) return std::nullopt;
  const Poly w = Poly::z();
  const RationalFunction rho(halved(num), halved(den));
  return std::pair{rho / RationalFunction(scale(w, NfElem(4))) -
                       RationalFunction(Poly(Rational(3, 16)), w * w),
                   centre};
}

std::optional<Recognized> squared(const RationalFunction& r, const Budget& budget) {
  const auto below = in_the_square(r);
  if (!below || is_zero(below->first) || !small(below->first, largest)) return std::nullopt;
  auto found = recognize(singularities(below->first, budget), budget);
  if (!found || found->family == Classical::heun) return std::nullopt;
  found->centre = below->second;
  if (found->answer) {
    found->answer->group.reset();
    found->answer->reason += "; the identity component is the same in a finite extension";
  }
  return found;
}

} // namespace

std::optional<Recognized> recognize(const RationalFunction& r, const Budget& budget,
                                    const Singularities* places) {
  if (is_zero(r)) return std::nullopt;
  std::optional<Recognized> found;
  if (small(r, largest))
    found = recognize(places != nullptr ? *places : singularities(r, budget), budget);
  if ((!found || found->family == Classical::heun) && small(r, 2 * largest + 2))
    if (auto other = squared(r, budget)) return other;
  return found;
}

} // namespace kov
