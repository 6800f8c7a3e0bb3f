#include "variation/normal.hpp"

#include "exact/error.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "exact/variables.hpp"

#include <algorithm>

namespace kov {
namespace {

Matrix jacobian(const VectorField& v, const InvariantManifold& m) {
  Matrix j(v.dimension());
  for (std::size_t i = 0; i < v.dimension(); ++i)
    for (std::size_t k = 0; k < v.dimension(); ++k)
      j[i].push_back(m.restrict(partial(v, v.components[i], k)));
  return j;
}

void note(std::vector<MPoly>& divisors, const MFraction& pivot) {
  for (const MPoly& f : {pivot.num(), pivot.den()})
    if (!is_constant(f) && !is_among(f, divisors)) divisors.push_back(f);
}

// An equation does not exist where one of its coefficients has a pole.
void note_poles(std::vector<MPoly>& divisors, const VectorField& v, const MFraction& f) {
  const auto main = v.main_variables();
  for (const MFactor& d : factor(f.den()).second)
    if (!uses_any(d.base, main)) note(divisors, MFraction(d.base));
}

} // namespace

std::optional<std::vector<MFraction>> combination(const InvariantManifold& m, const Matrix& rows,
                                                  const std::vector<MFraction>& target,
                                                  std::vector<MPoly>& divisors) {
  // columns: the unknowns c_i and the right side; one equation per coordinate
  Matrix system(target.size());
  for (std::size_t j = 0; j < target.size(); ++j) {
    for (const auto& row : rows)
      system[j].push_back(row[j]);
    system[j].push_back(target[j]);
  }
  const std::size_t k = rows.size();
  std::size_t top = 0;
  for (std::size_t c = 0; c < k; ++c) {
    std::size_t best = system.size();
    for (std::size_t r = top; r < system.size(); ++r) {
      if (m.vanishes_on_curve(system[r][c])) continue;
      if (best == system.size() || system[r][c].num().length() < system[best][c].num().length())
        best = r;
    }
    if (best == system.size()) return std::nullopt;
    std::swap(system[top], system[best]);
    const MFraction pivot = system[top][c];
    note(divisors, pivot);
    for (auto& entry : system[top])
      entry = m.restrict(entry / pivot);
    for (std::size_t r = 0; r < system.size(); ++r) {
      if (r == top || is_zero(system[r][c])) continue;
      const MFraction factor = system[r][c];
      for (std::size_t j = c; j <= k; ++j)
        system[r][j] = m.restrict(system[r][j] - factor * system[top][j]);
    }
    ++top;
  }
  for (std::size_t r = top; r < system.size(); ++r)
    if (!m.vanishes_on_curve(system[r][k])) return std::nullopt;
  std::vector<MFraction> c;
  for (std::size_t r = 0; r < k; ++r)
    c.push_back(system[r][k]);
  return c;
}

std::vector<MFraction> restricted_gradient(const VectorField& v, const InvariantManifold& m,
                                           const MFraction& f) {
  auto g = gradient(v, f);
  for (auto& entry : g)
    entry = m.restrict(entry);
  return g;
}

namespace {

// The Hamiltonian vector field of the covector vanishes on the curve.
bool is_casimir(const VectorField& v, const InvariantManifold& m,
                const std::vector<MFraction>& covector) {
  if (!v.poisson) return false;
  return std::ranges::all_of(*v.poisson, [&](const auto& row) {
    MFraction sum(v.ring);
    for (std::size_t j = 0; j < row.size(); ++j)
      sum += row[j] * covector[j];
    return m.vanishes_on_curve(m.restrict(sum));
  });
}

// "M1" for the equation M1 = 0, otherwise the text of the function.
std::string normal_name(const VectorField& v, const Equation& e) {
  for (std::size_t j = 0; j < v.dimension(); ++j) {
    const MFraction x = MFraction::variable(v.ring, v.coordinates[j]);
    if (is_constant(e.difference - x) || is_constant(e.difference + x)) return v.name(j);
  }
  return to_string(e.difference);
}

} // namespace

LinearSystem variational_equations(const VectorField& v, const InvariantManifold& m) {
  LinearSystem s;
  for (std::size_t j = 0; j < v.dimension(); ++j)
    s.names.push_back(v.name(j));
  s.a = jacobian(v, m);
  return s;
}

namespace {

// [i][j]: y_i is y_j or uses it, directly or through others.
std::vector<std::vector<bool>> uses(const LinearSystem& s, const InvariantManifold& m) {
  const std::size_t n = s.a.size();
  std::vector<std::vector<bool>> reach(n, std::vector<bool>(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      reach[i][j] = i == j || !m.vanishes_on_curve(s.a[i][j]);
  for (std::size_t k = 0; k < n; ++k) // Warshall
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        if (reach[i][k] && reach[k][j]) reach[i][j] = true;
  return reach;
}

} // namespace

std::vector<std::size_t> used_by(const LinearSystem& s, const InvariantManifold& m,
                                 const std::vector<std::size_t>& block) {
  const auto reach = uses(s, m);
  std::vector<std::size_t> all;
  for (std::size_t j = 0; j < s.a.size(); ++j)
    if (!is_among(j, block) &&
        std::ranges::any_of(block, [&](std::size_t i) { return reach[i][j]; }))
      all.push_back(j);
  return all;
}

std::vector<std::vector<std::size_t>> blocks(const LinearSystem& s, const InvariantManifold& m) {
  const std::size_t n = s.a.size();
  const auto reach = uses(s, m);
  std::vector<std::vector<std::size_t>> result;
  std::vector<bool> done(n);
  while (is_among(false, done))
    for (std::size_t i = 0; i < n; ++i) {
      if (done[i]) continue;
      std::vector<std::size_t> block;
      bool ready = true;
      for (std::size_t j = 0; j < n; ++j) {
        if (reach[i][j] && reach[j][i])
          block.push_back(j);
        else if (reach[i][j] && !done[j])
          ready = false;
      }
      if (!ready) continue;
      for (const std::size_t j : block)
        done[j] = true;
      result.push_back(std::move(block));
    }
  return result;
}

NormalSystem normal_system(const VectorField& v, const InvariantManifold& m,
                           const std::vector<SystemClaim>& integrals) {
  NormalSystem n;
  Matrix rows;
  std::vector<MPoly> scratch;
  for (std::size_t i = 0; i < m.equations.size(); ++i) { // a largest independent set of the df_i
    auto row = restricted_gradient(v, m, m.equations[i].difference);
    if (combination(m, rows, row, scratch)) continue;
    note_poles(n.divisors, v, m.equations[i].difference);
    rows.push_back(std::move(row));
    n.equations.push_back(i);
    n.system.names.push_back(normal_name(v, m.equations[i]));
  }
  const Matrix j = jacobian(v, m);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::vector<MFraction> target;
    for (std::size_t k = 0; k < v.dimension(); ++k) {
      MFraction entry = m.restrict(lie_derivative(v, rows[i][k]));
      for (std::size_t l = 0; l < v.dimension(); ++l)
        if (!is_zero(rows[i][l])) entry += rows[i][l] * j[l][k];
      target.push_back(m.restrict(entry));
    }
    auto c = combination(m, rows, target, n.divisors);
    if (!c)
      throw DomainError("the differentials of the equations do not span the normal directions of "
                        "the manifold; write its equations without multiplicities");
    n.system.a.push_back(*std::move(c));
  }
  for (const auto& claim : integrals) {
    const auto row = restricted_gradient(v, m, claim.value);
    auto c = combination(m, rows, row, n.divisors);
    if (!c) continue;
    if (std::ranges::all_of(*c, [&](const MFraction& f) { return m.vanishes_on_curve(f); }))
      continue;
    n.integrals.push_back({claim.name, *std::move(c), is_casimir(v, m, row)});
  }
  // the leaf first: what is left to the other integrals is counted on it
  std::stable_partition(n.integrals.begin(), n.integrals.end(),
                        [](const LinearIntegral& f) { return f.casimir; });
  return n;
}

namespace {

// (c)' + c a = 0 on the curve
bool is_linear_integral(const VectorField& v, const InvariantManifold& m, const LinearSystem& s,
                        const std::vector<MFraction>& c) {
  for (std::size_t j = 0; j < c.size(); ++j) {
    MFraction sum = m.restrict(lie_derivative(v, c[j]));
    for (std::size_t i = 0; i < c.size(); ++i)
      sum += c[i] * s.a[i][j];
    if (!m.vanishes_on_curve(sum)) return false;
  }
  return true;
}

std::optional<std::size_t> unknown_to_eliminate(const InvariantManifold& m, const LinearSystem& s,
                                                const std::vector<MFraction>& c,
                                                const std::vector<std::string>& keep) {
  std::optional<std::size_t> best;
  for (std::size_t i = c.size(); i-- > 0;) { // the last one first: the first equations lead
    if (m.vanishes_on_curve(c[i])) continue;
    if (is_among(s.names[i], keep)) continue;
    if (!best || c[i].num().length() < c[*best].num().length()) best = i;
  }
  return best;
}

} // namespace

ReducedSystem reduce_by_integrals(const VectorField& v, const InvariantManifold& m,
                                  const NormalSystem& n, const std::vector<std::string>& keep) {
  ReducedSystem r{n.system, {}, n.divisors};
  auto integrals = n.integrals;
  for (std::size_t k = 0; k < integrals.size(); ++k) {
    auto& c = integrals[k].coefficients;
    if (!is_linear_integral(v, m, r.system, c))
      throw DomainError(
          "the differential of '" + integrals[k].name +
          "' is not a first integral of the normal equations: the manifold has several "
          "components, or is not smooth; write one component");
    const auto e = unknown_to_eliminate(m, r.system, c, keep);
    if (!e) continue; // depends on the integrals already used
    r.eliminations.push_back({integrals[k].name, r.system.names[*e], integrals[k].casimir});
    note(r.divisors, c[*e]);
    std::vector<MFraction> w; // y_e = sum_j w_j y_j
    for (const auto& entry : c)
      w.push_back(m.restrict(-entry / c[*e]));
    const auto drop = [&](std::vector<MFraction>& row) {
      for (std::size_t j = 0; j < row.size(); ++j)
        if (j != *e) row[j] = m.restrict(row[j] + row[*e] * w[j]);
      row.erase(row.begin() + static_cast<long>(*e));
    };
    r.system.a.erase(r.system.a.begin() + static_cast<long>(*e));
    r.system.names.erase(r.system.names.begin() + static_cast<long>(*e));
    for (auto& row : r.system.a)
      drop(row);
    for (std::size_t l = k + 1; l < integrals.size(); ++l)
      drop(integrals[l].coefficients);
  }
  return r;
}

std::optional<NormalVariationalEquation>
scalar_equation(const VectorField& v, const InvariantManifold& m, const LinearSystem& s,
                const std::vector<std::size_t>& block, std::size_t unknown) {
  KOV_ENSURE(block.size() == 2);
  const std::size_t i = unknown;
  const std::size_t j = block[0] == unknown ? block[1] : block[0];
  const MFraction& a11 = s.a[i][i];
  const MFraction& a12 = s.a[i][j];
  if (m.vanishes_on_curve(a12)) return std::nullopt;
  const auto dot = [&](const MFraction& f) { return m.restrict(lie_derivative(v, f)); };
  NormalVariationalEquation e;
  e.unknown = s.names[i];
  e.combination = {{s.names[i], MPoly(v.ring, Integer(1))}};
  note(e.divisors, a12);
  const MFraction log12 = dot(a12) / a12;
  e.a1 = m.restrict(-(a11 + s.a[j][j] + log12));
  e.a0 = m.restrict(a11 * s.a[j][j] - a12 * s.a[j][i] - dot(a11) + a11 * log12);
  return e;
}

namespace {

std::string name_of(const std::vector<std::pair<std::string, MPoly>>& combination) {
  const auto term = [](const auto& x) {
    const auto& [name, c] = x;
    return is_one(c) ? name
                     : (c.length() > 1 ? "(" + to_string(c) + ")*" : to_string(c) + "*") + name;
  };
  return joined(combination, term, " + ");
}

} // namespace

// With y' = b (y1, y2) and y'' = d (y1, y2):  D y'' = (c1 d2 - c2 d1) y' + (d1 b2 - d2 b1) y, D = c1 b2 - c2 b1.
std::optional<NormalVariationalEquation>
scalar_equation(const VectorField& v, const InvariantManifold& m, const LinearSystem& s,
                const std::vector<std::size_t>& block, const std::array<MPoly, 2>& c) {
  KOV_ENSURE(block.size() == 2);
  const auto times_a = [&](const std::array<MFraction, 2>& row) {
    std::array<MFraction, 2> product;
    for (std::size_t k = 0; k < 2; ++k)
      product[k] = m.restrict(row[0] * s.a[block[0]][block[k]] + row[1] * s.a[block[1]][block[k]]);
    return product;
  };
  const auto det = [&](const std::array<MFraction, 2>& x, const std::array<MFraction, 2>& y) {
    return m.restrict(x[0] * y[1] - x[1] * y[0]);
  };
  const std::array<MFraction, 2> row{MFraction(c[0]), MFraction(c[1])};
  const auto b = times_a(row);
  auto d = times_a(b);
  for (std::size_t k = 0; k < 2; ++k)
    d[k] = m.restrict(d[k] + lie_derivative(v, b[k]));
  const MFraction divisor = det(row, b);
  if (m.vanishes_on_curve(divisor)) return std::nullopt;
  NormalVariationalEquation e;
  for (std::size_t k = 0; k < 2; ++k)
    e.combination.emplace_back(s.names[block[k]], c[k]);
  e.unknown = name_of(e.combination);
  note(e.divisors, divisor);
  e.a1 = m.restrict(-det(row, d) / divisor);
  e.a0 = m.restrict(-det(d, b) / divisor);
  return e;
}

} // namespace kov
