#include "certify/jets/series.hpp"

#include "certify/equation/facts.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>

namespace kov::certify {

LocalSeries SeriesAlgebra::trimmed(LocalSeries f) const {
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

LocalSeries SeriesAlgebra::plus(const LocalSeries& f, const LocalSeries& g) const {
  if (f.is_exact_zero()) return g;
  if (g.is_exact_zero()) return f;
  LocalSeries sum{std::min(f.start(), g.start()), {}, std::min(f.end, g.end)};
  const auto top = [](const LocalSeries& x) { return x.low + static_cast<long>(x.c.size()); };
  for (long m = sum.low; m < std::min(sum.end, std::max(top(f), top(g))); ++m)
    sum.c.push_back(a_.plus(coefficient(f, m), coefficient(g, m)));
  return trimmed(std::move(sum));
}

LocalSeries SeriesAlgebra::times(const LocalSeries& f, const LocalSeries& g) const {
  if (f.is_exact_zero() || g.is_exact_zero()) return {};
  const auto far = [](long end, long start) {
    return end == LocalSeries::exact ? LocalSeries::exact : end + start;
  };
  LocalSeries all{
      f.start() + g.start(), {}, std::min(far(f.end, g.start()), far(g.end, f.start()))};
  if (f.c.empty() || g.c.empty()) return {0, {}, all.end};
  const long length = static_cast<long>(f.c.size() + g.c.size()) - 1;
  for (long m = all.low; m < std::min(all.end, all.low + length); ++m)
    all.c.push_back(coefficient(f, g, m));
  return trimmed(std::move(all));
}

LocalSeries SeriesAlgebra::times(const CurveFunction& k, LocalSeries f) const {
  if (is_zero(k.p)) return {};
  for (CurveFunction& x : f.c)
    x = a_.times(k, x);
  return trimmed(std::move(f));
}

LocalSeries SeriesAlgebra::derivative(LocalSeries f, long d) const {
  if (f.is_exact_zero()) return f;
  for (std::size_t i = 0; i < f.c.size(); ++i)
    f.c[i] = a_.over(a_.times(a_.integer(f.low + static_cast<long>(i)), f.c[i]), Integer(d));
  f.low -= d;
  if (f.end != LocalSeries::exact) f.end -= d;
  return trimmed(std::move(f));
}

// Long series of short elements are much work, too.
CurveFunction SeriesAlgebra::product(const CurveFunction& f, const CurveFunction& g) const {
  a_.charge(work_of_an_element +
            work_of_its_term * static_cast<double>(f.p.length() + g.p.length()));
  return a_.times(f, g);
}

CurveFunction SeriesAlgebra::coefficient(const LocalSeries& f, long m) const {
  need(m < f.end, "a series is too short");
  const long i = m - f.low;
  return i < 0 || i >= static_cast<long>(f.c.size()) ? a_.zero() : f.c[static_cast<std::size_t>(i)];
}

CurveFunction SeriesAlgebra::coefficient(const LocalSeries& f, const LocalSeries& g, long m) const {
  CurveFunction sum = a_.zero();
  if (f.is_exact_zero() || g.is_exact_zero()) return sum;
  need((f.end == LocalSeries::exact || m < f.end + g.start()) &&
           (g.end == LocalSeries::exact || m < g.end + f.start()),
       "a series is too short");
  for (std::size_t i = 0; i < f.c.size(); ++i) {
    const long j = m - f.low - static_cast<long>(i) - g.low;
    if (j < 0 || j >= static_cast<long>(g.c.size())) continue;
    const CurveFunction &x = f.c[i], &y = g.c[static_cast<std::size_t>(j)];
    if (is_zero(x.p) || is_zero(y.p))
      a_.charge(1);
    else
      sum = a_.plus(sum, product(x, y));
  }
  return sum;
}

GradedSeries SeriesAlgebra::times(const GradedSeries& f, const GradedSeries& g) const {
  GradedSeries all(f.size());
  for (std::size_t i = 0; i < f.size(); ++i)
    for (std::size_t j = 0; i + j < f.size(); ++j)
      all[i + j] = plus(all[i + j], times(f[i], g[j]));
  return all;
}

Table SeriesAlgebra::plus(Table f, const Table& g) const {
  for (const auto& [exponents, k] : g) {
    const auto [at, is_new] = f.try_emplace(exponents, k);
    if (!is_new) at->second = a_.plus(at->second, k);
    if (is_zero(at->second.p)) f.erase(at);
  }
  return f;
}

Table SeriesAlgebra::times(const Table& f, const Table& g) const {
  Table all;
  for (const auto& [e, k] : f) {
    Table row;
    for (const auto& [o, l] : g)
      row[{e.first + o.first, e.second + o.second}] = a_.times(k, l);
    all = plus(std::move(all), row);
  }
  return all;
}

Table SeriesAlgebra::derivative(const Table& f, int which, const CurveFunction& k) const {
  Table all;
  for (const auto& [e, c] : f) {
    const long n = which == 0 ? e.first : e.second;
    if (n > 0)
      all[{e.first - (which == 0), e.second - (which == 1)}] =
          a_.times(k, a_.times(a_.integer(n), c));
  }
  return all;
}

GradedSeries SeriesAlgebra::value(const Table& f, const GradedSeries& x,
                                  const GradedSeries& y) const {
  GradedSeries one(x.size()), sum(x.size());
  one[0] = {0, {a_.integer(1)}, LocalSeries::exact};
  std::vector<GradedSeries> xs{one}, ys{one};
  const auto power = [&](std::vector<GradedSeries>& known, const GradedSeries& base, long n) {
    while (static_cast<long>(known.size()) <= n)
      known.push_back(times(known.back(), base));
    return known[static_cast<std::size_t>(n)];
  };
  for (const auto& [e, k] : f) {
    const GradedSeries term = times(power(xs, x, e.first), power(ys, y, e.second));
    for (std::size_t j = 0; j < sum.size(); ++j)
      sum[j] = plus(sum[j], times(k, term[j]));
  }
  return sum;
}

} // namespace kov::certify
