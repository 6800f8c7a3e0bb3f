#include "manifold/existence.hpp"

#include <algorithm>
#include <map>
#include <optional>

namespace kov {
namespace {

using Indices = std::vector<std::size_t>;

bool among(const Indices& all, std::size_t i) {
  return std::find(all.begin(), all.end(), i) != all.end();
}

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
    const auto used = used_variables(f);
    if (std::all_of(used.begin(), used.end(), [&](std::size_t i) { return among(variables, i); }))
      all.push_back(f);
  }
  return all;
}

// The coordinate is 0 on the curve, and each function has the value that its meaning has there.
bool has_values_at_zero(const VectorField& v, const InvariantManifold& m, std::size_t j,
                        const Group& g) {
  static const std::map<std::string, int> at_zero{{"sin", 0},  {"cos", 1},  {"tan", 0}, {"exp", 1},
                                                  {"sinh", 0}, {"cosh", 1}, {"tanh", 0}};
  const auto value = [&](std::size_t i, int at) {
    return m.vanishes_on_curve(MFraction::variable(v.ring, i) - MFraction(v.ring, Rational(at)));
  };
  return value(v.coordinates[j], 0) &&
         std::all_of(g.functions.begin(), g.functions.end(), [&](const FunctionSymbol* f) {
           return std::any_of(at_zero.begin(), at_zero.end(), [&](const auto& known) {
             return f->meaning == known.first + "(" + v.name(j) + ")" &&
                    value(f->variable, known.second);
           });
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

} // namespace

std::string unchecked_functions(const VectorField& v, const InvariantManifold& m) {
  Indices free;
  for (const auto& [j, group] : groups_of(v))
    if (takes_every_value(v, m, j, group) || has_values_at_zero(v, m, j, group))
      free.insert(free.end(), group.variables.begin(), group.variables.end());
  Indices others;
  for (const FunctionSymbol& f : v.functions)
    if (!among(free, f.variable)) others.push_back(f.variable);
  // algebraic over the coordinates and the free ones: every point is one of a branch
  if (others.empty() || Ideal(v.ring, others, v.relations, {}, m.curve->budget()).dimension() == 0)
    return {};
  std::string names;
  for (const std::size_t i : others)
    if (among(m.curve->main(), i)) names += (names.empty() ? "" : ", ") + v.ring->name(i);
  return names;
}

} // namespace kov
