#include "parameters/combination.hpp"

#include "exact/linear.hpp"

namespace kov {

namespace {

/// Rows: a x + artificial = b, the last of these that the sum over the strict is 1; then the cost, the sum of the
/// artificial variables, to be made 0.
class Tableau {
public:
  Tableau(const std::vector<std::vector<Rational>>& a, const std::vector<bool>& strict)
      : columns_(strict.size()) {
    rows_ = a;
    for (auto& row : rows_)
      row.emplace_back(0);
    rows_.emplace_back();
    for (const bool s : strict)
      rows_.back().emplace_back(s ? 1 : 0);
    rows_.back().emplace_back(1);
    basis_.assign(rows_.size(), columns_); // artificial
    std::vector<Rational> cost(columns_ + 1, Rational(0));
    for (const auto& row : rows_)
      for (std::size_t j = 0; j <= columns_; ++j)
        cost[j] = cost[j] + row[j];
    rows_.push_back(std::move(cost));
  }

  std::optional<std::vector<Rational>> solve() {
    while (rows_.back()[columns_] > Rational(0)) {
      std::size_t j = 0;
      while (j < columns_ && !(rows_.back()[j] > Rational(0)))
        ++j;
      if (j == columns_) return std::nullopt;
      const std::size_t i = leaving(j);
      if (i == basis_.size()) return std::nullopt;
      clear_column(rows_, i, j);
      basis_[i] = j;
    }
    std::vector<Rational> x(columns_, Rational(0));
    for (std::size_t i = 0; i < basis_.size(); ++i)
      if (basis_[i] < columns_) x[basis_[i]] = rows_[i][columns_];
    return x;
  }

private:
  [[nodiscard]] std::size_t leaving(std::size_t j) const {
    std::size_t best = basis_.size();
    for (std::size_t i = 0; i < basis_.size(); ++i) {
      if (!(rows_[i][j] > Rational(0))) continue;
      if (best == basis_.size()) {
        best = i;
        continue;
      }
      const Rational here = rows_[i][columns_] * rows_[best][j];
      const Rational there = rows_[best][columns_] * rows_[i][j];
      // of equal ones an artificial variable leaves, or the first (Bland)
      if (here < there || (here == there && before(basis_[i], basis_[best]))) best = i;
    }
    return best;
  }
  [[nodiscard]] bool before(std::size_t a, std::size_t b) const {
    return a == columns_ ? b != columns_ : b != columns_ && a < b;
  }

  std::size_t columns_;
  std::vector<std::vector<Rational>> rows_;
  std::vector<std::size_t> basis_;
};

} // namespace

std::optional<std::vector<Rational>>
nonnegative_combination(const std::vector<std::vector<Rational>>& a,
                        const std::vector<bool>& strict) {
  return Tableau(a, strict).solve();
}

} // namespace kov
