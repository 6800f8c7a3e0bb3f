#include "integrals/independence.hpp"
#include "exact/lists.hpp"

#include <algorithm>

namespace kov {

MPoly determinant(std::vector<std::vector<MPoly>> m) {
  const std::size_t n = m.size();
  const Ring& ring = m.at(0).at(0).ring();
  MPoly last(ring, Integer(1));
  bool odd = false;
  for (std::size_t k = 0; k + 1 < n; ++k) {
    const auto pivot = std::find_if(m.begin() + static_cast<long>(k), m.end(),
                                    [&](const auto& row) { return !is_zero(row[k]); });
    if (pivot == m.end()) return MPoly(ring);
    if (pivot != m.begin() + static_cast<long>(k)) {
      std::swap(*pivot, m[k]);
      odd = !odd;
    }
    for (std::size_t i = k + 1; i < n; ++i)
      for (std::size_t j = k + 1; j < n; ++j)
        m[i][j] = exact_div(m[k][k] * m[i][j] - m[i][k] * m[k][j], last);
    last = m[k][k];
  }
  return odd ? -m[n - 1][n - 1] : m[n - 1][n - 1];
}

MPoly IndependentRows::minor(const std::vector<MPoly>& row, std::size_t column) const {
  std::vector<std::vector<MPoly>> m;
  const auto add = [&](const std::vector<MPoly>& from) {
    m.emplace_back();
    for (const std::size_t c : columns_)
      m.back().push_back(from[c]);
    m.back().push_back(from[column]);
  };
  for (const auto& r : rows_)
    add(r);
  add(row);
  return determinant(std::move(m));
}

IndependentRows::Answer IndependentRows::add(const Set& where, const std::vector<MFraction>& row,
                                             const Budget& budget) {
  const auto polynomials = numerators(row, common_denominator(p_->field.ring, row));
  std::optional<MPoly> doubtful;
  for (std::size_t c = 0; c < row.size(); ++c) {
    if (is_among(c, columns_)) continue;
    budget.check();
    for (const auto& [m, value] : p_->coefficients(minor(polynomials, c), nullptr)) {
      const MPoly here = where.restrict(value).num();
      if (is_zero(here)) continue;
      if (where.is_nonzero(here)) {
        rows_.push_back(polynomials);
        columns_.push_back(c);
        return {true};
      }
      if (!doubtful || here.length() < doubtful->length()) doubtful = here;
    }
  }
  if (!doubtful) return {false};
  return {false, where.doubtful_factors(*doubtful).front()};
}

} // namespace kov
