#include "elementary/linear_system.hpp"

#include <map>

namespace kov::elementary {
namespace {

using Row = std::vector<MFraction>;

std::optional<Row> eliminated(std::vector<Row> m, std::size_t n, const Letters& letters) {
  const MFraction zero = letters.number(0);
  std::vector<std::size_t> pivots;
  std::size_t row = 0;
  for (std::size_t column = 0; column < n && row < m.size(); ++column) {
    std::size_t pivot = m.size();
    for (std::size_t i = row; i < m.size(); ++i) // the simplest
      if (!is_zero(m[i][column]) &&
          (pivot == m.size() || m[i][column].num().length() < m[pivot][column].num().length()))
        pivot = i;
    if (pivot == m.size()) continue;
    std::swap(m[row], m[pivot]);
    const MFraction inverse = letters.reduced(letters.number(1) / m[row][column]);
    for (std::size_t j = column; j <= n; ++j)
      if (!is_zero(m[row][j])) m[row][j] = letters.reduced(m[row][j] * inverse);
    for (std::size_t i = 0; i < m.size(); ++i) {
      if (i == row || is_zero(m[i][column])) continue;
      const MFraction factor = m[i][column];
      for (std::size_t j = column; j <= n; ++j)
        if (!is_zero(m[row][j])) m[i][j] = letters.reduced(m[i][j] - factor * m[row][j]);
    }
    pivots.push_back(column);
    ++row;
  }
  for (std::size_t i = row; i < m.size(); ++i)
    if (!is_zero(m[i][n])) return std::nullopt;
  Row c(n, zero);
  for (std::size_t i = 0; i < pivots.size(); ++i)
    c[pivots[i]] = m[i][n];
  return c;
}

} // namespace

std::optional<std::vector<MFraction>> coefficients_of(const Element& f,
                                                      const std::vector<Element>& images) {
  const Letters& letters = *f.letters();
  MPoly common(letters.ring(), Integer(1));
  const auto widen = [&](const Element& e) {
    for (const auto& [key, t] : e.terms())
      common = common * exact_div(t.coefficient.den(), gcd(common, t.coefficient.den()));
  };
  for (const Element& image : images)
    widen(image);
  widen(f);
  std::map<std::pair<std::string, std::size_t>, Row> rows;
  const std::size_t n = images.size();
  const auto enter = [&](const Element& e, std::size_t column) {
    for (const auto& [key, t] : e.terms()) {
      const MFraction p = t.coefficient * MFraction(common);
      const auto c = coefficients(p.num(), Letters::x);
      for (std::size_t k = 0; k < c.size(); ++k) {
        Row& row = rows[{key, k}];
        if (row.empty()) row.assign(n + 1, letters.number(0));
        row[column] = letters.reduced(MFraction(c[k]) / MFraction(p.den()));
      }
    }
  };
  for (std::size_t j = 0; j < n; ++j)
    enter(images[j], j);
  enter(f, n);
  std::vector<Row> matrix;
  for (auto& [place, row] : rows)
    matrix.push_back(std::move(row));
  return eliminated(std::move(matrix), n, letters);
}

} // namespace kov::elementary
