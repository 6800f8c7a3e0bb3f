#include "certify/loops/continuation.hpp"

#include "certify/equation/facts.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>

namespace kov::certify {
namespace {

constexpr long fewest_pieces = 2, most_pieces = 9; // binary logarithms of their number
constexpr int balancing_rounds = 8;
constexpr long noise_bits = 8;
constexpr long bound_bits = 64;

using Series = std::vector<ComplexBall>;

ComplexBall integer(const Integer& re, const Integer& im) {
  ComplexBall z;
  arb_set_fmpz(acb_realref(z.raw()), re.raw());
  arb_set_fmpz(acb_imagref(z.raw()), im.raw());
  return z;
}

// The coefficients of factor f, exact; the generator is i.
Series gaussian(const Poly& f, const Integer& factor) {
  Series out;
  const Rational scale(factor, Integer(1));
  for (long k = 0; k <= degree(f); ++k) {
    const NfElem c = f.coeff(k);
    const bool complex = c.field()->degree() == 2;
    out.push_back(
        integer((scale * c.coeff(0)).num(), complex ? (scale * c.coeff(1)).num() : Integer(0)));
  }
  return out;
}

ComplexBall dyadic(const LoopPoint& p) { // an odd denominator cannot occur, so this is exact
  ComplexBall z;
  const long bits = static_cast<long>(2 * max_coordinate_bits) + 64;
  arb_set_fmpq(acb_realref(z.raw()), p.x.raw(), bits);
  arb_set_fmpq(acb_imagref(z.raw()), p.y.raw(), bits);
  return z;
}

// f(point + step t)
Series moved(const Series& f, const ComplexBall& point, const ComplexBall& step, long precision) {
  Series out;
  for (std::size_t k = f.size(); k-- > 0;) {
    out.emplace_back();
    for (std::size_t i = out.size(); i-- > 0;) {
      acb_mul(out[i].raw(), out[i].raw(), point.raw(), precision);
      if (i > 0) acb_addmul(out[i].raw(), out[i - 1].raw(), step.raw(), precision);
    }
    acb_add(out[0].raw(), out[0].raw(), f[k].raw(), precision);
  }
  return out;
}

Ball upper(const ComplexBall& z) {
  Ball b;
  acb_abs(b.raw(), z.raw(), bound_bits);
  return b;
}

// |f(middle + u radius)| for |u| <= 1: at least (or at most) this.
Ball bound(const Series& f, const ComplexBall& middle, const ComplexBall& radius, bool least) {
  const Series g = moved(f, middle, radius, 2 * bound_bits);
  Ball sum;
  for (std::size_t k = 1; k < g.size(); ++k)
    arb_add(sum.raw(), sum.raw(), upper(g[k]).raw(), bound_bits);
  if (g.empty()) return sum;
  if (least)
    arb_sub(sum.raw(), upper(g[0]).raw(), sum.raw(), bound_bits);
  else
    arb_add(sum.raw(), upper(g[0]).raw(), sum.raw(), bound_bits);
  return sum;
}

Ball shifted(const Ball& x, long e) {
  Ball y;
  arb_mul_2exp_si(y.raw(), x.raw(), e);
  return y;
}

// The binary exponent of a number > 0, without a proof.
long size_of(const Ball& x) {
  Integer e;
  arf_abs_bound_lt_2exp_fmpz(e.raw(), arb_midref(x.raw()));
  return to_long(e);
}

using Table = std::vector<std::vector<Ball>>; // bounds of |num_ij|/|den_i|

struct Row {
  Series den;
  std::vector<Series> num; // of dY_i/dt
};

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

  [[nodiscard]] Enclosures matrix() {
    const long n = static_cast<long>(rows_.size());
    Enclosures m(n);
    for (long j = 0; j < n; ++j) {
      const std::vector<Series> y = series(static_cast<std::size_t>(j));
      const Ball error = error_of(y);
      for (long i = 0; i < n; ++i) {
        for (const ComplexBall& c : y[static_cast<std::size_t>(i)])
          acb_add(m.at(i, j), m.at(i, j), c.raw(), 2 * bits_);
        acb_add_error_arb(m.at(i, j), shifted(error, weights_[static_cast<std::size_t>(i)]).raw());
      }
    }
    return m;
  }

private:
  Row local(const LoopRow& row, const ComplexBall& point, const ComplexBall& step) {
    Integer factor(1);
    const auto clear = [&](const Poly& f) {
      for (long k = 0; k <= degree(f); ++k)
        for (long j = 0; j < f.field()->degree(); ++j)
          factor = lcm(factor, f.coeff(k).coeff(j).den());
    };
    clear(row.den);
    for (const Poly& f : row.num)
      clear(f);
    Row r{moved(gaussian(row.den, factor), point, step, ARF_PREC_EXACT), {}};
    for (const Poly& f : row.num) {
      r.num.push_back(moved(gaussian(f, factor), point, step, ARF_PREC_EXACT));
      for (ComplexBall& c : r.num.back())
        acb_mul(c.raw(), c.raw(), step.raw(), ARF_PREC_EXACT);
    }
    degree_ = std::max(degree_, static_cast<long>(r.den.size()) - 1);
    for (const Series& f : r.num)
      degree_ = std::max(degree_, static_cast<long>(f.size()) - 1);
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
    least_.assign(rows_.size(), Ball());
    ComplexBall middle, radius;
    acb_one(radius.raw());
    acb_mul_2exp_si(radius.raw(), radius.raw(), -k - 1);
    for (long j = 0; j < 1L << k; ++j) {
      acb_mul_si(middle.raw(), radius.raw(), 2 * j + 1, bound_bits);
      if (!bounded_on(middle, radius, tables)) return false;
    }
    balance(tables);
    growth_ = Ball();
    for (const Table& t : tables)
      arb_add(growth_.raw(), growth_.raw(), norm(t).raw(), bound_bits);
    growth_ = shifted(growth_, -k);
    return true;
  }
  bool bounded_on(const ComplexBall& middle, const ComplexBall& radius,
                  std::vector<Table>& tables) {
    Table table;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const Ball least = bound(rows_[i].den, middle, radius, true);
      if (arb_is_positive(least.raw()) == 0) return false;
      if (tables.empty())
        least_[i] = least;
      else
        arb_min(least_[i].raw(), least_[i].raw(), least.raw(), bound_bits);
      table.emplace_back();
      for (const Series& f : rows_[i].num) {
        table.back().push_back(bound(f, middle, radius, false));
        Ball& x = table.back().back();
        arb_div(x.raw(), x.raw(), least.raw(), bound_bits);
      }
    }
    tables.push_back(std::move(table));
    return true;
  }

  // max_i sum_j t_ij 2^(w_j - w_i)
  [[nodiscard]] Ball norm(const Table& t) const {
    Ball largest;
    for (std::size_t i = 0; i < t.size(); ++i) {
      Ball row;
      for (std::size_t j = 0; j < t.size(); ++j)
        arb_add(row.raw(), row.raw(), shifted(t[i][j], weights_[j] - weights_[i]).raw(),
                bound_bits);
      arb_max(largest.raw(), largest.raw(), row.raw(), bound_bits);
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
          const Ball& x = row ? t[i][j] : t[j][i];
          if (j == i || arb_is_zero(x.raw()) != 0) continue;
          const long shift = row ? weights_[j] - weights_[i] : weights_[i] - weights_[j];
          most = std::max(most.value_or(size_of(x) + shift), size_of(x) + shift);
        }
      return most;
    };
    for (int round = 0; round < balancing_rounds; ++round)
      for (std::size_t i = 0; i < n; ++i) {
        const auto row = largest(i, true), column = largest(i, false);
        if (row && column) weights_[i] += (*row - *column) / 2;
      }
  }

  // The right side of den_0 (k + 1) y_(k+1) = ... for the terms that there are.
  [[nodiscard]] ComplexBall right(const std::vector<Series>& y, std::size_t i, long k,
                                  long precision) const {
    const long last = static_cast<long>(y[i].size()) - 1;
    ComplexBall sum, term;
    for (std::size_t j = 0; j < rows_.size(); ++j) {
      const Series& f = rows_[i].num[j];
      for (long l = std::max(0L, k - last); l <= k && l < static_cast<long>(f.size()); ++l)
        acb_addmul(sum.raw(), f[l].raw(), y[j][k - l].raw(), precision);
    }
    const Series& f = rows_[i].den;
    for (long l = std::max(1L, k + 1 - last); l <= k && l < static_cast<long>(f.size()); ++l) {
      acb_mul_si(term.raw(), f[l].raw(), k + 1 - l, precision);
      acb_submul(sum.raw(), term.raw(), y[i][k + 1 - l].raw(), precision);
    }
    return sum;
  }

  // Some series with Y(0) = e_m; what it is worth is found by error_of.
  [[nodiscard]] std::vector<Series> series(std::size_t m) {
    const std::size_t n = rows_.size();
    std::vector<Series> y(n, Series(1));
    acb_one(y[m][0].raw());
    const long small = degree_ + noise_bits - bits_;
    for (long k = 0, quiet = 0; quiet <= degree_ + 1; ++k) {
      need(k < 8 * bits_ + 64, "a series does not converge");
      work_ -= static_cast<double>(n * (n + 1) * static_cast<std::size_t>(degree_ + 1)) *
               static_cast<double>(bits_ + 200);
      need_within(work_ > 0, "the work is above the limit");
      Series next;
      for (std::size_t i = 0; i < n; ++i) {
        next.push_back(right(y, i, k, bits_ + bound_bits));
        acb_struct* z = next.back().raw();
        acb_div(z, z, rows_[i].den[0].raw(), bits_ + bound_bits);
        acb_div_si(z, z, k + 1, bits_ + bound_bits);
        acb_get_mid(z, z);
      }
      bool is_small = true;
      for (std::size_t i = 0; i < n; ++i) {
        Ball size = upper(next[i]);
        arb_mul_2exp_si(size.raw(), size.raw(), -small);
        Ball one;
        arb_one(one.raw());
        is_small = is_small && arb_lt(size.raw(), one.raw()) != 0;
        y[i].push_back(next[i]);
      }
      quiet = is_small ? quiet + 1 : 0;
    }
    return y;
  }

  // max_i |E_i|/|den_i| 2^-w_i exp(growth), E_i = den_i Y_i' - sum num_ij Y_j coefficient by coefficient.
  [[nodiscard]] Ball error_of(const std::vector<Series>& y) const {
    Ball most;
    const long precision = 2 * bits_ + bound_bits;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      Ball sum;
      const long terms = static_cast<long>(y[i].size()) + degree_;
      for (long k = 0; k <= terms; ++k) {
        ComplexBall e = right(y, i, k, precision);
        acb_neg(e.raw(), e.raw());
        if (k + 1 < static_cast<long>(y[i].size())) {
          ComplexBall head;
          acb_mul_si(head.raw(), rows_[i].den[0].raw(), k + 1, precision);
          acb_addmul(e.raw(), head.raw(), y[i][k + 1].raw(), precision);
        }
        arb_add(sum.raw(), sum.raw(), upper(e).raw(), bound_bits);
      }
      arb_div(sum.raw(), sum.raw(), least_[i].raw(), bound_bits);
      sum = shifted(sum, -weights_[i]);
      arb_max(most.raw(), most.raw(), sum.raw(), bound_bits);
    }
    Ball factor;
    arb_exp(factor.raw(), growth_.raw(), bound_bits);
    arb_mul(most.raw(), most.raw(), factor.raw(), bound_bits);
    return most;
  }

  long bits_;
  double& work_;
  std::vector<Row> rows_;
  long degree_ = 0;
  Ball growth_;
  std::vector<Ball> least_;
  std::vector<long> weights_; // of the norm max_i |v_i| 2^-w_i
};

} // namespace

Enclosures along(const std::vector<LoopRow>& rows, const Polygon& polygon, long bits,
                 double& work) {
  const long n = static_cast<long>(rows.size());
  Enclosures m(n);
  acb_mat_one(m.raw());
  for (std::size_t k = 0; k + 1 < polygon.size(); ++k) {
    const Enclosures step = Segment(rows, polygon[k], polygon[k + 1], bits, work).matrix();
    acb_mat_mul(m.raw(), step.raw(), m.raw(), 2 * bits);
  }
  return m;
}

} // namespace kov::certify
