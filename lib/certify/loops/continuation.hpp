#pragma once
// Continuation of Y' = A(z) Y along polygons with proven errors: one Taylor series for each segment,
// whose residual is computed as a polynomial, and Gronwall's inequality.
// docs/theory/loop_certificates.md 3

#include "certify/loops/check.hpp"
#include "certify/loops/interval.hpp"
#include "exact/flint_matrix.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>

namespace kov::certify {

/// A square matrix of enclosures.
class Enclosures {
public:
  explicit Enclosures(long n) { acb_mat_init(m_, n, n); }
  Enclosures(const Enclosures& o) : Enclosures(o.size()) { acb_mat_set(m_, o.m_); }
  Enclosures& operator=(const Enclosures& o) = delete;
  ~Enclosures() { acb_mat_clear(m_); }
  [[nodiscard]] long size() const noexcept { return acb_mat_nrows(m_); }
  [[nodiscard]] acb_mat_struct* raw() noexcept { return m_; }
  [[nodiscard]] const acb_mat_struct* raw() const noexcept { return m_; }
  [[nodiscard]] acb_struct* at(long i, long j) noexcept { return acb_mat_entry(m_, i, j); }
  [[nodiscard]] const acb_struct* at(long i, long j) const noexcept {
    return acb_mat_entry(m_, i, j);
  }

private:
  acb_mat_t m_;
};

/// A polynomial with such coefficients.
class EnclosedPoly {
public:
  explicit EnclosedPoly(const std::vector<ComplexBall>& c = {}) {
    acb_poly_init(f_);
    for (std::size_t k = 0; k < c.size(); ++k)
      acb_poly_set_coeff_acb(f_, static_cast<long>(k), c[k].raw());
  }
  EnclosedPoly(const EnclosedPoly& o) : EnclosedPoly() { acb_poly_set(f_, o.f_); }
  EnclosedPoly& operator=(const EnclosedPoly& o) = delete;
  ~EnclosedPoly() { acb_poly_clear(f_); }
  [[nodiscard]] acb_poly_struct* raw() noexcept { return f_; }
  [[nodiscard]] long length() const noexcept { return acb_poly_length(f_); }
  [[nodiscard]] const acb_struct* at(long k) const noexcept { return f_->coeffs + k; }
  /// f(point + step t)
  [[nodiscard]] EnclosedPoly moved(const ComplexBall& point, const ComplexBall& step,
                                   long precision) const {
    EnclosedPoly g;
    acb_poly_compose_horner(g.f_, f_, EnclosedPoly({point, step}).f_, precision);
    return g;
  }
  [[nodiscard]] EnclosedPoly times(const EnclosedPoly& o, long precision) const {
    EnclosedPoly g;
    acb_poly_mul(g.f_, f_, o.f_, precision);
    return g;
  }
  /// The sum of all |f_i|, i >= k.
  [[nodiscard]] Interval sum_of_sizes(long k = 0) const {
    Interval sum, size;
    for (; k < length(); ++k) {
      acb_abs(size.raw(), at(k), Interval::bits);
      sum = sum + size;
    }
    return sum;
  }

private:
  acb_poly_t f_;
};

/// Y' = A(z) Y along a segment, in the variable t from 0 to 1.
class Segment {
public:
  Segment(const std::vector<LoopRow>& rows, const LoopPoint& start, const LoopPoint& end, long bits,
          double& work)
      : bits_(bits), work_(work) {
    const ComplexBall point = dyadic(start);
    ComplexBall step;
    acb_sub(step.raw(), dyadic(end).raw(), point.raw(), ARF_PREC_EXACT);
    for (const LoopRow& row : rows)
      rows_.push_back(local(row, point, step));
    find_growth();
  }

  /// The solutions at the end, those at the start are the unit matrix.
  [[nodiscard]] Enclosures matrix() {
    const long n = static_cast<long>(rows_.size());
    Enclosures m(n);
    for (long j = 0; j < n; ++j) {
      const Solution y = series(static_cast<std::size_t>(j));
      const Interval error = error_of(y);
      for (long i = 0; i < n; ++i) {
        for (const ComplexBall& c : y.value[static_cast<std::size_t>(i)])
          acb_add(m.at(i, j), m.at(i, j), c.raw(), 2 * bits_);
        acb_add_error_arb(m.at(i, j), shifted(error, weights_[static_cast<std::size_t>(i)]).raw());
      }
    }
    return m;
  }

private:
  static constexpr long fewest_pieces = 2, most_pieces = 9; // binary logarithms of their number
  static constexpr int balancing_rounds = 8;
  static constexpr long noise_bits = 8;

  using Terms = std::vector<ComplexBall>;
  using Table = std::vector<std::vector<Interval>>; // bounds of |num_ij|/|den_i|
  struct Row {
    EnclosedPoly den;
    std::vector<EnclosedPoly> num; // of dY_i/dt
  };
  struct Solution {
    std::vector<Terms> value, slope; // dY_i/dt, one term less
  };

  static ComplexBall
  dyadic(const LoopPoint& p) { // an odd denominator cannot occur, so this is exact
    ComplexBall z;
    const long bits = static_cast<long>(2 * max_coordinate_bits) + 64;
    arb_set_fmpq(acb_realref(z.raw()), p.x.raw(), bits);
    arb_set_fmpq(acb_imagref(z.raw()), p.y.raw(), bits);
    return z;
  }
  // factor f, exact; the generator is i.
  static EnclosedPoly gaussian(const Poly& f, const Integer& factor) {
    Terms out(static_cast<std::size_t>(degree(f) + 1));
    for (long k = 0; k <= degree(f); ++k) {
      const NfElem c = f.coeff(k);
      acb_struct* z = out[static_cast<std::size_t>(k)].raw();
      arb_set_fmpz(acb_realref(z), (Rational(factor) * c.coeff(0)).num().raw());
      if (c.field()->degree() == 2)
        arb_set_fmpz(acb_imagref(z), (Rational(factor) * c.coeff(1)).num().raw());
    }
    return EnclosedPoly(out);
  }
  Row local(const LoopRow& row, const ComplexBall& point, const ComplexBall& step) {
    Integer factor(1);
    const auto clear = [&](const Poly& f) {
      for (long k = 0; k <= degree(f); ++k)
        for (long j = 0; j < f.field()->degree(); ++j)
          factor = lcm(factor, f.coeff(k).coeff(j).den());
    };
    clear(row.den);
    std::ranges::for_each(row.num, clear);
    const auto moved = [&](const Poly& f) {
      degree_ = std::max(degree_, degree(f));
      return gaussian(f, factor).moved(point, step, ARF_PREC_EXACT);
    };
    Row r{moved(row.den), {}};
    for (const Poly& f : row.num)
      r.num.push_back(moved(f).times(EnclosedPoly({step}), ARF_PREC_EXACT));
    return r;
  }

  // The integral of the weighted norm of A over the segment, and lower bounds of the denominators.
  void find_growth() {
    for (long k = fewest_pieces; k <= most_pieces; ++k)
      if (bounded_on_pieces(k)) return;
    throw Refused{"a segment comes too near to a singularity"};
  }
  bool bounded_on_pieces(long k) {
    std::vector<Table> tables;
    least_.clear();
    ComplexBall middle, radius;
    acb_one(radius.raw());
    acb_mul_2exp_si(radius.raw(), radius.raw(), -k - 1);
    for (long j = 0; j < 1L << k; ++j) {
      acb_mul_si(middle.raw(), radius.raw(), 2 * j + 1, Interval::bits);
      Table& table = tables.emplace_back();
      for (std::size_t i = 0; i < rows_.size(); ++i) {
        // |f(middle + u radius)| for |u| <= 1: at least |g_0| - ..., at most |g_0| + ...
        const auto den = rows_[i].den.moved(middle, radius, Interval::bits);
        const Interval least = den.sum_of_sizes() - Interval(2) * den.sum_of_sizes(1);
        if (least.sign() <= 0) return false;
        if (j == 0) least_.push_back(least);
        least_[i] = -larger(-least_[i], -least);
        auto& bounds = table.emplace_back();
        for (const EnclosedPoly& f : rows_[i].num)
          bounds.push_back(f.moved(middle, radius, Interval::bits).sum_of_sizes() / least);
      }
    }
    balance(tables);
    growth_ = Interval();
    for (const Table& t : tables)
      growth_ = growth_ + shifted(norm(t), -k);
    return true;
  }

  // max_i sum_j t_ij 2^(w_j - w_i)
  [[nodiscard]] Interval norm(const Table& t) const {
    Interval largest;
    for (std::size_t i = 0; i < t.size(); ++i) {
      Interval row;
      for (std::size_t j = 0; j < t.size(); ++j)
        row = row + shifted(t[i][j], weights_[j] - weights_[i]);
      largest = larger(largest, row);
    }
    return largest;
  }

  // Osborne's: rows and columns of like size.  Any weights are correct.
  void balance(const std::vector<Table>& tables) {
    const std::size_t n = rows_.size();
    weights_.assign(n, 0);
    const auto largest = [&](std::size_t i, bool row) {
      std::optional<long> most;
      for (const Table& t : tables)
        for (std::size_t j = 0; j < n; ++j) {
          const Interval& x = row ? t[i][j] : t[j][i];
          if (j == i || arb_is_zero(x.raw()) != 0) continue;
          Integer e; // the binary exponent, without a proof
          arf_abs_bound_lt_2exp_fmpz(e.raw(), arb_midref(x.raw()));
          const long size =
              to_long(e) + (row ? weights_[j] - weights_[i] : weights_[i] - weights_[j]);
          most = std::max(most.value_or(size), size);
        }
      return most;
    };
    for (int round = 0; round < balancing_rounds; ++round)
      for (std::size_t i = 0; i < n; ++i) {
        const auto row = largest(i, true), column = largest(i, false);
        if (row && column) weights_[i] += (*row - *column) / 2;
      }
  }

  // Some series with Y(0) = e_m; what it is worth is found by error_of.
  [[nodiscard]] Solution series(std::size_t m) {
    const std::size_t n = rows_.size();
    Solution y{std::vector<Terms>(n, Terms(1)), std::vector<Terms>(n)};
    acb_one(y.value[m][0].raw());
    const Interval small = power_of_two(degree_ + noise_bits - bits_);
    for (long k = 0, quiet = 0; quiet <= degree_ + 1; ++k) {
      need(k < 8 * bits_ + 64, "a series does not converge");
      work_ -= static_cast<double>(n * (n + 1) * static_cast<std::size_t>(degree_ + 1)) *
               static_cast<double>(bits_ + 200);
      need_within(work_ > 0, "the work is above the limit");
      for (std::size_t i = 0; i < n; ++i)
        y.slope[i].push_back(next_slope(y, i, k));
      bool is_small = true;
      for (std::size_t i = 0; i < n; ++i) {
        acb_struct* z = y.value[i].emplace_back().raw();
        acb_div_si(z, y.slope[i].back().raw(), k + 1, bits_ + extra_bits);
        acb_get_mid(z, z);
        acb_mul_si(y.slope[i].back().raw(), z, k + 1, ARF_PREC_EXACT);
        is_small = is_small && EnclosedPoly({y.value[i].back()}).sum_of_sizes() < small;
      }
      quiet = is_small ? quiet + 1 : 0;
    }
    return y;
  }
  // (sum num_ij Y_j)_k - sum over l > 0 of den_l (Y_i')_(k - l), by den_0
  [[nodiscard]] ComplexBall next_slope(const Solution& y, std::size_t i, long k) const {
    static_assert(sizeof(ComplexBall) == sizeof(acb_struct)); // terms are vectors of acb_struct
    const auto& [den, num] = rows_[i];
    ComplexBall sum;
    for (std::size_t j = 0; j < rows_.size(); ++j)
      acb_dot(sum.raw(), sum.raw(), 0, num[j].at(0), 1, y.value[j].back().raw(), -1,
              std::min(k + 1, num[j].length()), bits_ + extra_bits);
    if (k > 0)
      acb_dot(sum.raw(), sum.raw(), 1, den.at(1), 1, y.slope[i].back().raw(), -1,
              std::min(k, den.length() - 1), bits_ + extra_bits);
    acb_div(sum.raw(), sum.raw(), den.at(0), bits_ + extra_bits);
    return sum;
  }

  // max_i |E_i|/|den_i| 2^-w_i exp(growth), E_i = den_i Y_i' - sum num_ij Y_j coefficient by coefficient.
  [[nodiscard]] Interval error_of(const Solution& y) const {
    Interval most, factor;
    const long precision = 2 * bits_ + extra_bits;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      EnclosedPoly e = rows_[i].den.times(EnclosedPoly(y.slope[i]), precision);
      for (std::size_t j = 0; j < rows_.size(); ++j)
        acb_poly_sub(e.raw(), e.raw(),
                     rows_[i].num[j].times(EnclosedPoly(y.value[j]), precision).raw(), precision);
      most = larger(most, shifted(e.sum_of_sizes() / least_[i], -weights_[i]));
    }
    arb_exp(factor.raw(), growth_.raw(), Interval::bits);
    return most * factor;
  }

  static constexpr long extra_bits = 64;

  long bits_;
  double& work_;
  std::vector<Row> rows_;
  long degree_ = 0;
  Interval growth_;
  std::vector<Interval> least_;
  std::vector<long> weights_; // of the norm max_i |v_i| 2^-w_i
};

/// M with Y -> Y M along the closed polygon, Y = 1 at its first point.
/// Throws Refused
[[nodiscard]] inline Enclosures along(const std::vector<LoopRow>& rows, const Polygon& polygon,
                                      long bits, double& work) {
  Enclosures m(static_cast<long>(rows.size()));
  acb_mat_one(m.raw());
  for (std::size_t k = 0; k + 1 < polygon.size(); ++k) {
    const Enclosures step = Segment(rows, polygon[k], polygon[k + 1], bits, work).matrix();
    acb_mat_mul(m.raw(), step.raw(), m.raw(), 2 * bits);
  }
  return m;
}

} // namespace kov::certify
