#pragma once
// Real intervals that contain the exact value, as two doubles: a middle and a radius.  A proof like Enclosure's at 53
// bits, and some thirty times as fast.
//
// Why it is one.  Every operation computes its middle in double, which is wrong by at most one unit in the last place,
// 2^-52 |result| (half of that where it is rounded to nearest), plus 2^-1000 where numbers are so small that they have
// fewer bits.  The bound of what the radii and this error make is a sum of products of numbers >= 0, of at most eight
// roundings, each wrong by the factor 1 +- 2^-52; `up` multiplies it by more than (1 - 2^-52)^-10.  So the rounding
// mode, products fused with sums, and numbers that are flushed to 0 make no difference.  What is too large for a double
// has radius infinity or not-a-number; all questions are asked so that these say "not known".

#include "flow/number/dual.hpp"
#include "flow/number/enclosure.hpp"

#include <cmath>
#include <concepts>
#include <limits>
#include <optional>

#if defined(__FAST_MATH__)
#error "the radii need the rounding that was written"
#endif
static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::digits == 53);

namespace kov::flow {

class DoubleBall {
public:
  DoubleBall() = default;
  DoubleBall(double middle) : m_(middle) {}
  /// Exact below 2^53.
  DoubleBall(std::integral auto n) : m_(static_cast<double>(n)) {
    if constexpr (sizeof(n) > 4) r_ = up(std::abs(m_) * ulp);
  }
  DoubleBall(double middle, double radius) : m_(middle), r_(radius) {}

  /// The bits for which the remainder of a step of an integration is made (return_map.hpp); not a
  /// precision that is kept.
  [[nodiscard]] static constexpr long bits() noexcept { return 60; }
  [[nodiscard]] double mid() const noexcept { return m_; }
  [[nodiscard]] double radius() const noexcept { return r_; }
  explicit operator double() const noexcept { return m_; }
  /// |x|, from above; infinity or not-a-number: not known.
  [[nodiscard]] double most() const noexcept { return up(std::abs(m_) + r_); }

  [[nodiscard]] static DoubleBall between(double low, double high) {
    const double m = low + (high - low) / 2;
    return {m, up(std::fmax(std::abs(high - m), std::abs(m - low)))};
  }
  [[nodiscard]] static DoubleBall hull(const DoubleBall& a, const DoubleBall& b) {
    if (!a.finite() || !b.finite()) return unknown();
    return between(std::fmin(a.low(), b.low()), std::fmax(a.high(), b.high()));
  }
  [[nodiscard]] DoubleBall middle() const { return m_; }
  [[nodiscard]] DoubleBall widened(const DoubleBall& r) const { return {m_, up(r_ + r.most())}; }
  [[nodiscard]] bool contains_zero() const { return !(std::abs(m_) > r_); }
  [[nodiscard]] bool inside(const DoubleBall& other) const { // strictly
    return up(std::abs(m_ - other.m_) + r_) < other.r_;
  }
  [[nodiscard]] bool is_positive() const { return m_ > r_; }
  [[nodiscard]] bool is_negative() const { return -m_ > r_; }
  [[nodiscard]] bool finite() const { return std::isfinite(m_) && std::isfinite(r_); }
  /// Bounds of the points, not infinite where the ball is not.
  [[nodiscard]] double low() const { return below(m_ - r_); }
  [[nodiscard]] double high() const { return -below(-m_ - r_); }

  friend DoubleBall operator+(const DoubleBall& a, const DoubleBall& b) {
    const double m = a.m_ + b.m_;
    return {m, up(a.r_ + b.r_ + std::abs(m) * ulp)};
  }
  friend DoubleBall operator-(const DoubleBall& a, const DoubleBall& b) {
    const double m = a.m_ - b.m_;
    return {m, up(a.r_ + b.r_ + std::abs(m) * ulp)};
  }
  friend DoubleBall operator-(const DoubleBall& a) { return {-a.m_, a.r_}; }
  friend DoubleBall operator*(const DoubleBall& a, const DoubleBall& b) {
    const double m = a.m_ * b.m_;
    return {m, up(std::abs(a.m_) * b.r_ + a.r_ * (std::abs(b.m_) + b.r_) + std::abs(m) * ulp)};
  }
  // |a/b - q| = |a - q b| / |b|, and |a - q b| <= |a.m - q b.m| + a.r + |q| b.r
  friend DoubleBall operator/(const DoubleBall& a, const DoubleBall& b) {
    const double least = (std::abs(b.m_) - b.r_) * (1 - 8 * ulp);
    if (!(least > smallest)) return unknown();
    const double q = a.m_ / b.m_;
    const double rest =
        std::abs(a.m_) * (4 * ulp) + a.r_ + std::abs(q) * b.r_ + std::abs(b.m_) * smallest;
    return {q, up(up(rest) / least)};
  }
  DoubleBall& operator+=(const DoubleBall& b) { return *this = *this + b; }
  DoubleBall& operator-=(const DoubleBall& b) { return *this = *this - b; }
  DoubleBall& operator*=(const DoubleBall& b) { return *this = *this * b; }
  DoubleBall& operator/=(const DoubleBall& b) { return *this = *this / b; }
  // Comparisons are proofs.
  friend bool operator<(const DoubleBall& a, const DoubleBall& b) { return (b - a).is_positive(); }
  friend bool operator>(const DoubleBall& a, const DoubleBall& b) { return (a - b).is_positive(); }
  friend bool operator==(const DoubleBall& a, const DoubleBall& b) {
    return a.m_ == b.m_ && a.r_ == 0 && b.r_ == 0;
  }

  static DoubleBall unknown() { return {0, std::numeric_limits<double>::infinity()}; }
  static constexpr double ulp = 0x1p-52, smallest = 0x1p-1000;
  /// More than x, by at least the errors of ten operations of its size.
  static double up(double x) { return x * (1 + 16 * ulp) + smallest; }

private:
  // of a difference that was rounded
  static double below(double x) { return x - (std::abs(x) * (4 * ulp) + smallest); }
  double m_ = 0, r_ = 0;
};

inline void add_product(DoubleBall& acc, const DoubleBall& a, const DoubleBall& b) {
  acc = acc + a * b;
}
inline void sub_product(DoubleBall& acc, const DoubleBall& a, const DoubleBall& b) {
  acc = acc - a * b;
}
[[nodiscard]] inline Enclosure power(const Enclosure& x, int n) {
  Enclosure r;
  arb_pow_ui(r.raw(), x.raw(), static_cast<ulong>(n), Enclosure::bits());
  return r;
}
[[nodiscard]] inline DoubleBall power(DoubleBall x, int n) {
  DoubleBall all(1);
  for (; n > 0; n /= 2, x = x * x)
    if (n % 2 == 1) all = all * x;
  return all;
}
/// The intersection of two enclosures of one number; nothing if it is empty, or one is not finite.
[[nodiscard]] std::optional<DoubleBall> intersection(const DoubleBall& a, const DoubleBall& b);
[[nodiscard]] std::optional<Enclosure> intersection(const Enclosure& a, const Enclosure& b);
/// A ball of doubles around an Arb ball, and the other way round: `within` lies inside of x.
[[nodiscard]] DoubleBall double_ball(const Enclosure& x);
[[nodiscard]] Enclosure around(const DoubleBall& x);
[[nodiscard]] Enclosure within(const DoubleBall& x);

/// Sum of a[j] b[-j], j < n, rounded once.
[[nodiscard]] Dual<Enclosure> dot(const Dual<Enclosure>* a, const Dual<Enclosure>* b, int n);
/// The sum of a[j] b[-j], j < n.  The sum of the middles is wrong by at most (n + 1) 2^-52 times the sum of the |a b|.
[[nodiscard]] Dual<DoubleBall> dot(const Dual<DoubleBall>* a, const Dual<DoubleBall>* b, int n);

} // namespace kov::flow
