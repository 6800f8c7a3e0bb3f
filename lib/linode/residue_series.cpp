#include "linode/residue_series.hpp"

#include "exact/error.hpp"

namespace kov {

namespace {

// At a place of degree one the residue field is K, and a series is a polynomial in t.
Poly packed(const ResidueSeries& a, std::size_t n) {
  std::vector<NfElem> coefficients;
  for (std::size_t k = 0; k < n; ++k)
    coefficients.push_back(a[k].coeff(0));
  return Poly::from_coefficients(coefficients);
}

ResidueSeries unpacked(const Poly& f, std::size_t n) {
  ResidueSeries series;
  for (std::size_t k = 0; k < n; ++k)
    series.emplace_back(f.coeff(static_cast<long>(k)));
  return series;
}

// Newton's iteration s <- (s + a/s)/2 from s = 1.  Requires a(0) = 1.
Poly square_root(const Poly& a, long n) {
  const NfElem half(Rational(1, 2));
  Poly s(1);
  for (long known = 1; known < n;) {
    known = std::min(2 * known, n);
    s = scale(s + truncate(truncate(a, known) * inverse_series(s, known), known), half);
  }
  return s;
}

// Below this length the quadratic recurrences are at least as fast.
constexpr std::size_t long_series = 32;

} // namespace

namespace {

// At z = a/b over Q: with F(x) = b^m f(x/b) integral but for one denominator, synthetic divisions
// by x - a are without fractions, and f = sum F_k b^(k-m) (z - a/b)^k.
ResidueSeries taylor_at_rational(const Poly& f, const Rational& c, long n) {
  ResidueSeries series;
  const long m = std::max(degree(f), 0L);
  fmpz_poly_t F;
  fmpz_poly_init(F);
  fmpq_poly_get_numerator(F, f.raw());
  const Integer b = c.den();
  Integer power(1);
  for (long i = m; i >= 0; --i, power *= b)
    if (i < F->length) fmpz_mul(F->coeffs + i, F->coeffs + i, power.raw());
  Rational weight(Integer(1), pow(b, static_cast<unsigned long>(m)));
  Integer value;
  Integer den;
  fmpz_set(den.raw(), fmpq_poly_denref(f.raw()));
  for (long k = 0; k < n; ++k, weight *= Rational(b)) {
    fmpz_poly_evaluate_fmpz(value.raw(), F, c.num().raw());
    series.emplace_back(Rational(value, den) * weight);
    fmpz_poly_div_root(F, F, c.num().raw());
  }
  fmpz_poly_clear(F);
  return series;
}

} // namespace

ResidueSeries taylor_at(const Poly& f, const Poly& q, long n) {
  ResidueSeries series;
  Poly rest = f;
  if (degree(q) == 1 && (is_zero(q.coeff(0)) || n > static_cast<long>(long_series)))
    return unpacked(taylor_shift(f, -q.coeff(0) / lead(q)), static_cast<std::size_t>(n));
  if (degree(q) == 1 && f.field()->is_rational() && q.field()->is_rational())
    return taylor_at_rational(f, to_rational(-q.coeff(0) / lead(q)), n);
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
  if (degree(q) == 1 && n > long_series) {
    const auto length = static_cast<long>(n);
    return unpacked(truncate(packed(a, n) * inverse_series(packed(b, n), length), length), n);
  }
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
  const std::size_t n = a.size();
  if (degree(q) == 1 && n > long_series)
    return unpacked(square_root(packed(a, n), static_cast<long>(n)), n);
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
