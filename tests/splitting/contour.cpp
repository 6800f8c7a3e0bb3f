#include "contour.hpp"

#include "exact/error.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace kov {
namespace {

using Balls = std::map<std::size_t, ComplexBall>;

ComplexBall of_rational(const Rational& q, long bits) {
  ComplexBall x;
  acb_set_fmpq(x.raw(), q.raw(), bits);
  return x;
}

// Arithmetic at a fixed precision.
struct Arithmetic {
  long bits;
  [[nodiscard]] ComplexBall add(const ComplexBall& a, const ComplexBall& b) const {
    ComplexBall c;
    acb_add(c.raw(), a.raw(), b.raw(), bits);
    return c;
  }
  [[nodiscard]] ComplexBall sub(const ComplexBall& a, const ComplexBall& b) const {
    ComplexBall c;
    acb_sub(c.raw(), a.raw(), b.raw(), bits);
    return c;
  }
  [[nodiscard]] ComplexBall mul(const ComplexBall& a, const ComplexBall& b) const {
    ComplexBall c;
    acb_mul(c.raw(), a.raw(), b.raw(), bits);
    return c;
  }
  [[nodiscard]] ComplexBall div(const ComplexBall& a, const ComplexBall& b) const {
    ComplexBall c;
    acb_div(c.raw(), a.raw(), b.raw(), bits);
    return c;
  }
  [[nodiscard]] ComplexBall root(const Rational& q) const {
    ComplexBall c = of_rational(q, bits);
    acb_sqrt(c.raw(), c.raw(), bits);
    return c;
  }
  [[nodiscard]] ComplexBall times_i(ComplexBall a) const {
    acb_mul_onei(a.raw(), a.raw());
    return a;
  }
  [[nodiscard]] ComplexBall number(long n) const { return of_rational(Rational(n), bits); }
};

ComplexBall evaluate_poly(const MPoly& f, const Balls& at, long bits) {
  const Arithmetic ar{bits};
  ComplexBall sum, power;
  for (long t = 0; t < f.length(); ++t) {
    ComplexBall term = of_rational(Rational(f.coefficient(t)), bits);
    const auto e = f.exponents(t);
    for (std::size_t j = 0; j < e.size(); ++j)
      if (e[j] != 0) {
        acb_pow_ui(power.raw(), at.at(j).raw(), e[j], bits);
        term = ar.mul(term, power);
      }
    sum = ar.add(sum, term);
  }
  return sum;
}

/// h_k(t) on one orbit.
class Mode {
public:
  Mode(const EulerPerturbation& p, const OrbitPoint& at, long k, int sign);
  [[nodiscard]] ComplexBall operator()(const ComplexBall& t, long bits) const;
  [[nodiscard]] long degree() const { return degree_; } ///< of H1 in M and Gamma

private:
  const EulerPerturbation& p_;
  const OrbitPoint& at_;
  MFraction first_; ///< H1 with numbers for all parameters
  long k_;
  int sign_;
  long degree_ = 0, samples_ = 1;
};

Mode::Mode(const EulerPerturbation& p, const OrbitPoint& at, long k, int sign)
    : p_(p), at_(at), k_(k), sign_(sign) {
  const Ring& r = p.first.ring();
  const std::array<const Rational*, 3> inverse{&at.a, &at.b, &at.c};
  Substitution values;
  for (std::size_t j = 0; j < 3; ++j)
    for (const std::size_t v : used_variables(p.inverse_inertia[j])) {
      const bool reciprocal = !is_constant(MFraction(p.inverse_inertia[j].den()));
      values[v] = MFraction(r, reciprocal ? Rational(1) / *inverse[j] : *inverse[j]);
    }
  for (const auto& [name, value] : at.parameters)
    values[r->index(name)] = MFraction(r, value);
  first_ = substitute(p.first, values);
  for (long t = 0; t < first_.num().length(); ++t) {
    long in_gamma = 0, total = 0;
    const auto e = first_.num().exponents(t);
    for (std::size_t j = 0; j < 6; ++j) {
      total += static_cast<long>(e[p.coordinates[j]]);
      if (j >= 3) in_gamma += static_cast<long>(e[p.coordinates[j]]);
    }
    samples_ = std::max(samples_, 2 * in_gamma + 1);
    degree_ = std::max(degree_, total);
  }
}

struct Frame {
  std::array<ComplexBall, 3> momentum, rotating, counter; ///< M, E, E*
};

Frame frame_at(const OrbitPoint& at, int sign, const ComplexBall& t, long bits) {
  const Arithmetic ar{bits};
  const ComplexBall alpha = ar.root(at.b - at.a), beta = ar.root(at.c - at.b);
  const ComplexBall delta = ar.root(at.c - at.a), g = of_rational(at.G, bits);
  const ComplexBall lt = ar.mul(ar.mul(ar.mul(g, alpha), beta), t), sigma = ar.number(sign);
  ComplexBall sech, tanh;
  acb_sech(sech.raw(), lt.raw(), bits);
  acb_tanh(tanh.raw(), lt.raw(), bits);
  Frame f;
  f.momentum = {ar.mul(g, ar.mul(ar.div(beta, delta), sech)),
                ar.mul(ar.mul(ar.number(-sign), g), tanh),
                ar.mul(sigma, ar.mul(g, ar.mul(ar.div(alpha, delta), sech)))};
  const auto turning = [&](int s) {
    const ComplexBall i = ar.times_i(ar.number(s));
    ComplexBall e;
    acb_exp(e.raw(), ar.mul(ar.mul(i, of_rational(at.G * at.b, bits)), t).raw(), bits);
    const ComplexBall first = ar.add(alpha, ar.mul(ar.mul(i, beta), tanh));
    const ComplexBall third = ar.add(ar.mul(alpha, tanh), ar.mul(i, beta));
    return std::array<ComplexBall, 3>{ar.mul(e, ar.div(ar.mul(ar.mul(i, sigma), first), delta)),
                                      ar.mul(e, ar.sub({}, sech)),
                                      ar.mul(e, ar.sub({}, ar.div(third, delta)))};
  };
  f.rotating = turning(1);
  f.counter = turning(-1);
  return f;
}

// (1/N) sum_j H1(M, Gamma(g0 = 2 pi j/N)) e^(-2 pi i j k/N).
ComplexBall Mode::operator()(const ComplexBall& t, long bits) const {
  const Arithmetic ar{bits};
  const Frame f = frame_at(at_, sign_, t, bits);
  const ComplexBall along = of_rational(at_.F / (at_.G * at_.G), bits);
  const ComplexBall across =
      ar.div(ar.root(at_.G * at_.G - at_.F * at_.F), of_rational(Rational(2) * at_.G, bits));
  const auto turn = [&](long n) { // e^(2 pi i n/N)
    ComplexBall w;
    const Rational q(Integer(2 * n), Integer(samples_));
    arb_sin_cos_pi_fmpq(acb_imagref(w.raw()), acb_realref(w.raw()), q.raw(), bits);
    return w;
  };
  Balls values;
  ComplexBall sum;
  for (long j = 0; j < samples_; ++j) {
    const ComplexBall forth = turn(j), back = turn(-j);
    for (std::size_t n = 0; n < 3; ++n) {
      values[p_.coordinates[n]] = f.momentum[n];
      values[p_.coordinates[n + 3]] =
          ar.add(ar.mul(along, f.momentum[n]),
                 ar.mul(across, ar.add(ar.mul(forth, f.rotating[n]), ar.mul(back, f.counter[n]))));
    }
    sum = ar.add(sum, ar.mul(turn(-j * k_), evaluate(first_, values, bits)));
  }
  return ar.div(sum, ar.number(samples_));
}

ComplexBall pi_ball(long bits) {
  ComplexBall pi;
  arb_const_pi(acb_realref(pi.raw()), bits);
  return pi;
}

/// A contour |t - centre| = radius.
struct Circle {
  ComplexBall centre, radius;
  /// The point at angle 2 pi q, or the arc of half-width 2^-m around it.
  [[nodiscard]] ComplexBall step(const Rational& q, std::optional<long> m, long bits) const {
    ComplexBall angle = of_rational(Rational(2) * q, bits);
    if (m) mag_set_ui_2exp_si(arb_radref(acb_realref(angle.raw())), 1, 1 - *m);
    acb_exp_pi_i(angle.raw(), angle.raw(), bits);
    return Arithmetic{bits}.mul(radius, angle);
  }
};

// The residue of h at the centre.
ComplexBall residue_by_trapezia(const Mode& h, const Circle& inner, const Circle& outer,
                                long ratio_bits, long bits) {
  const Arithmetic ar{bits};
  const long points = bits / ratio_bits + 1;
  KOV_ENSURE(points > h.degree()); // so that no term with j < 0 is left
  ComplexBall sum;
  for (long j = 0; j < points; ++j) {
    const ComplexBall step = inner.step(Rational(Integer(j), Integer(points)), {}, bits);
    sum = ar.add(sum, ar.mul(step, h(ar.add(inner.centre, step), bits)));
  }
  sum = ar.div(sum, ar.number(points));
  // the maximum on the outer circle, over 2^6 arcs
  arb_t most, one, size;
  arb_init(most);
  arb_init(one);
  arb_init(size);
  for (long j = 0; j < 64; ++j) {
    const ComplexBall arc = outer.step(Rational(Integer(j), Integer(64)), 7, 64);
    acb_abs(one, h(ar.add(outer.centre, arc), 64).raw(), 64);
    arb_max(most, most, one, 64);
  }
  // error <= most * rho * q/(1 - q), q = 2^(-ratio_bits * points) <= 1/2
  acb_abs(size, outer.radius.raw(), 64);
  arb_mul(most, most, size, 64);
  arb_mul_2exp_si(most, most, 1 - ratio_bits * points);
  mag_t error;
  mag_init(error);
  arb_get_mag(error, most);
  arb_add_error_mag(acb_realref(sum.raw()), error);
  arb_add_error_mag(acb_imagref(sum.raw()), error);
  mag_clear(error);
  arb_clear(most);
  arb_clear(one);
  arb_clear(size);
  return sum;
}

} // namespace

ComplexBall evaluate(const MFraction& f, const std::map<std::size_t, ComplexBall>& at, long bits) {
  if (is_zero(f)) return {};
  return Arithmetic{bits}.div(evaluate_poly(f.num(), at, bits), evaluate_poly(f.den(), at, bits));
}

std::map<std::size_t, ComplexBall> values_at(const Ring& ring, const OrbitPoint& at, long bits) {
  const Arithmetic ar{bits};
  Balls values;
  const auto put = [&](const char* name, const ComplexBall& x) { values[ring->index(name)] = x; };
  const ComplexBall alpha = ar.root(at.b - at.a), beta = ar.root(at.c - at.b);
  put("alpha", alpha);
  put("beta", beta);
  put("delta", ar.root(at.c - at.a));
  put("b", of_rational(at.b, bits));
  put("G", of_rational(at.G, bits));
  put("F", of_rational(at.F, bits));
  put("s", ar.root(at.G * at.G - at.F * at.F));
  put("i", ar.times_i(ar.number(1)));
  ComplexBall y;
  arb_const_pi(acb_realref(y.raw()), bits);
  y = ar.mul(ar.mul(ar.number(-1), y), ar.div(of_rational(at.b, bits), ar.mul(alpha, beta)));
  acb_exp(y.raw(), y.raw(), bits);
  put("Y", y);
  for (const auto& [name, value] : at.parameters)
    put(name.c_str(), of_rational(value, bits));
  return values;
}

ComplexBall strip_integral(const EulerPerturbation& p, const OrbitPoint& at, long k, int sign,
                           long bits) {
  const Arithmetic ar{bits};
  const Mode h(p, at, k, sign);
  const ComplexBall nu =
      ar.div(of_rational(at.b, bits), ar.mul(ar.root(at.b - at.a), ar.root(at.c - at.b)));
  const ComplexBall lambda =
      ar.mul(of_rational(at.G, bits), ar.mul(ar.root(at.b - at.a), ar.root(at.c - at.b)));
  const ComplexBall unit = ar.div(pi_ball(bits), lambda); // the distance of the poles
  const auto part = [&](long n, long d) {
    return ar.mul(unit, of_rational({Integer(n), Integer(d)}, bits));
  };
  ComplexBall sum;
  for (const long pole : {1L, 3L}) {
    const ComplexBall centre = ar.times_i(part(pole, 2));
    const Circle inner{centre, part(3, 64)}, outer{centre, part(3, 4)}; // ratio 2^4
    sum = ar.add(sum, residue_by_trapezia(h, inner, outer, 4, bits));
  }
  ComplexBall shift =
      ar.mul(ar.mul(pi_ball(bits), nu), of_rational({Integer(k), Integer(2)}, bits));
  acb_exp(shift.raw(), shift.raw(), bits); // X^(k/2)
  return ar.mul(shift, sum);
}

} // namespace kov
