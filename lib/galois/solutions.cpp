#include "galois/solutions.hpp"

#include "exact/error.hpp"
#include "exact/modular_gcd.hpp"
#include "kovacic/solve.hpp"
#include "linode/polynomial_solution.hpp"

#include <algorithm>
#include <array>

namespace kov {

namespace {

// u = P'/P + u0: at the roots of P, ordinary points of the equation, one of the m factors vanishes.
// T u0 and T^2 r are polynomials.
struct Denominators {
  Poly P, T;
  RationalFunction u0;
};

Denominators denominators(const RationalFunction& u, const RationalFunction& r) {
  const Poly poles = exact_div(r.den(), gcd(r.den(), derivative(r.den())));
  Denominators d{exact_div(u.den(), gcd(u.den(), poles)), poles, u};
  const RationalFunction u0 = u - RationalFunction(derivative(d.P), d.P);
  if (degree(gcd(u0.den(), d.P)) == 0)
    d.u0 = u0;
  else
    d.P = Poly(1);
  d.T = lcm(d.u0.den(), poles);
  if (!divides(r.den(), d.T * d.T)) d.T = lcm(d.u0.den(), r.den());
  return d;
}

} // namespace

std::vector<RationalFunction> riccati_polynomial(long m, const RationalFunction& u,
                                                 const RationalFunction& r, const Budget& budget) {
  // A_m = -1, A_(i-1) = -A_i' - u A_i - (m-i)(i+1) r A_(i+1); with A_i = B_i/(P T^(m-i)):
  // B_(i-1) = (m-i) T' B_i - T B_i' - (T u0) B_i - (m-i)(i+1) (T^2 r) B_(i+1)
  const auto [P, T, u0] = denominators(u, r);
  const Poly slope = derivative(T);
  const Poly Tu = u0.num() * exact_div(T, u0.den());
  const Poly TTr = r.num() * exact_div(T * T, r.den());
  std::vector<Poly> B(static_cast<std::size_t>(m) + 2);
  B[static_cast<std::size_t>(m)] = -P;
  Poly last;
  for (long i = m; i >= 0; --i) {
    budget.check();
    const auto k = static_cast<std::size_t>(i);
    Poly next = (scale(slope, NfElem(m - i)) - Tu) * B[k] - T * derivative(B[k]) -
                scale(TTr * B[k + 1], NfElem((m - i) * (i + 1)));
    (i > 0 ? B[k - 1] : last) = std::move(next);
  }
  KOV_ENSURE(is_zero(last));
  // monic in w: divided by -(m-i)!
  std::vector<RationalFunction> a(static_cast<std::size_t>(m) + 1);
  Integer factorial(1);
  Poly power = P;
  for (long i = m; i >= 0; --i) {
    budget.check();
    const auto k = static_cast<std::size_t>(i);
    if (i < m) {
      factorial *= Integer(m - i);
      power *= T;
    }
    a[k] = RationalFunction(scale(B[k], NfElem(Rational(Integer(-1), factorial))), power);
  }
  return a;
}

namespace {

// The factor of v without zeros at the poles of r: there y1 or y2 has a simple zero.
Poly ordinary_zeros(const RationalFunction& v, const RationalFunction& r) {
  Poly zeros = v.num();
  const Poly poles = coerce(r.den(), v.field());
  for (Poly common = gcd(zeros, poles); degree(common) > 0; common = gcd(zeros, common))
    zeros = exact_div(zeros, common);
  return zeros;
}

RationalFunction omega_of(const RationalFunction& v, const NfElem& w) {
  return (derivative(v) + RationalFunction(Poly(w))) / (RationalFunction(2) * v);
}

// From this degree on the zeros of y are told from the other ones of v by a gcd, and not factored.
constexpr long many_zeros = 60;

// The other root of x^2 = n for the generator.
Poly conjugate(const Poly& f) {
  std::vector<NfElem> c;
  for (long i = 0; i <= degree(f); ++i) {
    const NfElem a = f.coeff(i);
    c.push_back(NfElem(Rational(2) * a.coeff(0)) - a);
  }
  return Poly::from_coefficients(c);
}

// v = P Q M/D, P the zeros of v where v' = w, Q the other ones away from the poles of r; (M/D)' = L M/D.
struct Split {
  Poly P, Q, M, D;
  NfElem w;

  // (Q'P - P'Q) M + w D, which P Q divides.
  [[nodiscard]] Poly numerator() const {
    return (derivative(Q) * P - derivative(P) * Q) * M + scale(D, w);
  }
};

// Over K(w), w not in K, the two factors are conjugates: products prove what a gcd needs quotients for.
Split split(const RationalFunction& v, const Poly& zeros, const NfElem& w, bool conjugates) {
  Split s{Poly(1), zeros, exact_div(v.num(), zeros), v.den(), w};
  const Poly where = derivative(zeros) * s.M - scale(s.D, w);
  const auto set = [&](const Poly& P) {
    s.P = P;
    s.Q = scale(conjugate(P), lead(zeros));
    return s.P * s.Q == zeros && divides(zeros, s.numerator());
  };
  if (conjugates && modular_gcd(zeros, where, set)) return s;
  s.P = gcd(zeros, where);
  s.Q = exact_div(zeros, s.P);
  return s;
}

// omega = P'/P + theta, theta = L/2 + S/(2M), S = ((Q'P - P'Q) M + w D)/(P Q).
std::array<ExponentialSolution, 2> lines(const RationalFunction& v, const Poly& zeros,
                                         const NfElem& w, bool conjugates) {
  const Split s = split(v, zeros, w, conjugates);
  const Poly S = exact_div(s.numerator(), zeros);
  const RationalFunction half(Rational(1, 2)), rest(s.M, s.D);
  const RationalFunction L = derivative(rest) / rest;
  return {ExponentialSolution{half * (L + RationalFunction(S, s.M)), s.P},
          ExponentialSolution{half * (L - RationalFunction(S, s.M)), s.Q}};
}

// omega = (v' +- w)/(2v): over K if w is in K, over K(w) if K = Q, otherwise by its quadratic
// equation.
std::vector<LiouvillianSolution> exponentials(const ExponentialPair& pair,
                                              const RationalFunction& r) {
  std::optional<NfElem> w = exact_sqrt(pair.w_squared);
  RationalFunction v = pair.v;
  const bool adjoin = !w && v.field()->is_rational();
  if (adjoin) {
    // w^2 = n/d: w = sqrt(n d)/d with the square part taken out
    const Rational square = to_rational(pair.w_squared);
    const auto [outside, inside] = square_part(square.num() * square.den());
    const std::string name = inside == Integer(-1) ? "I" : "sqrt(" + to_string(inside) + ")";
    const Field k = make_field({-inside, Integer(0), Integer(1)}, name);
    w = NfElem::generator(k) * NfElem(Rational(outside, square.den()));
    v = coerce(v, k);
  }
  std::vector<LiouvillianSolution> found;
  if (!w) {
    LiouvillianSolution s;
    const RationalFunction phi = derivative(v) / v;
    const RationalFunction half(Rational(1, 2));
    s.minimal_polynomial = {derivative(phi) * half + phi * phi * half - r, -phi,
                            RationalFunction(1)};
    s.radicand = pair.w_squared;
    found.push_back(std::move(s));
    return found;
  }
  // omega' + omega^2 = (2 v v'' - v'^2 + w^2)/(4 v^2)
  KOV_ENSURE(*w * *w == pair.w_squared && wronskian_squared(pair.v, r) == pair.w_squared);
  const Poly zeros = ordinary_zeros(v, r);
  const auto both = degree(zeros) > many_zeros
                        ? lines(v, zeros, *w, adjoin)
                        : std::array{ExponentialSolution{omega_of(v, *w), Poly(1)},
                                     ExponentialSolution{omega_of(v, -*w), Poly(1)}};
  for (const ExponentialSolution& y : both)
    found.push_back({.exponential = y, .adjoined = adjoin});
  return found;
}

// All exponent differences are integers and nothing is logarithmic: y = P prod q^((1-Delta)/2), and
// the growth exponents at infinity give the two degrees of P.
std::vector<LiouvillianSolution> square_roots(const Singularities& s, const RationalFunction& r,
                                              const Budget& budget) {
  RationalFunction theta;
  Rational total;
  for (const Singularity& p : s.finite) {
    const Rational alpha = (Rational(1) - *p.delta) * Rational(1, 2);
    theta += RationalFunction(scale(derivative(p.place), NfElem(alpha)), p.place);
    total += alpha * Rational(p.degree());
  }
  const PolynomialEquation e = polynomial_equation(theta, r);
  std::vector<LiouvillianSolution> found;
  for (const int sign : {-1, 1}) {
    const Rational d = (Rational(1) + Rational(sign) * *s.infinity.delta) * Rational(1, 2) - total;
    KOV_ENSURE(is_integer(d) && fits_long(d.num()));
    if (kov::sign(d) < 0) continue;
    const auto p = polynomial_solution(e.c2, e.c1, e.c0, to_long(d.num()), budget);
    if (!p) continue;
    found.push_back({.exponential = ExponentialSolution{theta, *p}});
  }
  KOV_ENSURE(found.size() == 2);
  return found;
}

LiouvillianSolution algebraic(long m, const RationalFunction& u, const RationalFunction& r,
                              const Budget& budget) {
  LiouvillianSolution s;
  s.minimal_polynomial = riccati_polynomial(m, u, r, budget);
  return s;
}

// Q8 has three quadratics; the classical case 2 finds one over K, or their product if K conjugates
// them.
LiouvillianSolution quaternion(const RationalFunction& r, const Budget& budget) {
  const kovacic::Outcome outcome = kovacic::solve(r, budget);
  LiouvillianSolution s;
  if (const auto* one = std::get_if<kovacic::Imprimitive>(&outcome)) {
    const RationalFunction half(Rational(1, 2));
    s.minimal_polynomial = {derivative(one->phi) * half + one->phi * one->phi * half - r, -one->phi,
                            RationalFunction(1)};
  } else if (const auto* three = std::get_if<kovacic::ImprimitiveTriple>(&outcome)) {
    s.minimal_polynomial = three->riccati;
    s.three_quadratics = true;
  } else {
    throw OutOfBudget("the quadratic of the quaternion group was not separated");
  }
  return s;
}

RationalFunction log_derivative(const InvariantSearch& search, const Classification& c) {
  const RationalFunction v = value(search.basis.front(), *c.local);
  return derivative(v) / v;
}

const InvariantSearch* of_degree(const Classification& c, long m) {
  const auto found =
      std::ranges::find_if(c.invariants, [m](const InvariantSearch& i) { return i.m == m; });
  return found == c.invariants.end() ? nullptr : &*found;
}

} // namespace

std::vector<LiouvillianSolution> solutions(const Classification& c, const RationalFunction& r,
                                           const Budget& budget) {
  const RationalFunction half(Rational(1, 2));
  if (is_zero(r))
    return {{.exponential = ExponentialSolution{RationalFunction(0), Poly(1)}},
            {.exponential = ExponentialSolution{RationalFunction(0), Poly::z()}}};
  if (c.group && c.group->type == GroupType::cyclic && !c.pair)
    return square_roots(*c.local, r, budget);
  if (c.pair) return exponentials(*c.pair, r);
  if (c.exponential) return {{.exponential = *c.exponential}};
  if (!c.group) return {};
  switch (c.group->type) {
  case GroupType::Dinf:
  case GroupType::D: { // phi = F'/(2F)
    const InvariantSearch* quartic = of_degree(c, 4);
    KOV_ENSURE(quartic != nullptr);
    if (quartic->basis.size() > 1) return {quaternion(r, budget)};
    return {algebraic(2, half * log_derivative(*quartic, c), r, budget)};
  }
  case GroupType::A4:
    return {algebraic(6, log_derivative(*of_degree(c, 6), c), r, budget)};
  case GroupType::S4: { // Sym^12 is spanned by the square of the semi-invariant of degree 6
    const InvariantSearch twelve = invariants(*c.local, 12, budget);
    KOV_ENSURE(twelve.basis.size() == 1);
    return {algebraic(6, half * log_derivative(twelve, c), r, budget)};
  }
  case GroupType::A5:
    return {algebraic(12, log_derivative(*of_degree(c, 12), c), r, budget)};
  default:
    return {};
  }
}

} // namespace kov
