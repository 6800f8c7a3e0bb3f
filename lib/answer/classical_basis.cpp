#include "answer/classical_basis.hpp"

#include "answer/surd.hpp"
#include "exact/variables.hpp"
#include "strata/log_integral.hpp"
#include "symbol/written.hpp"

#include <algorithm>
#include <map>

namespace kov::answer {
namespace {

using trees::call;
using trees::from;
using trees::negative;
using trees::number;
using trees::product;

const Expression half = number(Rational(1, 2)), zero = number(0);

// Powers of polynomials times exp of something.
struct Prefactor {
  std::vector<std::pair<MPoly, Surd>> powers;
  Surd exponential;

  void times(const MPoly& base, const Surd& exponent) {
    const auto same = std::ranges::find(powers, base, &std::pair<MPoly, Surd>::first);
    if (same == powers.end())
      powers.emplace_back(base, exponent);
    else
      same->second = same->second + exponent;
  }
  [[nodiscard]] Surd at(const MPoly& base) const {
    const auto same = std::ranges::find(powers, base, &std::pair<MPoly, Surd>::first);
    return same == powers.end() ? Surd() : same->second;
  }
  [[nodiscard]] Expression formula() const {
    std::vector<Expression> all;
    for (const auto& [base, exponent] : powers)
      if (!is_zero(exponent)) all.push_back(trees::power(from(base), exponent.formula()));
    if (!is_zero(exponential)) all.push_back(call("exp", {exponential.formula()}));
    return product(all);
  }
  // The simpler, the smaller.
  [[nodiscard]] std::size_t weight() const {
    std::size_t w = is_zero(exponential) ? 0 : 100;
    for (const auto& [base, exponent] : powers)
      if (!is_zero(exponent)) w += number_in(exponent) ? 60 : 100;
    return w + trees::length_of(formula());
  }
};

bool is_whole(const Surd& a, int sign_of) { // 0, sign_of, 2 sign_of, ...
  const auto c = number_in(a);
  return c && is_integer(*c) && sign(*c) * sign_of >= 0;
}
bool is_whole(const Surd& a) {
  const auto c = number_in(a);
  return c && is_integer(*c);
}

/// y'' + p y' + q y = 0 with its normal form, the poles of r, and exp(-1/2 int p).
class Equation {
public:
  Equation(const MFraction& p, const MFraction& q, std::size_t z)
      : z_(z), ring_(p.ring()), p_(p),
        r_(Rational(1, 2) * derivative(p, z) + Rational(1, 4) * p * p - q) {}

  /// Is everything known that the searches need?
  bool prepare() {
    if (is_zero(r_) || degree(r_.num(), z_) > largest || degree(r_.den(), z_) > largest)
      return false;
    if (!is_zero(p_)) {
      const auto gauge = strata::log_integral(Rational(-1, 2) * p_, z_);
      if (!gauge) return false;
      for (const auto& [base, exponent] : gauge->powers)
        gauge_.times(base, exponent);
      gauge_.exponential = gauge->exponential;
    }
    return find_places();
  }
  [[nodiscard]] const std::vector<MFraction>& places() const { return places_; }

protected:
  static constexpr long largest = 8;

  [[nodiscard]] MFraction constant(const Rational& c) const { return {ring_, c}; }
  [[nodiscard]] MFraction z() const { return MFraction::variable(ring_, z_); }
  // As factor() writes it.
  [[nodiscard]] MPoly base_at(const MFraction& c) const {
    const auto factors = factor((z() - c).num()).second;
    return std::ranges::find_if(factors, [&](const MFactor& f) { return uses(f.base, z_); })->base;
  }
  void need(const MPoly& f) {
    if (is_constant(f)) return;
    for (const MFactor& x : factor(f).second)
      if (!uses(x.base, z_) && !is_among(x.base, nonzero_)) nonzero_.push_back(x.base);
  }

  // The poles of r, if all are known.
  bool find_places() {
    need(r_.den());
    if (!uses(r_.den(), z_)) return true;
    for (const MFactor& f : factor(r_.den()).second) {
      const long d = degree(f.base, z_);
      if (d == 0) continue;
      if (d > 1) return false;
      const auto c = coefficients(f.base, z_);
      places_.push_back(-MFraction(c[0], c[1]));
      orders_.push_back(f.exponent);
      need(c[1]);
    }
    return true;
  }

  [[nodiscard]] ClassicalBasis found(Classical family, const Expression& first,
                                     const Expression& second,
                                     std::vector<std::string> unless = {}) const {
    return {family, first, second, nonzero_, std::move(unless)};
  }

  // The sign of the number in front.
  static bool is_negative(const MFraction& a) {
    return !is_zero(a) && sign(a.num().coefficient(0)) < 0;
  }

  std::size_t z_;
  Ring ring_;
  MFraction p_, r_;
  Prefactor gauge_;
  std::vector<MFraction> places_;
  std::vector<long> orders_;
  std::vector<MPoly> nonzero_;
};

/// x^2 r = C + B x^e + A x^(2e), x = z - c.
class OneCentre : Equation {
public:
  explicit OneCentre(const Equation& e) : Equation(e) {}

  std::optional<ClassicalBasis> operator()() {
    MFraction centre = constant(0);
    if (!places_.empty()) {
      centre = places_.front();
    } else {
      const auto c = coefficients(r_.num(), z_);
      if (c.size() < 2) return std::nullopt; // a constant
      const long n = static_cast<long>(c.size()) - 1;
      centre = -(Rational(1, n) * MFraction(c[c.size() - 2], c.back()));
      need(c.back());
    }
    const MFraction there = z() * z() * substitute(r_, {{z_, z() + centre}});
    const auto below = coefficients(there.den(), z_);
    if (std::ranges::count_if(below, [](const MPoly& c) { return !is_zero(c); }) != 1)
      return std::nullopt;
    const long shift = static_cast<long>(below.size()) - 1;
    std::map<long, MFraction> terms;
    const auto above = coefficients(there.num(), z_);
    for (std::size_t i = 0; i < above.size(); ++i)
      if (!is_zero(above[i]))
        terms[static_cast<long>(i) - shift] = MFraction(above[i], below.back());
    c_ = terms.contains(0) ? terms.at(0) : constant(0);
    terms.erase(0);
    x_ = z() - centre;
    base_ = base_at(centre);
    if (terms.size() == 1) return one_power(terms.begin()->first, terms.begin()->second);
    if (terms.size() != 2) return std::nullopt;
    const auto [small, large] = std::pair{*terms.begin(), *terms.rbegin()};
    if (large.first == 2 * small.first) return two_powers(small.first, small.second, large.second);
    if (small.first == 2 * large.first) return two_powers(large.first, large.second, small.second);
    return std::nullopt;
  }

private:
  // The exponent difference at the centre.
  [[nodiscard]] Surd delta() const { return Surd::root(constant(1) + Rational(4) * c_); }
  [[nodiscard]] Expression power_of_x(const Rational& e) const {
    return trees::power(from(x_), number(e));
  }

  std::optional<ClassicalBasis> one_power(long e, const MFraction& a) {
    if (e == 2 && is_zero(c_)) return std::nullopt;
    need(a.num());
    if (e == 3 && is_zero(c_)) {
      const Expression argument = product({cube_root(a), from(x_)});
      const Expression front = gauge_.formula();
      return found(Classical::airy, product({front, call("airyai", {argument})}),
                   product({front, call("airybi", {argument})}));
    }
    const bool minus = is_negative(a);
    const MFraction size = minus ? -a : a;
    const long n = e < 0 ? -e : e;
    const Expression argument =
        product({number(Rational(2, n)), Surd::root(size).formula(), power_of_x(Rational(e, 2))});
    Surd order = constant(Rational(1, n)) * delta();
    if (order.is_fraction() && is_negative(order.rational_part())) order = -order;
    Prefactor front = gauge_;
    front.times(base_, constant(Rational(1, 2)));
    const auto with = [&](const char* function) {
      return product({front.formula(), call(function, {order.formula(), argument})});
    };
    return found(Classical::bessel, with(minus ? "besselj" : "besseli"),
                 with(minus ? "bessely" : "besselk"));
  }

  static Expression cube_root(const MFraction& a) {
    if (is_negative(a)) return negative(cube_root(-a));
    std::vector<Expression> factors;
    for (const bool above : {true, false}) {
      const auto [content, powers] = factor(above ? a.num() : a.den());
      const auto take = [&](const Expression& base, long e) {
        factors.push_back(trees::power(base, number(Rational(above ? e : -e, 3))));
      };
      Integer rest = content;
      for (long k = 2; k <= 100; ++k) // 8^(1/3) is 2
        for (const Integer cube = Integer(k) * Integer(k) * Integer(k);
             is_zero(rest - cube * floor_div(rest, cube));) {
          rest = exact_div(rest, cube);
          take(number(Rational(k)), 3);
        }
      if (!(rest == Integer(1))) take(number(Rational(rest)), 1);
      for (const MFactor& f : powers)
        take(from(f.base), f.exponent);
    }
    return product(factors);
  }

  std::optional<ClassicalBasis> two_powers(long e, const MFraction& b, const MFraction& a) {
    need(a.num());
    auto kummer = confluent(e, b, a);
    if (e != 2 || !is_zero(c_)) return kummer;
    // u'' = (a x^2 + b) u
    const Prefactor front = gauge_;
    const bool better =
        kummer && front.weight() > 100 && trees::length_of(kummer->first) < front.weight();
    if (better) return kummer;
    const Surd root = Surd::root(a); // of 4 a = scale^4
    if (!root.is_fraction() && !is_constant(a)) return kummer;
    const MFraction two = constant(2);
    Expression scale = trees::power((two * root).formula(), half);
    Surd nu = constant(Rational(-1, 2));
    if (root.is_fraction()) {
      nu = nu - Surd(Rational(1, 2) * b / root.rational_part());
    } else { // 1/sqrt(a) = sqrt(a)/a
      nu = nu - (Rational(1, 2) * b / a) * root;
      if (const auto c = is_constant(a) ? std::optional(to_rational(a)) : std::nullopt;
          c && sign(*c) < 0) // 2 I s = (1 + I)^2 s
        scale = product({trees::sum({number(1), trees::name("I")}),
                         trees::power(Surd::root(-a).formula(), half)});
    }
    const Expression argument = product({scale, from(x_)});
    const auto with = [&](const Expression& x) {
      return product({front.formula(), call("pcfd", {nu.formula(), x})});
    };
    std::vector<std::string> unless;
    if (!number_in(nu)) unless.push_back(written(nu.formula()) + " is 0, 1, 2, ...");
    return found(Classical::weber, with(argument), with(negative(argument)), std::move(unless));
  }

  // x^((1+d)/2) exp(-t/2) M(a, b, t), t = 2 sqrt(A) x^e/e
  std::optional<ClassicalBasis> confluent(long e, const MFraction& b, const MFraction& a) {
    const Surd root = Surd::root(a), d = delta();
    const MFraction half_one = constant(Rational(1, 2)), z_to_e = pow(x_, e);
    // k = -B/(2 e sqrt(A)), with the sign of the root
    Surd k = (Rational(-1, 2 * e) * b / a) * root;
    if (root.is_fraction()) k = Rational(-1, 2 * e) * b / root.rational_part();
    std::optional<ClassicalBasis> best;
    std::size_t weight = 0;
    for (const bool plus : {true, false})
      for (const bool decreasing : {true, false}) {
        const Surd delta = plus ? d : -d, rt = decreasing ? root : -root, kk = decreasing ? k : -k;
        const Surd second = Surd(constant(1)) + constant(Rational(1, e)) * delta;
        if (is_whole(second, -1)) continue;
        const Surd first = half_one * second - kk;
        Prefactor front = gauge_;
        front.times(base_, half_one * (Surd(constant(1)) + delta));
        front.exponential = front.exponential - (Rational(1, e) * z_to_e) * rt;
        const std::size_t w = front.weight() + trees::length_of(first.formula()) +
                              (decreasing ? 0 : 3) + // M(a, b, x) rather than M(a, b, -x)
                              (falls(second) ? 200 : 0);
        if (best && w >= weight) continue;
        weight = w;
        best = kummer(front, first, second,
                      product({number(Rational(2, e)), rt.formula(), power_of_x(Rational(e))}), e);
        if (is_zero(d)) break;
      }
    return best;
  }

  // M(a, -2 l, x) has no value for l = 0, 1, 2, ...
  static bool falls(const Surd& b) {
    return b.is_fraction() && !is_constant(b.rational_part()) && is_negative(b.rational_part());
  }

  [[nodiscard]] ClassicalBasis kummer(const Prefactor& front, const Surd& a, const Surd& b,
                                      const Expression& t, long e) const {
    const Expression first =
        product({front.formula(), call("hyp1f1", {a.formula(), b.formula(), t})});
    if (number_in(b) && !is_whole(b)) {
      Prefactor other = front;
      const MFraction one = constant(1);
      const Surd down = Surd(one) - b;
      other.times(base_, constant(Rational(e)) * down);
      return found(Classical::whittaker, first,
                   product({other.formula(), call("hyp1f1", {(a + down).formula(),
                                                             (Surd(one) + down).formula(), t})}));
    }
    std::vector<std::string> unless;
    for (const Surd& s : {a, b})
      if (!number_in(s)) unless.push_back(written(s.formula()) + " is 0, -1, -2, ...");
    return found(Classical::whittaker, first,
                 product({front.formula(), call("hyperu", {a.formula(), b.formula(), t})}),
                 std::move(unless));
  }

  MFraction c_, x_;
  MPoly base_;
};

/// Three regular places and nothing else.
class ThreeSingularPlaces : Equation {
public:
  explicit ThreeSingularPlaces(const Equation& e) : Equation(e) {}

  std::optional<ClassicalBasis> operator()() {
    const bool regular = std::ranges::all_of(orders_, [](long o) { return o <= 2; });
    const long order = degree(r_.den(), z_) - degree(r_.num(), z_);
    if (!regular || order < 2) return std::nullopt;
    if (places_.size() == 2 && order < 4) {
      std::ranges::sort(places_, [](const MFraction& x, const MFraction& y) {
        return (is_zero(x) && !is_zero(y)) ||
               (!is_zero(y) && to_string(x).size() < to_string(y).size());
      });
      need((places_[0] - places_[1]).num());
      if (auto legendre = by_legendre()) return legendre;
      return hypergeometric(std::nullopt, difference_at_infinity());
    }
    if (places_.size() == 3 && order >= 4) {
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < i; ++j)
          need((places_[i] - places_[j]).num());
      const MFraction last = places_[2];
      return hypergeometric(last, difference_at(last));
    }
    return std::nullopt;
  }

private:
  // 1 + 4 lim (z - c)^2 r
  [[nodiscard]] Surd difference_at(const MFraction& c) const {
    const MFraction x = z() - c;
    return Surd::root(constant(1) + Rational(4) * substitute(x * x * r_, {{z_, c}}));
  }
  [[nodiscard]] Surd difference_at_infinity() const {
    const long order = degree(r_.den(), z_) - degree(r_.num(), z_);
    if (order > 2) return constant(1);
    return Surd::root(constant(1) + Rational(4) * MFraction(coefficients(r_.num(), z_).back(),
                                                            coefficients(r_.den(), z_).back()));
  }

  // Places -c and c, the gauge (z^2 - c^2)^(-1/2).
  std::optional<ClassicalBasis> by_legendre() {
    if (!is_zero(places_[0] + places_[1])) return std::nullopt;
    const Surd m = difference_at(places_[0]);
    if (!is_zero(m - difference_at(places_[1]))) return std::nullopt;
    Prefactor front = gauge_;
    for (const MFraction& c : places_)
      front.times(base_at(c), constant(Rational(1, 2)));
    for (const auto& [base, exponent] : front.powers)
      if (!is_zero(exponent)) return std::nullopt;
    if (!is_zero(front.exponential)) return std::nullopt;
    const MFraction c = is_negative(places_[0]) ? places_[1] : places_[0];
    const Surd nu = constant(Rational(1, 2)) * (difference_at_infinity() - Surd(constant(1)));
    const auto with = [&](const char* function) {
      return call(function, {nu.formula(), m.formula(), from(z() / c)});
    };
    std::vector<std::string> unless;
    if (!number_in(nu + m))
      unless.push_back(written((nu + m).formula()) + " is a negative integer");
    return found(Classical::riemann, with("legenp"), with("legenq"), std::move(unless));
  }

  // A, B = places_[0], [1] and C (unset: infinity) go to 0, 1, infinity.
  std::optional<ClassicalBasis> hypergeometric(const std::optional<MFraction>& last,
                                               const Surd& n) {
    const MFraction one = constant(1), h = constant(Rational(1, 2));
    const Surd l = difference_at(places_[0]), m = difference_at(places_[1]);
    const MFraction t = last ? (z() - places_[0]) * (places_[1] - *last) /
                                   ((z() - *last) * (places_[1] - places_[0]))
                             : (z() - places_[0]) / (places_[1] - places_[0]);
    const MPoly at_a = base_at(places_[0]), at_b = base_at(places_[1]);
    if (is_zero(l - Surd(h)) && is_zero(m - Surd(h)) && !is_zero(n)) { // Chebyshev's equation
      Prefactor front = gauge_;
      for (const MPoly& base : {at_a, at_b})
        front.times(base, constant(Rational(1, 4)));
      if (last) front.times(base_at(*last), h);
      const Expression angle =
          product({(h * n).formula(), call("acos", {from(one - Rational(2) * t)})});
      std::vector<std::string> unless;
      if (!number_in(n)) unless.push_back(written((h * n).formula()) + " is 0");
      return found(Classical::riemann, product({front.formula(), call("cos", {angle})}),
                   product({front.formula(), call("sin", {angle})}), std::move(unless));
    }
    std::optional<ClassicalBasis> best;
    std::size_t weight = 0;
    for (const bool l_plus : {true, false})
      for (const bool m_plus : {true, false}) {
        // t^((1-l)/2) (1-t)^((1-m)/2) 2F1((1-l-m-n)/2, (1-l-m+n)/2; 1-l; t)
        const Surd ll = l_plus ? l : -l, mm = m_plus ? m : -m;
        const Surd sum = Surd(one) - ll - mm, c = Surd(one) - ll;
        Surd a = h * (sum - n), b = h * (sum + n);
        if (written(b.formula()) < written(a.formula())) std::swap(a, b);
        const Surd other = a + b - c + Surd(one);
        const bool alone = is_whole(c);
        if (is_whole(c, -1) || (alone && is_whole(other, -1))) continue;
        Prefactor front = gauge_;
        front.times(at_a, h * (Surd(one) - ll));
        front.times(at_b, h * (Surd(one) - mm));
        if (last) front.times(base_at(*last), h * (ll + mm)); // with 1/sqrt(t')
        const std::size_t w =
            front.weight() + trees::length_of(a.formula()) + trees::length_of(b.formula());
        if (best && w >= weight) continue;
        weight = w;
        best = of_gauss(front, a, b, c, t, at_a, last);
      }
    return best;
  }

  [[nodiscard]] ClassicalBasis of_gauss(const Prefactor& front, const Surd& a, const Surd& b,
                                        const Surd& c, const MFraction& t, const MPoly& at_a,
                                        const std::optional<MFraction>& last) const {
    const Surd one(constant(1));
    const auto with = [&](const Prefactor& f, const Surd& x, const Surd& y, const Surd& w,
                          const MFraction& argument) {
      return product(
          {f.formula(), call("hyp2f1", {x.formula(), y.formula(), w.formula(), from(argument)})});
    };
    const Expression first = with(front, a, b, c, t);
    std::vector<std::string> unless;
    if (is_whole(c)) {
      const Surd other = a + b - c + one;
      for (const Surd& s : {a, b, other})
        if (!number_in(s)) unless.push_back(written(s.formula()) + " is 0, -1, -2, ...");
      return found(Classical::riemann, first, with(front, a, b, other, constant(1) - t),
                   std::move(unless));
    }
    if (!number_in(c)) unless.push_back(written(c.formula()) + " is an integer");
    Prefactor second = front;
    second.times(at_a, one - c);
    if (last) second.times(base_at(*last), c - one);
    return found(Classical::riemann, first,
                 with(second, a - c + one, b - c + one, one + one - c, t), std::move(unless));
  }
};

std::optional<ClassicalBasis> searched(const MFraction& p, const MFraction& q, std::size_t z) {
  Equation equation(p, q, z);
  if (!equation.prepare()) return std::nullopt;
  if (equation.places().size() <= 1)
    if (auto found = OneCentre(equation)()) return found;
  return ThreeSingularPlaces(equation)();
}

// An equation that does not change with z -> -z, in s = z^2: y'' = 4 s y_ss + 2 y_s.
std::optional<ClassicalBasis> behind_the_square(const MFraction& p, const MFraction& q,
                                                std::size_t z) {
  const Ring& ring = p.ring();
  const MFraction s = MFraction::variable(ring, z);
  const Substitution mirror{{z, -s}};
  if (!is_zero(substitute(p, mirror) + p) || !is_zero(substitute(q, mirror) - q))
    return std::nullopt;
  const MFraction by_z = in_power(p / s, z, 2), one(ring, Rational(1));
  auto found =
      searched(Rational(1, 2) * (one + s * by_z) / s, Rational(1, 4) * in_power(q, z, 2) / s, z);
  if (!found) return std::nullopt;
  const std::string& letter = ring->name(z);
  const std::map<std::string, Expression> square{
      {letter, trees::power(trees::name(letter), number(2))}};
  found->first = trees::rebuilt(found->first, square);
  found->second = trees::rebuilt(found->second, square);
  return found;
}

} // namespace

std::optional<ClassicalBasis> classical_basis(const MFraction& p, const MFraction& q,
                                              std::size_t z) {
  const Ring& ring = p.ring() ? p.ring() : q.ring();
  if (!ring) return std::nullopt;
  const MFraction first = p.ring() ? p : MFraction(ring), second = q.ring() ? q : MFraction(ring);
  if (auto found = searched(first, second, z)) return found;
  return behind_the_square(first, second, z);
}

} // namespace kov::answer
