#include "integrability/curve_rows.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"

#include <algorithm>

namespace kov {

CurveRows::CurveRows(const VectorField& v, const FunctionField& f) : v_(v), f_(f) {
  for (const MFraction& x : v.components)
    jacobian_.push_back(gradient(x));
  if (!v.poisson) return;
  for (const auto& row : *v.poisson) {
    Row& values = bracket_.emplace_back();
    for (const MFraction& p : row)
      values.push_back(value(p));
  }
}

CurveRows::Element CurveRows::constant(long c) const {
  const FiniteAlgebra& r = f_.algebra();
  return r.constant(MFraction(r.ring(), Rational(c)));
}

CurveRows::Element CurveRows::value(const MFraction& f) const {
  const auto& main = f_.algebra().ideal().main();
  for (const std::size_t i : v_.main_variables())
    if (uses(f, i) && !is_among(i, main))
      throw DomainError("'" + v_.ring->name(i) + "' has no value on the curve");
  auto e = f_.evaluate(f);
  if (!e) throw DomainError(brief(f, 60) + " has a pole along a component of the curve");
  return *std::move(e);
}

CurveRows::Row CurveRows::gradient(const MFraction& f) const {
  Row row;
  for (const MFraction& d : kov::gradient(v_, f))
    row.push_back(value(d));
  return row;
}

CurveRows::Row CurveRows::nabla(const Row& a) const {
  Row result;
  for (std::size_t k = 0; k < a.size(); ++k) {
    Element sum = f_.algebra().zero();
    for (std::size_t i = 0; i < a.size(); ++i)
      if (!is_zero(a[i]) && !is_zero(jacobian_[i][k])) sum = sum + times(a[i], jacobian_[i][k]);
    result.push_back(f_.derivative(a[k]) + times(f_.inverse_z_dot(), sum));
  }
  return result;
}

CurveRows::Row CurveRows::through_bracket(const Row& a) const {
  if (bracket_.empty()) return a;
  Row result(a.size(), f_.algebra().zero());
  for (std::size_t j = 0; j < a.size(); ++j)
    for (std::size_t k = 0; k < a.size(); ++k)
      if (!is_zero(a[j]) && !is_zero(bracket_[j][k]))
        result[k] = result[k] + times(a[j], bracket_[j][k]);
  return result;
}

// Gauss-Jordan; a pivot is an entry with an inverse, the shortest one of its row.
std::optional<CurveRows::Row> CurveRows::solve(std::vector<Row> rows, Row right) const {
  const FiniteAlgebra& r = f_.algebra();
  const std::size_t n = rows.empty() ? 0 : rows.front().size();
  std::vector<std::pair<std::size_t, std::size_t>> pivots; // row, column
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::vector<std::size_t> columns;
    const auto length = [&](std::size_t c) {
      long sum = 0;
      for (const MFraction& x : rows[i][c])
        if (!is_zero(x)) sum += x.num().length() + x.den().length();
      return sum;
    };
    for (std::size_t c = 0; c < n; ++c)
      if (!is_zero(rows[i][c])) columns.push_back(c);
    std::ranges::stable_sort(columns,
                             [&](std::size_t a, std::size_t b) { return length(a) < length(b); });
    std::optional<Element> inverse;
    std::size_t c = 0;
    for (std::size_t k = 0; k < columns.size() && !inverse; ++k) {
      c = columns[k];
      inverse = r.invert(rows[i][c]);
    }
    if (!inverse) {
      if (columns.empty() && is_zero(right[i])) continue;
      return std::nullopt;
    }
    for (Element& x : rows[i])
      x = is_zero(x) ? x : r.multiply(x, *inverse);
    right[i] = r.multiply(right[i], *inverse);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      if (k == i || is_zero(rows[k][c])) continue;
      const Element factor = rows[k][c];
      for (std::size_t j = 0; j < n; ++j)
        if (!is_zero(rows[i][j])) rows[k][j] = rows[k][j] - r.multiply(factor, rows[i][j]);
      right[k] = right[k] - r.multiply(factor, right[i]);
    }
    pivots.emplace_back(i, c);
  }
  Row x(n, r.zero());
  for (const auto& [i, c] : pivots)
    x[c] = right[i];
  return x;
}

std::optional<CurveRows::Row> CurveRows::combination(const std::vector<Row>& rows,
                                                     const Row& target) const {
  std::vector<Row> equations(target.size());
  for (std::size_t j = 0; j < target.size(); ++j)
    for (const Row& row : rows)
      equations[j].push_back(row[j]);
  if (rows.empty()) {
    if (std::ranges::all_of(target, [](const Element& e) { return is_zero(e); })) return Row{};
    return std::nullopt;
  }
  auto c = solve(equations, target);
  if (!c) return std::nullopt;
  for (std::size_t j = 0; j < target.size(); ++j) { // pivots were found, but is it a solution?
    Element sum = f_.algebra().zero();
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (!is_zero((*c)[i]) && !is_zero(rows[i][j])) sum = sum + times((*c)[i], rows[i][j]);
    if (!is_zero(sum - target[j])) return std::nullopt;
  }
  return c;
}

} // namespace kov
