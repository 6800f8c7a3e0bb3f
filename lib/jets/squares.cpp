#include "jets/squares.hpp"

namespace kov::jets {
namespace {

constexpr long largest = 1'000'000'000'000;

// n > 0 has a prime factor 3 modulo 4 to an odd power.
bool has_odd_power(long n) {
  for (long p = 2; p * p <= n; ++p) {
    int exponent = 0;
    for (; n % p == 0; n /= p)
      ++exponent;
    if (p % 4 == 3 && exponent % 2 == 1) return true;
  }
  return n % 4 == 3; // 1 or a prime
}

// 4^a (8 b + 7)
bool needs_four(long n) {
  while (n % 4 == 0)
    n /= 4;
  return n % 8 == 7;
}

} // namespace

bool may_be_sum_of_squares(const Rational& q, long n) {
  const Integer m = q.num() * q.den(); // q times a square
  if (m < Integer(0)) return false;
  if (is_zero(m) || n > 3 || m > Integer(largest)) return true;
  return n == 2 ? !has_odd_power(to_long(m)) : !needs_four(to_long(m));
}

} // namespace kov::jets
