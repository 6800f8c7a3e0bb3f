#include "flow/number/double_ball.hpp"

namespace kov::flow {

std::optional<DoubleBall> intersection(const DoubleBall& a, const DoubleBall& b) {
  if (!a.finite() || !b.finite()) return std::nullopt;
  if (a.inside(b)) return a;
  if (b.inside(a)) return b;
  const double low = std::fmax(a.low(), b.low()), high = std::fmin(a.high(), b.high());
  if (!(low <= high)) return std::nullopt;
  return DoubleBall::between(low, high);
}

std::optional<Enclosure> intersection(const Enclosure& a, const Enclosure& b) {
  if (arb_is_finite(a.raw()) == 0 || arb_is_finite(b.raw()) == 0) return std::nullopt;
  Enclosure both;
  if (arb_intersection(both.raw(), a.raw(), b.raw(), Enclosure::bits()) == 0) return std::nullopt;
  return both;
}

DoubleBall double_ball(const Enclosure& x) {
  const auto m = static_cast<double>(x);
  if (!std::isfinite(m)) return DoubleBall::unknown();
  const Enclosure off = x - Enclosure(m);
  mag_t most;
  mag_init(most);
  arb_get_mag(most, off.raw());
  const double r = mag_get_d(most);
  mag_clear(most);
  return {m, r == 0 ? 0 : DoubleBall::up(r)};
}

namespace {
Enclosure with_radius(const DoubleBall& x, void (*set)(mag_t, double)) {
  Enclosure e(x.mid());
  set(arb_radref(e.raw()), x.radius());
  return e;
}
} // namespace

Enclosure around(const DoubleBall& x) {
  if (x.finite()) return with_radius(x, mag_set_d);
  Enclosure all;
  arb_zero_pm_inf(all.raw());
  return all;
}

Enclosure within(const DoubleBall& x) {
  return x.finite() ? with_radius(x, mag_set_d_lower) : Enclosure(0);
}

// A series of duals is one of balls, three by three.
Dual<Enclosure> dot(const Dual<Enclosure>* a, const Dual<Enclosure>* b, int n) {
  static_assert(sizeof(Dual<Enclosure>) == 3 * sizeof(arb_struct));
  const auto add = [n](Enclosure& sum, const Enclosure& x, const Enclosure& y) {
    arb_dot(sum.raw(), sum.raw(), 0, x.raw(), 3, y.raw(), -3, n, Enclosure::bits());
  };
  Dual<Enclosure> sum;
  add(sum.v, a->v, b->v);
  for (int i = 0; i < 2; ++i) {
    add(sum.d[i], a->v, b->d[i]);
    add(sum.d[i], a->d[i], b->v);
  }
  return sum;
}

// With e = b.r + (2 n + 8) ulp |b.m| the sum of |a.m| e + a.r (|b.m| + b.r) bounds what the radii make and the rounding
// of all 2 n products and sums; it is made of 4 n + 10 roundings at most, for which the last factor has room.
Dual<DoubleBall> dot(const Dual<DoubleBall>* a, const Dual<DoubleBall>* b, int n) {
  const double rounding = (2.0 * n + 8) * DoubleBall::ulp;
  double m[3]{}, r[3]{};
  for (int j = 0; j < n; ++j) {
    const Dual<DoubleBall>&x = a[j], &y = b[-j];
    const double xv = x.v.mid(), xr = x.v.radius(), size = std::abs(xv);
    const double yv = y.v.mid(), yr = y.v.radius(), most = std::abs(yv) + yr,
                 error = yr + rounding * std::abs(yv);
    m[0] += xv * yv;
    r[0] += size * error + xr * most;
    for (int i = 0; i < 2; ++i) {
      const double yd = y.d[i].mid(), ys = y.d[i].radius(), xd = x.d[i].mid();
      m[i + 1] += xv * yd + xd * yv;
      r[i + 1] += (size * (ys + rounding * std::abs(yd)) + xr * (std::abs(yd) + ys)) +
                  (std::abs(xd) * error + x.d[i].radius() * most);
    }
  }
  const double room = 1 + (8.0 * n + 32) * DoubleBall::ulp;
  const auto ball = [&](int i) { return DoubleBall(m[i], r[i] * room + DoubleBall::smallest); };
  return {ball(0), ball(1), ball(2)};
}

} // namespace kov::flow
