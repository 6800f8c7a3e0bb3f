#include "linode/logarithm.hpp"

#include "exact/error.hpp"
#include "exact/modular.hpp"

namespace kov {
namespace {

// The right side of the recurrence at k = N modulo a prime at which everything in sight is
// integral: p > N, c a root of q modulo p where den has order exactly 2.  Unset when p is not such
// a prime.
std::optional<bool> defect_vanishes_modulo(const PrimeIdeal& prime, const Poly& num,
                                           const Poly& den, const Poly& q, long N) {
  const auto n = prime.reduce(num);
  const auto d = prime.reduce(den);
  const auto place = prime.reduce(q);
  if (!n || !d || !place || degree(*place) != degree(q)) return std::nullopt;
  const auto at = roots(*place);
  if (at.empty()) return std::nullopt;
  const NmodPoly b = taylor_shift(*n, at.front());
  const NmodPoly a = taylor_shift(*d, at.front());
  const nmod_t mod = a.mod();
  if (a.coeff(0) != 0 || a.coeff(1) != 0 || a.coeff(2) == 0) return std::nullopt;
  const long width = std::max(degree(a) - 2, degree(b));
  const mp_limb_t quarter = nmod_inv(4, mod);
  std::vector<mp_limb_t> u{1};
  // weight of u_m in a row: B_j - A_j ((2m - N)^2 - 1)/4
  const auto row = [&](long k) {
    mp_limb_t sum = 0;
    for (long j = 1; j <= std::min(k, width); ++j) {
      const long m = k - j;
      const long s = 2 * m - N;
      mp_limb_t square = static_cast<mp_limb_t>(s < 0 ? -s : s);
      square = nmod_mul(square, square, mod);
      const mp_limb_t e = nmod_mul(nmod_sub(square, 1, mod), quarter, mod);
      const mp_limb_t weight = nmod_sub(b.coeff(j), nmod_mul(a.coeff(j + 2), e, mod), mod);
      sum = nmod_addmul(sum, weight, u[static_cast<std::size_t>(m)], mod);
    }
    return sum;
  };
  const mp_limb_t a0 = a.coeff(2);
  for (long k = 1; k < N; ++k) {
    mp_limb_t pivot = nmod_mul(static_cast<mp_limb_t>(k), static_cast<mp_limb_t>(N - k), mod);
    pivot = nmod_neg(nmod_mul(pivot, a0, mod), mod);
    u.push_back(nmod_div(row(k), pivot, mod));
  }
  return row(N) == 0;
}

bool defect_vanishes(const Poly& num, const Poly& den, const Poly& q, long N,
                     const Budget& budget) {
  const long terms_a = std::min(N + 3, degree(den) + 1);
  const long terms_b = std::min(N + 1, degree(num) + 1);
  const ResidueSeries a = taylor_at(den, q, terms_a);
  const ResidueSeries b = taylor_at(num, q, terms_b);
  KOV_ENSURE(is_zero(a.at(0)) && is_zero(a.at(1)) && !is_zero(a.at(2)));
  const Poly unit = inverse_mod(a[2], q);
  const long width = std::max(terms_a - 3, terms_b - 1);
  const auto at = [](const ResidueSeries& s, long i) {
    return i < static_cast<long>(s.size()) ? s[static_cast<std::size_t>(i)] : Poly(0);
  };
  ResidueSeries u{Poly(1)};
  const auto row = [&](long k) {
    budget.check();
    Poly sum(0);
    for (long j = 1; j <= std::min(k, width); ++j) {
      const Integer s(2 * (k - j) - N);
      const NfElem e(Rational(s * s - Integer(1), Integer(4)));
      sum += (at(b, j) - scale(at(a, j + 2), e)) * u[static_cast<std::size_t>(k - j)];
    }
    return sum % q;
  };
  for (long k = 1; k < N; ++k) {
    const NfElem pivot(Rational(Integer(1), Integer(k) * Integer(k - N)));
    u.push_back(scale(row(k) * unit % q, pivot));
  }
  return is_zero(row(N));
}

// The same at a rational place without a single division.  With P_k = 4 A_0 k (k-N) and
// U_k = u_k P_1 ... P_k the recurrence times P_1 ... P_{k-1} reads
//   U_k = sum_{j>=1} (4 B_j - A_j ((2(k-j)-N)^2 - 1)) P_{k-1} ... P_{k-j+1} U_{k-j}.
bool integer_defect_vanishes(const Poly& num, const Poly& den, const Poly& q, long N,
                             const Budget& budget) {
  const ResidueSeries a = taylor_at(den, q, std::min(N + 3, degree(den) + 1));
  const ResidueSeries b = taylor_at(num, q, std::min(N + 1, degree(num) + 1));
  KOV_ENSURE(is_zero(a.at(0)) && is_zero(a.at(1)) && !is_zero(a.at(2)));
  Integer common(1);
  for (const ResidueSeries* series : {&a, &b})
    for (const Poly& x : *series)
      common = lcm(common, to_rational(x.coeff(0)).den());
  const auto integers = [&common](const ResidueSeries& series, std::size_t from) {
    std::vector<Integer> v;
    for (std::size_t i = from; i < series.size(); ++i)
      v.push_back((to_rational(series[i].coeff(0)) * Rational(common)).num());
    return v;
  };
  const std::vector<Integer> A = integers(a, 2);
  const std::vector<Integer> B = integers(b, 0);
  const long width = static_cast<long>(std::max(A.size(), B.size())) - 1;
  const auto at = [](const std::vector<Integer>& v, long i) {
    return i < static_cast<long>(v.size()) ? v[static_cast<std::size_t>(i)] : Integer(0);
  };
  const Integer pivot = Integer(4) * A.front();
  std::vector<Integer> U{Integer(1)};
  for (long k = 1; k <= N; ++k) {
    budget.check();
    Integer sum(0);
    Integer pivots(1);
    for (long j = 1; j <= std::min(k, width); ++j) {
      const Integer s(2 * (k - j) - N);
      const Integer weight = Integer(4) * at(B, j) - at(A, j) * (s * s - Integer(1));
      sum += weight * pivots * U[static_cast<std::size_t>(k - j)];
      pivots *= pivot * Integer(k - j) * Integer(k - j - N);
    }
    U.push_back(std::move(sum));
  }
  return is_zero(U.back());
}

} // namespace

Truth has_logarithm(const Poly& num, const Poly& den, const Poly& q, long N, const Budget& budget) {
  KOV_ENSURE(N >= 0);
  if (N == 0) return Truth::yes;
  if (N > budget.max_degree) return Truth::unknown;
  PrimeIdeals primes = PrimeIdeals::large(common_field(num.field(), den.field()));
  // small cases are decided exactly in the time that a prime takes
  if (N > 4 || degree(den) > 16)
    for (int tries = 0; tries < 60; ++tries) {
      const auto vanishes = defect_vanishes_modulo(primes.next(), num, den, q, N);
      if (!vanishes) continue;
      if (!*vanishes) return Truth::yes;
      break; // zero modulo one prime proves nothing
    }
  if (N * degree(q) > 4000) return Truth::unknown;
  const bool rational = num.field()->is_rational() && den.field()->is_rational() &&
                        q.field()->is_rational() && degree(q) == 1;
  return truth(!(rational ? integer_defect_vanishes : defect_vanishes)(num, den, q, N, budget));
}

} // namespace kov
