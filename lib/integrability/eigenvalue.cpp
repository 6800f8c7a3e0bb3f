#include "integrability/eigenvalue.hpp"

#include "exact/error.hpp"
#include "integrability/constant_matrices.hpp"
#include "parameters/statement.hpp"
#include "system/in_ring.hpp"

#include <algorithm>

namespace kov {
namespace {

constexpr std::size_t largest_degree = 4;
constexpr std::size_t least_dimension = 4; // below it a normal part has two unknowns at most

using Polynomial = std::vector<MFraction>; // coefficients, ascending

struct Splitting {
  std::vector<std::size_t> block;
  ConstantRows rows;
  Matrix t;     // without denominators
  Polynomial p; // with the leading coefficient 1; of which a power maps t to 0
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
std::optional<Splitting> splitting(const System& s, const ManifoldReport& report,
                                   const Budget& budget) {
  std::optional<Splitting> best;
  for (const auto& block : blocks(report.normal.system, *report.manifold)) {
    if (block.size() < 3 || block.size() > largest_decoupled) continue;
    const ConstantRows rows(s, report.normal.system, *report.manifold, block);
    for (const Matrix& commuting : with_combinations(rows.commutant(budget))) {
      const Matrix t = without_denominators(commuting);
      auto factors = factors_of(minimal_polynomial(t, budget));
      if (factors.size() != 1) continue;
      Polynomial p = monic(std::move(factors.front().first));
      if (p.size() < 3 || p.size() > largest_degree + 1) continue;
      const auto size = [](const Polynomial& f) { return std::pair(f.size(), length_of(f)); };
      if (!best || size(p) < size(best->p)) best = {block, rows, t, std::move(p)};
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
  for (const auto& [c, relation] : quadratic_constants(s.field)) {
    Polynomial q;
    for (const MPoly& x : coefficients(relation, c))
      q.emplace_back(x);
    if (const auto k = square_root(discriminant(p) / discriminant(q)))
      return (*k * (two * q[2] * MFraction::variable(s.ring(), c) + q[1]) - p[1]) / two;
  }
  return std::nullopt;
}

std::string free_name(const Ring& ring, const std::string& name) {
  std::string candidate = name;
  for (int k = 1; ring->find(candidate); ++k)
    candidate = name + std::to_string(k);
  return candidate;
}

// The constant is the last variable of the ring.
MPoly relation_of(const Polynomial& p, const Ring& ring) {
  MFraction value(ring);
  for (std::size_t k = p.size(); k-- > 0;)
    value = value * MFraction::variable(ring, ring->size() - 1) + transfer(p[k], ring);
  return value.num();
}

// With the root of p as the last variable of the ring.
System with_root(const System& s, const Polynomial& p, const std::string& name,
                 const std::string& remark) {
  auto names = s.ring()->names();
  names.push_back(free_name(s.ring(), name));
  System larger = kov::in_ring(s, make_ring(names));
  larger.field.constants.push_back(names.size() - 1);
  larger.field.relations.push_back(relation_of(p, larger.ring()));
  larger.adjoined.push_back(names.back() + " is a root of " +
                            to_string(larger.field.relations.back()) + remark);
  return larger;
}

// ---- eigenrows

// v, v t, ..., v t^(d - 1) for rows v that generate all of them.
std::vector<Matrix> cyclic_rows(const Splitting& x, const Budget& budget) {
  const std::size_t d = x.p.size() - 1;
  std::vector<Matrix> all;
  Matrix chosen;
  for (const auto& unit : identity(x.rows.ring(), x.t.size())) {
    if (chosen.size() >= x.rows.size()) break;
    Matrix rows{unit};
    while (rows.size() < d)
      rows.push_back(times(rows.back(), x.t));
    Matrix with = chosen;
    with.insert(with.end(), rows.begin(), rows.end());
    if (!x.rows.independent(with, budget)) continue;
    chosen = std::move(with);
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

// Degree 2: eigenrows of both roots.  Higher degree: those of one root, completed to a basis.
Matrix eigenrows(const Splitting& x, const std::vector<Matrix>& generators, const MFraction& root) {
  const std::size_t d = x.p.size() - 1;
  Matrix rows;
  for (const Matrix& powers : generators)
    rows.push_back(eigenrow(powers, x.p, root));
  for (const Matrix& powers : generators)
    if (d == 2)
      rows.push_back(eigenrow(powers, x.p, -x.p[1] - root));
    else
      rows.insert(rows.end(), powers.begin(), powers.end() - 1);
  for (auto& row : rows)
    row = x.rows.row(row);
  return rows;
}

void move(const Ring& ring, std::vector<MFraction>& all) {
  for (MFraction& f : all)
    f = transfer(f, ring);
}

} // namespace

std::optional<WithEigenvalue> with_eigenvalue(const System& s, const ManifoldSpec& m,
                                              const ManifoldReport& report, const Budget& budget) {
  auto x = splitting(s, report, budget);
  if (!x) return std::nullopt;
  auto generators = cyclic_rows(*x, budget);
  WithEigenvalue result{s, m};
  auto root = known_root(s, x->p);
  if (!root) {
    System with_manifold = s;
    with_manifold.manifolds.push_back(m);
    result.system = with_root(with_manifold, x->p, "lambda",
                              " (an eigenvalue of the variations along " + m.name + ")");
    if (reducible_relations(result.system.field, budget)) return std::nullopt;
    result.manifold = std::move(result.system.manifolds.back());
    result.system.manifolds.pop_back();
    const Ring& ring = result.system.ring();
    move(ring, x->p);
    for (Matrix& powers : generators)
      for (auto& row : powers)
        move(ring, row);
    root = MFraction::variable(ring, ring->size() - 1);
  }
  const Matrix rows = eigenrows(*x, generators, *root);
  if (rows.size() != x->block.size()) return std::nullopt;
  replace_equations(result.manifold, report.normal, x->block, rows);
  return result;
}

System with_square_root(const System& s, const MPoly& d, const std::string& remark) {
  const Ring& ring = s.ring();
  return with_root(s, {-MFraction(d), MFraction(ring), MFraction(ring, Rational(1))}, "kappa",
                   remark);
}

System with_eigenvalues(System s, const CheckOptions& options) {
  constexpr std::size_t most = 2;
  if (s.field.dimension() < least_dimension) return s;
  std::optional<std::vector<ClaimReport>> claims; // they may reduce what is large without them
  for (std::size_t k = 0; k < s.manifolds.size(); ++k) {
    if (!over_an_eigenvalue(s, s.manifolds[k], {}, options)) continue;
    if (!claims) claims = decide_claims(s, options.decide.budget);
    auto x = over_an_eigenvalue(s, s.manifolds[k], claims_of(s, *claims), options);
    if (!x || x->system.adjoined.size() > most) continue;
    s = std::move(x->system);
    s.manifolds[k] = std::move(x->manifold);
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
