// strata_certificates.md 7.3: the defect of Frobenius' recurrence as a polynomial in the
// parameters.
//
// At the root c = -b/l of q = l z + b write z = c + s/l.  Then t^2 r = kappa F(s)/G(s) with
// F = l^(deg num) num(c + s/l), G = l^(deg w) w(c + s/l), w = den/q^2, kappa = l^(deg w - deg num -
// 2), all polynomials; and F/G = sum beta_k s^k/G_0^(k+1), beta_k = F_k G_0^k - sum_(i>0) G_i
// G_0^(i-1) beta_(k-i).  So u_k = V_k/(g^k G_0^k prod_(i<=k) i(i-N)), g = G_0 kappa_-, kappa =
// kappa_+/kappa_-:
//   V_k = sum_(j<k) kappa_+ beta_(k-j) g^(k-j-1) prod_(j<i<k) i(i-N) V_j,
// and the defect is the same sum for k = N, up to powers of l and G_0.  (The powers of l by which s
// differs from t belong to u_k and do not matter.)  At infinity t = 1/z, F and G are num and den
// read backwards, kappa = 1.

#include "certify/strata/places.hpp"

namespace kov::certify {

namespace {

struct LogExpansion {
  Coefficients F, G;
  MPoly above, below; ///< kappa = above/below
};

MPoly at_or_zero(const Coefficients& f, std::size_t i) {
  return i < f.size() ? f[i] : MPoly(f.front().ring());
}

// l^deg f f((s - b)/l), to count coefficients in s: by Horner, from the top.
Coefficients shifted(Arithmetic& a, const MPoly& f, const MPoly& l, const MPoly& b,
                     std::size_t count) {
  const Coefficients c = coefficients(f, 0);
  Coefficients g(count, MPoly(f.ring()));
  MPoly power(f.ring(), Integer(1));
  for (std::size_t k = c.size(); k-- > 0;) {
    // g <- g (s - b) + c_k l^(n-k)
    for (std::size_t i = count; i-- > 0;) {
      MPoly v = a.times(g[i], -b);
      if (i > 0) v = a.plus(v, g[i - 1]);
      g[i] = std::move(v);
    }
    g[0] = a.plus(g[0], a.times(c[k], power));
    if (k > 0) power = a.times(power, l);
  }
  return g;
}

Coefficients backwards(const MPoly& f) {
  Coefficients c = coefficients(f, 0);
  return {c.rbegin(), c.rend()};
}

LogExpansion expand(const Stratum& s, const ProvedPlace& x, std::size_t count) {
  Arithmetic& a = s.arithmetic();
  const Fraction& r = s.r();
  const MPoly one(r.den.ring(), Integer(1));
  if (!x.q) return {backwards(r.num), backwards(r.den), one, one};
  const Coefficients q = coefficients(*x.q, 0);
  const MPoly w = without_pole(s, *x.q);
  const long kappa = degree(w, 0) - degree(r.num, 0) - 2;
  const MPoly power = a.power(q[1], static_cast<unsigned long>(std::abs(kappa)));
  return {shifted(a, r.num, q[1], q[0], count), shifted(a, w, q[1], q[0], count),
          kappa > 0 ? power : one, kappa > 0 ? one : power};
}

} // namespace

bool has_logarithm(const Stratum& s, const ProvedPlace& x) {
  Arithmetic& a = s.arithmetic();
  const auto N = static_cast<std::size_t>(to_long(x.delta->num()));
  const LogExpansion e = expand(s, x, N + 1);
  const MPoly& G0 = e.G[0];
  Coefficients G_power{MPoly(G0.ring(), Integer(1))};
  Coefficients beta;
  for (std::size_t k = 0; k <= N; ++k) {
    MPoly v = a.times(at_or_zero(e.F, k), G_power[k]);
    for (std::size_t i = 1; i <= k; ++i)
      v = a.minus(v, a.times(a.times(at_or_zero(e.G, i), G_power[i - 1]), beta[k - i]));
    beta.push_back(std::move(v));
    G_power.push_back(a.times(G_power.back(), G0));
  }
  const MPoly g = a.times(G0, e.below);
  Coefficients g_power{G_power[0]};
  Coefficients V{G_power[0]};
  for (std::size_t k = 1; k <= N; ++k) {
    MPoly sum(G0.ring());
    Integer numbers(1); // prod_(j<i<k) i(i-N)
    for (std::size_t j = k; j-- > 0;) {
      const MPoly term = a.times(a.times(beta[k - j], g_power[k - j - 1]), V[j]);
      sum = a.plus(sum, scaled(term, numbers));
      numbers *= Integer(j) * (Integer(j) - Integer(N));
    }
    V.push_back(a.times(sum, e.above));
    g_power.push_back(a.times(g_power.back(), g));
  }
  return s.is_unit(V[N]);
}

} // namespace kov::certify
