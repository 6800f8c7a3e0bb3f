#include "spectrum/spectrum.hpp"

namespace kov::spectrum {
namespace {

std::string in_parentheses(const std::string& text) {
  return text.find_first_of("+-*/ ") == std::string::npos ? text : "(" + text + ")";
}

// z - c for a place with the monic or integral polynomial q.
std::string base_text(const MPoly& q, std::size_t z) {
  return in_parentheses(to_string_by_powers(MFraction(q), z));
}

std::string power_text(const MPoly& q, const MFraction& alpha, std::size_t z) {
  if (is_one(alpha)) return base_text(q, z);
  return base_text(q, z) + "^" + in_parentheses(kov::to_string(alpha));
}

MFraction polynomial(const std::vector<MFraction>& p, std::size_t z) {
  const Ring& ring = p.back().ring();
  MFraction sum(ring);
  for (std::size_t i = 0; i < p.size(); ++i)
    sum += p[i] * pow(MFraction::variable(ring, z), static_cast<long>(i));
  return sum;
}

} // namespace

std::string to_string(const Eigenfunction& y, std::size_t z) {
  std::string out;
  const auto factor = [&](const std::string& text) { out += (out.empty() ? "" : "*") + text; };
  if (y.p.size() > 1)
    factor(in_parentheses(to_string_by_powers(MFraction(polynomial(y.p, z).num()), z)));
  for (const auto& [base, power] : y.powers)
    if (!is_zero(power)) factor(power_text(base, power, z));
  if (!is_zero(y.exponent)) factor("exp(" + to_string_by_powers(y.exponent, z) + ")");
  return out.empty() ? "1" : out;
}

} // namespace kov::spectrum
