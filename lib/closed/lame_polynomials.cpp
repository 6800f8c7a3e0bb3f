#include "closed/lame_polynomials.hpp"

#include "closed/coefficients.hpp"
#include "closed/half.hpp"
#include "exact/error.hpp"

#include <optional>

namespace kov {
namespace {

NfElem constant(const Rational& c, const LameParameters<NfElem>&) { return NfElem(c); }
MFraction constant(const Rational& c, const LameParameters<MFraction>& p) {
  for (const MFraction* f : {&p.b, &p.g2, &p.g3})
    if (f->ring()) return {f->ring(), c};
  throw InvalidArgument("the parameters of Lame's equation belong to no ring");
}

template <class R> Coefficients<R> cubic(const LameParameters<R>& p) {
  return {-p.g3, -p.g2, constant(Rational(0), p), constant(Rational(4), p)};
}

// n(n+1) x + B
template <class R> Coefficients<R> potential(const Rational& alpha, const LameParameters<R>& p) {
  return {p.b, constant(alpha, p)};
}

// The m-th symmetric power: L_0 v = v, L_1 v = v_t, L_{i+1} v = (L_i v)_t - i (m-i+1) r L_{i-1} v.
// With d/dt = sqrt(f) d/dx the L_i v are polynomials for even i and sqrt(f) times polynomials for
// odd i; what is returned is L_{m+1} v/sqrt(f), m even.
template <class R>
Coefficients<R> symmetric_power(const Coefficients<R>& v, long m, const Rational& alpha,
                                const LameParameters<R>& p) {
  const Coefficients<R> f = cubic(p);
  const Coefficients<R> half_f1 = sum({}, derivative(f), half);
  const Coefficients<R> r = potential(alpha, p);
  Coefficients<R> before;
  Coefficients<R> now = v;
  for (long i = 0; i <= m; ++i) {
    Coefficients<R> next = derivative(now);
    if (i % 2 == 1) next = sum(product(f, next), product(half_f1, now), Rational(1));
    if (i > 0) next = sum(std::move(next), product(r, before), Rational(-i * (m - i + 1)));
    before = std::move(now);
    now = std::move(next);
  }
  return now;
}

// The largest degree d >= 0 of F(y1, y2), deg F = m: growth (m-j) n/2 - j (n+1)/2 at infinity,
// an integer; nothing if there is none.
std::optional<long> largest_degree(const Rational& n, long m) {
  for (long j = 0; j <= m; ++j) {
    const Rational d = half * (Rational(m - j) * n - Rational(j) * (n + Rational(1)));
    if (sign(d) < 0) return std::nullopt;
    if (is_integer(d) && fits_long(d.num())) return to_long(d.num());
  }
  return std::nullopt;
}

// A linear form in the free coefficients of v.
template <class R> using LinearForm = std::vector<R>;

// The forms whose common zeros, not all 0, are the v = sum v_j x^j with L v = 0, where image[j] is
// L x^j, of degree at most j + e, and v_d, v_{d-1}, ... are found from the top.
template <class R> class TopDownForms {
public:
  TopDownForms(std::vector<Coefficients<R>> image, long e, const LameParameters<R>& p)
      : image_(std::move(image)), e_(e), parameters_(p), v_(image_.size()) {}

  std::vector<LinearForm<R>> conditions(const Budget& budget) {
    for (long row = static_cast<long>(image_.size()) - 1 + e_; row >= 0; --row) {
      budget.check();
      const long j = row - e_;
      const LinearForm<R> rest = applied(row, j);
      if (j < 0) {
        note(rest);
        continue;
      }
      const R indicial = entry(j, row);
      if (is_zero(indicial)) { // a growth exponent: v_j is free
        note(rest);
        LinearForm<R>& v = v_[static_cast<std::size_t>(j)];
        v.resize(static_cast<std::size_t>(free_) + 1, constant(Rational(0), parameters_));
        v.back() = constant(Rational(1), parameters_);
        ++free_;
      } else {
        for (const R& c : rest)
          v_[static_cast<std::size_t>(j)].push_back(-c / indicial);
      }
    }
    for (LinearForm<R>& form : found_)
      form.resize(static_cast<std::size_t>(free_), constant(Rational(0), parameters_));
    return std::move(found_);
  }
  [[nodiscard]] long free() const { return free_; }

private:
  [[nodiscard]] R entry(long j, long row) const {
    const auto& column = image_[static_cast<std::size_t>(j)];
    return static_cast<std::size_t>(row) < column.size() ? column[static_cast<std::size_t>(row)]
                                                         : constant(Rational(0), parameters_);
  }
  // The coefficient of x^row in L of the known part v_{j+1}, v_{j+2}, ...
  [[nodiscard]] LinearForm<R> applied(long row, long j) const {
    LinearForm<R> form(static_cast<std::size_t>(free_), constant(Rational(0), parameters_));
    for (long i = std::max(j + 1, 0L); i < static_cast<long>(image_.size()); ++i) {
      const R c = entry(i, row);
      if (is_zero(c)) continue;
      const LinearForm<R>& v = v_[static_cast<std::size_t>(i)];
      for (std::size_t k = 0; k < v.size(); ++k)
        form[k] = form[k] + c * v[k];
    }
    return form;
  }
  void note(const LinearForm<R>& form) {
    for (const R& c : form)
      if (!is_zero(c)) return found_.push_back(form);
  }

  std::vector<Coefficients<R>> image_;
  long e_;
  const LameParameters<R>& parameters_;
  std::vector<LinearForm<R>> v_;
  long free_ = 0;
  std::vector<LinearForm<R>> found_;
};

} // namespace

// y = sum c_k x^(s - k), s = n/2: with s_k = s - k the coefficient of x^(s_k + 1) is
// (-2k)(2m - 2k) c_k - B c_{k-1} - g2 s_{k-2}(s_{k-2} - 1/2) c_{k-2} - g3 s_{k-3}(s_{k-3} - 1)
// c_{k-3}, so that c_m meets a condition.  It is made monic.
template <class R> R brioschi(long m, const LameParameters<R>& p) {
  if (m < 1) throw InvalidArgument("Brioschi's determinant has m >= 1 rows");
  const auto sigma = [&](long k) { return Rational(2 * m - 1, 4) - Rational(k); };
  std::vector<R> c{constant(Rational(1), p)};
  Rational leading(1);
  for (long k = 1;; ++k) {
    R right = p.b * c[static_cast<std::size_t>(k - 1)];
    if (k >= 2)
      right = right + scaled(sigma(k - 2) * (sigma(k - 2) - half),
                             p.g2 * c[static_cast<std::size_t>(k - 2)]);
    if (k >= 3)
      right = right + scaled(sigma(k - 3) * (sigma(k - 3) - Rational(1)),
                             p.g3 * c[static_cast<std::size_t>(k - 3)]);
    if (k == m) return scaled(Rational(1) / leading, right);
    const Rational indicial = Rational(-2 * k) * Rational(2 * m - 2 * k);
    leading = leading / indicial;
    c.push_back(scaled(Rational(1) / indicial, right));
  }
}

// f X''' + 3/2 f' X'' + (f''/2 - 4 n(n+1) x - 4B) X' - 2 n(n+1) X = 0 from the top: with s = n - k
// 2 (2s+1)(s-n)(s+n+1) v_k = 4B (s+1) v_{k-1} + g2 (s+2)(s+1)(s+3/2) v_{k-2}
//                            + g3 (s+3)(s+2)(s+1) v_{k-3}.
template <class R> LameHermite<R> lame_hermite(long n, const LameParameters<R>& p) {
  if (n < 0) throw InvalidArgument("the invariant of Lame's equation needs n >= 0");
  std::vector<R> x(static_cast<std::size_t>(n) + 1);
  x.back() = constant(Rational(1), p);
  for (long s = n - 1; s >= 0; --s) {
    const auto v = [&](long j) -> const R& { return x[static_cast<std::size_t>(j)]; };
    R right = scaled(Rational(4 * (s + 1)), p.b * v(s + 1));
    if (s + 2 <= n)
      right = right + scaled(Rational((s + 2) * (s + 1)) * Rational(2 * s + 3, 2), p.g2 * v(s + 2));
    if (s + 3 <= n) right = right + scaled(Rational((s + 3) * (s + 2) * (s + 1)), p.g3 * v(s + 3));
    x[static_cast<std::size_t>(s)] =
        scaled(Rational(1) / Rational(2 * (2 * s + 1) * (s - n) * (s + n + 1)), right);
  }
  const Coefficients<R> f = cubic(p);
  const Coefficients<R> x1 = derivative(x);
  Coefficients<R> x_tt = sum(product(f, derivative(x1)), product(derivative(f), x1), half);
  Coefficients<R> w = product(f, product(x1, x1));
  w = sum(std::move(w), product(x, x_tt), Rational(-2));
  w = sum(std::move(w), product(potential(Rational(n * (n + 1)), p), product(x, x)), Rational(4));
  for (std::size_t i = 1; i < w.size(); ++i)
    KOV_ENSURE(is_zero(w[i]));
  return {std::move(x), w.empty() ? constant(Rational(0), p) : w.front()};
}

template <class R>
std::vector<R> invariant_conditions(const Rational& n, long m, const LameParameters<R>& p,
                                    const Budget& budget) {
  if (m < 2 || m > 12 || m % 2 != 0)
    throw InvalidArgument("the degree of the invariant must be even and at most 12");
  if (n < -half || is_integer(n + n))
    throw InvalidArgument("2n must not be an integer, and n >= -1/2");
  const std::optional<long> d = largest_degree(n, m);
  if (!d) return {constant(Rational(1), p)};
  budget.check_degree(*d);
  const Rational alpha = n * (n + Rational(1));
  std::vector<Coefficients<R>> image;
  for (long j = 0; j <= *d; ++j) {
    budget.check();
    Coefficients<R> power(static_cast<std::size_t>(j) + 1);
    power.back() = constant(Rational(1), p);
    image.push_back(symmetric_power(power, m, alpha, p));
  }
  TopDownForms<R> system(std::move(image), (m - 2) / 2, p);
  const std::vector<LinearForm<R>> forms = system.conditions(budget);
  std::vector<R> conditions;
  const auto keep = [&](const R& c) {
    if (!is_zero(c)) conditions.push_back(c);
  };
  if (system.free() == 1) {
    for (const LinearForm<R>& form : forms)
      keep(form.front());
    return conditions;
  }
  // Two growth exponents (more need m > 12): all minors of order 2; one form alone has a zero.
  KOV_ENSURE(system.free() == 2);
  for (std::size_t i = 0; i < forms.size(); ++i)
    for (std::size_t j = i + 1; j < forms.size(); ++j)
      keep(forms[i][0] * forms[j][1] - forms[i][1] * forms[j][0]);
  return conditions;
}

template NfElem brioschi(long, const LameParameters<NfElem>&);
template MFraction brioschi(long, const LameParameters<MFraction>&);
template LameHermite<NfElem> lame_hermite(long, const LameParameters<NfElem>&);
template LameHermite<MFraction> lame_hermite(long, const LameParameters<MFraction>&);
template std::vector<NfElem> invariant_conditions(const Rational&, long,
                                                  const LameParameters<NfElem>&, const Budget&);
template std::vector<MFraction>
invariant_conditions(const Rational&, long, const LameParameters<MFraction>&, const Budget&);

} // namespace kov
