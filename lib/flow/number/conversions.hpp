#pragma once
// From one number type to another.

#include "flow/number/big_real.hpp"
#include "flow/number/twin.hpp"

#include <cmath>

namespace kov::flow {

/// x itself, if the thread's precision has room for it.
inline BigReal to_big(const BigReal& x) { return x; }
inline BigReal to_big(double x) { return BigReal(x); }
inline BigReal to_big(long double x) { return BigReal(x); }
inline BigReal to_big(const Twin1& x) { return BigReal(x.hi) + BigReal(x.lo); }

inline double to_double(const BigReal& x) { return static_cast<double>(x); }
inline double to_double(double x) { return x; }
inline double to_double(long double x) { return static_cast<double>(x); }
inline double to_double(const Twin1& x) { return x.hi; }

inline Twin1 to_twin(const BigReal& x) {
  const auto high = static_cast<double>(x);
  return {high, static_cast<double>(x - BigReal(high))};
}

/// Bits for so many decimal digits, with a few to spare.
inline long bits_of(int digits) {
  return static_cast<long>(std::ceil(digits * 3.3219280948873623)) + 8;
}

} // namespace kov::flow
