#include "riccati/lift.hpp"

#include "exact/error.hpp"
#include "linode/polynomial_solution.hpp"

namespace kov {

RationalFunction ExponentialSolution::omega() const {
  return degree(p) == 0 ? theta : theta + RationalFunction(derivative(p), p);
}

PolynomialEquation polynomial_equation(const RationalFunction& theta, const RationalFunction& r) {
  const RationalFunction c = derivative(theta) + theta * theta - r;
  const Poly common = lcm(theta.den(), c.den());
  return {common, scale(exact_div(common, theta.den()) * theta.num(), NfElem(2)),
          exact_div(common, c.den()) * c.num()};
}

bool solves(const ExponentialSolution& y, const RationalFunction& r) {
  const PolynomialEquation e = polynomial_equation(y.theta, r);
  const Poly dp = derivative(y.p);
  return is_zero(e.c2 * derivative(dp) + e.c1 * dp + e.c0 * y.p);
}

namespace {

const NfElem half(Rational(1, 2));

// The square root of a residue that is visible without an extension of the residue field.
std::optional<NfElem> visible_root(const Singularity& s, const Poly& square) {
  if (degree(square) > 0) return std::nullopt;
  const NfElem c = square.coeff(0);
  if (s.degree() > 1 && !is_rational(c)) return std::nullopt;
  return exact_sqrt(c);
}

// The polar parts that omega may have at a finite place, over K.
std::optional<std::vector<RationalFunction>> polar_parts(const Singularity& s) {
  const Poly& q = s.place;
  const RationalFunction simple_pole(derivative(q), q);
  const auto times = [&](const NfElem& alpha) {
    return RationalFunction(scale(derivative(q), alpha), q);
  };
  if (s.kind == PlaceKind::simple) return {{simple_pole}};
  if (s.kind == PlaceKind::regular) {
    const auto delta =
        s.delta ? std::optional<NfElem>(NfElem(*s.delta)) : visible_root(s, s.delta_squared);
    if (!delta) return std::nullopt;
    std::vector<RationalFunction> parts{times((NfElem(1) + *delta) * half)};
    if (s.log != Truth::yes) parts.push_back(times((NfElem(1) - *delta) * half));
    return parts;
  }
  if (s.degree() > 1) return std::nullopt;
  const auto a = visible_root(s, s.leading);
  if (!a) return std::nullopt;
  std::vector<RationalFunction> parts;
  for (const NfElem& lead : {*a, -*a}) {
    RationalFunction part = times(half * (NfElem(s.nu()) + s.beta.coeff(0) / lead));
    for (std::size_t i = 0; i < s.sqrt_tail.size(); ++i)
      part += RationalFunction(scale(s.sqrt_tail[i], lead),
                               pow(q, static_cast<unsigned long>(s.nu()) - i));
    parts.push_back(part);
  }
  return parts;
}

bool divides(const NmodPoly& q, const NmodPoly& f) { return degree(gcd(f, q)) == degree(q); }

// Does omega - part lose its pole at q modulo the prime?  (true also says: part is integral there)
bool fits(const RationalFunction& part, const Poly& q, const ModularOmega& image) {
  const auto n = image.prime.reduce(part.num());
  const auto d = image.prime.reduce(part.den());
  const auto place = image.prime.reduce(q);
  if (!n || !d || !place || degree(*d) != degree(part.den())) return false;
  if (*d == *place && divides(*place, image.den)) { // a simple pole of both?
    const NmodPoly rest = exact_div(image.den, *place);
    if (degree(gcd(rest, *place)) == 0) return divides(*place, image.num - *n * rest);
  }
  NmodPoly num = image.num * *d - *n * image.den;
  NmodPoly den = image.den * *d;
  if (is_zero(num)) return true;
  const NmodPoly g = gcd(num, den);
  den = exact_div(den, g);
  return degree(gcd(den, *place)) == 0;
}

// The polynomial part of omega: 0 unless infinity is irregular.
std::optional<Poly> polynomial_part(const Singularity& s, const ModularOmega& image) {
  if (s.kind != PlaceKind::irregular) return Poly(0);
  const auto a = visible_root(s, s.leading);
  if (!a) return std::nullopt;
  const long nu = s.nu();
  if (degree(image.num) - degree(image.den) != nu) return std::nullopt;
  const mp_limb_t top = image.num.coeff(degree(image.num)); // den is monic
  for (const NfElem& lead : {*a, -*a}) {
    const auto residue = image.prime.reduce(lead);
    if (!residue || *residue != top) continue;
    Poly part(s.leading.field());
    for (std::size_t i = 0; i < s.sqrt_tail.size(); ++i)
      part += Poly::monomial(lead * s.sqrt_tail[i].coeff(0), nu - static_cast<long>(i));
    return part;
  }
  return std::nullopt;
}

// Adds by halves, so that the denominators stay small for long.
RationalFunction sum_of(const RationalFunction* f, std::size_t n) {
  return n == 1 ? *f : sum_of(f, n / 2) + sum_of(f + n / 2, n - n / 2);
}

} // namespace

std::optional<ExponentialSolution>
lift_by_exponents(const Singularities& s, const ModularOmega& image, const Budget& budget) {
  const auto regular_part = polynomial_part(s.infinity, image);
  if (!regular_part) return std::nullopt;
  std::vector<RationalFunction> summands{RationalFunction(*regular_part)};
  for (const Singularity& place : s.finite) {
    const auto parts = polar_parts(place);
    if (!parts) return std::nullopt;
    const RationalFunction* chosen = nullptr;
    for (const RationalFunction& part : *parts)
      if (fits(part, place.place, image)) chosen = &part;
    if (chosen == nullptr) return std::nullopt;
    summands.push_back(*chosen);
  }
  const RationalFunction theta = sum_of(summands.data(), summands.size());
  // omega = theta + P'/P: the remaining poles are the roots of P.
  const auto theta_den = image.prime.reduce(theta.den());
  if (!theta_den) return std::nullopt;
  const long d = degree(image.den) - degree(gcd(image.den, *theta_den));
  if (d == 0) {
    const ExponentialSolution y{theta, Poly(1)};
    return solves(y, s.r) ? std::optional(y) : std::nullopt;
  }
  const PolynomialEquation e = polynomial_equation(theta, s.r);
  const auto p = polynomial_solution(e.c2, e.c1, e.c0, d, budget);
  if (!p) return std::nullopt;
  return ExponentialSolution{theta, *p};
}

} // namespace kov
