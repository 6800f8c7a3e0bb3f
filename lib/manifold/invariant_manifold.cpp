#include "manifold/invariant_manifold.hpp"

#include "exact/error.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "exact/variables.hpp"

#include <algorithm>

namespace kov {
namespace {

// The value of f on the manifold, for a message: numerator reduced, denominator kept.
MFraction value_on(const MFraction& f, const Ideal& ideal) {
  const MFraction d = ideal.normal_form(MFraction(f.den()));
  const MFraction n = ideal.normal_form(MFraction(f.num()));
  return is_zero(d) ? f : n / d;
}

// Equations a x_i + rest = 0 with a free of main variables, solved one after the other.
void solve_linear_equations(const VectorField& v, InvariantManifold& m) {
  const auto main = v.main_variables();
  m.linear = true;
  for (const auto& e : m.equations) {
    const MFraction f = substitute(e.difference, m.solved);
    if (is_zero(f)) continue;
    bool done = false;
    for (const std::size_t i : main) {
      const auto c = coefficients(f.num(), i);
      if (c.size() != 2 || uses_any(c[1], main)) continue;
      const MFraction value = -MFraction(c[0], c[1]);
      for (auto& [k, old] : m.solved)
        old = substitute(old, {{i, value}});
      m.solved[i] = value;
      done = true;
      break;
    }
    if (!done) m.linear = false;
  }
}

// The same set, and one line for each equation that is written in another way.
std::vector<Equation> without_multiplicities(std::vector<Equation> equations,
                                             std::vector<std::string>& rewritten) {
  for (Equation& e : equations) {
    if (is_zero(e.difference)) continue;
    const auto factors = factor(e.difference.num()).second;
    if (std::ranges::all_of(factors, [](const MFactor& f) { return f.exponent == 1; })) continue;
    const MFraction reduced(squarefree_part(e.difference.num()));
    rewritten.push_back("'" + e.text + "' is read as " + to_string(reduced) + " = 0, the same set");
    e.difference = reduced;
  }
  return equations;
}

std::vector<MPoly> numerators(const std::vector<Equation>& equations) {
  return mapped<MPoly>(equations, [&](const auto& e) { return e.difference.num(); });
}

} // namespace

MFraction InvariantManifold::restrict(const MFraction& f) const {
  MFraction g = solved.empty() ? f : substitute(f, solved);
  if (linear || is_zero(g)) return g;
  const MFraction den = ideal->normal_form(MFraction(g.den()));
  if (is_zero(den)) return g;
  return ideal->normal_form(MFraction(g.num())) / den;
}

bool InvariantManifold::vanishes_on_curve(const MFraction& f) const {
  return is_zero_modulo(f, *curve);
}

std::vector<MPoly> factors_on_components(const InvariantManifold& m) {
  for (const KPoly& g : m.curve->basis()) {
    std::vector<MPoly> bases;
    for (MFactor& f : factor(m.curve->from_kpoly(g).num()).second)
      bases.push_back(std::move(f.base));
    if (bases.size() > 1 &&
        std::ranges::none_of(bases, [&](const MPoly& f) { return m.curve->vanishes(f); }))
      return bases;
  }
  return {};
}

std::optional<ManifoldFailure> invariance_failure(const VectorField& v,
                                                  const std::vector<Equation>& equations,
                                                  const Ideal& ideal) {
  for (const auto& e : equations) {
    const MFraction d = lie_derivative(v, e.difference);
    if (is_in(d, ideal)) continue;
    const MFraction value = value_on(d, ideal);
    if (vanishes_on(d, ideal))
      return ManifoldFailure{
          "the derivative " + brief(value) + " of '" + e.text + "' vanishes on " +
              "the set but is not in the ideal of its equations, so that the set " +
              "is not proved invariant: write equations without multiplicities",
          e.text, value};
    const auto& p = v.parameters; // at special values, an assumed one too, it may be invariant
    const bool in_general = uses_any(value, p);
    return ManifoldFailure{"the set is not invariant" +
                               std::string(in_general ? " for all parameters" : "") +
                               ": on it the derivative of the left side minus the right side of '" +
                               e.text + "' is " + brief(value) + ", not 0",
                           e.text, value};
  }
  return std::nullopt;
}

namespace {

std::optional<ManifoldFailure> level_failure(const VectorField& v, const InvariantManifold& m) {
  for (const auto& e : m.levels) {
    const MFraction d = lie_derivative(v, e.difference);
    if (vanishes_on(d, *m.ideal)) continue;
    const MFraction value = value_on(d, *m.ideal);
    return ManifoldFailure{"the level '" + e.text + "' is not one of a first integral: on the " +
                               "manifold its derivative is " + brief(value) + ", not 0",
                           e.text, value};
  }
  return std::nullopt;
}

std::optional<ManifoldFailure> curve_failure(const VectorField& v, const InvariantManifold& m) {
  const int d = m.curve->dimension();
  const auto failure = [&](const std::string& why) {
    return ManifoldFailure{why, m.name, MFraction(v.ring)};
  };
  if (d < 0) return failure("the manifold with its levels is empty");
  if (d == 0) return failure("the manifold with its levels consists of points, not of curves");
  std::vector<std::string> free; // functions that are not algebraic
  for (const FunctionSymbol& f : v.functions)
    if (!any_uses(v.relations, f.variable)) free.push_back(v.ring->name(f.variable));
  if (d > 1 && static_cast<std::size_t>(d) <= 1 + free.size())
    return failure("the phase curves on the manifold are not algebraic in the coordinates and " +
                   joined(free) + ": no level changes that, and they are not studied");
  if (d > 1)
    return failure("the levels of the first integrals do not cut out a curve on the manifold, but "
                   "a set of dimension " +
                   std::to_string(d) + ": add " +
                   (d == 2 ? "one more level" : std::to_string(d - 1) + " more levels") +
                   " (level = [\"H = h\", ...])");
  for (const auto& x : v.components)
    if (!m.vanishes_on_curve(x)) return std::nullopt;
  return failure("all points of the manifold with its levels are equilibria");
}

// The relations, the manifold and the levels.  Where they leave points, a coordinate on which
// nothing depends may still move, like the time of a linear system with constant coefficients: it
// runs through a line over each point, at constant speed.
Ideal phase_curve(const VectorField& v, std::vector<MPoly> generators,
                  const std::vector<MPoly>& nonzero, const Budget& budget) {
  Ideal points = relation_ideal(v, generators, nonzero, budget);
  if (points.dimension() != 0) return points;
  std::vector<std::size_t> main = points.main();
  for (std::size_t j = 0; j < v.dimension(); ++j) {
    const std::size_t x = v.coordinates[j];
    if (is_among(x, main) || is_zero_modulo(v.components[j], points)) continue;
    main.insert(std::ranges::upper_bound(main, x), x);
    generators.insert(generators.begin(), v.relations.begin(), v.relations.end());
    return {v.ring, main, generators, nonzero, budget};
  }
  return points;
}

} // namespace

std::variant<InvariantManifold, ManifoldFailure>
prove_invariant(const VectorField& v, const ManifoldSpec& spec, const Budget& budget) {
  InvariantManifold m;
  m.name = spec.name;
  m.equations = without_multiplicities(spec.equations, m.rewritten);
  m.levels = without_multiplicities(spec.levels, m.rewritten);
  m.nonzero = spec.nonzero;
  auto generators = numerators(m.equations);
  m.ideal = std::make_shared<const Ideal>(relation_ideal(v, generators, m.nonzero, budget));
  if (m.ideal->is_unit())
    return ManifoldFailure{"the manifold is empty: its equations contradict each other", m.name,
                           MFraction(v.ring)};
  if (const auto den = pole_along(v, *m.ideal))
    return ManifoldFailure{"the vector field is not defined on the manifold: the denominator " +
                               to_string(*den) + " vanishes there",
                           m.name, MFraction(*den)};
  if (auto failure = invariance_failure(v, m.equations, *m.ideal)) return *std::move(failure);
  for (const auto& e : m.equations)
    m.proof.push_back("d/dt of '" + e.text + "' is in the ideal of the manifold");
  if (auto failure = level_failure(v, m)) return *std::move(failure);
  for (const auto& e : m.levels)
    m.proof.push_back("'" + e.text + "': its derivative is in the ideal of the manifold");
  const auto levels = numerators(m.levels);
  generators.insert(generators.end(), levels.begin(), levels.end());
  m.curve = std::make_shared<const Ideal>(phase_curve(v, generators, m.nonzero, budget));
  solve_linear_equations(v, m);
  if (auto failure = curve_failure(v, m)) return *std::move(failure);
  m.proof.push_back("the manifold with its levels is a curve, and the field is not zero on it");
  return m;
}

} // namespace kov
