#include "elementary/rational_integral.hpp"

#include "elementary/linear_system.hpp"

#include <cmath>
#include <numeric>

namespace kov::elementary {
namespace {

constexpr std::size_t x = Letters::x;
constexpr long most_degree = 60;

using Factors = std::vector<MFactor>;

class RationalIntegral {
public:
  RationalIntegral(LettersPtr letters, bool near_zero)
      : letters_(std::move(letters)), near_zero_(near_zero) {}

  // top / prod q^e, where the q are coprime and free of squares
  std::optional<Element> operator()(const MFraction& top, const Factors& factors) const {
    if (is_zero(top)) return Element(letters_);
    long bottom = 0;
    MFraction reduced_den = one(); // prod q^(e - 1)
    for (const auto& [q, e] : factors) {
      bottom += e * degree(q, x);
      reduced_den = reduced_den * pow(MFraction(q), e - 1);
    }
    const long most = std::max(degree(top.num(), x), bottom) + 1;
    if (most > most_degree) return std::nullopt;
    MFraction f = top;
    for (const auto& [q, e] : factors)
      f = f / pow(MFraction(q), e);
    // f = (polynomial + A/prod q^(e-1))' + sum B_q/q
    std::vector<MFraction> unknowns;
    std::vector<Element> images;
    const auto unknown = [&](const MFraction& primitive) {
      unknowns.push_back(primitive);
      images.emplace_back(letters_, letters_->reduced(derivative(primitive, x)));
    };
    for (long i = 1; i <= degree(top.num(), x) - bottom + 1; ++i)
      unknown(power_of_x(i));
    for (long i = 0; i < degree(reduced_den.num(), x); ++i)
      unknown(power_of_x(i) / reduced_den);
    const std::size_t derivatives = unknowns.size();
    std::vector<std::pair<std::size_t, long>> places;
    for (std::size_t k = 0; k < factors.size(); ++k)
      for (long i = 0; i < degree(factors[k].base, x); ++i) {
        places.emplace_back(k, i);
        images.emplace_back(letters_, power_of_x(i) / MFraction(factors[k].base));
      }
    const auto c = coefficients_of(Element(letters_, f), images);
    if (!c) return std::nullopt;
    Element sum(letters_);
    for (std::size_t j = 0; j < derivatives; ++j)
      sum += Element(letters_, (*c)[j] * unknowns[j]);
    std::vector<std::vector<MFraction>> tops(factors.size());
    for (std::size_t j = 0; j < places.size(); ++j)
      tops[places[j].first].push_back((*c)[derivatives + j]);
    for (std::size_t k = 0; k < factors.size(); ++k) {
      const auto part = logarithms(tops[k], factors[k].base);
      if (!part) return std::nullopt;
      sum += *part;
    }
    return sum;
  }

private:
  [[nodiscard]] MFraction one() const { return letters_->number(1); }
  [[nodiscard]] MFraction power_of_x(long i) const { return pow(letters_->variable_value(), i); }
  [[nodiscard]] Element of(const MFraction& f) const { return {letters_, f}; }
  [[nodiscard]] MFraction polynomial(const std::vector<MFraction>& b) const {
    MFraction sum = letters_->number(0);
    for (std::size_t i = 0; i < b.size(); ++i)
      sum += b[i] * power_of_x(static_cast<long>(i));
    return sum;
  }

  [[nodiscard]] Element logarithm(const MPoly& q) const {
    const auto c = coefficients(q, x);
    const bool turned =
        near_zero_ && degree(q, x) == 1 && !is_zero(c[0]) && sample(MFraction(c[0]), *letters_) < 0;
    return log(of(MFraction(turned ? -q : q)));
  }

  // int B/q for an irreducible q
  [[nodiscard]] std::optional<Element> logarithms(std::vector<MFraction> b, const MPoly& q) const {
    while (!b.empty() && is_zero(b.back()))
      b.pop_back();
    if (b.empty()) return Element(letters_);
    const long n = degree(q, x);
    const auto c = coefficients(q, x);
    const MFraction lead(c.back());
    // t q' + the rest
    const MFraction t = static_cast<long>(b.size()) == n
                            ? letters_->reduced(b.back() / (letters_->number(Rational(n)) * lead))
                            : letters_->number(0);
    std::vector<MFraction> rest = b;
    for (long i = 1; i <= n && !is_zero(t); ++i) {
      MFraction& at = rest[static_cast<std::size_t>(i - 1)];
      at = letters_->reduced(at - t * letters_->number(Rational(i)) *
                                      MFraction(c[static_cast<std::size_t>(i)]));
    }
    Element sum = is_zero(t) ? Element(letters_) : t * logarithm(q);
    while (!rest.empty() && is_zero(rest.back()))
      rest.pop_back();
    if (rest.empty()) return sum;
    std::optional<Element> others = n == 2 ? quadratic(rest.front(), c) : by_power(rest, c);
    if (!others && n == 4) others = two_quadratics(rest, c);
    if (!others) return std::nullopt;
    return sum + *others;
  }

  // int b/(c2 x^2 + c1 x + c0)
  [[nodiscard]] Element quadratic(const MFraction& b, const std::vector<MPoly>& c) const {
    const MFraction c2(c[2]), c1(c[1]), c0(c[0]);
    const MFraction inside = letters_->reduced(letters_->number(4) * c2 * c0 - c1 * c1);
    const MFraction slope = letters_->number(2) * c2 * letters_->variable_value() + c1;
    if (sample(inside, *letters_) > 0) {
      const MFraction root = letters_->root(inside);
      return letters_->reduced(letters_->number(2) * b / root) *
             atan(of(letters_->reduced(slope / root)));
    }
    const MFraction root = letters_->root(-inside);
    return letters_->reduced(b / root) *
           (log(of(primitive_part(root - slope))) - log(of(primitive_part(root + slope))));
  }
  // Without constant factors.
  [[nodiscard]] MFraction primitive_part(const MFraction& f) const {
    const MPoly p = f.num();
    const auto c = coefficients(p, x);
    MPoly common = c[0];
    for (const MPoly& a : c)
      common = gcd(common, a);
    return MFraction(exact_div(p, common));
  }

  // b = x^(k-1) B(x^k), q = Q(x^k): u = x^k
  [[nodiscard]] std::optional<Element> by_power(const std::vector<MFraction>& b,
                                                const std::vector<MPoly>& c) const {
    long k = 0;
    for (std::size_t i = 0; i < c.size(); ++i)
      if (!is_zero(c[i])) k = std::gcd(k, static_cast<long>(i));
    for (std::size_t i = 0; i < b.size(); ++i)
      if (!is_zero(b[i])) k = std::gcd(k, static_cast<long>(i) + 1);
    if (k < 2) return std::nullopt;
    const auto step = static_cast<std::size_t>(k);
    MPoly q(letters_->ring());
    for (std::size_t i = 0; i < c.size(); i += step)
      q += c[i] * pow(MPoly::variable(letters_->ring(), x), i / step);
    std::vector<MFraction> top;
    for (std::size_t i = step - 1; i < b.size(); i += step)
      top.push_back(b[i] / letters_->number(Rational(k)));
    const auto inner = logarithms(top, q);
    if (!inner) return std::nullopt;
    return compose(*inner, of(power_of_x(k)));
  }

  // c4 (x^2 + r)^2 - s^2 x^2 with real roots r and s
  [[nodiscard]] std::optional<Element> two_quadratics(const std::vector<MFraction>& b,
                                                      const std::vector<MPoly>& c) const {
    if (!is_zero(c[1]) || !is_zero(c[3])) return std::nullopt;
    const MFraction c4(c[4]), middle = MFraction(c[2]) / c4, last = MFraction(c[0]) / c4;
    if (sample(last, *letters_) <= 0) return std::nullopt;
    const MFraction r = letters_->root(last);
    const MFraction inside = letters_->number(2) * r - middle;
    if (sample(inside, *letters_) <= 0) return std::nullopt;
    const MFraction s = letters_->root(inside), z = letters_->variable_value();
    const MFraction plus = z * z + s * z + r, minus = z * z - s * z + r;
    const MFraction top = polynomial(b) / c4 * MFraction(plus.den()) * MFraction(minus.den());
    return (*this)(top, {{plus.num(), 1}, {minus.num(), 1}});
  }

  LettersPtr letters_;
  bool near_zero_;
};

} // namespace

double sample(const MFraction& constant, const Letters& letters) {
  std::vector<double> values;
  const auto at = [&](const MPoly& p) {
    double sum = 0;
    for (long i = 0; i < p.length(); ++i) {
      const Rational c(p.coefficient(i));
      double term = fmpq_get_d(c.raw());
      const auto e = p.exponents(i);
      for (std::size_t k = 0; k < e.size(); ++k)
        if (e[k] > 0) term *= std::pow(values[k], static_cast<double>(e[k]));
      sum += term;
    }
    return sum;
  };
  for (std::size_t i = 0; i < letters.ring()->size(); ++i)
    values.push_back(1 + static_cast<double>((i * 37) % 29) / 31);
  for (std::size_t i = 0; i < letters.radicands().size(); ++i)
    values[Letters::first_root + i] =
        std::sqrt(at(letters.radicands()[i].num()) / at(letters.radicands()[i].den()));
  return at(constant.num()) / at(constant.den());
}

std::optional<Element> rational_integral(const MFraction& f, const LettersPtr& letters,
                                         bool near_zero) {
  Factors factors;
  MFraction top = f * MFraction(f.den());
  const auto [content, all] = factor(f.den());
  top = top / letters->number(Rational(content));
  for (const MFactor& q : all) {
    if (uses(q.base, Letters::x))
      factors.push_back(q);
    else
      top = top / pow(MFraction(q.base), q.exponent);
  }
  return RationalIntegral(letters, near_zero)(top, factors);
}

} // namespace kov::elementary
