#include "variation/whole.hpp"

#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "variation/leaf.hpp"

#include <algorithm>

namespace kov {
namespace {

using Indices = std::vector<std::size_t>;

std::size_t rank(const InvariantManifold& m, const Matrix& all, std::vector<MPoly>& divisors) {
  Matrix rows;
  for (const auto& row : all)
    if (!combination(m, rows, row, divisors)) rows.push_back(row);
  return rows.size();
}

Matrix conormals(const VectorField& v, const InvariantManifold& m, const NormalSystem& n) {
  Matrix rows;
  for (const std::size_t i : n.equations)
    rows.push_back(restricted_gradient(v, m, m.equations[i].difference));
  return rows;
}

// The unknowns of the normal part that are left on a symplectic leaf.
Indices on_the_leaf(const NormalSystem& n, const ReducedSystem& r) {
  Indices kept;
  for (std::size_t i = 0; i < n.system.names.size(); ++i)
    if (std::ranges::none_of(r.eliminations, [&](const Elimination& e) {
          return e.casimir && e.unknown == n.system.names[i];
        }))
      kept.push_back(i);
  return kept;
}

Matrix restricted(const InvariantManifold& m, Matrix a) {
  for (auto& row : a)
    for (auto& entry : row)
      entry = m.restrict(entry);
  return a;
}

Matrix brackets(const InvariantManifold& m, const Matrix& poisson, const Matrix& rows) {
  Matrix result(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < rows.size(); ++j) {
      MFraction sum(rows[i].front().ring());
      for (std::size_t a = 0; a < poisson.size(); ++a)
        for (std::size_t b = 0; b < poisson.size(); ++b)
          if (!is_zero(rows[i][a]) && !is_zero(poisson[a][b]) && !is_zero(rows[j][b]))
            sum += rows[i][a] * poisson[a][b] * rows[j][b];
      result[i].push_back(m.restrict(sum));
    }
  return result;
}

// Expansion by the first row; its square is the determinant.
MFraction pfaffian(const InvariantManifold& m, const Matrix& a, const Indices& of) {
  const Ring& ring = m.curve->ring();
  if (of.empty()) return {ring, Rational(1)};
  MFraction sum(ring);
  if (of.size() % 2 != 0) return sum;
  for (std::size_t j = 1; j < of.size(); ++j) {
    const MFraction& entry = a[of[0]][of[j]];
    if (m.vanishes_on_curve(entry)) continue;
    Indices rest(of.begin() + 1, of.end());
    rest.erase(rest.begin() + static_cast<long>(j) - 1);
    sum += Rational(j % 2 == 1 ? 1 : -1) * (entry * pfaffian(m, a, rest));
  }
  return m.restrict(sum);
}

// All Pfaffians of this size vanish; on every component of the curve and for all parameters.
bool has_rank_below(const InvariantManifold& m, const Matrix& a, std::size_t size) {
  if (size > a.size()) return true;
  std::vector<bool> chosen(a.size());
  std::fill_n(chosen.begin(), size, true);
  do {
    Indices of;
    for (std::size_t i = 0; i < a.size(); ++i)
      if (chosen[i]) of.push_back(i);
    if (!m.vanishes_on_curve(pfaffian(m, a, of))) return false;
  } while (std::prev_permutation(chosen.begin(), chosen.end()));
  return true;
}

// d(X(F)) = (dF)' + dF J is a combination of the rows: dF is an integral where these vanish.
bool is_integral_along(const VectorField& v, const InvariantManifold& m, const Matrix& rows,
                       const Matrix& jacobian, const std::vector<MFraction>& df,
                       std::vector<MPoly>& divisors) {
  std::vector<MFraction> change;
  for (std::size_t k = 0; k < df.size(); ++k) {
    MFraction sum = lie_derivative(v, df[k]);
    for (std::size_t l = 0; l < df.size(); ++l)
      if (!is_zero(df[l])) sum += df[l] * jacobian[l][k];
    change.push_back(m.restrict(sum));
  }
  return combination(m, rows, change, divisors).has_value();
}

// Solutions of VE that are known: the tangent X, and a coordinate that nothing depends on.
std::size_t known_solutions(const VectorField& v, const InvariantManifold& m) {
  const auto& main = m.curve->main();
  std::size_t count = 0;
  bool moves = false;
  for (std::size_t j = 0; j < v.dimension(); ++j) {
    const bool cyclic = !is_among(v.coordinates[j], main);
    if (cyclic) ++count;
    if (!cyclic && !m.vanishes_on_curve(m.restrict(v.components[j]))) moves = true;
  }
  return count + (moves ? 1 : 0);
}

// The levels leave nothing of the tangent space of the manifold but known solutions.
bool solved_by_levels(const VectorField& v, const InvariantManifold& m, const Matrix& rows,
                      const Matrix& jacobian, std::vector<MPoly>& divisors) {
  Matrix all = rows;
  for (const auto& e : m.levels) {
    const auto df = restricted_gradient(v, m, e.difference);
    if (is_integral_along(v, m, rows, jacobian, df, divisors)) all.push_back(df);
  }
  return v.dimension() - rank(m, all, divisors) == known_solutions(v, m);
}

// The manifold meets the leaf in a symplectic surface, or in a symplectic manifold that its levels
// solve.
bool is_symplectic(const VectorField& v, const InvariantManifold& m, const Matrix& rows,
                   const Matrix& jacobian, const Indices& leaf, std::vector<MPoly>& divisors) {
  if (!v.poisson) return false;
  const Matrix poisson = restricted(m, *v.poisson);
  const MFraction pf = pfaffian(m, brackets(m, poisson, rows), leaf);
  if (m.vanishes_on_curve(pf)) return false;
  add_divisors(divisors, pf);
  return has_rank_below(m, poisson, leaf.size() + 4) ||
         solved_by_levels(v, m, rows, jacobian, divisors);
}

// The coordinate vectors of the unknowns that the equations determine are mapped to their span.
bool has_coordinate_complement(const VectorField& v, const InvariantManifold& m, const Matrix& rows,
                               const Matrix& jacobian, std::vector<MPoly>& divisors) {
  if (!m.linear || m.solved.size() != rows.size()) return false;
  const auto solved = [&](std::size_t j) { return m.solved.contains(v.coordinates[j]); };
  std::size_t found = 0;
  for (std::size_t j = 0; j < v.dimension(); ++j) {
    if (!solved(j)) continue;
    ++found;
    for (std::size_t l = 0; l < v.dimension(); ++l)
      if (!solved(l) && !m.vanishes_on_curve(jacobian[l][j])) return false;
  }
  return found == rows.size() && solved_by_levels(v, m, rows, jacobian, divisors);
}

std::string list(const std::vector<std::string>& names, const Indices& members) {
  std::string text = joined(members, [&](const std::size_t i) { return names[i]; });
  return "(" + text + ")";
}

std::string coupled_blocks(const InvariantManifold& m, const LinearSystem& s,
                           const std::vector<Indices>& studied) {
  for (const Indices& a : studied)
    for (const Indices& b : studied)
      if (&a != &b)
        for (const std::size_t i : a)
          for (const std::size_t j : b)
            if (!m.vanishes_on_curve(s.a[i][j]))
              return "not studied: the coupling of the block " + list(s.names, a) +
                     " with the block " + list(s.names, b);
  return {};
}

} // namespace

WholeVariation whole_variation(const VectorField& v, const InvariantManifold& m,
                               const NormalSystem& n, const ReducedSystem& r,
                               const std::vector<std::vector<std::size_t>>& studied) {
  WholeVariation w;
  const Matrix rows = conormals(v, m, n);
  const Matrix jacobian = variational_equations(v, m).a;
  const Indices leaf = on_the_leaf(n, r);
  const bool symplectic = is_symplectic(v, m, rows, jacobian, leaf, w.divisors);
  const auto integral =
      std::ranges::find_if(r.eliminations, [](const Elimination& e) { return !e.casimir; });
  // an invariant covector in a symplectic plane: the group is additive or trivial
  if (symplectic && integral != r.eliminations.end() && leaf.size() == 2) return w;
  if (integral != r.eliminations.end())
    w.missing = "not studied: the coupling of the subspace d" + integral->integral +
                " = 0 of the variational equation with the rest";
  else if (!symplectic) {
    w.divisors.clear();
    if (!has_coordinate_complement(v, m, rows, jacobian, w.divisors))
      w.missing =
          std::string("not studied: the coupling of the normal part with the variations along the "
                      "manifold") +
          (v.poisson ? " (the manifold is not symplectic)" : "");
  }
  if (w.missing.empty()) w.missing = coupled_blocks(m, r.system, studied);
  if (!w.missing.empty()) w.divisors.clear();
  return w;
}

} // namespace kov
