#include "integrability/constant_matrices.hpp"

#include "exact/finite_algebra.hpp"

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

// Coefficients of det(x - t), ascending (Faddeev and LeVerrier).
std::vector<MFraction> characteristic_polynomial(const Matrix& t) {
  const Ring ring = t[0][0].ring();
  const std::size_t n = t.size();
  std::vector<MFraction> c(n + 1, MFraction(ring));
  c[n] = MFraction(ring, Rational(1));
  Matrix m = zeros(ring, n);
  for (std::size_t k = 1; k <= n; ++k) {
    m = sum(product(t, m), c[n - k + 1], identity(ring, n));
    const Matrix tm = product(t, m);
    MFraction trace(ring);
    for (std::size_t i = 0; i < n; ++i)
      trace += tm[i][i];
    c[n - k] = trace / MFraction(ring, Rational(-static_cast<long>(k)));
  }
  return c;
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

// C without denominators, on the manifold, by monomials: the coefficients are constants.
std::map<Monomial, Matrix> by_monomials(const LinearSystem& s, const InvariantManifold& m,
                                        const std::vector<std::size_t>& block) {
  const Ring ring = m.ideal->ring();
  MFraction common(ring, Rational(1));
  for (const std::size_t i : block)
    for (const std::size_t j : block)
      common = common * MFraction((MFraction(s.a[i][j].den()) / common).num());
  std::map<Monomial, Matrix> all;
  for (std::size_t i = 0; i < block.size(); ++i)
    for (std::size_t j = 0; j < block.size(); ++j)
      for (const auto& [monomial, c] :
           m.ideal->reduce(MFraction((s.a[block[i]][block[j]] * common).num()))) {
        const auto at = all.try_emplace(monomial, zeros(ring, block.size())).first;
        at->second[i][j] = c;
      }
  return all;
}

// A basis of the matrices T with T A = A T for all A.
std::vector<Matrix> commutant(const std::map<Monomial, Matrix>& all, std::size_t n,
                              const Budget& budget) {
  Matrix equations;
  const Ring ring = all.begin()->second[0][0].ring();
  for (const auto& [monomial, a] : all)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        std::vector<MFraction> row(n * n, MFraction(ring));
        for (std::size_t k = 0; k < n; ++k) {
          row[i * n + k] += a[k][j];
          row[k * n + j] -= a[i][k];
        }
        if (std::any_of(row.begin(), row.end(), [](const MFraction& f) { return !is_zero(f); }))
          equations.push_back(std::move(row));
      }
  std::vector<Matrix> basis;
  for (const auto& solution : null_space(equations, n * n, ring, budget)) {
    Matrix t = zeros(ring, n);
    for (std::size_t i = 0; i < n * n; ++i)
      t[i / n][i % n] = solution[i];
    basis.push_back(std::move(t));
  }
  return basis;
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
