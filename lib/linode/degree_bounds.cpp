#include "linode/degree_bounds.hpp"

#include "exact/error.hpp"

#include <algorithm>

namespace kov {
namespace {

const Rational half(1, 2);

// |Re sqrt(w)| = sqrt((|w| + Re w)/2), stable also where the two square roots meet.
Rational real_part_of_root(const ComplexBall& w, long bits) {
  Ball x;
  acb_abs(x.raw(), w.raw(), bits);
  arb_add(x.raw(), x.raw(), acb_realref(w.raw()), bits);
  arb_mul_2exp_si(x.raw(), x.raw(), -1);
  arb_sqrtpos(x.raw(), x.raw(), bits);
  return upper_bound(x);
}

// All complex roots of q under the chosen embedding of its field, as disjoint balls.
std::vector<ComplexBall> complex_roots(const Poly& q) {
  const long n = degree(q);
  std::vector<ComplexBall> found(static_cast<std::size_t>(n));
  acb_ptr roots = _acb_vec_init(n);
  if (q.field()->is_rational()) {
    fmpz_poly_t f;
    fmpz_poly_init(f);
    fmpq_poly_get_numerator(f, q.raw());
    arb_fmpz_poly_complex_roots(roots, f, 0, 128);
    fmpz_poly_clear(f);
  } else {
    acb_poly_t f;
    acb_poly_init(f);
    long isolated = 0;
    for (long bits = 128; isolated < n && bits <= (1L << 16); bits *= 2) {
      for (long i = 0; i <= n; ++i)
        acb_poly_set_coeff_acb(f, i, embed(q.coeff(i), bits).raw());
      isolated = acb_poly_find_roots(roots, f, nullptr, 0, bits);
    }
    acb_poly_clear(f);
    if (isolated < n) {
      _acb_vec_clear(roots, n);
      throw OutOfBudget("the roots of a place could not be separated");
    }
  }
  for (long i = 0; i < n; ++i)
    acb_set(found[static_cast<std::size_t>(i)].raw(), roots + i);
  _acb_vec_clear(roots, n);
  return found;
}

Rational sqrt_upper_bound(const Rational& q) {
  ComplexBall w;
  arb_set_fmpq(acb_realref(w.raw()), q.raw(), 128);
  return real_part_of_root(w, 128);
}

} // namespace

Rational real_part_sum(const Singularity& s) {
  if (s.delta) return *s.delta * Rational(s.degree());
  const Poly& square = s.delta_squared;
  if (degree(square) <= 0 && is_rational(square.coeff(0)))
    return sqrt_upper_bound(to_rational(square.coeff(0))) * Rational(s.degree());
  if (degree(square) <= 0)
    return real_part_of_root(embed(square.coeff(0), 128), 128) * Rational(s.degree());
  Rational sum;
  for (const ComplexBall& c : complex_roots(s.place))
    sum += real_part_of_root(evaluate(square, c, 128), 128);
  return sum;
}

std::string place_name(const Singularity& s, const std::string& variable) {
  if (s.at_infinity) return "infinity";
  if (degree(s.place) == 1) {
    const std::string value = to_string(-s.place.coeff(0));
    return variable + " = " + value;
  }
  return to_string(s.place, variable) + " = 0";
}

std::string to_string(const Obstruction& o, const Singularities& s, const std::string& variable) {
  const Singularity& p = place_at(s, o.place);
  const std::string m = std::to_string(o.m);
  switch (o.kind) {
  case Obstruction::Kind::odd_order:
    return "the order of r at " + place_name(p, variable) + " is odd (" + std::to_string(p.order) +
           "), so that no exponential solution exists";
  case Obstruction::Kind::no_integral_exponent:
    return "at " + place_name(p, variable) + " no exponent of Sym^" + m + " is an integer";
  default:
    break;
  }
  if (o.m == 1)
    return "the exponents bound the degree of the polynomial part by " + to_string(o.degree) +
           " < 0, so that no exponential solution exists";
  return "the exponents bound the degree of a rational solution of Sym^" + m + " by D_" + m +
         " = " + to_string(o.degree) + " < 0";
}

namespace {

// The sum over the roots of the place of the least real part of an exponent, log-aware.
Rational least_exponents(const Singularity& s) {
  const Rational n(s.degree());
  if (s.kind == PlaceKind::simple) return n;
  if (s.kind == PlaceKind::regular && s.log == Truth::yes)
    return n * (Rational(1) + *s.delta) * half;
  if (s.kind == PlaceKind::regular) return (n - real_part_sum(s)) * half;
  return (n * Rational(s.nu()) - real_part_sum(s)) * half; // irregular
}

Rational greatest_exponent_at_infinity(const Singularity& s) {
  switch (s.kind) {
  case PlaceKind::ordinary:
    return 1;
  case PlaceKind::simple:
    return 0;
  case PlaceKind::regular:
    if (s.log == Truth::yes) return (Rational(1) - *s.delta) * half;
    return (Rational(1) + real_part_sum(s)) * half;
  default:
    return (real_part_sum(s) - Rational(s.nu())) * half;
  }
}

long to_bounded_long(const Integer& n) {
  if (!fits_long(n) || n > Integer(1000000000L) || n < Integer(-1000000000L)) {
    if (sign(n) < 0) return -1000000000L;
    throw OutOfBudget("degree limit: exponents allow a polynomial of degree " + to_string(n));
  }
  return to_long(n);
}

} // namespace

ExponentialShape exponential_shape(const Singularities& s) {
  ExponentialShape shape;
  const auto ramified = [](const Singularity& p) { return p.kind == PlaceKind::ramified; };
  const auto bad = std::ranges::find_if(s.finite, ramified);
  if (bad != s.finite.end() || ramified(s.infinity)) {
    PlaceIndex where;
    if (bad != s.finite.end()) where = static_cast<std::size_t>(bad - s.finite.begin());
    shape.obstruction = Obstruction{Obstruction::Kind::odd_order, 1, where, {}};
    shape.degree = -1;
    return shape;
  }
  Rational bound = greatest_exponent_at_infinity(s.infinity);
  for (const Singularity& p : s.finite) {
    bound -= least_exponents(p);
    shape.denominator += p.degree() * std::max(1L, p.kind == PlaceKind::irregular ? p.nu() : 1L);
  }
  if (s.infinity.kind == PlaceKind::irregular) shape.nu_infinity = s.infinity.nu();
  shape.degree = to_bounded_long(floor(bound));
  if (shape.degree < 0)
    shape.obstruction = Obstruction{Obstruction::Kind::negative_degree, 1, {}, floor(bound)};
  return shape;
}

namespace {

// Least (sign = -1) or greatest (sign = +1) integer among m/2 + (j - m/2) Delta, 0 <= j <= m.
std::optional<Integer> extreme_integer(long m, const Rational& delta, int direction) {
  for (long i = m / 2; i >= -m / 2; --i) {
    const Rational value = Rational(m / 2) + Rational(direction * i) * delta;
    if (is_integer(value)) return value.num();
  }
  return std::nullopt;
}

struct LocalExponent {
  std::optional<Integer> value; ///< unset: no admissible integer
};

LocalExponent invariant_exponent(const Singularity& s, long m) {
  const int direction = s.at_infinity ? 1 : -1;
  switch (s.kind) {
  case PlaceKind::ordinary:
    return {Integer(m)};
  case PlaceKind::simple:
    return {Integer(s.at_infinity ? 0 : m)};
  case PlaceKind::regular: {
    if (!s.delta) return {Integer(m / 2)};
    if (s.log == Truth::yes) {
      const Rational value = Rational(m / 2) - Rational(direction * (m / 2)) * *s.delta;
      return {value.num()}; // Delta is a natural number and m even
    }
    return {extreme_integer(m, *s.delta, direction)};
  }
  default:
    break;
  }
  const Rational value(Integer(s.order) * Integer(m), Integer(4));
  if (!is_integer(value)) return {};
  return {value.num()};
}

} // namespace

InvariantShape invariant_shape(const Singularities& s, long m) {
  KOV_ENSURE(m >= 2 && m % 2 == 0);
  InvariantShape shape;
  shape.m = m;
  Integer bound;
  const auto refuse = [&](PlaceIndex where) {
    shape.obstruction = Obstruction{Obstruction::Kind::no_integral_exponent, m, where, {}};
    shape.degree = -1;
    return shape;
  };
  const auto tau = invariant_exponent(s.infinity, m).value;
  if (!tau) return refuse({});
  bound = *tau;
  for (std::size_t i = 0; i < s.finite.size(); ++i) {
    const auto e = invariant_exponent(s.finite[i], m).value;
    if (!e) return refuse(i);
    bound -= *e * Integer(s.finite[i].degree());
    shape.e.push_back(to_bounded_long(*e));
  }
  shape.tau = to_bounded_long(*tau);
  shape.degree = to_bounded_long(bound);
  if (shape.degree < 0)
    shape.obstruction = Obstruction{Obstruction::Kind::negative_degree, m, {}, bound};
  return shape;
}

} // namespace kov
