#include "strata/log_integral.hpp"

namespace kov::strata {
namespace {

using Line = std::vector<MFraction>; // a polynomial in z, ascending

Line line_of(const MPoly& f, std::size_t z) {
  const auto c = coefficients(f, z);
  return {c.begin(), c.end()};
}

// The rest of f after division by q.
Line rest_of(Line f, const Line& q) {
  while (f.size() >= q.size()) {
    const MFraction top = f.back() / q.back();
    const std::size_t shift = f.size() - q.size();
    for (std::size_t i = 0; i < q.size(); ++i)
      f[shift + i] -= top * q[i];
    f.pop_back();
  }
  return f;
}

MFraction value_of(const Line& f, const Ring& ring, std::size_t z) {
  MFraction sum(ring);
  for (std::size_t k = f.size(); k-- > 0;)
    sum = sum * MFraction::variable(ring, z) + f[k];
  return sum;
}

class LogIntegration {
public:
  LogIntegration(MFraction w, std::size_t z) : w_(std::move(w)), ring_(w_.ring()), z_(z) {
    y_.exponential = MFraction(ring_);
  }

  std::optional<LogIntegral> operator()() {
    const MFraction given = w_;
    const auto factors = factor(w_.den()).second;
    for (const MFactor& f : factors) {
      if (!uses(f.base, z_)) continue;
      const bool done = degree(f.base, z_) == 1 ? linear_pole(f) : simple_pole(f);
      if (!done) return std::nullopt;
    }
    if (!polynomial_part()) return std::nullopt;
    if (!is_zero(log_derivative(y_, z_) - given)) return std::nullopt;
    return std::move(y_);
  }

private:
  // The Laurent coefficients at e, from the deepest.
  bool linear_pole(const MFactor& f) {
    const auto line = coefficients(f.base, z_);
    const MFraction e = -MFraction(line[0]) / MFraction(line[1]);
    const MFraction distance = MFraction::variable(ring_, z_) - e;
    for (long k = f.exponent; k > 0; --k) {
      const MFraction c = substitute(w_ * pow(distance, k), {{z_, e}});
      if (is_zero(c)) continue;
      w_ -= c / pow(distance, k);
      if (k == 1)
        y_.powers.emplace_back(f.base, c);
      else
        y_.exponential += Rational(-1, k - 1) * c / pow(distance, k - 1);
    }
    return true;
  }

  // lambda q'/q
  bool simple_pole(const MFactor& f) {
    if (f.exponent != 1) return false;
    const Line q = line_of(f.base, z_);
    const MPoly others = exact_div(w_.den(), f.base);
    Line above = rest_of(line_of(w_.num(), z_), q);
    Line slope = rest_of(line_of(derivative(f.base, z_) * others, z_), q);
    for (Line* one : {&above, &slope})
      one->resize(q.size() - 1, MFraction(ring_));
    std::optional<MFraction> lambda;
    for (std::size_t i = 0; i < slope.size(); ++i)
      if (!is_zero(slope[i]) && !lambda) lambda = above[i] / slope[i];
    if (!lambda) return false;
    for (std::size_t i = 0; i < slope.size(); ++i)
      if (!is_zero(above[i] - *lambda * slope[i])) return false;
    w_ -= *lambda * MFraction(derivative(f.base, z_)) / MFraction(f.base);
    y_.powers.emplace_back(f.base, *lambda);
    return true;
  }

  bool polynomial_part() {
    if (uses(w_.den(), z_)) return false;
    Line p{MFraction(ring_)};
    const MFraction den(w_.den());
    for (const MPoly& c : coefficients(w_.num(), z_))
      p.push_back(Rational(1, static_cast<long>(p.size())) * MFraction(c) / den);
    y_.exponential += value_of(p, ring_, z_);
    return true;
  }

  MFraction w_;
  Ring ring_;
  std::size_t z_;
  LogIntegral y_;
};

} // namespace

std::optional<LogIntegral> log_integral(const MFraction& w, std::size_t z) {
  return LogIntegration(w, z)();
}

MFraction log_derivative(const LogIntegral& y, std::size_t z) {
  MFraction w = derivative(y.exponential, z);
  for (const auto& [base, exponent] : y.powers)
    w += exponent * MFraction(derivative(base, z)) / MFraction(base);
  return w;
}

Defined defined_where(const LogIntegral& y, std::size_t z) {
  Defined d;
  for (const auto& [base, exponent] : y.powers) {
    d.denominators.push_back(exponent.den());
    d.bases.push_back(coefficients(base, z));
  }
  // one coefficient of each factor of the denominator
  if (!is_zero(y.exponential))
    for (const MFactor& f : factor(y.exponential.den()).second)
      d.bases.push_back(coefficients(f.base, z));
  return d;
}

} // namespace kov::strata
