#include "jets/series.hpp"

#include <algorithm>

namespace kov::jets {

Series::Series(long low, std::vector<MFraction> c, long end)
    : low_(low), c_(std::move(c)), end_(end > exact / 2 ? exact : end) {
  if (top() > end_) c_.resize(static_cast<std::size_t>(std::max(0L, end_ - low_)));
  while (!c_.empty() && is_zero(c_.back()))
    c_.pop_back();
  const auto first = std::ranges::find_if(c_, [](const auto& x) { return !is_zero(x); });
  low_ += first - c_.begin();
  c_.erase(c_.begin(), first);
}

MFraction Series::operator[](long m) const {
  if (m >= end_) throw NeedsMoreTerms("a series is not known so far");
  return m < low_ || m >= top() ? MFraction() : c_[static_cast<std::size_t>(m - low_)];
}

Series operator+(const Series& a, const Series& b) {
  if (a.is_exact_zero()) return b;
  if (b.is_exact_zero()) return a;
  const long end = std::min(a.end(), b.end());
  const long low = std::min(a.low(), b.low());
  std::vector<MFraction> c;
  for (long m = low; m < std::min(end, std::max(a.top(), b.top())); ++m)
    c.push_back(a[m] + b[m]);
  return {low, std::move(c), end};
}

Series operator*(const Series& a, const Series& b) {
  if (a.is_exact_zero() || b.is_exact_zero()) return {};
  const long end = std::min(a.end() + b.low(), b.end() + a.low());
  const long low = a.low() + b.low();
  std::vector<MFraction> c;
  if (!a.c_.empty() && !b.c_.empty())
    for (long m = low; m < std::min(end, a.top() + b.top() - 1); ++m)
      c.push_back(coefficient_of_product(a, b, m));
  return {low, std::move(c), end};
}

Series operator*(const MFraction& c, const Series& a) {
  if (is_zero(c)) return {};
  return map(a, 0, [&](const MFraction& x, long) { return c * x; });
}

MFraction coefficient_of_product(const Series& a, const Series& b, long m) {
  if (a.is_exact_zero() || b.is_exact_zero()) return {};
  if (m >= std::min(a.end() + b.low(), b.end() + a.low()))
    throw NeedsMoreTerms("a product of series is not known so far");
  MFraction sum;
  for (long i = std::max(a.low(), m - b.top() + 1); i < a.top() && m - i >= b.low(); ++i)
    sum += a[i] * b[m - i];
  return sum;
}

} // namespace kov::jets
