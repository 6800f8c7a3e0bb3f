#include "linode/modular_series.hpp"

#include "exact/error.hpp"
#include "exact/meter.hpp"

#include <algorithm>

namespace kov {
namespace {

std::vector<mp_limb_t> reversed_coefficients(const NmodPoly& f) {
  std::vector<mp_limb_t> c(static_cast<std::size_t>(degree(f) + 1));
  for (long i = degree(f); i >= 0; --i)
    c[static_cast<std::size_t>(degree(f) - i)] = f.coeff(i);
  return c;
}

// sum_{j>=1} f_j x_(k-j), with f given reversed
mp_limb_t tail_product(const std::vector<mp_limb_t>& reversed, const std::vector<mp_limb_t>& x,
                       long k, nmod_t mod, int limbs) {
  const long top = std::min(static_cast<long>(reversed.size()) - 1, k); // largest j
  if (top < 1) return 0;
  const mp_limb_t* f = reversed.data() + (static_cast<long>(reversed.size()) - 1 - top);
  return _nmod_vec_dot(f, x.data() + (k - top), top, mod, limbs);
}

} // namespace

NmodPoly power_series_solution(const ThetaEquation& equation, const std::vector<mp_limb_t>& initial,
                               long n) {
  const nmod_t mod = equation.c2.mod();
  KOV_ENSURE(static_cast<mp_limb_t>(n) < mod.n);
  const auto c2 = reversed_coefficients(equation.c2);
  const auto c1 = reversed_coefficients(equation.c1);
  const auto c0 = reversed_coefficients(equation.c0);
  const long longest = static_cast<long>(std::max({c2.size(), c1.size(), c0.size()}));
  const int limbs = _nmod_vec_dot_bound_limbs(longest + 1, mod);
  charge(static_cast<double>(n) * static_cast<double>(c2.size() + c1.size() + c0.size()) / 8);
  // u_k, k u_k and k(k-1) u_k side by side
  std::vector<mp_limb_t> x0(static_cast<std::size_t>(n));
  std::vector<mp_limb_t> x1(static_cast<std::size_t>(n));
  std::vector<mp_limb_t> x2(static_cast<std::size_t>(n));
  for (long k = 0; k < n; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const mp_limb_t k1 =
        nmod_mul(static_cast<mp_limb_t>(k), static_cast<mp_limb_t>(std::max(k - 1, 0L)), mod);
    if (i < initial.size()) {
      x0[i] = initial[i];
    } else {
      mp_limb_t sum = tail_product(c2, x2, k, mod, limbs);
      sum = nmod_add(sum, tail_product(c1, x1, k, mod, limbs), mod);
      sum = nmod_add(sum, tail_product(c0, x0, k, mod, limbs), mod);
      mp_limb_t pivot = nmod_mul(k1, equation.c2.coeff(0), mod);
      pivot = nmod_addmul(pivot, static_cast<mp_limb_t>(k), equation.c1.coeff(0), mod);
      pivot = nmod_add(pivot, equation.c0.coeff(0), mod);
      KOV_ENSURE(pivot != 0);
      x0[i] = sum == 0 ? 0 : nmod_neg(nmod_div(sum, pivot, mod), mod);
    }
    x1[i] = nmod_mul(static_cast<mp_limb_t>(k), x0[i], mod);
    x2[i] = nmod_mul(k1, x0[i], mod);
  }
  NmodPoly u(mod.n);
  nmod_poly_fit_length(u.raw(), n);
  std::ranges::copy(x0, u.raw()->coeffs);
  u.raw()->length = n;
  _nmod_poly_normalise(u.raw());
  return u;
}

Recurrence shortest_recurrence(const NmodPoly& series, long n) {
  nmod_berlekamp_massey_t bm;
  nmod_berlekamp_massey_init(bm, series.modulus());
  std::vector<mp_limb_t> points(static_cast<std::size_t>(n));
  for (long i = 0; i < n; ++i)
    points[static_cast<std::size_t>(i)] = series.coeff(i);
  nmod_berlekamp_massey_add_points(bm, points.data(), n);
  nmod_berlekamp_massey_reduce(bm);
  Recurrence r{0, NmodPoly(series.modulus())};
  nmod_poly_set(r.characteristic.raw(), nmod_berlekamp_massey_V_poly(bm));
  r.length = degree(r.characteristic);
  nmod_berlekamp_massey_clear(bm);
  return r;
}

} // namespace kov
