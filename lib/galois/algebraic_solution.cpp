#include "galois/algebraic_solution.hpp"

#include "exact/error.hpp"

#include <algorithm>
#include <limits>

namespace kov {
namespace {

// ----- polynomials in X over K[z]

using Bivariate = std::vector<Poly>;

Bivariate product(const Bivariate& a, const Bivariate& b, const Budget& budget) {
  Bivariate ab(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    budget.check();
    if (is_zero(a[i])) continue;
    for (std::size_t j = 0; j < b.size(); ++j)
      if (!is_zero(b[j])) ab[i + j] += a[i] * b[j];
  }
  return ab;
}

void add(Bivariate& a, const Bivariate& b, const Poly& factor) {
  if (a.size() < b.size()) a.resize(b.size());
  for (std::size_t i = 0; i < b.size(); ++i)
    a[i] += factor * b[i];
}

void reduce(Bivariate& a, const Bivariate& monic, const Budget& budget) {
  const std::size_t n = monic.size() - 1;
  for (; a.size() > n; a.pop_back()) {
    budget.check();
    if (is_zero(a.back())) continue;
    const std::size_t shift = a.size() - 1 - n;
    for (std::size_t i = 0; i < n; ++i)
      if (!is_zero(monic[i])) a[shift + i] -= a.back() * monic[i];
  }
}

Bivariate by_z(Bivariate p) {
  for (Poly& c : p)
    c = derivative(c);
  return p;
}

Bivariate by_x(const Bivariate& p) {
  Bivariate d;
  for (std::size_t i = 1; i < p.size(); ++i)
    d.push_back(scale(p[i], NfElem(static_cast<long>(i))));
  return d;
}

// P(z0, X) has no double root for some small z0: then P has none over the closure of K(z).
bool has_simple_roots(const Bivariate& p, const Field& k) {
  for (long z0 = 0; z0 < 40; ++z0) {
    std::vector<NfElem> at;
    for (const Poly& c : p)
      at.push_back(evaluate(coerce(c, k), NfElem(z0)));
    const Poly f = Poly::from_coefficients(at);
    if (degree(gcd(f, derivative(f))) == 0) return true;
  }
  return false;
}

// ----- ground forms

// coefficient * h^i t^j q^k in front of one power of X
struct Term {
  std::size_t x;
  long h, t, q;
  long coefficient;
};

// prod (X - lambda l^power) over the linear factors l of the ground form f of degree m: a polynomial
// in h = -Hessian/(m-1)^2, t = -Jacobian(f, h)/(2m-4) and q, where h^3 - t^2 = q_unit q.
struct GroundForm {
  long m, power, q_unit;
  long weight_h, weight_t, weight_q; ///< X has weight 1
  std::vector<Term> terms;           ///< and the leading X^m
};

const GroundForm& tetrahedral() {
  static const GroundForm form{6,
                               4,
                               108,
                               2,
                               3,
                               6,
                               {{4, 1, 0, 0, -10},
                                {3, 0, 1, 0, -20},
                                {2, 2, 0, 0, -15},
                                {1, 1, 1, 0, -4},
                                {0, 0, 0, 1, 16}}};
  return form;
}

const GroundForm& octahedral() { // f and t change their signs
  static const GroundForm form{6,
                               8,
                               108,
                               1,
                               0,
                               3,
                               {{5, 1, 0, 0, -20},
                                {4, 2, 0, 0, 70},
                                {3, 3, 0, 0, -100},
                                {3, 0, 0, 1, 43232},
                                {2, 4, 0, 0, 65},
                                {2, 1, 0, 1, 16960},
                                {1, 5, 0, 0, -16},
                                {1, 2, 0, 1, 1248},
                                {0, 0, 0, 2, 256}}};
  return form;
}

const GroundForm& icosahedral() {
  static const GroundForm form{12,
                               10,
                               -1728,
                               2,
                               3,
                               6,
                               {{10, 1, 0, 0, -9350},
                                {9, 0, 1, 0, -625625},
                                {8, 2, 0, 0, -17796625},
                                {7, 1, 1, 0, -244543750},
                                {6, 3, 0, 0, -1408123750},
                                {6, 0, 0, 1, -1392220156250},
                                {5, 2, 1, 0, -1275484375},
                                {4, 4, 0, 0, -495309375},
                                {4, 1, 0, 1, 15542200781250},
                                {3, 3, 1, 0, -97968750},
                                {3, 0, 1, 1, -5975234375000},
                                {2, 5, 0, 0, -9762500},
                                {2, 2, 0, 1, 202855468750},
                                {1, 4, 1, 0, -390625},
                                {1, 1, 1, 1, -195312500},
                                {0, 0, 0, 2, 48828125}}};
  return form;
}

// v^2 for the value v of the ground form, and v itself where it is in K(z).
struct Value {
  const GroundForm& form;
  RationalFunction square;
  std::optional<RationalFunction> v;
};

std::optional<Value> value_of_ground_form(const Classification& c, const Budget& budget) {
  if (!c.group || !c.local) return std::nullopt;
  const auto found = [&](long m) {
    for (const InvariantSearch& search : c.invariants)
      if (search.m == m && search.basis.size() == 1) return value(search.basis.front(), *c.local);
    const InvariantSearch search = invariants(*c.local, m, budget);
    KOV_ENSURE(search.basis.size() == 1);
    return value(search.basis.front(), *c.local);
  };
  switch (c.group->type) {
  case GroupType::A4: {
    const RationalFunction v = found(6);
    return Value{tetrahedral(), v * v, v};
  }
  case GroupType::S4:
    return Value{octahedral(), found(12), {}};
  case GroupType::A5: {
    const RationalFunction v = found(12);
    return Value{icosahedral(), v * v, v};
  }
  default:
    return std::nullopt;
  }
}

// The values of h, t and q; t = 0 where it is not in K(z).
struct Covariants {
  RationalFunction h, t, q;
};

Covariants covariants(const Value& value, const RationalFunction& r) {
  const long m = value.form.m;
  const RationalFunction phi =
      derivative(value.square) / (RationalFunction(2) * value.square); // v'/v
  const RationalFunction h =
      value.square * (phi * phi - RationalFunction(Rational(m, m - 1)) *
                                      (derivative(phi) + phi * phi - RationalFunction(m) * r));
  const RationalFunction t_over_v =
      h * phi - RationalFunction(Rational(m, 2 * m - 4)) * derivative(h);
  const RationalFunction q = (h * h * h - value.square * t_over_v * t_over_v) *
                             RationalFunction(Rational(1, value.form.q_unit));
  return {h, value.v ? *value.v * t_over_v : RationalFunction(), q};
}

// The least e for which place^(weight e) f has no pole there.
long needed(const RationalFunction& f, const Poly& place, long weight) {
  if (is_zero(f) || weight == 0) return std::numeric_limits<long>::min();
  const long order = remove_factor(f.num(), place).first - remove_factor(f.den(), place).first;
  return order >= 0 ? -(order / weight) : (-order + weight - 1) / weight;
}

RationalFunction denominator(const Covariants& v, const GroundForm& form, const Singularities& s) {
  RationalFunction b(1);
  for (const Singularity& p : s.finite)
    b *= pow(RationalFunction(p.place),
             std::max({needed(v.h, p.place, form.weight_h), needed(v.t, p.place, form.weight_t),
                       needed(v.q, p.place, form.weight_q)}));
  return b;
}

Poly polynomial_part(const RationalFunction& f) {
  KOV_ENSURE(degree(f.den()) == 0);
  return f.num();
}

std::vector<Poly> resolvent(const GroundForm& form, const Poly& h, const Poly& t, const Poly& q,
                            const Budget& budget) {
  const auto power = [](const Poly& f, long e) { return pow(f, static_cast<unsigned long>(e)); };
  std::vector<Poly> p(static_cast<std::size_t>(form.m) + 1);
  p.back() = Poly(1);
  for (const Term& term : form.terms) {
    budget.check();
    p[term.x] +=
        scale(power(h, term.h) * power(t, term.t) * power(q, term.q), NfElem(term.coefficient));
  }
  return p;
}

} // namespace

bool solves(const AlgebraicSolution& y, const RationalFunction& r, const Budget& budget) {
  const Bivariate& P = y.polynomial;
  if (P.size() < 2 || !is_one(P.back()) || !has_simple_roots(P, r.field())) return false;
  // X' = -P_z/P_X.  With beta = -factor'/(k factor) the equation for y = (factor X)^(1/k) is
  // k X X'' - (k-1) X'^2 - 2 beta k X X' = k^2 (r + beta' - beta^2) X^2; times P_X^3:
  const long k = y.power;
  const RationalFunction beta = RationalFunction(Rational(-1, k)) * derivative(y.factor) / y.factor;
  const RationalFunction linear = RationalFunction(2 * k) * beta;
  const RationalFunction constant = RationalFunction(k * k) * (r + derivative(beta) - beta * beta);
  const Poly d = lcm(linear.den(), constant.den());
  const auto times = [&](const Bivariate& a, const Bivariate& b) {
    Bivariate ab = product(a, b, budget);
    reduce(ab, P, budget);
    return ab;
  };
  const Bivariate Pz = by_z(P), Px = by_x(P), Pzz = by_z(Pz), Pzx = by_x(Pz), Pxx = by_x(Px);
  const Bivariate x{Poly(), Poly(1)};
  const Bivariate zz = times(Pz, Pz), zx = times(Pz, Px), xx = times(Px, Px);
  Bivariate second = times(Pzx, zx); // X'' P_X^3
  for (Poly& c : second)
    c = scale(c, NfElem(2));
  add(second, times(Pxx, zz), Poly(-1));
  add(second, times(Pzz, xx), Poly(-1));
  Bivariate sum;
  add(sum, times(x, second), scale(d, NfElem(k)));
  add(sum, times(Px, zz), scale(d, NfElem(1 - k)));
  add(sum, times(x, times(Pz, xx)), linear.num() * exact_div(d, linear.den()));
  add(sum, times(times(x, x), times(Px, xx)), -(constant.num() * exact_div(d, constant.den())));
  return std::ranges::all_of(sum, [](const Poly& c) { return is_zero(c); });
}

std::optional<AlgebraicSolution>
algebraic_solution(const Classification& c, const RationalFunction& r, const Budget& budget) {
  const auto value = value_of_ground_form(c, budget);
  if (!value) return std::nullopt;
  const GroundForm& form = value->form;
  const Covariants v = covariants(*value, r);
  const RationalFunction b = denominator(v, form, *c.local);
  AlgebraicSolution y{form.power, RationalFunction(1) / b, {}};
  y.polynomial = resolvent(form, polynomial_part(v.h * pow(b, form.weight_h)),
                           polynomial_part(v.t * pow(b, form.weight_t)),
                           polynomial_part(v.q * pow(b, form.weight_q)), budget);
  KOV_ENSURE(solves(y, r, budget));
  return y;
}

std::optional<RationalFunction> with_logarithmic_derivative(const RationalFunction& theta,
                                                            const Budget& budget) {
  const LogarithmicParts parts = logarithmic_parts(theta, budget);
  if (!is_zero(derivative(parts.rational_part))) return std::nullopt;
  RationalFunction f(1);
  for (const auto& [q, rho] : parts.residues) {
    if (degree(rho) > 0 || !is_rational(rho.coeff(0))) return std::nullopt;
    const Rational e = to_rational(rho.coeff(0));
    if (!is_integer(e) || abs(e) > Rational(budget.max_degree)) return std::nullopt;
    f *= pow(RationalFunction(q), to_long(e.num()));
  }
  KOV_ENSURE(derivative(f) == theta * f);
  return f;
}

std::optional<AlgebraicSolution>
times_exponential(AlgebraicSolution y, const RationalFunction& gauge, const Budget& budget) {
  const auto f = with_logarithmic_derivative(RationalFunction(y.power) * gauge, budget);
  if (!f) return std::nullopt;
  y.factor *= *f;
  return y;
}

} // namespace kov
