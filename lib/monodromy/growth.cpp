#include "monodromy/growth.hpp"

#include "monodromy/imprecise.hpp"

#include <algorithm>

namespace kov::monodromy {
namespace {

constexpr long bits = 96;
constexpr long fewest_pieces = 3; // binary logarithms of their number
constexpr long most_pieces = 12;
constexpr int balancing_rounds = 8;

using Table = std::vector<std::vector<Magnitude>>;

Coefficients short_numbers(Coefficients f) {
  for (ComplexBall& a : f)
    acb_set_round(a.raw(), a.raw(), bits);
  return f;
}

// |f_1| h + |f_2| h^2 + ...
Magnitude variation(const Coefficients& f, const Magnitude& h) {
  Magnitude sum;
  for (std::size_t i = f.size(); i-- > 1;)
    sum = (sum + Magnitude::of(f[i].raw())) * h;
  return sum;
}

// One of 2^log_count equal pieces of the segment: a disc about its middle.
struct Piece {
  ComplexBall middle;
  Magnitude radius;
};

Piece piece_of(const ComplexBall& t, long k, long log_count) {
  Piece p;
  acb_mul_si(p.middle.raw(), t.raw(), 2 * k + 1, bits);
  acb_mul_2exp_si(p.middle.raw(), p.middle.raw(), -log_count - 1);
  p.radius = times_power_of_two(Magnitude::of(t.raw()), -log_count - 1);
  return p;
}

class Segment {
public:
  Segment(const LocalSystem& s, const ComplexBall& t) : t_(t) {
    for (const LocalRow& row : s.rows) {
      den_.push_back(short_numbers(row.den));
      num_.emplace_back();
      for (const Coefficients& f : row.num)
        num_.back().push_back(short_numbers(f));
    }
  }

  Growth growth() {
    for (long log_count = fewest_pieces; log_count <= most_pieces; ++log_count)
      if (divide(log_count)) return finish(log_count);
    throw Imprecise("a step comes too near to a singularity");
  }

private:
  // Bounds on every piece; false when a denominator could vanish on one.
  bool divide(long log_count) {
    least_den_.clear();
    norms_.clear();
    for (long k = 0; k < 1L << log_count; ++k)
      if (!bound(piece_of(t_, k, log_count))) return false;
    return true;
  }

  bool bound(const Piece& piece) {
    const std::size_t n = den_.size();
    least_den_.resize(n);
    Table norms(n, std::vector<Magnitude>(n));
    for (std::size_t i = 0; i < n; ++i) {
      const Magnitude least = least_den(i, piece);
      if (is_zero(least)) return false;
      const bool first = norms_.empty();
      if (first || least < least_den_[i]) least_den_[i] = least;
      for (std::size_t j = 0; j < n; ++j)
        norms[i][j] = most_num(i, j, piece) / least;
    }
    norms_.push_back(std::move(norms));
    return true;
  }

  [[nodiscard]] Magnitude least_den(std::size_t i, const Piece& piece) const {
    const Coefficients f = shifted(den_[i], piece.middle, bits);
    Magnitude at_middle;
    acb_get_mag_lower(at_middle.raw(), f.front().raw());
    return less(at_middle, variation(f, piece.radius));
  }

  [[nodiscard]] Magnitude most_num(std::size_t i, std::size_t j, const Piece& piece) const {
    if (num_[i][j].empty()) return {};
    const Coefficients f = shifted(num_[i][j], piece.middle, bits);
    return Magnitude::of(f.front().raw()) + variation(f, piece.radius);
  }

  [[nodiscard]] Growth finish(long log_count) const {
    Growth g{balanced(), {}, {}};
    for (std::size_t i = 0; i < least_den_.size(); ++i)
      g.inverse.push_back(Magnitude::of(den_[i].front().raw()) / least_den_[i]);
    for (const Table& norms : norms_)
      g.exponent += weighted(norms, g.weights);
    g.exponent = times_power_of_two(g.exponent * Magnitude::of(t_.raw()), -log_count);
    return g;
  }

  [[nodiscard]] static Magnitude weighted(const Table& a, const std::vector<long>& w) {
    Magnitude most;
    for (std::size_t i = 0; i < a.size(); ++i) {
      Magnitude row;
      for (std::size_t j = 0; j < a.size(); ++j)
        row += times_power_of_two(a[i][j], w[j] - w[i]);
      most = max(most, row);
    }
    return most;
  }

  // Osborne's balancing of the largest entries: rows and columns of like size.
  [[nodiscard]] std::vector<long> balanced() const {
    const std::size_t n = den_.size();
    std::vector<long> w(n, 0);
    for (int round = 0; round < balancing_rounds; ++round)
      for (std::size_t i = 0; i < n; ++i) {
        Magnitude row, column;
        for (std::size_t j = 0; j < n; ++j) {
          if (j == i) continue;
          row = max(row, times_power_of_two(largest(i, j), w[j] - w[i]));
          column = max(column, times_power_of_two(largest(j, i), w[i] - w[j]));
        }
        if (!is_zero(row) && !is_zero(column)) w[i] += (exponent(row) - exponent(column)) / 2;
      }
    return w;
  }

  [[nodiscard]] Magnitude largest(std::size_t i, std::size_t j) const {
    Magnitude most;
    for (const Table& norms : norms_)
      most = max(most, norms[i][j]);
    return most;
  }

  ComplexBall t_;
  std::vector<Coefficients> den_;
  std::vector<std::vector<Coefficients>> num_;
  std::vector<Magnitude> least_den_;
  std::vector<Table> norms_;
};

} // namespace

Growth growth(const LocalSystem& s, const ComplexBall& t) { return Segment(s, t).growth(); }

} // namespace kov::monodromy
