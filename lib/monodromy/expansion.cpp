#include "monodromy/expansion.hpp"

#include "monodromy/growth.hpp"
#include "monodromy/imprecise.hpp"

#include <algorithm>

namespace kov::monodromy {
namespace {

constexpr long guard_bits = 24;
constexpr long growth_bits = 128;
constexpr long largest_growth = 1L << 24; // bits; beyond, nothing could be stored

struct Gaussian {
  Integer re, im;
};

void add_product(Gaussian& sum, const Gaussian& a, const Integer& re, const Integer& im) {
  fmpz_addmul(sum.re.raw(), a.re.raw(), re.raw());
  fmpz_addmul(sum.im.raw(), a.im.raw(), re.raw());
  if (is_zero(im)) return;
  fmpz_submul(sum.re.raw(), a.im.raw(), im.raw());
  fmpz_addmul(sum.im.raw(), a.re.raw(), im.raw());
}

void subtract_product(Gaussian& sum, const Gaussian& a, const Integer& re, const Integer& im) {
  fmpz_submul(sum.re.raw(), a.re.raw(), re.raw());
  fmpz_submul(sum.im.raw(), a.im.raw(), re.raw());
  if (is_zero(im)) return;
  fmpz_addmul(sum.re.raw(), a.im.raw(), im.raw());
  fmpz_submul(sum.im.raw(), a.re.raw(), im.raw());
}

// x / (a n), each part rounded towards 0: the error is less than 1.5 units.
class Divisor {
public:
  Divisor(const Integer& re, const Integer& im) : re_(re), im_(-im), norm_(re * re + im * im) {}
  [[nodiscard]] Gaussian divide(const Gaussian& x, long n) const {
    Gaussian y;
    add_product(y, x, re_, im_);
    const Integer by = norm_ * Integer(n);
    fmpz_tdiv_q(y.re.raw(), y.re.raw(), by.raw());
    fmpz_tdiv_q(y.im.raw(), y.im.raw(), by.raw());
    return y;
  }

private:
  Integer re_, im_, norm_;
};

// What one unit, lost by rounding, can become before it dies away.
long noise_bits(const LocalSystem& s) { return 4 + s.degree; }

bool negligible(const Gaussian& y, long noise) {
  return static_cast<long>(fmpz_bits(y.re.raw())) <= noise &&
         static_cast<long>(fmpz_bits(y.im.raw())) <= noise;
}

using Series = std::vector<Gaussian>;

// One column of the fundamental matrix: the solution with Y(0) = e_m.
class Column {
public:
  Column(const LocalSystem& s, std::size_t m, long fixed, const Budget& budget)
      : s_(s), y_(s.rows.size()), v_(s.rows.size()) {
    for (const LocalRow& row : s.rows)
      divisors_.emplace_back(row.den.re.front(), row.den.im.front());
    for (Series& y : y_)
      y.emplace_back();
    fmpz_one(y_[m].front().re.raw());
    fmpz_mul_2exp(y_[m].front().re.raw(), y_[m].front().re.raw(), static_cast<ulong>(fixed));
    const long most_terms = 4 * fixed + 64; // then the residual tells what is missing
    while (quiet_ <= s.degree + 1 && terms() < most_terms) {
      if (terms() % 256 == 0) budget.check();
      advance();
    }
  }

  /// The last index: Y = sum of Y_k t^k for k <= terms.
  [[nodiscard]] long terms() const noexcept { return static_cast<long>(v_.front().size()); }
  [[nodiscard]] const Series& component(std::size_t i) const { return y_[i]; }

  /// An upper bound of |den_i dY_i/dt - sum num_ij Y_j|/|den_i(0)| for |t| <= 1, in units.
  [[nodiscard]] Magnitude residual(std::size_t i) const {
    const auto n = static_cast<unsigned long>(terms());
    const LocalRow& row = s_.rows[i];
    Magnitude sum = Magnitude::of(row.den.re.front(), row.den.im.front()) *
                    Magnitude(n * (n + 1)); // 1.5 (1 + ... + n) |den_0|
    for (long k = terms(); k <= terms() + s_.degree; ++k) {
      const Gaussian e = right_side(i, k);
      sum += Magnitude::of(e.re, e.im);
    }
    if (!is_zero(row.error)) sum += row.error * lost_by_rounding(i);
    return sum / least_head(row);
  }

private:
  [[nodiscard]] static Magnitude least_head(const LocalRow& row) {
    ComplexBall head;
    acb_set_fmpz_fmpz(head.raw(), row.den.re.front().raw(), row.den.im.front().raw());
    Magnitude least;
    acb_get_mag_lower(least.raw(), head.raw());
    return less(least, row.error);
  }

  // What the recurrence puts on the right at index k; coefficients behind the last one are 0.
  [[nodiscard]] Gaussian right_side(std::size_t i, long k) const {
    Gaussian sum;
    const LocalRow& row = s_.rows[i];
    for (std::size_t j = 0; j < row.num.size(); ++j)
      for (long l = std::max(0L, k - terms()); l < row.num[j].length() && l <= k; ++l)
        add_product(sum, y_[j][k - l], row.num[j].re[l], row.num[j].im[l]);
    for (long l = std::max(1L, k - terms() + 1); l < row.den.length() && l <= k; ++l)
      subtract_product(sum, v_[i][k - l], row.den.re[l], row.den.im[l]);
    return sum;
  }

  void advance() {
    const long k = terms();
    bool quiet = true;
    std::vector<Gaussian> next;
    for (std::size_t i = 0; i < s_.rows.size(); ++i) {
      next.push_back(divisors_[i].divide(right_side(i, k), k + 1));
      quiet = quiet && negligible(next.back(), noise_bits(s_));
    }
    for (std::size_t i = 0; i < s_.rows.size(); ++i) {
      v_[i].push_back({next[i].re * Integer(k + 1), next[i].im * Integer(k + 1)});
      y_[i].push_back(std::move(next[i]));
    }
    quiet_ = quiet ? quiet_ + 1 : 0;
  }

  // (degree + 1) (sum |dY_i coefficients| + sum_j sum |Y_j coefficients|)
  [[nodiscard]] Magnitude lost_by_rounding(std::size_t i) const {
    Magnitude sum;
    for (const Gaussian& v : v_[i])
      sum += Magnitude::of(v.re, v.im);
    for (const Series& y : y_)
      for (const Gaussian& a : y)
        sum += Magnitude::of(a.re, a.im);
    return sum * Magnitude(static_cast<unsigned long>(s_.degree + 1));
  }

  const LocalSystem& s_;
  std::vector<Series> y_; // y_[i][k]: the coefficient of t^k
  std::vector<Series> v_; // v_[i][k] = (k+1) y_[i][k+1]
  std::vector<Divisor> divisors_;
  long quiet_ = 0; // negligible coefficients in a row
};

// t = (re + i im)/(odd 2^shift), |t| <= 1.
struct Ratio {
  Integer re, im, divisor;
};

// sum y_k t^k, each step rounded towards 0: the error is less than 1.5 (terms + 1) units.
Gaussian evaluate(const Series& y, const Ratio& t) {
  Gaussian value;
  for (std::size_t k = y.size(); k-- > 0;) {
    Gaussian product;
    add_product(product, value, t.re, t.im);
    fmpz_tdiv_q(value.re.raw(), product.re.raw(), t.divisor.raw());
    fmpz_tdiv_q(value.im.raw(), product.im.raw(), t.divisor.raw());
    value.re += y[k].re;
    value.im += y[k].im;
  }
  return value;
}

// scale = m 2^e >= |h| for every h, m = 4, ..., 7 as small as can be.
struct Scale {
  Ball value;
  long m = 0, e = 0;
};

Scale scale_of(const std::vector<ComplexBall>& steps) {
  Magnitude most;
  for (const ComplexBall& h : steps)
    most = max(most, Magnitude::of(h.raw()));
  Scale s;
  s.e = exponent(most) - 3;
  s.m = 4;
  const auto reaches = [&] {
    return !(times_power_of_two(Magnitude(static_cast<unsigned long>(s.m)), s.e) < most);
  };
  while (!reaches())
    ++s.m;
  arb_set_si(s.value.raw(), s.m);
  arb_mul_2exp_si(s.value.raw(), s.value.raw(), s.e);
  return s;
}

// h = (re + i im) 2^e, exactly.
Ratio ratio(const ComplexBall& h, const Scale& scale) {
  Ratio r;
  Integer e_re, e_im;
  arf_get_fmpz_2exp(r.re.raw(), e_re.raw(), arb_midref(acb_realref(h.raw())));
  arf_get_fmpz_2exp(r.im.raw(), e_im.raw(), arb_midref(acb_imagref(h.raw())));
  if (is_zero(r.re)) e_re = e_im;
  if (is_zero(r.im)) e_im = e_re;
  const Integer e = std::min(e_re, e_im);
  fmpz_mul_2exp(r.re.raw(), r.re.raw(), static_cast<ulong>(to_long(e_re - e)));
  fmpz_mul_2exp(r.im.raw(), r.im.raw(), static_cast<ulong>(to_long(e_im - e)));
  r.divisor = Integer(scale.m);
  const long shift = to_long(Integer(scale.e) - e);
  if (shift >= 0) {
    fmpz_mul_2exp(r.divisor.raw(), r.divisor.raw(), static_cast<ulong>(shift));
  } else {
    fmpz_mul_2exp(r.re.raw(), r.re.raw(), static_cast<ulong>(-shift));
    fmpz_mul_2exp(r.im.raw(), r.im.raw(), static_cast<ulong>(-shift));
  }
  return r;
}

ComplexBall quotient(const ComplexBall& h, const Scale& scale) {
  ComplexBall t;
  acb_div_si(t.raw(), h.raw(), scale.m, growth_bits);
  acb_mul_2exp_si(t.raw(), t.raw(), -scale.e);
  return t;
}

// What exp(x) costs in bits.
long bits_of(const Magnitude& x) {
  Integer bits;
  mag_get_fmpz(bits.raw(), (x * Magnitude(1443) / Magnitude(1000)).raw()); // 1/log 2
  if (Integer(largest_growth) < bits)
    throw Imprecise("the solutions grow beyond what can be stored");
  return to_long(bits);
}

long spread(const std::vector<long>& weights) {
  const auto [least, most] = std::minmax_element(weights.begin(), weights.end());
  return *most - *least;
}

// The bits P behind the point that make every error about 2^-bits.
long fixed_bits(const std::vector<Growth>& ends, long degree, long bits) {
  long extra = 0;
  for (const Growth& g : ends) {
    long one = bits_of(g.exponent) + spread(g.weights);
    for (const Magnitude& inverse : g.inverse)
      one = std::max(one, bits_of(g.exponent) + spread(g.weights) + exponent(inverse));
    extra = std::max(extra, one);
  }
  const auto terms = static_cast<ulong>(bits + extra);
  return bits + extra + 2 * static_cast<long>(FLINT_BIT_COUNT(terms)) + 3 * degree + guard_bits;
}

class Expansion {
public:
  Expansion(const EmbeddedSystem& s, const ComplexBall& centre,
            const std::vector<ComplexBall>& steps, long bits, const Budget& budget)
      : scale_(scale_of(steps)) {
    const LocalSystem coarse = s.at(centre, scale_.value, growth_bits);
    for (const ComplexBall& h : steps) {
      ratios_.push_back(ratio(h, scale_));
      lengths_.push_back(Magnitude::of(quotient(h, scale_).raw()));
      growths_.push_back(growth(coarse, quotient(h, scale_)));
    }
    fixed_ = fixed_bits(growths_, coarse.degree, bits);
    local_ = s.at(centre, scale_.value, fixed_ + guard_bits);
    for (std::size_t m = 0; m < local_.rows.size(); ++m)
      columns_.emplace_back(local_, m, fixed_, budget);
  }

  /// Y at the end of one step.
  [[nodiscard]] BallMatrix at(std::size_t step) const {
    BallMatrix y(local_.size());
    for (std::size_t m = 0; m < columns_.size(); ++m) {
      const Magnitude error = weighted_error(columns_[m], step);
      for (std::size_t i = 0; i < columns_.size(); ++i) {
        const auto terms = static_cast<unsigned long>(columns_[m].terms());
        const Magnitude radius = times_power_of_two(error, growths_[step].weights[i]) +
                                 Magnitude(2 * (terms + 1));
        set(y.entry(static_cast<long>(i), static_cast<long>(m)),
            evaluate(columns_[m].component(i), ratios_[step]), radius);
      }
    }
    return y;
  }

private:
  // |D|_w at the end, in units.
  [[nodiscard]] Magnitude weighted_error(const Column& column, std::size_t step) const {
    const Growth& g = growths_[step];
    Magnitude most;
    for (std::size_t i = 0; i < local_.rows.size(); ++i)
      most = max(most, times_power_of_two(column.residual(i) * g.inverse[i], -g.weights[i]));
    return most * lengths_[step] * exp(g.exponent);
  }

  void set(acb_struct* z, const Gaussian& value, const Magnitude& radius) const {
    acb_set_fmpz_fmpz(z, value.re.raw(), value.im.raw());
    mag_set(arb_radref(acb_realref(z)), radius.raw());
    mag_set(arb_radref(acb_imagref(z)), radius.raw());
    acb_mul_2exp_si(z, z, -fixed_);
  }

  Scale scale_;
  std::vector<Ratio> ratios_;
  std::vector<Magnitude> lengths_;
  std::vector<Growth> growths_;
  long fixed_ = 0;
  LocalSystem local_;
  std::vector<Column> columns_;
};

} // namespace

std::vector<BallMatrix> values(const EmbeddedSystem& s, const ComplexBall& centre,
                               const std::vector<ComplexBall>& ends, long bits,
                               const Budget& budget) {
  std::vector<ComplexBall> steps(ends.size());
  for (std::size_t k = 0; k < ends.size(); ++k)
    acb_sub(steps[k].raw(), ends[k].raw(), centre.raw(), ARF_PREC_EXACT);
  const Expansion expansion(s, centre, steps, bits, budget);
  std::vector<BallMatrix> all;
  for (std::size_t k = 0; k < ends.size(); ++k)
    all.push_back(expansion.at(k));
  return all;
}

} // namespace kov::monodromy
