#include "jets/logarithm.hpp"

#include <map>

namespace kov::jets {
namespace {

Rational binomial(std::size_t n, int m) {
  Rational b = 1;
  for (int i = 0; i < m; ++i)
    b *= Rational(static_cast<long>(n) - i, i + 1);
  return b;
}

class Jets {
public:
  Jets(const InvariantPlane& plane, const Place& p, int up_to, const Budget& budget)
      : plane_(plane), p_(p), up_to_(up_to), budget_(budget), across_(taylor(plane.across)),
        along_(taylor(plane.along)) {
    const auto c = [&](std::size_t i) { return MFraction::variable(plane.ring, i); };
    xi_ = {{}, c(plane.c1) * p.u1 + c(plane.c2) * p.u2};
    eta_ = {{}, {}}; // the energy is that of y(t) to the first order
  }

  std::optional<Logarithm> first() {
    const Rational sigma(-2, p_.degree - 2);
    const Rational tangential = (sigma - 1) * (sigma - 2);
    for (int j = 2; j <= up_to_; ++j) {
      budget_.check();
      const Series f = force(across_, j), g = force(along_, j);
      const MFraction r1 = residue(f, p_.u1), r2 = residue(f, p_.u2);
      KOV_ENSURE(is_zero(residue(g, p_.y_t)) && is_zero(residue(g, p_.y_e))); // (4.2)
      if (!is_zero(r1) || !is_zero(r2))
        return Logarithm{
            j, form(r1, r2, j), {xi_.begin() + 2, xi_.end()}, {eta_.begin() + 2, eta_.end()}};
      xi_.push_back(without_logarithm(f, p_.normal_force, p_.rho1 * (p_.rho1 - 1)));
      eta_.push_back(without_logarithm(g, p_.plane_force, tangential));
    }
    return std::nullopt;
  }

private:
  /// The Taylor coefficients of a force, by the exponents (a, m) of x^a (y - y(t))^m.
  using Taylor = std::map<std::pair<int, int>, Series>;

  // Without the linear part, which is the left side of the variational equations.
  [[nodiscard]] Taylor taylor(const MFraction& force) const {
    Taylor all;
    const auto in_x = coefficients(force, plane_.x);
    for (int a = 0; a < static_cast<int>(in_x.size()) && a <= up_to_; ++a) {
      const auto in_y = coefficients(p_.time_scale * in_x[static_cast<std::size_t>(a)], plane_.y);
      for (int m = 0; a + 2 * m <= up_to_; ++m) {
        budget_.check();
        Series sum;
        for (std::size_t b = in_y.size(); b-- > static_cast<std::size_t>(m);)
          sum = reduced(sum * p_.y) + Series::constant(binomial(b, m) * in_y[b]);
        if (a + m > 1 && !sum.is_exact_zero()) all[{a, m}] = reduced(sum);
      }
    }
    return all;
  }

  [[nodiscard]] Series reduced(const Series& f) const {
    if (!plane_.constants) return f;
    return map(f, 0, [&](const MFraction& c, long) { return plane_.reduced(c); });
  }

  // The part of degree j of the product of (..)^n with (..)^1, of series by degree.
  using Graded = std::vector<Series>;
  const Series& power(std::map<std::pair<int, int>, Series>& known, const Graded& base, int n,
                      int j) {
    if (n == 1) return base[static_cast<std::size_t>(j)];
    const auto [place, is_new] = known.try_emplace({n, j});
    if (!is_new) return place->second;
    Series sum;
    for (int i = 1; i <= j - n + 1; ++i)
      sum += base[static_cast<std::size_t>(i)] * power(known, base, n - 1, j - i);
    return known[{n, j}] = reduced(sum);
  }

  // The part of degree j of x^a (y - y(t))^m; those of x and y are not needed.
  Series monomial(int a, int m, int j) {
    if (m == 0) return power(xi_powers_, xi_, a, j);
    if (a == 0) return power(eta_powers_, eta_, m, j);
    Series sum;
    for (int i = a; i <= j - 2 * m; ++i)
      sum += power(xi_powers_, xi_, a, i) * power(eta_powers_, eta_, m, j - i);
    return sum;
  }

  Series force(const Taylor& taylor, int j) {
    Series sum;
    for (const auto& [exponents, coefficient] : taylor) {
      budget_.check();
      if (exponents.first + 2 * exponents.second <= j)
        sum += coefficient * monomial(exponents.first, exponents.second, j);
    }
    return reduced(sum);
  }

  // The residue of f u dt.
  [[nodiscard]] MFraction residue(const Series& f, const Series& u) const {
    return plane_.reduced(coefficient_of_product(f, u, -p_.ramification));
  }

  [[nodiscard]] Series without_logarithm(const Series& f, const Series& w,
                                         const Rational& lead) const {
    auto u = solution({w, lead, p_.ramification, p_.terms}, f, {}, plane_);
    KOV_ENSURE(u.has_value()); // the residues say so
    return *std::move(u);
  }

  // (4.3): dR/dc_i = -residue_i.
  [[nodiscard]] MFraction form(const MFraction& r1, const MFraction& r2, int j) const {
    const MFraction c1 = MFraction::variable(plane_.ring, plane_.c1);
    const MFraction c2 = MFraction::variable(plane_.ring, plane_.c2);
    const MFraction r = Rational(-1, j + 1) * (c1 * r1 + c2 * r2);
    KOV_ENSURE(is_zero(plane_.reduced(derivative(r, plane_.c1) + r1)));
    KOV_ENSURE(is_zero(plane_.reduced(derivative(r, plane_.c2) + r2)));
    return plane_.reduced(r);
  }

  const InvariantPlane& plane_;
  const Place& p_;
  int up_to_;
  const Budget& budget_;
  Taylor across_, along_;
  Graded xi_, eta_;
  std::map<std::pair<int, int>, Series> xi_powers_, eta_powers_;
};

} // namespace

std::optional<Logarithm> first_logarithm(const InvariantPlane& plane, const Place& p, int up_to,
                                         const Budget& budget) {
  return Jets(plane, p, up_to, budget).first();
}

} // namespace kov::jets
