#include "manifold/existence.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "exact/variables.hpp"
#include "system/formula.hpp"
#include "system/parameter_scope.hpp"

#include <algorithm>
#include <map>
#include <optional>

namespace kov {
namespace {

using Indices = std::vector<std::size_t>;

bool among(const Indices& all, std::size_t i) { return is_among(i, all); }

// The one coordinate that a function depends on.
std::optional<std::size_t> only_coordinate(const FunctionSymbol& f) {
  std::optional<std::size_t> found;
  for (std::size_t j = 0; j < f.gradient.size(); ++j) {
    if (is_zero(f.gradient[j])) continue;
    if (found) return std::nullopt;
    found = j;
  }
  return found;
}

/// The functions of one coordinate, which satisfy u' = g(u).
struct Group {
  std::vector<const FunctionSymbol*> functions;
  Indices variables;
};

std::map<std::size_t, Group> groups_of(const VectorField& v) {
  std::map<std::size_t, Group> groups;
  for (const FunctionSymbol& f : v.functions)
    if (const auto j = only_coordinate(f)) {
      groups[*j].functions.push_back(&f);
      groups[*j].variables.push_back(f.variable);
    }
  return groups;
}

std::vector<MPoly> relations_in(const VectorField& v, const Indices& variables) {
  std::vector<MPoly> all;
  for (const MPoly& f : v.relations) {
    if (uses_only(f, variables)) all.push_back(f);
  }
  return all;
}

// f(u) at u = 0 where u = 0 on the curve; unset: it is not, or f is not known.
std::optional<Rational> value_at_zero(const VectorField& v, const InvariantManifold& m,
                                      const FunctionSymbol& f) {
  static const std::map<std::string, int> at_zero{{"sin", 0},  {"cos", 1},  {"tan", 0}, {"exp", 1},
                                                  {"sinh", 0}, {"cosh", 1}, {"tanh", 0}};
  try {
    const Expression e = parse_expression(f.meaning, "means");
    if (e.kind() != Expression::Kind::call || e.operands().size() != 1) return std::nullopt;
    const auto known = at_zero.find(e.name());
    if (known == at_zero.end()) return std::nullopt;
    const MFraction argument = evaluate(e.operand(0), ParameterScope(v.ring, {}));
    if (!m.vanishes_on_curve(argument)) return std::nullopt;
    return Rational(known->second);
  } catch (const Error&) { // no meaning, or one with other names
    return std::nullopt;
  }
}

bool has_value(const VectorField& v, const InvariantManifold& m, const FunctionSymbol& f,
               const Rational& value) {
  return m.vanishes_on_curve(MFraction::variable(v.ring, f.variable) - MFraction(v.ring, value));
}

// Each function of the group has the value that its meaning has on the curve, at 0.
bool has_values_at_zero(const VectorField& v, const InvariantManifold& m, const Group& g) {
  return std::ranges::all_of(g.functions, [&](const FunctionSymbol* f) {
    const auto value = value_at_zero(v, m, *f);
    return value && has_value(v, m, *f, *value);
  });
}

// The values of the functions run through an irreducible curve, all of it but the zeros of g, and
// nothing else says where the coordinate is.
bool takes_every_value(const VectorField& v, const InvariantManifold& m, std::size_t j,
                       const Group& g) {
  if (among(m.curve->main(), v.coordinates[j])) return false;
  const auto relations = relations_in(v, g.variables);
  if (relations.size() + 1 != g.variables.size() || relations.size() > 1) return false;
  if (!relations.empty()) {
    const auto factors = factor(relations.front()).second;
    if (factors.size() != 1 || factors.front().exponent != 1) return false;
  }
  bool moves = false;
  for (const FunctionSymbol* f : g.functions) {
    const MFraction& d = f->gradient[j];
    for (const std::size_t i : used_variables(d))
      if (!among(g.variables, i)) return false; // not autonomous
    if (!m.curve->vanishes(d.num())) moves = true;
  }
  return moves;
}

// Over the coordinates and the other functions: every point is one of a branch.
bool are_algebraic(const VectorField& v, const Indices& functions, const Budget& budget) {
  Indices all = functions; // with the constants, which are algebraic over the parameters
  all.insert(all.end(), v.constants.begin(), v.constants.end());
  std::vector<MPoly> relations;
  for (const MPoly& p : v.relations)
    if (uses_any(p, all)) relations.push_back(p);
  return Ideal(v.ring, all, relations, {}, budget).dimension() == 0;
}

} // namespace

std::string contradicted_function(const VectorField& v, const InvariantManifold& m) {
  std::vector<MPoly> curve;
  for (const KPoly& g : m.curve->basis())
    curve.push_back(m.curve->from_kpoly(g).num());
  for (const FunctionSymbol& f : v.functions) {
    const auto value = value_at_zero(v, m, f);
    if (!value || !among(m.curve->main(), f.variable)) continue;
    auto there = curve;
    there.push_back((MFraction::variable(v.ring, f.variable) - MFraction(v.ring, *value)).num());
    if (Ideal(v.ring, m.curve->main(), there, {}, m.curve->budget()).is_unit())
      return f.meaning + " is " + to_string(*value) + " there, and " + v.ring->name(f.variable) +
             " is not";
  }
  return {};
}

std::string unchecked_functions(const VectorField& v, const InvariantManifold& m) {
  Indices free;
  for (const auto& [j, group] : groups_of(v))
    if (takes_every_value(v, m, j, group) || has_values_at_zero(v, m, group))
      free.insert(free.end(), group.variables.begin(), group.variables.end());
  Indices others;
  for (const FunctionSymbol& f : v.functions)
    if (!among(free, f.variable)) others.push_back(f.variable);
  if (others.empty() || are_algebraic(v, others, m.curve->budget())) return {};
  std::string names;
  for (const std::size_t i : others)
    if (among(m.curve->main(), i)) names += (names.empty() ? "" : ", ") + v.ring->name(i);
  return names;
}

std::string existence_not_checked(const VectorField& v, const InvariantManifold& m) {
  return existence_not_checked(unchecked_functions(v, m));
}

std::string existence_not_checked(const std::string& functions) {
  if (functions.empty()) return "";
  return "that the phase curve has points for the functions meant by " + functions +
         ": only their derivatives and relations are known";
}

} // namespace kov
