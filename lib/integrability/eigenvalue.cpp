#include "integrability/eigenvalue.hpp"

#include "exact/error.hpp"
#include "exact/finite_algebra.hpp"
#include "integrability/constant_matrices.hpp"
#include "special/arithmetic.hpp"
#include "system/in_ring.hpp"

#include <algorithm>

namespace kov {
namespace {

constexpr std::size_t largest_degree = 4;
constexpr std::size_t least_dimension = 4; // below it a normal part has two unknowns at most

using Polynomial = std::vector<MFraction>; // coefficients, ascending

struct Splitting {
  std::vector<std::size_t> block;
  Matrix t;     // without denominators
  Polynomial p; // with the leading coefficient 1; a power of it is det(x - t)
};

Matrix without_denominators(Matrix t) {
  MFraction common(t[0][0].ring(), Rational(1));
  for (const auto& row : t)
    for (const MFraction& f : row)
      common = common * MFraction((MFraction(f.den()) / common).num());
  for (auto& row : t)
    for (MFraction& f : row)
      f = f * common;
  return t;
}

// So that there is a root for all parameters.
Polynomial monic(Polynomial p) {
  const MFraction leading = p.back();
  for (MFraction& c : p)
    c = c / leading;
  return p;
}

std::size_t length_of(const Polynomial& p) {
  std::size_t length = 0;
  for (const MFraction& c : p)
    length += to_string(c).size();
  return length;
}

// The shortest polynomial of the lowest degree.
std::optional<Splitting> splitting(const ManifoldReport& report, const Budget& budget) {
  std::optional<Splitting> best;
  for (const auto& block : blocks(report.normal.system, *report.manifold)) {
    if (block.size() < 3 || block.size() > largest_decoupled) continue;
    const auto all = by_monomials(report.normal.system, *report.manifold, block);
    if (all.empty()) continue;
    for (const Matrix& commuting : with_combinations(commutant(all, block.size(), budget))) {
      const Matrix t = without_denominators(commuting);
      auto factors = factors_of(characteristic_polynomial(t));
      if (factors.size() != 1) continue;
      Polynomial p = monic(std::move(factors.front().first));
      if (p.size() < 3 || p.size() > largest_degree + 1) continue;
      const auto size = [](const Polynomial& f) { return std::pair(f.size(), length_of(f)); };
      if (!best || size(p) < size(best->p)) best = {block, t, std::move(p)};
    }
  }
  return best;
}

// ---- the constant

MFraction discriminant(const Polynomial& p) {
  return p[1] * p[1] - MFraction(p[1].ring(), Rational(4)) * p[0] * p[2];
}

// A root of p of degree 2 by an algebraic constant of degree 2 that the system has.
std::optional<MFraction> known_root(const System& s, const Polynomial& p) {
  if (p.size() != 3) return std::nullopt;
  const MFraction two(s.ring(), Rational(2));
  for (const std::size_t c : s.field.constants)
    for (const MPoly& relation : s.field.relations) {
      const auto used = used_variables(relation);
      const bool of_parameters = std::all_of(used.begin(), used.end(), [&](std::size_t i) {
        const auto& all = s.field.parameters;
        return i == c || std::find(all.begin(), all.end(), i) != all.end();
      });
      if (!of_parameters || degree(relation, c) != 2) continue;
      Polynomial q;
      for (const MPoly& x : coefficients(relation, c))
        q.emplace_back(x);
      if (const auto k = square_root(discriminant(p) / discriminant(q)))
        return (*k * (two * q[2] * MFraction::variable(s.ring(), c) + q[1]) - p[1]) / two;
    }
  return std::nullopt;
}

std::string free_name(const Ring& ring) {
  std::string name = "lambda";
  for (int k = 1; ring->find(name); ++k)
    name = "lambda" + std::to_string(k);
  return name;
}

// The constant is the last variable of the ring.
MPoly relation_of(const Polynomial& p, const Ring& ring) {
  MFraction value(ring);
  for (std::size_t k = p.size(); k-- > 0;)
    value = value * MFraction::variable(ring, ring->size() - 1) + transfer(p[k], ring);
  return value.num();
}

// ---- eigenrows

std::vector<MFraction> times(const std::vector<MFraction>& row, const Matrix& t) {
  std::vector<MFraction> result(row.size(), MFraction(row.front().ring()));
  for (std::size_t i = 0; i < row.size(); ++i)
    if (!is_zero(row[i]))
      for (std::size_t j = 0; j < row.size(); ++j)
        result[j] += row[i] * t[i][j];
  return result;
}

// v, v t, ..., v t^(d - 1) for rows v that generate all of them.
std::vector<Matrix> cyclic_rows(const Matrix& t, std::size_t d, const Budget& budget) {
  const Ring ring = t[0][0].ring();
  const std::size_t n = t.size();
  std::vector<Matrix> all;
  Matrix columns(n);
  for (std::size_t i = 0; i < n && all.size() * d < n; ++i) {
    Matrix rows{std::vector<MFraction>(n, MFraction(ring))};
    rows[0][i] = MFraction(ring, Rational(1));
    while (rows.size() < d)
      rows.push_back(times(rows.back(), t));
    Matrix with = columns;
    for (const auto& row : rows)
      for (std::size_t j = 0; j < n; ++j)
        with[j].push_back(row[j]);
    if (!null_space(with, with[0].size(), ring, budget).empty()) continue;
    columns = std::move(with);
    all.push_back(std::move(rows));
  }
  return all;
}

// v q(t), q(x) = p(x)/(x - root): it is mapped to root times itself.
std::vector<MFraction> eigenrow(const Matrix& powers, const Polynomial& p, const MFraction& root) {
  std::vector<MFraction> row(powers[0].size(), MFraction(root.ring()));
  MFraction coefficient(root.ring());
  for (std::size_t k = powers.size(); k-- > 0;) {
    coefficient = coefficient * root + p[k + 1];
    for (std::size_t j = 0; j < row.size(); ++j)
      row[j] += coefficient * powers[k][j];
  }
  return row;
}

// Those of one root after the other; of more than two roots, one and what is needed for a basis.
Matrix eigenrows(const Splitting& x, const MFraction& root, const Budget& budget) {
  const std::size_t d = x.p.size() - 1;
  const auto generators = cyclic_rows(x.t, d, budget);
  Matrix rows;
  for (const Matrix& powers : generators)
    rows.push_back(eigenrow(powers, x.p, root));
  for (const Matrix& powers : generators)
    if (d == 2)
      rows.push_back(eigenrow(powers, x.p, -x.p[1] - root));
    else
      rows.insert(rows.end(), powers.begin(), powers.end() - 1);
  return rows;
}

Splitting in_ring(Splitting x, const Ring& ring) {
  for (auto& row : x.t)
    for (MFraction& f : row)
      f = transfer(f, ring);
  for (MFraction& c : x.p)
    c = transfer(c, ring);
  return x;
}

} // namespace

std::optional<WithEigenvalue> with_eigenvalue(const System& s, const ManifoldSpec& m,
                                              const ManifoldReport& report, const Budget& budget) {
  auto x = splitting(report, budget);
  if (!x) return std::nullopt;
  WithEigenvalue result{s, m, {}};
  auto root = known_root(s, x->p);
  if (!root) {
    auto names = s.ring()->names();
    names.push_back(free_name(s.ring()));
    System with_manifold = s;
    with_manifold.manifolds.push_back(m);
    result.system = kov::in_ring(with_manifold, make_ring(names));
    result.manifold = std::move(result.system.manifolds.back());
    result.system.manifolds.pop_back();
    const Ring& ring = result.system.ring();
    VectorField& field = result.system.field;
    field.constants.push_back(ring->size() - 1);
    field.relations.push_back(relation_of(x->p, ring));
    x = in_ring(*std::move(x), ring);
    root = MFraction::variable(ring, ring->size() - 1);
    result.constant = names.back() + " is a root of " + to_string(field.relations.back()) +
                      " (an eigenvalue of the variations along " + m.name + ")";
  }
  const Matrix rows = eigenrows(*x, *root, budget);
  if (rows.size() != x->block.size()) return std::nullopt;
  replace_equations(result.manifold, report.normal, x->block, rows);
  return result;
}

System with_eigenvalues(System s, const CheckOptions& options) {
  constexpr std::size_t most = 2;
  if (s.field.dimension() < least_dimension) return s;
  std::optional<std::vector<ClaimReport>> claims; // they may reduce what is large without them
  for (std::size_t k = 0; k < s.manifolds.size(); ++k) {
    if (!over_an_eigenvalue(s, s.manifolds[k], {}, options)) continue;
    if (!claims) claims = decide_claims(s, options);
    auto x = over_an_eigenvalue(s, s.manifolds[k], claims_of(s, *claims), options);
    if (!x || (!x->constant.empty() && s.adjoined.size() == most)) continue;
    s = std::move(x->system);
    s.manifolds[k] = std::move(x->manifold);
    if (!x->constant.empty()) s.adjoined.push_back(x->constant);
  }
  return s;
}

std::vector<ClaimReport> claims_of(const System& s, std::vector<ClaimReport> claims) {
  KOV_ENSURE(claims.size() == s.claims.size());
  for (std::size_t k = 0; k < claims.size(); ++k) {
    claims[k].claim = s.claims[k];
    for (MPoly& g : claims[k].result.generic)
      g = transfer(MFraction(g), s.ring()).num();
  }
  return claims;
}

} // namespace kov
