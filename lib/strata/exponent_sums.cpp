#include "strata/exponent_sums.hpp"

#include <algorithm>
#include <set>

namespace kov::strata {
namespace {

const Rational one_half(1, 2);
constexpr std::size_t most_sums = 1000;

// d = fixed + (sum of the numbers, each with a sign)/2, for one of the fixed ones.
class ExponentSums {
public:
  explicit ExponentSums(const Scheme& s) : s_(s) {}

  std::optional<std::variant<bool, SumIn>> run() {
    for (PlaceIndex i = 0; i < number_of_places(s_); ++i)
      if (!add(place_at(s_, i))) return std::nullopt;
    if (numbers_.size() > 3) return std::nullopt;
    if (numbers_.empty()) {
      const bool possible = std::ranges::any_of(
          fixed_, [](const Rational& d) { return is_integer(d) && sign(d) >= 0; });
      if (possible) return std::nullopt;
      return false;
    }
    SumIn sum{numbers_, classes()};
    const bool odd = sum.classes.size() == 1 && sum.classes[0].a == Rational(1);
    if (numbers_.size() == 3 && !odd) return std::nullopt;
    return sum;
  }

private:
  // False: no formula.
  bool add(const ParametricPlace& p) {
    const Rational side(p.at_infinity ? 1 : -1);
    switch (p.kind) {
    case PlaceKind::ordinary:
      return !p.at_infinity || choose({Rational(0), Rational(1)});
    case PlaceKind::simple:
      for (long k = p.at_infinity ? 0 : p.degree(s_.z); k > 0; --k)
        if (!choose({Rational(-1)})) return false;
      return true;
    case PlaceKind::regular:
      for (long k = 0; k < p.degree(s_.z); ++k)
        if (!add_regular(p, side)) return false;
      return true;
    case PlaceKind::irregular:
      return p.degree(s_.z) == 1 && add_irregular(p, side);
    default:
      return false;
    }
  }

  bool choose(const std::vector<Rational>& choices) {
    std::set<Rational> sums;
    for (const Rational& d : fixed_)
      for (const Rational& c : choices)
        sums.insert(d + c);
    fixed_ = std::move(sums);
    return fixed_.size() <= most_sums;
  }

  // side (1 +- Delta)/2; with a logarithm the exponent of the solution without one.
  bool add_regular(const ParametricPlace& p, const Rational& side) {
    if (p.exponent == ExponentKind::rational) {
      std::vector<Rational> choices{side * one_half * (Rational(1) - side * p.delta)};
      if (p.log != Truth::yes) choices.push_back(side * one_half * (Rational(1) + side * p.delta));
      return choose(choices);
    }
    if (p.chi.size() != 2) return false;
    numbers_.push_back(-(p.chi[0] / p.chi[1]));
    return choose({side * one_half});
  }

  // At infinity (e - nu)/2, at a finite place -(e + nu)/2, e up to sign.
  bool add_irregular(const ParametricPlace& p, const Rational& side) {
    const long nu = p.at_infinity ? (p.order - 4) / 2 : p.order / 2;
    const auto square =
        exponent_squared(p, static_cast<std::size_t>(side == Rational(1) ? nu + 1 : nu - 1));
    if (!is_zero(square)) numbers_.push_back(square);
    return choose({Rational(-nu) * one_half});
  }

  // r = c0 t^-2nu (q(t)^2 + b t^K + ...), q = 1 + ... of degree < K: c0 b^2.
  [[nodiscard]] MFraction exponent_squared(const ParametricPlace& p, std::size_t K) const {
    const auto c = expansion(p, K + 1);
    std::vector<MFraction> q{c[0] / c[0]};
    const auto products = [&](std::size_t k) {
      MFraction sum(s_.r.ring());
      for (std::size_t i = 1; i < k; ++i)
        if (i < q.size() && k - i < q.size()) sum += q[i] * q[k - i];
      return sum;
    };
    for (std::size_t k = 1; k < K; ++k)
      q.push_back(one_half * (c[k] / c[0] - products(k)));
    const MFraction b = c[K] / c[0] - products(K);
    return b * b * c[0];
  }

  // The first n coefficients of r at the place, from that of the pole on.
  [[nodiscard]] std::vector<MFraction> expansion(const ParametricPlace& p, std::size_t n) const {
    const MFraction t = MFraction::variable(s_.r.ring(), s_.z);
    MFraction r = s_.r;
    if (p.at_infinity) {
      r = substitute(r, {{s_.z, pow(t, -1)}});
    } else {
      const auto line = coefficients(p.q, s_.z);
      r = substitute(r, {{s_.z, t - MFraction(line[0]) / MFraction(line[1])}});
    }
    const auto num = from_the_first(coefficients(r.num(), s_.z));
    const auto den = from_the_first(coefficients(r.den(), s_.z));
    std::vector<MFraction> c;
    for (std::size_t k = 0; k < n; ++k) {
      MFraction sum = k < num.size() ? MFraction(num[k]) : MFraction(s_.r.ring());
      for (std::size_t i = 0; i < k; ++i)
        if (k - i < den.size()) sum -= c[i] * MFraction(den[k - i]);
      c.push_back(sum / MFraction(den[0]));
    }
    return c;
  }
  static std::vector<MPoly> from_the_first(std::vector<MPoly> c) {
    c.erase(c.begin(), std::ranges::find_if(c, [](const MPoly& f) { return !is_zero(f); }));
    return c;
  }

  // 2 fixed + the sum is in 2 N.
  [[nodiscard]] std::vector<Residues> classes() const {
    std::set<Rational> folded;
    for (const Rational& d : fixed_) {
      const Rational twice = Rational(2) * d;
      const Rational a = twice - Rational(2) * Rational(floor(d));
      folded.insert(std::min(a, Rational(2) - a));
    }
    std::vector<Residues> all;
    for (const Rational& a : folded)
      all.push_back({a == Rational(2) ? Rational(0) : a, Rational(2)});
    return all;
  }

  const Scheme& s_;
  std::set<Rational> fixed_{Rational(0)};
  Squares numbers_;
};

} // namespace

std::optional<std::variant<bool, SumIn>> exponential_needs(const Scheme& s) {
  return ExponentSums(s).run();
}

} // namespace kov::strata
