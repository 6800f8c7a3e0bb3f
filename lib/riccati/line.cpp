#include "riccati/line.hpp"

#include "exact/error.hpp"

#include <algorithm>

namespace kov {

int formal_lines(const Singularity& s) {
  switch (s.kind) {
  case PlaceKind::ordinary:
    return -1;
  case PlaceKind::simple:
    return 1;
  case PlaceKind::regular:
    if (s.log == Truth::yes) return 1;
    return s.delta && is_integer(*s.delta) ? -1 : 2;
  case PlaceKind::irregular:
    return 2;
  case PlaceKind::ramified:
    return 0;
  }
  throw InternalError("unknown kind of place");
}

namespace {

NmodPoly shift_right(const NmodPoly& f, long k) {
  NmodPoly g(f.modulus());
  nmod_poly_shift_right(g.raw(), f.raw(), k);
  return g;
}

NmodPoly shift_left(const NmodPoly& f, long k) {
  NmodPoly g(f.modulus());
  nmod_poly_shift_left(g.raw(), f.raw(), k);
  return g;
}

NmodPoly reversed(const NmodPoly& f) {
  NmodPoly g(f.modulus());
  nmod_poly_reverse(g.raw(), f.raw(), degree(f) + 1);
  return g;
}

// Sets a, b, order; false when a leading coefficient or the order of the pole changes modulo p.
bool set_local_equation(ModularPlace& m, const Singularities& s, const Singularity& place) {
  const auto num = m.prime.reduce(s.r.num());
  const auto den = m.prime.reduce(s.r.den());
  if (!num || !den) return false;
  if (place.at_infinity) {
    if (degree(*num) != degree(s.r.num()) || degree(*den) != degree(s.r.den())) return false;
    m.at_infinity = true;
    m.order = 4 - place.order; // y = w/t turns r into r(1/t)/t^4
    m.a = reversed(*den);
    m.b = reversed(*num);
    return true;
  }
  const auto q = m.prime.reduce(place.place);
  if (!q) return false;
  const auto at = roots(*q);
  if (at.empty()) return false;
  m.root = at.front();
  m.order = place.order;
  const NmodPoly shifted = taylor_shift(*den, m.root);
  for (long i = 0; i < m.order; ++i)
    if (shifted.coeff(i) != 0) return false;
  if (shifted.coeff(m.order) == 0) return false;
  m.a = shift_right(shifted, m.order);
  m.b = taylor_shift(*num, m.root);
  return m.b.coeff(0) != 0 || m.order < 2;
}

std::optional<mp_limb_t> square_root(mp_limb_t x, mp_limb_t p) {
  if (x == 0) return 0;
  const mp_limb_t root = n_sqrtmod(x, p);
  if (root == 0) return std::nullopt;
  return root;
}

} // namespace

std::optional<ModularPlace> reduce_place(const Singularities& s, const Singularity& place,
                                         const PrimeIdeal& prime, long n) {
  const mp_limb_t p = prime.p;
  ModularPlace m{prime, 0, false, 0, NmodPoly(p), NmodPoly(p), 0};
  if (!set_local_equation(m, s, place)) return std::nullopt;
  const nmod_t mod = m.a.mod();
  const mp_limb_t u = nmod_div(m.b.coeff(0), m.a.coeff(0), mod);
  if (place.kind == PlaceKind::irregular) {
    const auto root = u == 0 ? std::nullopt : square_root(u, p);
    if (!root) return std::nullopt;
    m.delta = *root;
  } else if (place.kind == PlaceKind::regular) {
    std::optional<mp_limb_t> delta;
    if (place.delta)
      delta = prime.reduce(*place.delta);
    else
      delta = square_root(nmod_add(1, nmod_mul(4, u, mod), mod), p);
    if (!delta) return std::nullopt;
    m.delta = *delta;
    const bool plus_vanishes = p - m.delta < static_cast<mp_limb_t>(n) && m.delta != 0;
    const bool minus_vanishes = m.delta != 0 && m.delta < static_cast<mp_limb_t>(n);
    if (plus_vanishes || (minus_vanishes && formal_lines(place) == 2)) return std::nullopt;
  }
  return m;
}

namespace {

// Coefficients of sqrt(r)/a in t^(i - nu), 0 <= i < n.
NmodPoly unit_square_root(const ModularPlace& m, long n) {
  const nmod_t mod = m.a.mod();
  NmodPoly series = mul_series(m.b, inverse_series(m.a, n), n);
  series = scale(series, nmod_inv(series.coeff(0), mod));
  NmodPoly root(mod.n);
  nmod_poly_sqrt_series(root.raw(), series.raw(), n);
  return root;
}

// g with omega_0 = g/t^nu: the polar part of the line.
NmodPoly polar_part(const ModularPlace& m, int sign) {
  const nmod_t mod = m.a.mod();
  NmodPoly g(mod.n);
  const mp_limb_t half = nmod_inv(2, mod);
  if (m.order == 1) {
    g.set_coeff(0, 1);
  } else if (m.order == 2) {
    const mp_limb_t delta = sign > 0 ? m.delta : nmod_neg(m.delta, mod);
    g.set_coeff(0, nmod_mul(nmod_add(1, delta, mod), half, mod));
  } else {
    const long nu = m.nu();
    const mp_limb_t lead = sign > 0 ? m.delta : nmod_neg(m.delta, mod);
    g = scale(unit_square_root(m, nu), lead);
    // alpha = nu/2 + lead * s_(nu-1)
    const mp_limb_t alpha = nmod_addmul(g.coeff(nu - 1), static_cast<mp_limb_t>(nu), half, mod);
    g.set_coeff(nu - 1, alpha);
  }
  return g;
}

} // namespace

NmodPoly expand_line(const ModularPlace& m, int sign, long n) {
  const nmod_t mod = m.a.mod();
  const long nu = m.nu();
  const NmodPoly g = polar_part(m, sign);
  // y = exp(int omega_0) u:  t^(2nu) A u'' + 2 A g t^nu u' + C u = 0,
  // C = A (t^nu g' - nu t^(nu-1) g + g^2) - t^(2nu - order) B, divisible by t^nu.
  NmodPoly c = shift_left(derivative(g), nu);
  c = c - scale(shift_left(g, nu - 1), static_cast<mp_limb_t>(nu)) + g * g;
  c = m.a * c - shift_left(m.b, 2 * nu - m.order);
  for (long i = 0; i < nu; ++i)
    KOV_ENSURE(c.coeff(i) == 0);
  const ThetaEquation equation{shift_left(m.a, nu - 1), scale(m.a * g, 2), shift_right(c, nu - 1)};
  const NmodPoly u = power_series_solution(equation, {1}, n);
  // t^nu omega = g + t^nu u'/u
  const NmodPoly log_derivative = mul_series(derivative(u), inverse_series(u, n), n);
  NmodPoly series = g + shift_left(log_derivative, nu);
  nmod_poly_truncate(series.raw(), n);
  (void)mod;
  return series;
}

} // namespace kov
