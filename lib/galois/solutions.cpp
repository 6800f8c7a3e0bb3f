#include "galois/solutions.hpp"

#include "exact/error.hpp"
#include "kovacic/solve.hpp"
#include "linode/polynomial_solution.hpp"

#include <algorithm>

namespace kov {

namespace {

// S with S u and S^2 r polynomials; S has no superfluous factors if r has double poles only.
Poly common_denominator(const RationalFunction& u, const RationalFunction& r) {
  const Poly poles = exact_div(r.den(), gcd(r.den(), derivative(r.den())));
  const Poly s = lcm(u.den(), poles);
  return divides(r.den(), s * s) ? s : lcm(u.den(), r.den());
}

} // namespace

std::vector<RationalFunction> riccati_polynomial(long m, const RationalFunction& u,
                                                 const RationalFunction& r) {
  // A_m = -1, A_(i-1) = -A_i' - u A_i - (m-i)(i+1) r A_(i+1); with A_i = P_i/S^(m-i):
  // P_(i-1) = (m-i) S' P_i - S P_i' - (S u) P_i - (m-i)(i+1) (S^2 r) P_(i+1)
  const Poly S = common_denominator(u, r);
  const Poly slope = derivative(S);
  const Poly Su = u.num() * exact_div(S, u.den());
  const Poly SSr = r.num() * exact_div(S * S, r.den());
  std::vector<Poly> P(static_cast<std::size_t>(m) + 2);
  P[static_cast<std::size_t>(m)] = Poly(-1);
  Poly last;
  for (long i = m; i >= 0; --i) {
    const auto k = static_cast<std::size_t>(i);
    Poly next = (scale(slope, NfElem(m - i)) - Su) * P[k] - S * derivative(P[k]) -
                scale(SSr * P[k + 1], NfElem((m - i) * (i + 1)));
    (i > 0 ? P[k - 1] : last) = std::move(next);
  }
  KOV_ENSURE(is_zero(last));
  // monic in w: divided by -(m-i)!
  std::vector<RationalFunction> a(static_cast<std::size_t>(m) + 1);
  Integer factorial(1);
  Poly power(1);
  for (long i = m; i >= 0; --i) {
    const auto k = static_cast<std::size_t>(i);
    if (i < m) {
      factorial *= Integer(m - i);
      power *= S;
    }
    a[k] = RationalFunction(scale(P[k], NfElem(Rational(Integer(-1), factorial))), power);
  }
  return a;
}

namespace {

LiouvillianSolution exponential(const ExponentialSolution& y, const std::string& variable,
                                const Budget& budget) {
  LiouvillianSolution s;
  s.exponential = y;
  s.text = exponential_text(y.p, logarithmic_parts(y.theta, budget), variable);
  return s;
}

// omega = (v' +- w)/(2v): over K if w is in K, over K(w) if K = Q, otherwise by its quadratic
// equation.
std::vector<LiouvillianSolution> exponentials(const ExponentialPair& pair,
                                              const RationalFunction& r,
                                              const std::string& variable, const Budget& budget) {
  std::optional<NfElem> w = exact_sqrt(pair.w_squared);
  RationalFunction v = pair.v;
  std::string note;
  if (!w && v.field()->is_rational()) {
    // w^2 = n/d: w = sqrt(n d)/d with the square part taken out
    const Rational square = to_rational(pair.w_squared);
    const auto [outside, inside] = square_part(square.num() * square.den());
    const std::string name = inside == Integer(-1) ? "I" : "sqrt(" + to_string(inside) + ")";
    const Field k = make_field({-inside, Integer(0), Integer(1)}, name);
    w = NfElem::generator(k) * NfElem(Rational(outside, square.den()));
    v = coerce(v, k);
    note = "over Q(" + name + ")";
  }
  std::vector<LiouvillianSolution> found;
  if (!w) {
    LiouvillianSolution s;
    const RationalFunction phi = derivative(v) / v;
    const RationalFunction half(Rational(1, 2));
    s.minimal_polynomial = {derivative(phi) * half + phi * phi * half - r, -phi,
                            RationalFunction(1)};
    s.note = "both roots are rational functions over K(sqrt(" + to_string(pair.w_squared) + "))";
    found.push_back(std::move(s));
    return found;
  }
  for (const NfElem& sign : {*w, -*w}) {
    const RationalFunction omega =
        (derivative(v) + RationalFunction(Poly(sign))) / (RationalFunction(2) * v);
    KOV_ENSURE(derivative(omega) + omega * omega == coerce(r, omega.field()));
    found.push_back(exponential({omega, Poly(1)}, variable, budget));
    found.back().note = note;
  }
  return found;
}

// All exponent differences are integers and nothing is logarithmic: y = P prod q^((1-Delta)/2), and
// the growth exponents at infinity give the two degrees of P.
std::vector<LiouvillianSolution> square_roots(const Singularities& s, const RationalFunction& r,
                                              const std::string& variable, const Budget& budget) {
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
    found.push_back(exponential({theta, *p}, variable, budget));
  }
  KOV_ENSURE(found.size() == 2);
  return found;
}

LiouvillianSolution algebraic(long m, const RationalFunction& u, const RationalFunction& r) {
  LiouvillianSolution s;
  s.minimal_polynomial = riccati_polynomial(m, u, r);
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
    s.note = "the product of three quadratics that are conjugate over the constants";
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
  const auto found = std::find_if(c.invariants.begin(), c.invariants.end(),
                                  [m](const InvariantSearch& i) { return i.m == m; });
  return found == c.invariants.end() ? nullptr : &*found;
}

} // namespace

std::vector<LiouvillianSolution> solutions(const Classification& c, const RationalFunction& r,
                                           const std::string& variable, const Budget& budget) {
  const RationalFunction half(Rational(1, 2));
  if (is_zero(r)) {
    LiouvillianSolution one{ExponentialSolution{RationalFunction(0), Poly(1)}, {}, "1", ""};
    LiouvillianSolution z{ExponentialSolution{RationalFunction(0), Poly::z()}, {}, variable, ""};
    return {one, z};
  }
  if (c.group && c.group->type == GroupType::cyclic && !c.pair)
    return square_roots(*c.local, r, variable, budget);
  if (c.pair) return exponentials(*c.pair, r, variable, budget);
  if (c.exponential) return {exponential(*c.exponential, variable, budget)};
  if (!c.group) return {};
  switch (c.group->type) {
  case GroupType::Dinf:
  case GroupType::D: { // phi = F'/(2F)
    const InvariantSearch* quartic = of_degree(c, 4);
    KOV_ENSURE(quartic != nullptr);
    if (quartic->basis.size() > 1) return {quaternion(r, budget)};
    return {algebraic(2, half * log_derivative(*quartic, c), r)};
  }
  case GroupType::A4:
    return {algebraic(6, log_derivative(*of_degree(c, 6), c), r)};
  case GroupType::S4: { // Sym^12 is spanned by the square of the semi-invariant of degree 6
    const InvariantSearch twelve = invariants(*c.local, 12, budget);
    KOV_ENSURE(twelve.basis.size() == 1);
    return {algebraic(6, half * log_derivative(twelve, c), r)};
  }
  case GroupType::A5:
    return {algebraic(12, log_derivative(*of_degree(c, 12), c), r)};
  default:
    return {};
  }
}

} // namespace kov
