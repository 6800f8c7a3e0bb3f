#include "monodromy/decimal.hpp"

namespace kov::monodromy {
namespace {

Rational exact_value(const arf_struct* x) {
  Rational q;
  arf_get_fmpq(q.raw(), x);
  return q;
}

Rational power_of_ten(long e) { return pow(Integer(10), static_cast<unsigned long>(e)); }

// n 10^-digits with a point.
std::string with_point(const Integer& n, long digits) {
  std::string s = to_string(sign(n) < 0 ? -n : n);
  const auto behind = static_cast<std::size_t>(digits);
  if (s.size() <= behind) s.insert(0, behind + 1 - s.size(), '0');
  if (behind > 0) s.insert(s.size() - behind, 1, '.');
  return (sign(n) < 0 ? "-" : "") + s;
}

std::string rounded(const arf_struct* x, long digits) {
  return with_point(floor(exact_value(x) * power_of_ten(digits) + Rational(Integer(1), Integer(2))),
                    digits);
}

std::string all_digits(const Real& x) {
  const Rational q = exact_value(arb_midref(x.raw()));
  const long digits = static_cast<long>(fmpz_val2(q.den().raw())); // den = 2^digits
  return with_point((q * power_of_ten(digits)).num(), digits);
}

} // namespace

std::pair<std::string, std::string> decimals(const acb_struct* z, long digits) {
  const long behind = written_digits(digits);
  return {rounded(arb_midref(acb_realref(z)), behind), rounded(arb_midref(acb_imagref(z)), behind)};
}

std::string decimal_radius(const BallMatrix& m, long digits) {
  // Rounding loses at most 10^-behind/sqrt 2.
  Rational bound = exact_value(arb_midref(largest_radius(m).raw())) +
                   Rational(1) / power_of_ten(written_digits(digits));
  long e = 0; // bound = mantissa 10^-e, 1 <= mantissa < 10
  for (; bound < Rational(1); ++e)
    bound *= Rational(10);
  for (; !(bound < Rational(10)); --e)
    bound /= Rational(10);
  const Integer tenths = ceil(bound * Rational(10));
  return with_point(tenths, 1) + "e" + (e > 0 ? "-" : "+") + std::to_string(e > 0 ? e : -e);
}

std::pair<std::string, std::string> exact_decimals(const Point& p) {
  return {all_digits(p.x), all_digits(p.y)};
}

} // namespace kov::monodromy
