#pragma once
// Laurent series in a local parameter s, cut off:  sum of c_m s^m for m < end, + O(s^end).

#include "exact/error.hpp"
#include "exact/multivariate.hpp"

#include <vector>

namespace kov::jets {

/// A coefficient beyond the end of a series was asked for.
class NeedsMoreTerms : public Error {
  using Error::Error;
};

/// Given   const Ring ring = make_ring({"a"});
/// Given   const MFraction a = MFraction::variable(ring, "a");
/// Given   const Series u(-1, {a, a*a}, 3);
/// Example (u * u)[-1]  // -> 2*a^3
/// Example (u * u)[2]  // -> throws NeedsMoreTerms
class Series {
public:
  static constexpr long exact = 1L << 40; ///< the `end` of a finite sum
  Series() = default;                     ///< zero, exactly
  Series(long low, std::vector<MFraction> c, long end);
  [[nodiscard]] static Series constant(const MFraction& c) { return {0, {c}, exact}; }

  [[nodiscard]] bool is_exact_zero() const noexcept { return c_.empty() && end_ == exact; }
  /// No coefficient below this one is not 0.
  [[nodiscard]] long low() const noexcept { return c_.empty() ? end_ : low_; }
  [[nodiscard]] long end() const noexcept { return end_; }
  /// One more than the last coefficient that is kept.
  [[nodiscard]] long top() const noexcept { return low_ + static_cast<long>(c_.size()); }
  [[nodiscard]] MFraction operator[](long m) const; ///< Throws NeedsMoreTerms unless m < end().

  friend Series operator+(const Series& a, const Series& b);
  friend Series operator*(const Series& a, const Series& b);
  friend Series operator*(const MFraction& c, const Series& a);
  Series& operator+=(const Series& b) { return *this = *this + b; }

private:
  long low_ = 0;
  std::vector<MFraction> c_; ///< from low_ on; the first and the last are not 0
  long end_ = exact;
};

/// The coefficient of s^m in a product.  Throws NeedsMoreTerms.
[[nodiscard]] MFraction coefficient_of_product(const Series& a, const Series& b, long m);

/// f applied to each coefficient with its exponent.
template <class Function> [[nodiscard]] Series map(const Series& a, long shift, Function f) {
  if (a.is_exact_zero()) return a;
  std::vector<MFraction> c;
  for (long m = a.low(); m < a.top(); ++m)
    c.push_back(f(a[m], m));
  return {a.low() + shift, std::move(c), a.end() == Series::exact ? a.end() : a.end() + shift};
}

} // namespace kov::jets
