#include "galois/dihedral.hpp"

#include "exact/error.hpp"
#include "exact/factor.hpp"
#include "exact/modular.hpp"
#include "galois/jacobian.hpp"
#include "galois/torsion_function.hpp"
#include "linode/polynomial_solution.hpp"

#include <algorithm>

namespace kov {

namespace {

// w^2 is a constant by theory: its value at one point, where F has neither zero nor pole.
NfElem wronskian_squared(const QuarticRoot& root, const Singularities& s) {
  for (long at = 0;; at = at > 0 ? -at : 1 - at) {
    const NfElem c(Rational(at), s.r.field());
    if (is_zero(evaluate(s.r.den(), c)) || is_zero(evaluate(root.q, c))) continue;
    // u = F'/F and its derivative:  w^2 = F (4r - u^2/4 - u')
    const NfElem q0 = evaluate(root.q, c);
    const Poly dq = derivative(root.q);
    const NfElem q1 = evaluate(dq, c) / q0;
    const NfElem q2 = evaluate(derivative(dq), c) / q0;
    NfElem f = root.k * q0 * q0;
    NfElem u = NfElem(2) * q1;
    NfElem du = NfElem(2) * (q2 - q1 * q1);
    for (std::size_t i = 0; i < s.finite.size(); ++i) {
      if (root.e[i] == 0) continue;
      const Poly& place = s.finite[i].place;
      const Poly slope = derivative(place);
      const NfElem p0 = evaluate(place, c);
      const NfElem p1 = evaluate(slope, c) / p0;
      const NfElem p2 = evaluate(derivative(slope), c) / p0;
      const NfElem e(root.e[i]);
      const NfElem power = pow(p0, static_cast<unsigned long>(std::abs(root.e[i])));
      f = root.e[i] > 0 ? f * power : f / power;
      u += e * p1;
      du += e * (p2 - p1 * p1);
    }
    const NfElem r = evaluate(s.r.num(), c) / evaluate(s.r.den(), c);
    return f * (NfElem(4) * r - u * u * NfElem(Rational(1, 4)) - du);
  }
}

} // namespace

QuarticRoot quartic_root(const Invariant& v, const Singularities& s) {
  QuarticRoot root;
  Poly rest = v.p;
  root.k = lead(rest);
  for (std::size_t i = 0; i < s.finite.size(); ++i) {
    auto [extra, left] = remove_factor(rest, s.finite[i].place);
    root.e.push_back(v.e.at(i) + extra);
    rest = std::move(left);
  }
  const auto q = exact_sqrt(monic(rest));
  KOV_ENSURE(q);
  root.q = *q;
  root.w_squared = wronskian_squared(root, s);
  return root;
}

DihedralCurve dihedral_curve(const QuarticRoot& root, const Singularities& s) {
  DihedralCurve c;
  c.field = s.r.field();
  c.w_squared = root.w_squared;
  KOV_ENSURE(!is_zero(c.w_squared));
  c.k = root.k;
  c.ordinary = root.q;
  c.branch = coerce(Poly(1), c.field);
  Poly top = root.q;
  Poly bottom = coerce(Poly(1), c.field);
  for (std::size_t i = 0; i < s.finite.size(); ++i) {
    const Poly& place = s.finite[i].place;
    const bool odd = root.e[i] % 2 != 0;
    if (odd) c.branch *= place;
    const long half = (root.e[i] - (odd ? 1 : 0)) / 2; // q^e = q^odd (q^half)^2, e may be negative
    const long exact = odd && root.e[i] < 0 ? (root.e[i] - 1) / 2 : half;
    if (exact > 0) {
      top *= pow(place, static_cast<unsigned long>(exact));
      c.singular.push_back(place);
      c.order.push_back(exact);
    } else if (exact < 0) {
      bottom *= pow(place, static_cast<unsigned long>(-exact));
    }
  }
  c.g = RationalFunction::from_coprime(top, bottom);
  const long places = degree(c.branch) + degree(c.branch) % 2;
  KOV_ENSURE(places >= 2);
  c.genus = places / 2 - 1;
  return c;
}

namespace {

// Points of the z-line over which eta has poles with residues +-rho, rho > 0.
struct PoleOfEta {
  Poly q = Poly(1); ///< monic squarefree; 1 at infinity
  bool at_infinity = false;
  Rational rho;
};

struct Poles {
  std::vector<PoleOfEta> list;
  std::optional<DihedralAnswer> infinite; ///< a residue or pole that already proves it
};

DihedralAnswer infinite_by(Torsion by, std::optional<Poly> pole,
                           std::optional<NfElem> residue_squared = {}) {
  DihedralAnswer answer;
  answer.finite = Truth::no;
  answer.by = by;
  answer.pole = std::move(pole);
  answer.residue_squared = std::move(residue_squared);
  return answer;
}

void add_pole(Poles& poles, PoleOfEta pole, const NfElem& square) {
  const auto rho = is_rational(square) ? exact_sqrt(to_rational(square)) : std::nullopt;
  if (!rho) {
    poles.infinite = infinite_by(Torsion::irrational_residue,
                                 pole.at_infinity ? std::nullopt : std::optional(pole.q), square);
    return;
  }
  pole.rho = *rho;
  poles.list.push_back(std::move(pole));
}

Poles poles_of(const DihedralCurve& c) {
  Poles poles;
  const NfElem scale_squared = c.w_squared / c.k; // W^2
  for (std::size_t i = 0; i < c.singular.size(); ++i) {
    const Poly& q = c.singular[i];
    if (c.order[i] > 1 || divides(q, c.branch)) {
      poles.infinite = infinite_by(Torsion::multiple_pole, q);
      return poles;
    }
    // residue^2 = W^2/(g'(c)^2 F0(c)) in K[c]/q; g = q * rest
    const Poly rest = exact_div(c.g.num(), q);
    const Poly slope = derivative(q) * rest % q;
    const Poly value = slope * slope % q * c.branch % q;
    const Poly den_squared = c.g.den() * c.g.den() % q;
    const Poly square = scale(den_squared * inverse_mod(value, q) % q, scale_squared);
    if (degree(square) > 0) {
      poles.infinite = infinite_by(Torsion::irrational_residue, q);
      return poles;
    }
    add_pole(poles, {q, false, {}}, square.coeff(0));
    if (poles.infinite) return poles;
  }
  // At an ordinary point y1/y2 has a simple zero or pole.
  if (degree(c.ordinary) > 0) poles.list.push_back({c.ordinary, false, Rational(1)});
  // at infinity, t = 1/z:  eta ~ -W/(lead(g) sigma) t^(deg g + genus - 1) dt  if unbranched there
  const long deg_g = degree(c.g.num()) - degree(c.g.den());
  const bool branched = degree(c.branch) % 2 == 1;
  // order of eta at infinity in t (in sqrt t for a branch point)
  const long order = branched ? 2 * deg_g + degree(c.branch) - 3 : deg_g + c.genus - 1;
  if (order < -1 || (branched && order < 0)) {
    poles.infinite = infinite_by(Torsion::multiple_pole, {});
  } else if (order == -1) {
    const NfElem leading = lead(c.g.num());
    add_pole(poles, {Poly(1), true, {}}, scale_squared / (leading * leading));
  }
  return poles;
}

struct ReducedClass {
  Jacobian jacobian;
  DivisorClass e;
};

// The class of E in the Jacobian modulo one prime; unset when the prime is not good.
class JacobianReduction {
public:
  JacobianReduction(const DihedralCurve& c, const std::vector<PoleOfEta>& poles, const Integer& l,
                    PrimeIdeal prime)
      : c_(c), poles_(poles), l_(l), prime_(prime) {}

  [[nodiscard]] std::optional<ReducedClass> divisor_class() {
    if (!set_curve()) return std::nullopt;
    const Jacobian jacobian(*model_);
    DivisorClass e = jacobian.zero();
    for (const PoleOfEta& pole : poles_) {
      const auto point = point_over(pole);
      if (!point) return std::nullopt;
      // L rho (P - P') ~ 2 L rho (P - infinity)
      const Rational multiple = Rational(2) * Rational(l_) * pole.rho;
      e = jacobian.add(e, jacobian.multiply(jacobian.reduce(*point), multiple.num()));
    }
    return ReducedClass{jacobian, e};
  }

private:
  // x = z, or x = 1/(z - e) for a root e of F0 when infinity is not a branch point
  bool set_curve() {
    const auto f0 = prime_.reduce(c_.branch);
    const auto top = prime_.reduce(c_.g.num());
    const auto bottom = prime_.reduce(c_.g.den());
    const auto square = prime_.reduce(c_.w_squared / c_.k);
    if (!f0 || !top || !bottom || !square || *square == 0 || prime_.p < 3) return false;
    if (degree(*top) != degree(c_.g.num()) || degree(*bottom) != degree(c_.g.den())) return false;
    if (degree(*f0) != degree(c_.branch) || degree(gcd(*f0, derivative(*f0))) > 0) return false;
    if (degree(gcd(*top, *bottom)) > 0 || degree(gcd(*top, *f0)) > 0) return false;
    if (degree(gcd(*top, derivative(*top))) > 0) return false;
    w_ = n_sqrtmod(*square, prime_.p);
    if (w_ == 0) return false;
    f0_ = *f0;
    g_num_ = *top;
    g_den_ = *bottom;
    if (degree(f0_) % 2 == 1) {
      model_ = f0_;
      return true;
    }
    const auto e = roots(f0_);
    if (e.empty()) return false;
    e_ = e.front();
    model_ = inverted(f0_, degree(f0_));
    return true;
  }

  // x^n f(e + 1/x)
  [[nodiscard]] NmodPoly inverted(const NmodPoly& f, long n) const {
    NmodPoly shifted = taylor_shift(f, *e_);
    NmodPoly result(f.modulus());
    nmod_poly_reverse(result.raw(), shifted.raw(), n + 1);
    return result;
  }

  // The point (or conjugate points) over the pole where the residue is +rho, as a Mumford pair.
  [[nodiscard]] std::optional<DivisorClass> point_over(const PoleOfEta& pole) const {
    const auto rho = prime_.reduce(pole.rho);
    if (!rho || *rho == 0) return std::nullopt;
    const nmod_t mod = f0_.mod();
    if (pole.at_infinity) { // x = 0, S(0) = sigma = -W/(lead(g) rho)
      NmodPoly u(prime_.p);
      u.set_coeff(1, 1);
      NmodPoly v(prime_.p);
      const mp_limb_t lead_g = g_num_.coeff(degree(g_num_)); // g_den is monic
      v.set_coeff(0, nmod_neg(nmod_div(w_, nmod_mul(lead_g, *rho, mod), mod), mod));
      return on_curve({u, v});
    }
    const auto q = prime_.reduce(pole.q);
    if (!q || degree(*q) != degree(pole.q)) return std::nullopt;
    // s = W g_den / (g_num' rho) modulo q
    NmodPoly s(prime_.p);
    NmodPoly slope(prime_.p);
    nmod_poly_rem(slope.raw(), derivative(g_num_).raw(), q->raw());
    if (nmod_poly_invmod(s.raw(), slope.raw(), q->raw()) == 0) return std::nullopt;
    nmod_poly_mulmod(s.raw(), s.raw(), remainder(g_den_, *q).raw(), q->raw());
    s = scale(s, nmod_div(w_, *rho, mod));
    if (!e_) return on_curve({*q, s});
    // S = s x^(genus+1): write s of degree < deg q as a polynomial in z, then substitute z = e +
    // 1/x
    const NmodPoly u = inverted(*q, degree(*q));
    if (degree(u) != degree(*q)) return std::nullopt; // e is not a pole
    const long n = degree(*q) - 1;
    NmodPoly v = inverted(s, n); // x^n s(e + 1/x)
    const long shift = c_.genus + 1 - n;
    NmodPoly x(prime_.p);
    x.set_coeff(1, 1);
    NmodPoly factor(prime_.p);
    if (shift >= 0) {
      nmod_poly_powmod_ui_binexp(factor.raw(), x.raw(), static_cast<ulong>(shift), u.raw());
    } else {
      NmodPoly inverse(prime_.p);
      if (nmod_poly_invmod(inverse.raw(), remainder(x, u).raw(), u.raw()) == 0) return std::nullopt;
      nmod_poly_powmod_ui_binexp(factor.raw(), inverse.raw(), static_cast<ulong>(-shift), u.raw());
    }
    nmod_poly_mulmod(v.raw(), remainder(v, u).raw(), remainder(factor, u).raw(), u.raw());
    return on_curve({monic(u), v});
  }

  [[nodiscard]] std::optional<DivisorClass> on_curve(const DivisorClass& d) const {
    KOV_ENSURE(is_zero(remainder(*model_ - d.v * d.v, d.u)));
    return d;
  }

  const DihedralCurve& c_;
  const std::vector<PoleOfEta>& poles_;
  const Integer& l_;
  PrimeIdeal prime_;
  mp_limb_t w_ = 0;
  std::optional<mp_limb_t> e_;
  NmodPoly f0_{3};
  NmodPoly g_num_{3};
  NmodPoly g_den_{3};
  std::optional<NmodPoly> model_;
};

// The degrees that a polynomial solution of the Fuchsian equation c2 A'' + c1 A' + c0 A = 0 may
// have: the natural roots D of lambda_2 D (D-1) + lambda_1 D + lambda_0, lambda_i the coefficient
// of z^(deg c2 - 2 + i) in c_i.  h(infinity+) = -h(infinity-) is possible: then the leading
// terms cancel in a = (h + its conjugate)/2, and the smaller root is the degree.
std::vector<long> degrees_at_infinity(const Poly& c2, const Poly& c1, const Poly& c0) {
  const long n = degree(c2);
  KOV_ENSURE(degree(c1) < n && degree(c0) < n - 1);
  const NfElem lead2 = c2.coeff(n);
  const Poly indicial = Poly::from_coefficients({c0.coeff(n - 2), c1.coeff(n - 1) - lead2, lead2});
  std::vector<long> degrees;
  for (const Factor& f : irreducible_factors(indicial)) {
    if (degree(f.base) != 1 || !is_rational(f.base.coeff(0))) continue;
    const Rational root = -to_rational(f.base.coeff(0));
    if (is_integer(root) && sign(root) >= 0 && fits_long(root.num()))
      degrees.push_back(to_long(root.num()));
  }
  return degrees;
}

// a with h = a + b s, dh/h = M eta:  (g a')' + g a' F0'/(2 F0) = M^2 W^2 a/(g F0).
// Requires  M rho integral at all poles
std::optional<RationalFunction> function_with_divisor(const DihedralCurve& c,
                                                      const std::vector<PoleOfEta>& poles,
                                                      const Rational& m, const Budget& budget) {
  Poly denominator(1);
  for (const PoleOfEta& pole : poles) {
    const Rational order = m * pole.rho;
    KOV_ENSURE(is_integer(order));
    const Integer needed = order.num() * Integer(std::max(degree(pole.q), 1L));
    if (!fits_long(needed))
      throw OutOfBudget("degree limit: a polynomial of degree " + to_string(needed) +
                        " would be needed");
    budget.check_degree(to_long(needed));
    if (!pole.at_infinity)
      denominator *= pow(pole.q, static_cast<unsigned long>(to_long(order.num())));
  }
  // a = A/denominator; substitute into a'' + (g'/g + F0'/(2F0)) a' - M^2 W^2/(g^2 F0) a = 0
  const RationalFunction f0(c.branch);
  const RationalFunction den(denominator);
  const RationalFunction p1 = derivative(c.g) / c.g + derivative(f0) / (RationalFunction(2) * f0);
  const RationalFunction p0 =
      RationalFunction(Poly(c.w_squared / c.k * NfElem(m * m))) / (c.g * c.g * f0);
  const RationalFunction l = -derivative(den) / den; // (1/den)'/(1/den)
  const RationalFunction c1 = RationalFunction(2) * l + p1;
  const RationalFunction c0 = derivative(l) + l * l + p1 * l - p0;
  const Poly common = lcm(c1.den(), c0.den());
  const Poly q1 = exact_div(common, c1.den()) * c1.num();
  const Poly q0 = exact_div(common, c0.den()) * c0.num();
  for (const long degree_a : degrees_at_infinity(common, q1, q0))
    if (const auto a = polynomial_solution(common, q1, q0, degree_a, budget))
      return RationalFunction(*a, denominator);
  return std::nullopt;
}

// The gcd of the integers L rho.
Integer common_multiplicity(const std::vector<PoleOfEta>& poles, const Integer& l) {
  Integer common(0);
  for (const PoleOfEta& pole : poles)
    common = gcd(common, (Rational(l) * pole.rho).num());
  return common;
}

// h = h1^(kappa/g), dh1/h1 = (M g/kappa) eta: the divisor of eta without its content kappa has an
// order that may be divisible by some g | kappa (docs/theory/dihedral_torsion.md, 9d).
bool is_power(const DihedralCurve& c, const std::vector<PoleOfEta>& poles, const Integer& m,
              const Integer& kappa, const Budget& budget) {
  constexpr long largest = 100;
  for (Integer g(1); g <= Integer(largest) && g < kappa; g += Integer(1))
    if (gcd(g, kappa) == g && function_with_divisor(c, poles, Rational(m * g, kappa), budget))
      return true;
  return false;
}

constexpr int prime_tries = 400;
constexpr int immense_orders = 2; ///< before the question is left to p-curvatures

// The order of E modulo a few primes: until two differ, or three agree (a third opinion is cheaper
// than a large h).
void reduce_modulo_primes(DihedralAnswer& answer, const DihedralCurve& c,
                          const std::vector<PoleOfEta>& poles, const Budget& budget) {
  PrimeIdeals primes(c.field, 2);
  int immense = 0;
  for (int tries = 0; tries < prime_tries && answer.orders.size() < 3; ++tries) {
    budget.check();
    const PrimeIdeal prime = primes.next();
    const auto reduced =
        JacobianReduction(c, poles, answer.residue_denominator, prime).divisor_class();
    if (!reduced) continue;
    const auto order = reduced->jacobian.order(reduced->e, budget);
    if (!order) {
      if (++immense == immense_orders) return;
      continue;
    }
    answer.orders.push_back({prime, *order});
    if (answer.orders.front().order == *order) continue;
    answer.finite = Truth::no;
    answer.by = Torsion::orders_differ;
    return;
  }
}

DihedralAnswer by_curvatures(DihedralAnswer answer, const DihedralCurve& c, const Singularities& s,
                             const Budget& budget) {
  answer.curvatures = infinite_by_curvatures(c, s, budget);
  if (!answer.curvatures) return answer;
  answer.finite = Truth::no;
  answer.by = Torsion::curvatures;
  return answer;
}

} // namespace

std::optional<RationalFunction> torsion_function(const DihedralCurve& c, const Integer& n,
                                                 const Budget& budget) {
  const Poles poles = poles_of(c);
  if (poles.infinite) return std::nullopt;
  return function_with_divisor(c, poles.list, Rational(n), budget);
}

DihedralAnswer decide_dihedral(const DihedralCurve& c, const Singularities& s,
                               const Budget& budget) {
  DihedralAnswer answer;
  const Poles poles = poles_of(c);
  if (poles.infinite) return *poles.infinite;
  for (const PoleOfEta& pole : poles.list)
    answer.residue_denominator = lcm(answer.residue_denominator, pole.rho.den());
  const Integer& l = answer.residue_denominator;
  if (poles.list.empty()) {
    KOV_ENSURE(c.genus >= 1); // a nonzero differential without poles needs genus >= 1
    answer.finite = Truth::no;
    answer.by = Torsion::holomorphic;
    return answer;
  }
  if (c.genus == 0) {
    answer.finite = Truth::yes;
    answer.by = Torsion::genus_zero;
    answer.n = l;
    return answer;
  }
  reduce_modulo_primes(answer, c, poles.list, budget);
  if (answer.by == Torsion::orders_differ) return answer;
  if (answer.orders.size() < 2) return by_curvatures(std::move(answer), c, s, budget);
  const Integer m = l * answer.orders.front().order;
  answer.n = m;
  try {
    answer.a = function_with_divisor(c, poles.list, Rational(m), budget);
    answer.finite = truth(answer.a.has_value());
  } catch (const OutOfBudget&) { // h may be a power of a function of small degree
    if (!is_power(c, poles.list, m, common_multiplicity(poles.list, l), budget)) throw;
    answer.finite = Truth::yes;
  }
  answer.by = answer.finite == Truth::yes ? Torsion::function : Torsion::no_function;
  return answer;
}

} // namespace kov
