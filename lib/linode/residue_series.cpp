#include "linode/residue_series.hpp"

#include "exact/error.hpp"

namespace kov {

ResidueSeries taylor_at(const Poly& f, const Poly& q, long n) {
  ResidueSeries series;
  Poly rest = f;
  if (degree(q) == 1) { // repeated synthetic division
    for (long k = 0; k < n; ++k) {
      auto [quot, value] = divrem(rest, q);
      series.push_back(std::move(value));
      rest = std::move(quot);
    }
    return series;
  }
  Integer factorial(1);
  for (long k = 0; k < n; ++k) {
    if (k > 0) {
      rest = derivative(rest);
      factorial *= Integer(k);
    }
    series.push_back(scale(rest % q, NfElem(Rational(Integer(1), factorial))));
  }
  return series;
}

ResidueSeries divide(const ResidueSeries& a, const ResidueSeries& b, const Poly& q) {
  const std::size_t n = std::min(a.size(), b.size());
  const Poly unit = inverse_mod(b.at(0), q);
  ResidueSeries quotient_series;
  for (std::size_t k = 0; k < n; ++k) {
    Poly sum = a[k];
    for (std::size_t j = 1; j <= k; ++j)
      sum -= b[j] * quotient_series[k - j];
    quotient_series.push_back((sum % q) * unit % q);
  }
  return quotient_series;
}

ResidueSeries square_root(const ResidueSeries& a, const Poly& q) {
  KOV_ENSURE(!a.empty() && is_one(a[0]));
  const NfElem half(Rational(1, 2));
  ResidueSeries s{Poly(1)};
  for (std::size_t k = 1; k < a.size(); ++k) {
    Poly sum = a[k];
    for (std::size_t i = 1; i < k; ++i)
      sum -= s[i] * s[k - i];
    s.push_back(scale(sum % q, half));
  }
  return s;
}

} // namespace kov
