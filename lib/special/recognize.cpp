#include "special/recognize.hpp"

#include "special/recognize_families.hpp"

namespace kov {
namespace recognition {

std::string root_text(const NfElem& square) {
  if (const auto root = exact_sqrt(square)) {
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
  if (irregular == 1 && regular <= 1) return recognition::irregular(s, regular);
  return std::nullopt;
}

std::optional<Recognized> recognize(const RationalFunction& r, const Budget& budget) {
  constexpr long largest = 8; // four double poles; a pole of order 6 and a double one
  if (is_zero(r) || degree(r.den()) > largest || degree(r.num()) > largest) return std::nullopt;
  return recognize(singularities(r, budget), budget);
}

} // namespace kov
