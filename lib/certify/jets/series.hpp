#pragma once
// Laurent series over the algebra of a certificate, with their ends, and sums of such series by
// degree in c1, c2: docs/theory/jet_certificates.md 3.

#include "certify/jets/check.hpp"
#include "certify/system/curve_algebra.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>

namespace kov::certify {

/// Entry j is of degree j in c1, c2; all have the same number of entries.
using GradedSeries = std::vector<LocalSeries>;

class SeriesAlgebra {
public:
  explicit SeriesAlgebra(const CurveAlgebra& algebra) : a_(algebra) {}

  static LocalSeries constant(CurveFunction k) {
    return is_zero(k.p) ? LocalSeries{} : LocalSeries{0, {std::move(k)}, LocalSeries::exact};
  }
  [[nodiscard]] LocalSeries plus(const LocalSeries& f, const LocalSeries& g) const {
    if (f.is_exact_zero()) return g;
    if (g.is_exact_zero()) return f;
    LocalSeries sum{std::min(f.start(), g.start()), {}, std::min(f.end, g.end)};
    const auto top = [](const LocalSeries& x) { return x.low + static_cast<long>(x.c.size()); };
    for (long m = sum.low; m < std::min(sum.end, std::max(top(f), top(g))); ++m)
      sum.c.push_back(a_.plus(coefficient(f, m), coefficient(g, m)));
    return trimmed(std::move(sum));
  }
  [[nodiscard]] LocalSeries times(const LocalSeries& f, const LocalSeries& g) const {
    if (f.is_exact_zero() || g.is_exact_zero()) return {};
    LocalSeries all{
        f.start() + g.start(), {}, std::min(end_of(f, g.start()), end_of(g, f.start()))};
    if (f.c.empty() || g.c.empty()) return {0, {}, all.end};
    const long length = static_cast<long>(f.c.size() + g.c.size()) - 1;
    for (long m = all.low; m < std::min(all.end, all.low + length); ++m)
      all.c.push_back(coefficient(f, g, m));
    return trimmed(std::move(all));
  }
  [[nodiscard]] LocalSeries times(const CurveFunction& k, LocalSeries f) const {
    if (is_zero(k.p)) return {};
    for (CurveFunction& x : f.c)
      x = a_.times(k, x);
    return trimmed(std::move(f));
  }
  [[nodiscard]] LocalSeries minus(const LocalSeries& f, const LocalSeries& g) const {
    return plus(f, times(a_.integer(-1), g));
  }
  /// The derivative by t, t = s^d.
  [[nodiscard]] LocalSeries derivative(LocalSeries f, long d) const {
    if (f.is_exact_zero()) return f;
    for (std::size_t i = 0; i < f.c.size(); ++i)
      f.c[i] = a_.over(a_.times(a_.integer(f.low + static_cast<long>(i)), f.c[i]), Integer(d));
    f.low -= d;
    f.end = end_of(f, -d);
    return trimmed(std::move(f));
  }

  /// The coefficient of s^m.  Refuses m >= end.
  [[nodiscard]] CurveFunction coefficient(const LocalSeries& f, long m) const {
    need(m < f.end, "a series is too short");
    const long i = m - f.low;
    return i < 0 || i >= static_cast<long>(f.c.size()) ? a_.zero()
                                                       : f.c[static_cast<std::size_t>(i)];
  }
  /// The coefficient of s^m in f g.
  [[nodiscard]] CurveFunction coefficient(const LocalSeries& f, const LocalSeries& g,
                                          long m) const {
    CurveFunction sum = a_.zero();
    if (f.is_exact_zero() || g.is_exact_zero()) return sum;
    need(m < end_of(f, g.start()) && m < end_of(g, f.start()), "a series is too short");
    for (std::size_t i = 0; i < f.c.size(); ++i) {
      const long j = m - f.low - static_cast<long>(i) - g.low;
      if (j < 0 || j >= static_cast<long>(g.c.size())) continue;
      const CurveFunction &x = f.c[i], &y = g.c[static_cast<std::size_t>(j)];
      if (is_zero(x.p) || is_zero(y.p)) {
        a_.charge(1);
        continue;
      }
      // long series of short elements are much work, too
      a_.charge(work_of_an_element +
                work_of_its_term * static_cast<double>(x.p.length() + y.p.length()));
      sum = a_.plus(sum, a_.times(x, y));
    }
    return sum;
  }
  /// The series without coefficients that are 0 at its ends.
  [[nodiscard]] LocalSeries trimmed(LocalSeries f) const {
    const auto zero = [](const CurveFunction& x) { return is_zero(x.p); };
    const auto size = std::clamp(f.end - f.low, 0L, static_cast<long>(f.c.size()));
    f.c.resize(static_cast<std::size_t>(size));
    while (!f.c.empty() && zero(f.c.back()))
      f.c.pop_back();
    const auto first = std::ranges::find_if_not(f.c, zero);
    f.low += first - f.c.begin();
    f.c.erase(f.c.begin(), first);
    return f;
  }

  [[nodiscard]] GradedSeries times(const GradedSeries& f, const GradedSeries& g) const {
    GradedSeries all(f.size());
    for (std::size_t i = 0; i < f.size(); ++i)
      for (std::size_t j = 0; i + j < f.size(); ++j)
        all[i + j] = plus(all[i + j], times(f[i], g[j]));
    return all;
  }
  /// 1, f, f^2, ..., f^n
  [[nodiscard]] std::vector<GradedSeries> powers(const GradedSeries& f, std::size_t n) const {
    std::vector<GradedSeries> all{GradedSeries(f.size())};
    all[0][0] = constant(a_.integer(1));
    while (all.size() <= n)
      all.push_back(times(all.back(), f));
    return all;
  }

private:
  static long end_of(const LocalSeries& f, long shift) {
    return f.end == LocalSeries::exact ? f.end : f.end + shift;
  }

  const CurveAlgebra& a_;
};

} // namespace kov::certify
