#include "certify/equation/bounds.hpp"

#include "certify/equation/facts.hpp"

namespace kov::certify {

Rational root_above(const Rational& x, const Integer& k) {
  if (sign(x) <= 0) return 0;
  const Integer top = ceil(Rational(k * k) * x);
  Integer j;
  fmpz_sqrt(j.raw(), top.raw());
  if (j * j < top) j += Integer(1);
  return {j, k};
}

namespace {

Rational power_of_two(long k) {
  const Integer p = pow(Integer(2), static_cast<unsigned long>(std::abs(k)));
  return k >= 0 ? Rational(p) : Rational(Integer(1), p);
}

} // namespace

Rational root_bound(const Poly& chi) {
  const long n = degree(chi);
  need(n >= 1, "the annihilator is constant");
  std::vector<Rational> c;
  Rational largest;
  for (long i = 0; i <= n; ++i) {
    const NfElem e = chi.coeff(i);
    need(is_rational(e), "the annihilator is not over Q");
    c.push_back(abs(to_rational(e)));
    if (i < n && c.back() > largest) largest = c.back();
  }
  if (is_zero(largest)) return 0;
  const auto holds = [&](const Rational& b) {
    Rational v;
    for (long i = n - 1; i >= 0; --i)
      v = v * b + c[static_cast<std::size_t>(i)];
    Rational top = c.back();
    for (long i = 0; i < n; ++i)
      top *= b;
    return top >= v;
  };
  long k = static_cast<long>(fmpz_bits(ceil(Rational(1) + largest / c.back()).raw()));
  need(k < 4096, "the annihilator is too large");
  while (k > -64 && holds(power_of_two(k - 1)))
    --k;
  Rational low = power_of_two(k - 1);
  Rational high = power_of_two(k);
  for (int i = 0; i < 8; ++i) {
    const Rational mid = (low + high) / Rational(2);
    (holds(mid) ? high : low) = mid;
  }
  return high;
}

} // namespace kov::certify
