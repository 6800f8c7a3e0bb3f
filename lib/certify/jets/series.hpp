#pragma once
// Laurent series over the algebra of a certificate, with their ends, and sums of such series by
// degree in c1, c2: docs/theory/jet_certificates.md 3.

#include "certify/system/curve_algebra.hpp"

#include <map>

namespace kov::certify {

/// sum of c[i] s^(low + i), + O(s^end).
struct LocalSeries {
  static constexpr long exact = 1L << 40; ///< the end of a finite sum
  long low = 0;
  CurveRow c;
  long end = exact;

  [[nodiscard]] bool is_exact_zero() const { return c.empty() && end == exact; }
  /// Below this exponent there is nothing.
  [[nodiscard]] long start() const { return c.empty() ? end : low; }
};

/// Entry j is of degree j in c1, c2; all have the same number of entries.
using GradedSeries = std::vector<LocalSeries>;
/// A polynomial in x and y, by exponents, without zeros.
using Table = std::map<std::pair<long, long>, CurveFunction>;

class SeriesAlgebra {
public:
  explicit SeriesAlgebra(const CurveAlgebra& algebra) : a_(algebra) {}

  [[nodiscard]] LocalSeries plus(const LocalSeries& f, const LocalSeries& g) const;
  [[nodiscard]] LocalSeries times(const LocalSeries& f, const LocalSeries& g) const;
  [[nodiscard]] LocalSeries times(const CurveFunction& k, LocalSeries f) const;
  [[nodiscard]] LocalSeries minus(const LocalSeries& f, const LocalSeries& g) const {
    return plus(f, times(a_.integer(-1), g));
  }
  /// The derivative by t, t = s^d.
  [[nodiscard]] LocalSeries derivative(LocalSeries f, long d) const;
  /// The coefficient of s^m.  Refuses m >= end.
  [[nodiscard]] CurveFunction coefficient(const LocalSeries& f, long m) const;
  /// The coefficient of s^m in f g.
  [[nodiscard]] CurveFunction coefficient(const LocalSeries& f, const LocalSeries& g, long m) const;

  /// The series without coefficients that are 0 at its ends.
  [[nodiscard]] LocalSeries trimmed(LocalSeries f) const;

  [[nodiscard]] GradedSeries times(const GradedSeries& f, const GradedSeries& g) const;

  [[nodiscard]] Table plus(Table f, const Table& g) const;
  [[nodiscard]] Table times(const Table& f, const Table& g) const;
  /// The derivative by x (which = 0) or y (1), times k.
  [[nodiscard]] Table derivative(const Table& f, int which, const CurveFunction& k) const;
  /// f(x, y)
  [[nodiscard]] GradedSeries value(const Table& f, const GradedSeries& x,
                                   const GradedSeries& y) const;

private:
  [[nodiscard]] CurveFunction product(const CurveFunction& f, const CurveFunction& g) const;

  const CurveAlgebra& a_;
};

} // namespace kov::certify
