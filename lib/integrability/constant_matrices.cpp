#include "integrability/constant_matrices.hpp"

#include "exact/error.hpp"
#include "exact/finite_algebra.hpp"

#include <algorithm>
#include <utility>

namespace kov {

Matrix zeros(const Ring& ring, std::size_t n) {
  return Matrix(n, std::vector<MFraction>(n, MFraction(ring)));
}

Matrix identity(const Ring& ring, std::size_t n) {
  Matrix one = zeros(ring, n);
  for (std::size_t i = 0; i < n; ++i)
    one[i][i] = MFraction(ring, Rational(1));
  return one;
}

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c = zeros(a[0][0].ring(), a.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; k < a.size(); ++k)
      if (!is_zero(a[i][k]))
        for (std::size_t j = 0; j < a.size(); ++j)
          if (!is_zero(b[k][j])) c[i][j] += a[i][k] * b[k][j];
  return c;
}

// a + f b
Matrix sum(Matrix a, const MFraction& f, const Matrix& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < a.size(); ++j)
      a[i][j] += f * b[i][j];
  return a;
}

std::vector<MFraction> times(const std::vector<MFraction>& row, const Matrix& t) {
  std::vector<MFraction> result(row.size(), MFraction(row.front().ring()));
  for (std::size_t i = 0; i < row.size(); ++i)
    if (!is_zero(row[i]))
      for (std::size_t j = 0; j < row.size(); ++j)
        result[j] += row[i] * t[i][j];
  return result;
}

namespace {

std::vector<MFraction> product_of(const std::vector<MFraction>& p,
                                  const std::vector<MFraction>& q) {
  std::vector<MFraction> all(p.size() + q.size() - 1, MFraction(p.front().ring()));
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < q.size(); ++j)
      all[i + j] += p[i] * q[j];
  return all;
}

std::vector<MFraction> image(std::vector<MFraction> row, const std::vector<MFraction>& polynomial,
                             const Matrix& t) {
  std::vector<MFraction> all(row.size(), MFraction(row.front().ring()));
  for (std::size_t k = 0; k < polynomial.size(); ++k) {
    if (k > 0) row = times(row, t);
    for (std::size_t j = 0; j < row.size(); ++j)
      all[j] += polynomial[k] * row[j];
  }
  return all;
}

// The polynomial of least degree that maps the row to 0.
std::vector<MFraction> annihilator(std::vector<MFraction> row, const Matrix& t,
                                   const Budget& budget) {
  Matrix columns(row.size());
  for (std::size_t d = 0;; ++d) {
    KOV_ENSURE(d <= t.size());
    for (std::size_t j = 0; j < row.size(); ++j)
      columns[j].push_back(row[j]);
    auto relation = null_space(columns, d + 1, row.front().ring(), budget);
    if (relation.empty()) {
      row = times(row, t);
      continue;
    }
    const MFraction leading = relation[0][d];
    for (MFraction& c : relation[0])
      c = c / leading;
    return relation[0];
  }
}

} // namespace

std::vector<MFraction> minimal_polynomial(const Matrix& t, const Budget& budget) {
  std::vector<MFraction> p{MFraction(t[0][0].ring(), Rational(1))};
  for (const auto& unit : identity(t[0][0].ring(), t.size())) {
    const auto row = image(unit, p, t);
    if (std::ranges::any_of(row, [](const MFraction& f) { return !is_zero(f); }))
      p = product_of(p, annihilator(row, t, budget));
  }
  return p;
}

Matrix value(const std::vector<MFraction>& polynomial, const Matrix& t) {
  Matrix v = zeros(t[0][0].ring(), t.size());
  for (std::size_t i = polynomial.size(); i-- > 0;)
    v = sum(product(v, t), polynomial[i], identity(t[0][0].ring(), t.size()));
  return v;
}

// The irreducible factors over the parameters, each with its multiplicity.
std::vector<std::pair<std::vector<MFraction>, long>>
factors_of(const std::vector<MFraction>& polynomial) {
  const Ring ring = polynomial[0].ring();
  auto names = ring->names();
  names.emplace_back("an eigenvalue");
  const Ring larger = make_ring(names);
  const std::size_t x = names.size() - 1;
  MFraction p(larger);
  for (std::size_t i = polynomial.size(); i-- > 0;)
    p = p * MFraction::variable(larger, x) + transfer(polynomial[i], larger);
  std::vector<std::pair<std::vector<MFraction>, long>> all;
  for (const MFactor& f : factor(p.num()).second) {
    if (degree(f.base, x) < 1) continue;
    std::vector<MFraction> coefficients_here;
    for (const MPoly& c : coefficients(f.base, x))
      coefficients_here.push_back(transfer(MFraction(c), ring));
    all.emplace_back(std::move(coefficients_here), static_cast<long>(f.exponent));
  }
  return all;
}

// Rows l with l m = 0.
Matrix row_kernel(const Matrix& m, const Budget& budget) {
  Matrix transposed = m;
  for (std::size_t i = 0; i < m.size(); ++i)
    for (std::size_t j = 0; j < m.size(); ++j)
      transposed[i][j] = m[j][i];
  return null_space(transposed, m.size(), m[0][0].ring(), budget);
}

namespace {

// f C by monomials: a linear map of it.
std::map<Monomial, Matrix> by_monomials(const Matrix& c, const MFraction& f, const Ideal& ideal) {
  std::map<Monomial, Matrix> all;
  for (std::size_t i = 0; i < c.size(); ++i)
    for (std::size_t j = 0; j < c.size(); ++j)
      for (const auto& [monomial, x] : ideal.reduce(f * c[i][j])) {
        const auto at = all.try_emplace(monomial, zeros(ideal.ring(), c.size())).first;
        at->second[i][j] = x;
      }
  return all;
}

// (a b; c d)
Matrix of_blocks(const Matrix& a, const Matrix& b, const Matrix& c, const Matrix& d) {
  Matrix all;
  for (const auto* half : {&a, &c})
    for (std::size_t i = 0; i < a.size(); ++i) {
      auto row = (*half)[i];
      const auto& right = (half == &a ? b : d)[i];
      row.insert(row.end(), right.begin(), right.end());
      all.push_back(std::move(row));
    }
  return all;
}

} // namespace

ConstantRows::ConstantRows(const System& s, const LinearSystem& linear, const InvariantManifold& m,
                           const std::vector<std::size_t>& block)
    : size_(block.size()), ring_(m.ideal->ring()) {
  const auto constants = quadratic_constants(s.field);
  if (s.field.constants.size() == 1 && constants.size() == 1) constant_ = constants.front();
  const MFraction one(ring_, Rational(1));
  MFraction common = one;
  for (const std::size_t i : block)
    for (const std::size_t j : block)
      common = common * MFraction((MFraction(linear.a[i][j].den()) / common).num());
  Matrix c = zeros(ring_, size_); // without denominators
  for (std::size_t i = 0; i < size_; ++i)
    for (std::size_t j = 0; j < size_; ++j)
      c[i][j] = MFraction((linear.a[block[i]][block[j]] * common).num());
  const auto add = [&](const MFraction& f, Matrix Parts::*part) {
    for (auto& [monomial, a] : by_monomials(c, f, *m.ideal)) {
      const auto zero = zeros(ring_, size_);
      parts_.try_emplace(monomial, Parts{zero, zero}).first->second.*part = a;
    }
  };
  add(one, &Parts::plain);
  if (constant_) add(MFraction::variable(ring_, constant_->variable), &Parts::times_constant);
}

// l_0 + kappa l_1 -> (l_0 + kappa l_1) (t_0 + kappa t_1).
Matrix ConstantRows::matrix(const Matrix& t0, const Matrix& t1) const {
  if (!constant_) return t0;
  const auto r = coefficients(constant_->relation, constant_->variable);
  const MFraction b(r[1], r[2]), c(r[0], r[2]); // kappa^2 = -b kappa - c
  return of_blocks(t0, t1, sum(zeros(ring_, size_), -c, t1), sum(t0, -b, t1));
}

// [t_0, C] + [t_1, kappa C] = 0, monomial by monomial.
std::vector<Matrix> ConstantRows::commutant(const Budget& budget) const {
  const std::size_t n = size_, square = n * n;
  Matrix equations;
  for (const auto& [monomial, part] : parts_)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        std::vector<MFraction> row(n * width(), MFraction(ring_));
        for (std::size_t k = 0; k < n; ++k)
          for (std::size_t half = 0; half * n < width(); ++half) {
            const Matrix& a = half == 0 ? part.plain : part.times_constant;
            row[half * square + i * n + k] += a[k][j];
            row[half * square + k * n + j] -= a[i][k];
          }
        if (std::ranges::any_of(row, [](const MFraction& f) { return !is_zero(f); }))
          equations.push_back(std::move(row));
      }
  std::vector<Matrix> all;
  for (const auto& solution : null_space(equations, n * width(), ring_, budget)) {
    Matrix t0 = zeros(ring_, n), t1 = t0;
    for (std::size_t i = 0; i < square; ++i) {
      t0[i / n][i % n] = solution[i];
      if (constant_) t1[i / n][i % n] = solution[square + i];
    }
    all.push_back(matrix(t0, t1));
  }
  return all;
}

std::vector<MFraction> ConstantRows::row(const std::vector<MFraction>& pair) const {
  if (!constant_) return pair;
  const Ring& ring = pair.front().ring(); // perhaps a larger one
  const MFraction kappa = MFraction::variable(ring, constant_->variable);
  std::vector<MFraction> all;
  for (std::size_t i = 0; i < size_; ++i)
    all.push_back(pair[i] + kappa * pair[size_ + i]);
  return all;
}

Matrix ConstantRows::with_multiples(const Matrix& rows) const {
  Matrix all = rows;
  if (constant_)
    for (const auto& row : rows)
      all.push_back(times(row, matrix(zeros(ring_, size_), identity(ring_, size_))));
  return all;
}

bool ConstantRows::independent(const Matrix& rows, const Budget& budget) const {
  const Matrix all = with_multiples(rows);
  Matrix columns(width());
  for (const auto& row : all)
    for (std::size_t j = 0; j < row.size(); ++j)
      columns[j].push_back(row[j]);
  return null_space(columns, all.size(), ring_, budget).empty();
}

Matrix ConstantRows::basis(const Matrix& rows, const Budget& budget) const {
  Matrix chosen;
  for (const auto& row : rows) {
    if (chosen.size() == size_) break;
    chosen.push_back(row);
    if (!independent(chosen, budget)) chosen.pop_back();
  }
  return chosen;
}

std::vector<Matrix> with_combinations(std::vector<Matrix> commuting) {
  constexpr long combinations = 3;
  const std::size_t n = commuting.size();
  const Ring ring = commuting.front()[0][0].ring();
  for (long k = 1; k <= combinations; ++k) {
    Matrix mixed = zeros(ring, commuting.front().size());
    Rational weight(1);
    for (std::size_t i = 0; i < n; ++i) {
      mixed = sum(mixed, MFraction(ring, weight), commuting[i]);
      weight = weight * Rational(k) + Rational(1);
    }
    commuting.push_back(std::move(mixed));
  }
  return commuting;
}

void replace_equations(ManifoldSpec& m, const NormalSystem& normal,
                       const std::vector<std::size_t>& block, const Matrix& rows) {
  std::vector<MFraction> here;
  for (const std::size_t i : block)
    here.push_back(m.equations[normal.equations[i]].difference);
  for (std::size_t i = 0; i < block.size(); ++i) {
    MFraction sum(here.front().ring());
    for (std::size_t k = 0; k < block.size(); ++k)
      if (!is_zero(rows[i][k])) sum += rows[i][k] * here[k];
    m.equations[normal.equations[block[i]]] = {sum, to_string(sum) + " = 0"};
  }
}

} // namespace kov
