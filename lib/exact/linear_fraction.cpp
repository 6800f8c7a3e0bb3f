#include "exact/linear_fraction.hpp"

namespace kov {

std::optional<std::size_t> variable_of_linear_fraction(const MFraction& f) {
  if (!f.ring()) return std::nullopt;
  const auto used = used_variables(f);
  if (used.size() != 1) return std::nullopt;
  // in lowest terms and not constant: a d != b c
  if (degree(f.num(), used[0]) > 1 || degree(f.den(), used[0]) > 1) return std::nullopt;
  return used[0];
}

} // namespace kov
