#include "monodromy/bessel_crossings.hpp"

#include "monodromy/imprecise.hpp"

#include <acb_hypgeom.h>

namespace kov::monodromy {
namespace {

constexpr long most_directions = 24;

class Bessel {
public:
  Bessel(const BesselEquation& e, const Point& base, long bits) : n_{bits}, e_(e) {
    x_ = n_.minus(exact(base), n_.of(e.centre));
    const NfElem square = NfElem(1) + NfElem(4) * e.c;
    order_ = n_.over(n_.root(n_.of(square), 2), n_.integer(e.n));
  }

  [[nodiscard]] Crossings crossings() {
    Crossings out{{}, formal_trace()};
    if (is_zero(e_.c) && e_.n > 1)
      entire(out);
    else
      multivalued(out);
    return out;
  }

private:
  // Once around infinity: x^(1/2) xi^(-1/2) exp(+-xi) has the factor -i^-n; n odd swaps both signs.
  [[nodiscard]] ComplexBall formal_trace() const {
    if (e_.n % 2 != 0) return n_.integer(0);
    return n_.integer(e_.n % 4 == 0 ? -2 : 2);
  }
  // -2 i cos(pi nu)
  [[nodiscard]] ComplexBall multiplier() const {
    return n_.minus(n_.integer(0), n_.times(n_.i(), n_.twice_cos_pi(order_)));
  }
  [[nodiscard]] ComplexBall half_pi(long k) const {
    return n_.half(n_.times(n_.integer(k), n_.pi()));
  }

  // No finite singularity: R_k = f(w^-k x), w = exp(2 pi i/n), f an entire function.
  void entire(Crossings& out) const {
    const ComplexBall quotient = n_.over(n_.of(e_.a), n_.integer(e_.n * e_.n));
    const ComplexBall root = n_.root(quotient, static_cast<ulong>(2 * e_.n));
    const ComplexBall phase = n_.times(n_.i(), n_.root_of_unity(-1, 2 * e_.n));
    for (long k = 0; k < e_.n; ++k) {
      const ComplexBall turned = n_.root_of_unity(-k, e_.n);
      out.all.push_back({angle(k), recessive(root, n_.times(turned, x_)), turned, half_pi(e_.n),
                         multiplier(), phase});
    }
  }

  // f = x^(1/2) K_nu = pi/(2 sin(pi nu)) (F_-/root - root x F_+), F_+- = 0F1(; 1 +- nu; s) divided
  // by Gamma(1 +- nu), s = a x^n/n^2.
  [[nodiscard]] Value recessive(const ComplexBall& root, const ComplexBall& x) const {
    const ComplexBall one = n_.integer(1), two = n_.integer(2);
    const ComplexBall s_slope =
        n_.over(n_.times(n_.of(e_.a), n_.to(x, static_cast<ulong>(e_.n - 1))), n_.integer(e_.n));
    const ComplexBall s = n_.over(n_.times(s_slope, x), n_.integer(e_.n));
    const ComplexBall factor = n_.over(half_pi(1), n_.sin_pi(order_));
    const ComplexBall minus = n_.over(factor, root), plus = n_.times(factor, root);
    const ComplexBall f_plus = limit_function(n_.plus(one, order_), s);
    Value v;
    v.y = n_.minus(n_.times(minus, limit_function(n_.minus(one, order_), s)),
                   n_.times(plus, n_.times(x, f_plus)));
    const ComplexBall first = n_.times(s_slope, limit_function(n_.minus(two, order_), s));
    const ComplexBall second = n_.times(s_slope, limit_function(n_.plus(two, order_), s));
    v.slope =
        n_.minus(n_.times(minus, first), n_.times(plus, n_.plus(f_plus, n_.times(x, second))));
    return v;
  }
  // 0F1(; b; s)/Gamma(b), of derivative 0F1(; b + 1; s)/Gamma(b + 1)
  [[nodiscard]] ComplexBall limit_function(const ComplexBall& b, const ComplexBall& s) const {
    ComplexBall f;
    acb_hypgeom_0f1(f.raw(), b.raw(), s.raw(), 1, n_.bits);
    return f;
  }

  // R_k = x^(1/2) (exp(pi i k nu) K_nu(xi) + pi i sin(pi k nu)/sin(pi nu) I_nu(xi)), divided by the
  // value of x^(1/2) at the base.
  void multivalued(Crossings& out) const {
    const ComplexBall xi = argument();
    const long first = first_direction(xi);
    const ComplexBall wronskian = n_.over(half_pi(e_.n), x_);
    const Value k_part = bessel_k(xi), i_part = bessel_i(xi);
    ComplexBall chebyshev = n_.integer(0), next = n_.integer(1); // sin(pi k nu)/sin(pi nu)
    for (long k = 0; k < e_.n; ++k) {
      const ComplexBall turn = n_.turn(n_.times(n_.integer(k), order_));
      const ComplexBall of_i = n_.times(n_.times(n_.pi(), n_.i()), chebyshev);
      const Value v{n_.plus(n_.times(turn, k_part.y), n_.times(of_i, i_part.y)),
                    n_.plus(n_.times(turn, k_part.slope), n_.times(of_i, i_part.slope))};
      out.all.push_back(
          {angle((first + k) % e_.n), v, n_.integer(1), wronskian, multiplier(), std::nullopt});
      const ComplexBall after = n_.minus(n_.times(n_.twice_cos_pi(order_), next), chebyshev);
      chebyshev = next;
      next = after;
    }
  }

  // xi at the base, -pi < arg xi <= 0.  A base that cannot be told from a direction lies on it.
  [[nodiscard]] ComplexBall argument() const {
    const ComplexBall square = n_.times(n_.of(e_.a), n_.to(x_, static_cast<ulong>(e_.n)));
    const ComplexBall twice = n_.over(n_.integer(2), n_.integer(e_.n));
    if (arb_is_positive(acb_realref(square.raw())) != 0 &&
        arb_contains_zero(acb_imagref(square.raw())) != 0)
      return n_.times(twice, n_.root(square, 2));
    const ComplexBall turned = n_.root(n_.minus(n_.integer(0), square), 2);
    return n_.minus(n_.integer(0), n_.times(twice, n_.times(n_.i(), turned)));
  }

  // With (x^(1/2))' = x^(1/2)/(2 x) and xi' = n xi/(2 x): what K_nu(xi) and xi K_nu'(xi) give.
  [[nodiscard]] Value at_base(const ComplexBall& f, const ComplexBall& logarithmic) const {
    const ComplexBall twice = n_.plus(x_, x_);
    return {f, n_.over(n_.plus(f, n_.times(n_.integer(e_.n), logarithmic)), twice)};
  }
  [[nodiscard]] Value bessel_k(const ComplexBall& xi) const {
    ComplexBall f, next;
    acb_hypgeom_bessel_k(f.raw(), order_.raw(), xi.raw(), n_.bits);
    acb_hypgeom_bessel_k(next.raw(), n_.plus(order_, n_.integer(1)).raw(), xi.raw(), n_.bits);
    return at_base(f, n_.minus(n_.times(order_, f), n_.times(xi, next)));
  }
  [[nodiscard]] Value bessel_i(const ComplexBall& xi) const {
    ComplexBall f, next;
    acb_hypgeom_bessel_i(f.raw(), order_.raw(), xi.raw(), n_.bits);
    acb_hypgeom_bessel_i(next.raw(), n_.plus(order_, n_.integer(1)).raw(), xi.raw(), n_.bits);
    return at_base(f, n_.plus(n_.times(order_, f), n_.times(xi, next)));
  }

  // arg x of the directions: (2 pi k - arg a)/n
  [[nodiscard]] Ball angle(long k) const {
    Ball of_a, turned;
    acb_arg(of_a.raw(), n_.of(e_.a).raw(), n_.bits);
    arb_const_pi(turned.raw(), n_.bits);
    arb_mul_si(turned.raw(), turned.raw(), 2 * k, n_.bits);
    arb_sub(turned.raw(), turned.raw(), of_a.raw(), n_.bits);
    arb_div_si(turned.raw(), turned.raw(), e_.n, n_.bits);
    return turned;
  }

  // The k of the direction where arg xi, counted on from the base, is 0.
  [[nodiscard]] long first_direction(const ComplexBall& xi) const {
    Ball turns, part;
    acb_arg(turns.raw(), x_.raw(), n_.bits);
    arb_mul_si(turns.raw(), turns.raw(), e_.n, n_.bits);
    acb_arg(part.raw(), xi.raw(), n_.bits);
    arb_submul_si(turns.raw(), part.raw(), 2, n_.bits);
    acb_arg(part.raw(), n_.of(e_.a).raw(), n_.bits);
    arb_add(turns.raw(), turns.raw(), part.raw(), n_.bits);
    arb_const_pi(part.raw(), n_.bits);
    arb_mul_2exp_si(part.raw(), part.raw(), 1);
    arb_div(turns.raw(), turns.raw(), part.raw(), n_.bits);
    Integer k;
    if (arb_get_unique_fmpz(k.raw(), turns.raw()) == 0)
      throw Imprecise("the first Stokes direction behind the base is not known");
    return ((static_cast<long>(fmpz_get_si(k.raw())) % e_.n) + e_.n) % e_.n;
  }

  Numbers n_;
  const BesselEquation& e_;
  ComplexBall x_, order_;
};

} // namespace

std::optional<BesselEquation> bessel_equation(const RationalFunction& r) {
  const long pole = degree(r.den()), top = degree(r.num()), n = top - pole + 2;
  if (is_zero(r) || pole > 2 || n < 1 || n > most_directions || top == pole) return std::nullopt;
  BesselEquation e;
  e.n = n;
  if (pole > 0)
    e.centre = -r.den().coeff(pole - 1) / (NfElem(pole) * r.den().coeff(pole));
  else
    e.centre = -r.num().coeff(top - 1) / (NfElem(top) * r.num().coeff(top));
  const RationalFunction x = RationalFunction(Poly::z()) + RationalFunction(Poly(e.centre));
  const RationalFunction moved = compose(r, x) * RationalFunction(Poly::z() * Poly::z());
  if (degree(moved.den()) > 0) return std::nullopt;
  for (long k = 1; k < n; ++k)
    if (!is_zero(moved.num().coeff(k))) return std::nullopt;
  e.a = moved.num().coeff(n) / moved.den().coeff(0);
  e.c = moved.num().coeff(0) / moved.den().coeff(0);
  return e;
}

Crossings bessel_crossings(const BesselEquation& e, const Point& base, long bits) {
  return Bessel(e, base, bits).crossings();
}

} // namespace kov::monodromy
