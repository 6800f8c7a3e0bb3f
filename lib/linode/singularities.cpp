#include "linode/singularities.hpp"

#include "exact/error.hpp"
#include "linode/double_poles.hpp"
#include "linode/logarithm.hpp"
#include "linode/residue_series.hpp"

namespace kov {
namespace {

std::optional<Rational> rational_root(const Poly& square) {
  if (degree(square) > 0) return std::nullopt;
  const NfElem constant = square.coeff(0);
  if (!is_rational(constant)) return std::nullopt;
  return exact_sqrt(to_rational(constant));
}

// A natural number as a machine integer; an exponent difference beyond that is past every budget.
std::optional<long> natural(const std::optional<Rational>& delta) {
  if (!delta || !is_integer(*delta)) return std::nullopt;
  if (!fits_long(delta->num()) || delta->num() > Integer(1000000000L)) return std::nullopt;
  return to_long(delta->num());
}

// sqrt(r)/a for r = u (1 + ...), and beta = 2 u s_next where s_next is the first coefficient after
// the tail: the tail squared misses exactly that term (docs/theory/local_exponents.md).
void set_irregular(Singularity& s, const ResidueSeries& series, long tail, const Poly& q) {
  s.kind = PlaceKind::irregular;
  s.leading = series.at(0);
  const Poly unit = inverse_mod(s.leading, q);
  ResidueSeries normalized;
  for (const Poly& c : series)
    normalized.push_back(c * unit % q);
  const ResidueSeries root = square_root(normalized, q);
  s.sqrt_tail.assign(root.begin(), root.begin() + tail);
  const Poly next = root.at(static_cast<std::size_t>(tail));
  s.beta = scale(s.leading * next % q, NfElem(2));
  s.delta_squared = scale((s.leading * next % q) * next % q, NfElem(4));
  s.delta = rational_root(s.delta_squared);
}

Singularity finite_place(const RationalFunction& r, const Factor& factor,
                         const std::optional<Rational>& delta_squared, const Budget& budget) {
  budget.check();
  Singularity s;
  s.place = factor.base;
  s.order = factor.exponent;
  const Poly& q = s.place;
  const auto series = [&](long n) { // t^order * r to n terms
    ResidueSeries den = taylor_at(r.den(), q, s.order + n);
    den.erase(den.begin(), den.begin() + s.order);
    return divide(taylor_at(r.num(), q, n), den, q);
  };
  if (s.order == 1) {
    s.kind = PlaceKind::simple;
    s.delta = Rational(1);
    s.log = Truth::yes;
  } else if (s.order == 2) {
    s.kind = PlaceKind::regular;
    s.delta_squared =
        delta_squared ? Poly(*delta_squared) : Poly(1) + scale(series(1)[0], NfElem(4));
    s.delta = rational_root(s.delta_squared);
    if (s.delta && is_integer(*s.delta)) {
      const auto n = natural(s.delta);
      s.log = n ? has_logarithm(r.num(), r.den(), q, *n, budget) : Truth::unknown;
    }
  } else if (s.order % 2 == 0) {
    budget.check_degree(s.order);
    set_irregular(s, series(s.order / 2), s.order / 2 - 1, q);
  } else {
    s.kind = PlaceKind::ramified;
  }
  return s;
}

// With t = 1/z and y = w/t the equation becomes w'' = r(1/t) t^-4 w, so that infinity is a place t
// = 0 like any other; only [sqrt r] is written in powers of z.
Singularity infinite_place(const RationalFunction& r, const Budget& budget) {
  Singularity s;
  s.at_infinity = true;
  s.order = order_at_infinity(r);
  const Poly t = Poly::z();
  const Poly num = reverse(r.num(), degree(r.num()) + 1);
  const Poly den = reverse(r.den(), degree(r.den()) + 1); // r(1/t) = t^order num/den
  if (s.order >= 4) {
    s.kind = PlaceKind::ordinary;
    s.delta = Rational(1);
  } else if (s.order == 3) {
    s.kind = PlaceKind::simple;
    s.delta = Rational(1);
    s.log = Truth::yes;
  } else if (s.order == 2) {
    s.kind = PlaceKind::regular;
    s.delta_squared = Poly(NfElem(1) + NfElem(4) * lead(r.num()) / lead(r.den()));
    s.delta = rational_root(s.delta_squared);
    if (s.delta && is_integer(*s.delta)) {
      const auto n = natural(s.delta);
      s.log = n ? has_logarithm(num, den * t * t, t, *n, budget) : Truth::unknown;
    }
  } else if (s.order % 2 == 0) {
    const long nu = -s.order / 2;
    budget.check_degree(nu);
    const ResidueSeries series = divide(taylor_at(num, t, nu + 2), taylor_at(den, t, nu + 2), t);
    set_irregular(s, series, nu + 1, t);
  } else {
    s.kind = PlaceKind::ramified;
  }
  return s;
}

} // namespace

Singularities singularities(const RationalFunction& r, const Budget& budget) {
  if (is_zero(r)) throw InvalidArgument("y'' = 0 has no singularities to list");
  budget.check_degree(degree(r.den()));
  Singularities s;
  s.r = r;
  const auto factors = irreducible_factors(r.den(), budget);
  const auto delta_squared = double_pole_delta_squared(r, factors, budget);
  for (std::size_t i = 0; i < factors.size(); ++i)
    s.finite.push_back(finite_place(r, factors[i], delta_squared[i], budget));
  s.infinity = infinite_place(r, budget);
  return s;
}

} // namespace kov
