#include "monodromy/expansion.hpp"

#include "monodromy/growth.hpp"
#include "monodromy/imprecise.hpp"

#include <algorithm>

namespace kov::monodromy {
namespace {

constexpr long guard_bits = 12;
constexpr long growth_bits = 128;
constexpr long tail_bits = 64;
constexpr long slack_bits = 16;
constexpr long largest_growth = 1L << 24; // bits; beyond, nothing could be stored

// The size that one rounding of size 1 can reach before it dies away, in bits.
long noise_bits(const LocalSystem& s) { return 4 + s.degree; }

static_assert(sizeof(ComplexBall) == sizeof(acb_struct)); // so that a Series is a vector of Arb's

using Series = std::vector<ComplexBall>;

// sum_l f[first + l] y[k - first - l] for l < length
void dot(acb_struct* sum, const Coefficients& f, long first, const Series& y, long k, long length,
         bool subtract, long precision) {
  if (length <= 0) return;
  const double words = static_cast<double>(precision) / 64;
  charge(static_cast<double>(length) * (2 + words * words / 8));
  acb_dot(sum, sum, subtract ? 1 : 0, f[first].raw(), 1, y[k - first].raw(), -1, length, precision);
}

Magnitude radius(const ComplexBall& z) {
  Magnitude m;
  mag_hypot(m.raw(), arb_radref(acb_realref(z.raw())), arb_radref(acb_imagref(z.raw())));
  return m;
}

// e with |z| <= 2^e; very small for 0.
long size_of(const ComplexBall& z, long least) {
  const Magnitude m = Magnitude::of(z.raw());
  return is_zero(m) ? least : std::max(least, exponent(m));
}

// One column of the fundamental matrix: the solution with Y(0) = e_m, to 2^-fixed.
class Column {
public:
  Column(const LocalSystem& s, std::size_t m, long fixed, const Budget& budget)
      : s_(s), fixed_(fixed), y_(s.rows.size()), v_(s.rows.size()), rounding_(s.rows.size()) {
    for (Series& y : y_)
      y.emplace_back();
    for (const LocalRow& row : s.rows) {
      inverse_.emplace_back();
      acb_inv(inverse_.back().raw(), row.den.front().raw(), fixed + guard_bits);
    }
    acb_one(y_[m].front().raw());
    const long most_terms = 4 * fixed + 64; // then the residual tells what is missing
    while (quiet_ <= s.degree + 1 && terms() < most_terms) {
      if (terms() % 256 == 0) budget.check();
      advance();
    }
  }

  /// The last index: Y = sum of Y_k t^k for k <= terms.
  [[nodiscard]] long terms() const noexcept { return static_cast<long>(v_.front().size()); }
  [[nodiscard]] const Series& component(std::size_t i) const { return y_[i]; }

  /// An upper bound of |den_i dY_i/dt - sum num_ij Y_j|/|den_i(0)| for |t| <= 1.
  [[nodiscard]] Magnitude residual(std::size_t i) const {
    Magnitude tail;
    for (long k = terms(); k <= terms() + s_.degree; ++k)
      tail += Magnitude::of(right_side(i, k, tail_bits).raw());
    Magnitude head;
    acb_get_mag_lower(head.raw(), s_.rows[i].den.front().raw());
    return rounding_[i] + tail / head;
  }

private:
  // The right side of the recurrence at index k; coefficients behind the last one are 0.
  [[nodiscard]] ComplexBall right_side(std::size_t i, long k, long precision) const {
    ComplexBall sum;
    const LocalRow& row = s_.rows[i];
    for (std::size_t j = 0; j < row.num.size(); ++j) {
      const long first = std::max(0L, k - terms());
      const long end = std::min(k + 1, static_cast<long>(row.num[j].size()));
      dot(sum.raw(), row.num[j], first, y_[j], k, end - first, false, precision);
    }
    const long first = std::max(1L, k - terms() + 1);
    const long end = std::min(k + 1, static_cast<long>(row.den.size()));
    dot(sum.raw(), row.den, first, v_[i], k, end - first, true, precision);
    return sum;
  }

  void advance() {
    const long k = terms();
    const long precision = std::max(tail_bits, fixed_ + largest_ + slack_bits);
    const long noise = noise_bits(s_) - fixed_;
    std::vector<ComplexBall> next;
    long largest = -fixed_ - 1;
    for (std::size_t i = 0; i < s_.rows.size(); ++i) {
      next.push_back(right_side(i, k, precision));
      acb_struct* y = next.back().raw();
      acb_mul(y, y, inverse_[i].raw(), precision);
      acb_div_si(y, y, k + 1, precision);
      rounding_[i] += radius(next.back()) * Magnitude(static_cast<unsigned long>(k + 1));
      acb_get_mid(y, y);
      largest = std::max(largest, size_of(next.back(), -fixed_ - 1));
    }
    for (std::size_t i = 0; i < s_.rows.size(); ++i) {
      v_[i].emplace_back();
      acb_mul_si(v_[i].back().raw(), next[i].raw(), k + 1, ARF_PREC_EXACT);
      y_[i].push_back(std::move(next[i]));
    }
    largest_ = std::max(largest, largest_ - 1); // the coefficients in use shrink slowly
    quiet_ = largest < noise ? quiet_ + 1 : 0;
  }

  const LocalSystem& s_;
  long fixed_;
  std::vector<ComplexBall> inverse_; // of den_i(0)
  std::vector<Series> y_;            // y_[i][k]: the coefficient of t^k, exact
  std::vector<Series> v_;            // v_[i][k] = (k+1) y_[i][k+1], exact
  std::vector<Magnitude> rounding_;  // of the residual, relative to den_i(0)
  long largest_ = 0;                 // the coefficients of late are at most about 2^largest
  long quiet_ = 0;                   // negligible coefficients in a row
};

// t = numerator/divisor with short numbers, |t| <= 1.
struct Ratio {
  ComplexBall numerator;
  long divisor = 1;
  long shift = 0; // and a power of two
};

// sum y_k t^k to about 2^-fixed for |t| <= length, by Horner's scheme on exact numbers.  A ball
// that is turned at every step would swell by up to sqrt 2 each time; what a step rounds is set
// aside and shrinks with t.
ComplexBall evaluate(const Series& y, const Ratio& t, const Magnitude& length, long fixed) {
  ComplexBall value;
  Magnitude error;
  for (std::size_t k = y.size(); k-- > 0;) {
    const long size = std::max(size_of(value, -fixed), size_of(y[k], -fixed));
    const long precision = fixed + slack_bits + size;
    acb_mul(value.raw(), value.raw(), t.numerator.raw(), precision);
    acb_div_si(value.raw(), value.raw(), t.divisor, precision);
    acb_mul_2exp_si(value.raw(), value.raw(), t.shift);
    acb_add(value.raw(), value.raw(), y[k].raw(), precision);
    error = error * length + radius(value);
    acb_get_mid(value.raw(), value.raw());
  }
  acb_add_error_mag(value.raw(), error.raw());
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

ComplexBall quotient(const ComplexBall& h, const Scale& scale) {
  ComplexBall t;
  acb_div_si(t.raw(), h.raw(), scale.m, growth_bits);
  acb_mul_2exp_si(t.raw(), t.raw(), -scale.e);
  return t;
}

// The size of exp(x) in bits.
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
  return bits + extra + static_cast<long>(FLINT_BIT_COUNT(terms)) + degree + guard_bits;
}

class Expansion {
public:
  Expansion(const EmbeddedSystem& s, const ComplexBall& centre,
            const std::vector<ComplexBall>& steps, long bits, const Budget& budget)
      : scale_(scale_of(steps)) {
    const LocalSystem coarse = s.at(centre, scale_.value, growth_bits);
    for (const ComplexBall& h : steps) {
      ratios_.push_back({h, scale_.m, -scale_.e});
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
        const Magnitude radius = times_power_of_two(error, growths_[step].weights[i]);
        acb_struct* entry = y.entry(static_cast<long>(i), static_cast<long>(m));
        acb_set(entry,
                evaluate(columns_[m].component(i), ratios_[step], lengths_[step], fixed_).raw());
        acb_add_error_mag(entry, radius.raw());
      }
    }
    return y;
  }

private:
  // |D|_w at the end.
  [[nodiscard]] Magnitude weighted_error(const Column& column, std::size_t step) const {
    const Growth& g = growths_[step];
    Magnitude most;
    for (std::size_t i = 0; i < local_.rows.size(); ++i)
      most = max(most, times_power_of_two(column.residual(i) * g.inverse[i], -g.weights[i]));
    return most * lengths_[step] * exp(g.exponent);
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
