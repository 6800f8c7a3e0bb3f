#include "monodromy/stokes.hpp"

#include "exact/error.hpp"
#include "monodromy/bessel_crossings.hpp"
#include "monodromy/imprecise.hpp"

#include <acb_hypgeom.h>

#include <algorithm>
#include <functional>

namespace kov::monodromy {
namespace {

constexpr long stokes_spare_bits = 64;
constexpr long most_stokes_bits = 1L << 18;

// ---- the families

// r in x = z - centre: the coefficients of x^-2, ..., x^2.
struct Canonical {
  NfElem centre;
  std::vector<NfElem> coefficient = std::vector<NfElem>(5, NfElem(0));
  [[nodiscard]] const NfElem& at(long power) const {
    return coefficient[static_cast<std::size_t>(power + 2)];
  }
  [[nodiscard]] std::string family() const {
    return !is_zero(at(2)) ? "Weber" : !is_zero(at(1)) ? "Airy" : "Whittaker";
  }
};

// The centre makes the second coefficient 0; with a pole it is the pole.
std::optional<Canonical> canonical(const RationalFunction& r) {
  const long pole = degree(r.den()), top = degree(r.num());
  if (pole > 2 || top - pole > 2 || top < pole) return std::nullopt;
  if (pole > 0 && top != pole) return std::nullopt;
  if (pole == 0 && top == 0) return std::nullopt; // constant coefficients
  Canonical c;
  if (pole > 0)
    c.centre = -r.den().coeff(pole - 1) / NfElem(pole);
  else
    c.centre = -r.num().coeff(top - 1) / (NfElem(top) * r.num().coeff(top));
  const RationalFunction x = RationalFunction(Poly::z()) + RationalFunction(Poly(c.centre));
  const RationalFunction moved = compose(r, x) * RationalFunction(Poly::z() * Poly::z());
  if (degree(moved.den()) > 0) return std::nullopt;
  const NfElem unit = moved.den().coeff(0);
  for (long k = 0; k <= degree(moved.num()); ++k)
    c.coefficient[static_cast<std::size_t>(k)] = moved.num().coeff(k) / unit;
  return c;
}

class Connection {
public:
  Connection(const Canonical& c, const Point& base, long bits) : n_{bits}, c_(c) {
    x_ = n_.minus(exact(base), n_.of(c.centre));
  }

  [[nodiscard]] Crossings crossings() {
    const std::string family = c_.family();
    return family == "Airy" ? airy() : family == "Weber" ? weber() : whittaker();
  }

private:
  // 10.2: Ai(w^-k xi), xi = a^(1/3) x, w = exp(2 pi i/3).
  Crossings airy() {
    scale_ = n_.root(n_.of(c_.at(1)), 3);
    Crossings out{{}, n_.integer(0)};
    for (long k = 0; k < 3; ++k) {
      const ComplexBall turned = n_.root_of_unity(-k, 3);
      const ComplexBall xi = n_.times(turned, n_.times(scale_, x_));
      Value v;
      acb_hypgeom_airy(v.y.raw(), v.slope.raw(), nullptr, nullptr, xi.raw(), n_.bits);
      const ComplexBall one_over_two_pi = n_.over(n_.integer(1), n_.times(n_.integer(2), n_.pi()));
      out.all.push_back({angle(2 * k, 3), v, n_.times(turned, scale_), one_over_two_pi,
                         n_.minus(n_.integer(0), n_.i()), n_.root_of_unity(1, 12)});
    }
    return out;
  }

  // 10.3: D_(-a-1/2)(i^-k xi), a by turns with both signs, xi = (4 u)^(1/4) x.
  Crossings weber() {
    const ComplexBall u = n_.of(c_.at(2));
    scale_ = n_.root(n_.times(n_.integer(4), u), 4);
    const ComplexBall a = n_.over(n_.of(c_.at(0)), n_.times(scale_, scale_));
    Crossings out{{}, n_.twice_cos_pi(n_.plus(n_.integer(1), n_.times(n_.integer(2), a)))};
    for (long k = 0; k < 4; ++k) {
      const ComplexBall here = k % 2 == 0 ? a : n_.minus(n_.integer(0), a);
      const ComplexBall turned = n_.root_of_unity(-k, 4);
      const ComplexBall xi = n_.times(turned, n_.times(scale_, x_));
      const ComplexBall half = n_.half(n_.integer(1));
      const ComplexBall constant = n_.times(n_.i(), n_.root(n_.times(n_.integer(2), n_.pi()), 2));
      const ComplexBall multiplier = n_.times(constant, n_.reciprocal_gamma(n_.minus(half, here)));
      out.all.push_back({angle(2 * k, 4), parabolic_cylinder(here, xi), n_.times(turned, scale_),
                         n_.integer(1), n_.minus(n_.integer(0), multiplier),
                         n_.turn(n_.half(n_.minus(n_.half(n_.integer(1)), here)))});
    }
    return out;
  }

  // U(a, xi) = D_nu(xi) = 2^(-nu/2) exp(-xi^2/4) H_nu(xi/sqrt 2), D_nu' = xi/2 D_nu - D_(nu+1).
  [[nodiscard]] Value parabolic_cylinder(const ComplexBall& a, const ComplexBall& xi) const {
    const ComplexBall nu = n_.minus(n_.half(n_.integer(-1)), a);
    Value v;
    v.y = hermite(nu, xi);
    v.slope = n_.minus(n_.times(n_.half(xi), v.y), hermite(n_.plus(nu, n_.integer(1)), xi));
    return v;
  }
  [[nodiscard]] ComplexBall hermite(const ComplexBall& nu, const ComplexBall& xi) const {
    ComplexBall h;
    const ComplexBall argument = n_.over(xi, n_.root(n_.integer(2), 2));
    acb_hypgeom_hermite_h(h.raw(), nu.raw(), argument.raw(), n_.bits);
    const ComplexBall quarter = n_.half(n_.half(n_.times(xi, xi)));
    const ComplexBall two = n_.power(n_.integer(2), n_.half(nu));
    return n_.over(n_.times(n_.exp(n_.minus(n_.integer(0), quarter)), h), two);
  }

  // 10.4: xi = 2 sqrt(a) x with -pi < arg xi <= 0 at the base.
  Crossings whittaker() {
    const ComplexBall root = n_.root(n_.of(c_.at(0)), 2);
    scale_ = n_.plus(root, root);
    if (!below(n_.times(scale_, x_))) scale_ = n_.minus(n_.integer(0), scale_);
    const ComplexBall xi = n_.times(scale_, x_);
    if (!below(xi)) throw Imprecise("the base cannot be told from a Stokes direction");
    const ComplexBall kappa = n_.over(n_.minus(n_.integer(0), n_.of(c_.at(-1))), scale_);
    const ComplexBall mu = n_.root(n_.of(c_.at(-2) + NfElem(Rational(1, 4))), 2);
    const ComplexBall minus_kappa = n_.minus(n_.integer(0), kappa);
    const ComplexBall first = multiplier(kappa, mu);
    const ComplexBall second =
        n_.times(n_.turn(n_.plus(kappa, kappa)), multiplier(minus_kappa, mu));
    const Value w = whittaker_w(kappa, mu, xi);
    Value v = whittaker_w(minus_kappa, mu, n_.minus(n_.integer(0), xi));
    const ComplexBall factor = n_.turn(kappa); // v+ = exp(pi i kappa) W_-kappa(exp(pi i) xi)
    v.y = n_.minus(n_.times(factor, v.y), n_.times(first, w.y));
    v.slope = n_.minus(n_.integer(0), n_.plus(n_.times(factor, v.slope), n_.times(first, w.slope)));
    Crossings out{{}, n_.twice_cos_pi(n_.plus(kappa, kappa))};
    out.all.push_back({angle(0, 1), w, scale_, n_.integer(1), n_.minus(n_.integer(0), first)});
    out.all.push_back({angle(1, 1), v, scale_, n_.integer(-1), n_.minus(n_.integer(0), second)});
    return out;
  }

  // Does xi lie in the lower half plane, or is it exactly positive?
  static bool below(const ComplexBall& xi) {
    const arb_struct* im = acb_imagref(xi.raw());
    return arb_is_negative(im) != 0 ||
           (arb_is_zero(im) != 0 && arb_is_positive(acb_realref(xi.raw())) != 0);
  }

  // 2 pi i/(Gamma(1/2 + mu + kappa) Gamma(1/2 - mu + kappa))
  [[nodiscard]] ComplexBall multiplier(const ComplexBall& kappa, const ComplexBall& mu) const {
    const ComplexBall middle = n_.plus(n_.half(n_.integer(1)), kappa);
    return n_.times(n_.times(n_.times(n_.integer(2), n_.pi()), n_.i()),
                    n_.times(n_.reciprocal_gamma(n_.plus(middle, mu)),
                             n_.reciprocal_gamma(n_.minus(middle, mu))));
  }

  // W = exp(-xi/2) xi^c U(c - kappa, 2 c, xi), c = mu + 1/2; principal branch.
  [[nodiscard]] Value whittaker_w(const ComplexBall& kappa, const ComplexBall& mu,
                                  const ComplexBall& xi) const {
    const ComplexBall c = n_.plus(mu, n_.half(n_.integer(1)));
    const ComplexBall a = n_.minus(c, kappa), b = n_.plus(c, c);
    const ComplexBall one = n_.integer(1);
    const ComplexBall u = tricomi(a, b, xi);
    const ComplexBall u_slope = n_.times(a, tricomi(n_.plus(a, one), n_.plus(b, one), xi));
    const ComplexBall front =
        n_.times(n_.exp(n_.half(n_.minus(n_.integer(0), xi))), n_.power(xi, c));
    const ComplexBall log_slope = n_.minus(n_.over(c, xi), n_.half(one));
    return {n_.times(front, u), n_.times(front, n_.minus(n_.times(log_slope, u), u_slope))};
  }
  [[nodiscard]] ComplexBall tricomi(const ComplexBall& a, const ComplexBall& b,
                                    const ComplexBall& xi) const {
    ComplexBall u;
    acb_hypgeom_u(u.raw(), a.raw(), b.raw(), xi.raw(), n_.bits);
    return u;
  }

  // arg x where arg xi = pi k/m
  [[nodiscard]] Ball angle(long k, long m) const {
    Ball of_scale, turned;
    acb_arg(of_scale.raw(), scale_.raw(), n_.bits);
    arb_const_pi(turned.raw(), n_.bits);
    arb_mul_si(turned.raw(), turned.raw(), k, n_.bits);
    arb_div_si(turned.raw(), turned.raw(), m, n_.bits);
    arb_sub(turned.raw(), turned.raw(), of_scale.raw(), n_.bits);
    return turned;
  }

  Numbers n_;
  const Canonical& c_;
  ComplexBall x_, scale_;
};

// A family, and what its closed formulas say at a base to a precision.
struct Solved {
  std::string family;
  std::function<Crossings(const Point&, long)> at;
};

std::optional<Solved> solved(const RationalFunction& r) {
  if (const auto c = canonical(r))
    return Solved{c->family(), [c = *c](const Point& base, long bits) {
                    return Connection(c, base, bits).crossings();
                  }};
  if (const auto e = bessel_equation(r))
    return Solved{"Bessel", [e = *e](const Point& base, long bits) {
                    return bessel_crossings(e, base, bits);
                  }};
  return std::nullopt;
}

// 1 + multiplier/(R D' - R' D) (R, R') (-R', R)
BallMatrix matrix_of(const Crossing& c, const Numbers& n) {
  const ComplexBall& y = c.recessive.y;
  const ComplexBall slope = n.times(c.recessive.slope, c.slope_factor);
  const ComplexBall factor = n.over(c.multiplier, n.times(c.wronskian, c.slope_factor));
  const ComplexBall product = n.times(factor, n.times(y, slope));
  const ComplexBall one = n.integer(1);
  BallMatrix s(2);
  acb_set(s.entry(0, 0), n.minus(one, product).raw());
  acb_set(s.entry(0, 1), n.times(factor, n.times(y, y)).raw());
  acb_set(s.entry(1, 0), n.times(n.integer(-1), n.times(factor, n.times(slope, slope))).raw());
  acb_set(s.entry(1, 1), n.plus(one, product).raw());
  return s;
}

// (y, y') of y = u exp(-1/2 int p), from (u, u').
BallMatrix with_first_derivative(const BallMatrix& s, const RationalFunction& p, const Point& base,
                                 const Numbers& n) {
  if (is_zero(p)) return s;
  const ComplexBall half_p = n.half(
      n.over(evaluate(p.num(), exact(base), n.bits), evaluate(p.den(), exact(base), n.bits)));
  BallMatrix l = BallMatrix::identity(2);
  acb_neg(l.entry(1, 0), half_p.raw());
  return multiply(multiply(l, s, n.bits), inverse(l, n.bits), n.bits);
}

// D above - D below = multiplier R, from values of three solutions at the base.
void ensure_crossings(const std::vector<Crossing>& all, const Numbers& n) {
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (!all[k].phase) continue;
    const ComplexBall& below = all[(k + all.size() - 1) % all.size()].recessive.y;
    const ComplexBall& above = all[(k + 1) % all.size()].recessive.y;
    const ComplexBall jump = n.minus(n.over(above, *all[k].phase), n.times(below, *all[k].phase));
    if (acb_overlaps(jump.raw(), n.times(all[k].multiplier, all[k].recessive.y).raw()) == 0)
      throw InternalError("a Stokes matrix fails its self-test: the connection formula");
  }
}

// tr(M S_n ... S_1) is the trace of the formal monodromy, M once around infinity (10.5).
void ensure_connected(const Stokes& s, const Crossings& c, const std::optional<BallMatrix>& around,
                      long bits) {
  BallMatrix product = BallMatrix::identity(2);
  for (const StokesMatrix& x : s.matrices)
    product = multiply(x.matrix, product, bits);
  if (around) product = multiply(*around, product, bits);
  if (acb_overlaps(trace(product, bits).raw(), c.formal_trace.raw()) == 0)
    throw InternalError("the Stokes matrices fail their self-test: the formal monodromy");
}

Ball ball_radius(const ComplexBall& z) {
  BallMatrix m(1);
  acb_set(m.entry(0, 0), z.raw());
  return largest_radius(m);
}

bool is_within(const Ball& radius, const Ball& bound) {
  return arb_is_finite(radius.raw()) != 0 && arb_le(radius.raw(), bound.raw()) != 0;
}

bool accurate(const Stokes& s, long digits) {
  Ball bound;
  arb_set_si(bound.raw(), 10);
  arb_pow_ui(bound.raw(), bound.raw(), static_cast<ulong>(digits), 64);
  arb_inv(bound.raw(), bound.raw(), 64);
  return std::ranges::all_of(s.matrices, [&](const StokesMatrix& m) {
    return is_within(largest_radius(m.matrix), bound) &&
           is_within(ball_radius(m.multiplier), bound);
  });
}

} // namespace

std::optional<Stokes> stokes_at_infinity(const RationalFunction& p, const RationalFunction& q,
                                         const Point& base, const Request& request) {
  const RationalFunction r = normal_form(p, q).r;
  const auto equation = solved(r);
  if (!equation) return std::nullopt;
  std::optional<BallMatrix> around; // of y'' = r y
  if (degree(r.den()) > 0) {
    const Monodromy m = monodromy(RationalFunction(0), -r, {request.digits, base, request.budget});
    around = m.loops.at(0).matrix;
  }
  for (long bits = request.digits * 4 + stokes_spare_bits; bits < most_stokes_bits; bits *= 2) {
    request.budget.check();
    try {
      const Numbers n{bits};
      const Crossings crossings = equation->at(base, bits);
      Stokes s{equation->family, {}, {}};
      for (const Crossing& x : crossings.all)
        s.matrices.push_back({x.angle, x.multiplier, matrix_of(x, n)});
      ensure_crossings(crossings.all, n);
      ensure_connected(s, crossings, around, bits);
      for (StokesMatrix& x : s.matrices)
        x.matrix = with_first_derivative(x.matrix, p, base, n);
      if (!accurate(s, request.digits)) continue;
      s.self_tests.emplace_back(around ? "once around infinity, monodromy and Stokes matrices are "
                                         "together the formal monodromy"
                                       : "the Stokes matrices are together the formal monodromy");
      return s;
    } catch (const Imprecise&) {
      continue; // with twice the bits
    }
  }
  throw OutOfBudget("the Stokes matrices could not be computed to " +
                    std::to_string(request.digits) + " digits");
}

} // namespace kov::monodromy
