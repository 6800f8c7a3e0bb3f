#include "jets/place.hpp"

#include <algorithm>

namespace kov::jets {
namespace {

constexpr long largest_ramification = 24;

long as_long(const Rational& q) {
  KOV_ENSURE(is_integer(q) && fits_long(q.num()));
  return to_long(q.num());
}

MFraction number(const InvariantPlane& plane, const Rational& q) { return {plane.ring, q}; }

MFraction on_the_plane(const InvariantPlane& plane, const MFraction& f) {
  return substitute(f, {{plane.x, MFraction(plane.ring)}});
}

// y'' = sum g_b y^b, the last coefficient sigma(sigma - 1), solved for y = t^sigma(1 + ...): with
// the coefficients of all powers of y.  [Knuth] 4.7 for the powers of a series.
class PlaneSolution {
public:
  PlaneSolution(const InvariantPlane& plane, std::vector<MFraction> g, long d, long terms,
                const Budget& budget)
      : plane_(plane), g_(std::move(g)), k_(static_cast<long>(g_.size())), d_(d) {
    sigma_ = as_long(Rational(-2 * d_, k_ - 2));
    powers_.assign(g_.size(), {number(plane, 1)});
    for (long n = 1; n < terms; ++n) {
      budget.check();
      add(n);
    }
  }

  [[nodiscard]] Series y() const {
    return {sigma_, powers_[1], sigma_ + static_cast<long>(powers_[1].size())};
  }

private:
  // The coefficient n of y^b without the term b y_n.
  [[nodiscard]] MFraction power(long b, long n) const {
    const auto& y = powers_[1];
    const auto& p = powers_[static_cast<std::size_t>(b)];
    MFraction sum(plane_.ring);
    for (long i = 1; i < n; ++i)
      sum += Rational((b + 1) * i - n, n) *
             (y[static_cast<std::size_t>(i)] * p[static_cast<std::size_t>(n - i)]);
    return sum;
  }

  void add(long n) {
    MFraction rest = g_.back() * power(k_ - 1, n);
    for (long b = 0; b < k_ - 1; ++b) {
      const long i = n + sigma_ * (k_ - 1 - b);
      if (b == 0 && i == 0) rest += g_[0];
      if (b > 0 && i >= 0)
        rest += g_[static_cast<std::size_t>(b)] *
                powers_[static_cast<std::size_t>(b)][static_cast<std::size_t>(i)];
    }
    rest = plane_.reduced(rest);
    const Rational sigma(sigma_, d_), m(sigma_ + n, d_);
    const Rational indicial = m * (m - 1) - Rational(k_ - 1) * sigma * (sigma - 1);
    if (is_zero(indicial)) {
      KOV_ENSURE(is_zero(rest)); // y is a Puiseux series: the equation has the integral H
      rest = MFraction::variable(plane_.ring, plane_.e);
    } else {
      rest = Rational(1) / indicial * rest;
    }
    std::vector<MFraction> next;
    for (long b = 1; b < k_; ++b)
      next.push_back(b == 1 ? rest : plane_.reduced(power(b, n) + Rational(b) * rest));
    for (long b = 1; b < k_; ++b)
      powers_[static_cast<std::size_t>(b)].push_back(next[static_cast<std::size_t>(b - 1)]);
  }

  const InvariantPlane& plane_;
  std::vector<MFraction> g_;
  long k_, d_, sigma_ = 0;
  std::vector<std::vector<MFraction>> powers_; ///< of y/t^sigma, by exponent; [0] is not used
};

Series polynomial_at(const std::vector<MFraction>& c, const Series& y, const InvariantPlane& plane,
                     const Budget& budget) {
  Series sum;
  for (std::size_t b = c.size(); b-- > 0;) {
    budget.check();
    sum = map(sum * y, 0, [&](const MFraction& x, long) { return plane.reduced(x); });
    sum += Series::constant(c[b]);
  }
  return sum;
}

Series time_derivative(const Series& f, long d) {
  return map(f, -d, [d](const MFraction& x, long m) { return Rational(m, d) * x; });
}

// H = y_t^2/(2 A scale) + potential: all coefficients but that of s^0 vanish.
MFraction energy_of(const InvariantPlane& plane, const Place& p, const Budget& budget) {
  const MFraction half = number(plane, Rational(1, 2)) / (plane.inertia * p.time_scale);
  Series h = half * (p.y_t * p.y_t);
  h += polynomial_at(coefficients(plane.potential, plane.y), p.y, plane, budget);
  for (long m = h.low(); m < std::min(h.end(), h.top()); ++m)
    KOV_ENSURE(m == 0 || is_zero(plane.reduced(h[m])));
  return plane.reduced(h[0]);
}

} // namespace

std::optional<Series> solution(const SecondOrder& equation, const Series& f,
                               std::optional<long> start, const InvariantPlane& plane) {
  const auto& [w, lead, d, terms] = equation;
  if (!start && f.is_exact_zero()) return Series();
  const long low = start ? *start : f.low() + 2 * d;
  const long known = std::min(f.end(), w.end() + low) + 2 * d;
  const long end = std::min(known, low + terms);
  std::vector<MFraction> u;
  for (long m = low; m < end; ++m) {
    MFraction rest = f[m - 2 * d];
    for (long n = 1 - 2 * d; n <= m - 2 * d - low; ++n)
      rest += w[n] * u[static_cast<std::size_t>(m - 2 * d - n - low)];
    const Rational t(m, d), indicial = t * (t - 1) - lead;
    if (!is_zero(rest)) rest = plane.reduced(rest);
    if (start && m == low) {
      KOV_ENSURE(is_zero(indicial) && is_zero(rest));
      u.push_back(number(plane, 1));
    } else if (is_zero(indicial)) {
      if (!is_zero(rest)) return std::nullopt;
      u.emplace_back();
    } else {
      u.push_back(Rational(1) / indicial * rest);
    }
  }
  return Series(low, std::move(u), end);
}

std::variant<Place, OutOfScope> place_at_infinity(const InvariantPlane& plane, long terms,
                                                  const Budget& budget) {
  std::vector<MFraction> g = coefficients(on_the_plane(plane, plane.along), plane.y);
  std::vector<MFraction> w =
      coefficients(on_the_plane(plane, derivative(plane.across, plane.x)), plane.y);
  Place p;
  p.degree = static_cast<long>(g.size());
  const long k = p.degree;
  if (k < 3) return OutOfScope::low_degree;
  if (static_cast<long>(w.size()) > k - 1) return OutOfScope::irregular;
  const Rational sigma(-2, k - 2), first = sigma * (sigma - 1);
  p.time_scale = plane.reduced(number(plane, first) / g.back());
  for (auto* all : {&g, &w})
    for (MFraction& c : *all)
      c = plane.reduced(p.time_scale * c);
  const MFraction lead = static_cast<long>(w.size()) == k - 1 ? w.back() : MFraction(plane.ring);
  if (!is_constant(lead)) return OutOfScope::exponents_with_parameters;
  const Rational alpha = to_rational(lead);
  const auto root = exact_sqrt(1 + 4 * alpha);
  if (!root || is_zero(*root)) return OutOfScope::exponents_irrational_or_equal;
  p.rho1 = (1 - *root) / 2;
  p.rho2 = (1 + *root) / 2;
  const Integer d = lcm(sigma.den(), lcm(p.rho1.den(), p.rho2.den()));
  if (d > Integer(largest_ramification)) return OutOfScope::large_denominator;
  p.ramification = to_long(d);
  p.terms = terms;
  budget.check();
  p.y = PlaneSolution(plane, g, p.ramification, terms, budget).y();
  p.y_t = time_derivative(p.y, p.ramification);
  p.y_e = map(p.y, 0, [&](const MFraction& c, long) { return derivative(c, plane.e); });
  p.normal_force = polynomial_at(w, p.y, plane, budget);
  for (std::size_t b = 0; b < g.size(); ++b)
    g[b] = Rational(static_cast<long>(b)) * g[b];
  g.erase(g.begin());
  p.plane_force = polynomial_at(g, p.y, plane, budget);
  p.energy = energy_of(plane, p, budget);
  const auto start = [&](const Rational& rho) { return as_long(rho * p.ramification); };
  const SecondOrder normal{p.normal_force, alpha, p.ramification, terms};
  const auto u1 = solution(normal, {}, start(p.rho1), plane);
  if (!u1) return OutOfScope::first_order_logarithm;
  p.u1 = *u1;
  p.u2 = *solution(normal, {}, start(p.rho2), plane);
  return p;
}

} // namespace kov::jets
