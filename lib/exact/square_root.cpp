#include "exact/square_root.hpp"

namespace kov {

std::optional<MFraction> square_root(const MFraction& f) {
  if (is_zero(f)) return f;
  MFraction root(f.ring(), Rational(1));
  for (const bool top : {true, false}) {
    const auto [content, factors] = factor(top ? f.num() : f.den());
    const auto c = exact_sqrt(Rational(content));
    if (!c) return std::nullopt;
    MFraction side(f.ring(), *c);
    for (const auto& one : factors) {
      if (one.exponent % 2 != 0) return std::nullopt;
      side *= MFraction(pow(one.base, static_cast<unsigned long>(one.exponent / 2)));
    }
    root = top ? root * side : root / side;
  }
  return root;
}

} // namespace kov
