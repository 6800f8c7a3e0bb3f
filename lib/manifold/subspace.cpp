#include "manifold/subspace.hpp"

#include "exact/error.hpp"

#include <algorithm>

namespace kov {
namespace {

constexpr std::size_t most_choices = 4;

// The positions of q_i, q_j, p_i, p_j among the coordinates; empty: it is something else that is left.
std::vector<std::size_t> two_degrees_of_freedom(const VectorField& v, const Substitution& solved) {
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < v.dimension(); ++i)
    if (!solved.contains(v.coordinates[i])) left.push_back(i);
  const std::size_t n = v.dimension() / 2;
  const bool canonical = v.dimension() == 2 * n && left.size() == 4 && left[0] + n == left[2] &&
                         left[1] + n == left[3];
  return canonical ? left : std::vector<std::size_t>{};
}

// The values of a symbol, by the factors of its relations that are linear in it.
std::vector<MFraction> values_of(const VectorField& v, std::size_t symbol,
                                 const Substitution& known) {
  std::vector<MFraction> all;
  for (const MPoly& relation : v.relations) {
    if (!uses(relation, symbol)) continue;
    const MPoly here = substitute(relation, known).num();
    if (is_zero(here)) continue;
    for (const MFactor& f : factor(here).second) {
      const auto c = coefficients(f.base, symbol);
      if (c.size() == 2 && is_constant(c[1])) all.push_back(-MFraction(c[0], c[1]));
    }
  }
  std::stable_partition(all.begin(), all.end(), [](const MFraction& f) { // r = x before r = -x
    return !is_zero(f) && sign(f.num().coefficient(0)) > 0;
  });
  return all;
}

// One of these for each choice of values of the symbols that are not known.
std::vector<Substitution> with_symbols(const VectorField& v, const Substitution& solved) {
  std::vector<Substitution> all{solved};
  for (const FunctionSymbol& f : v.functions) {
    if (solved.contains(f.variable)) continue;
    std::vector<Substitution> finer;
    for (const Substitution& known : all)
      for (MFraction& value : values_of(v, f.variable, known)) {
        finer.push_back(known);
        finer.back()[f.variable] = std::move(value);
      }
    all = std::move(finer);
    all.resize(std::min(all.size(), most_choices));
  }
  return all;
}

} // namespace

std::vector<FieldOnSubspace> fields_on_subspace(const VectorField& v, const Substitution& solved) {
  std::vector<FieldOnSubspace> all;
  const auto left = two_degrees_of_freedom(v, solved);
  if (left.empty()) return all;
  for (const Substitution& known : with_symbols(v, solved))
    try {
      FieldOnSubspace there;
      there.field.ring = v.ring;
      there.field.parameters = v.parameters;
      there.field.constants = v.constants;
      for (const MPoly& relation : v.relations)
        if (std::ranges::none_of(
                v.functions, [&](const FunctionSymbol& f) { return uses(relation, f.variable); }))
          there.field.relations.push_back(relation);
      for (const std::size_t i : left) {
        there.field.coordinates.push_back(v.coordinates[i]);
        there.field.components.push_back(substitute(v.components[i], known));
      }
      for (const FunctionSymbol& f : v.functions)
        if (!solved.contains(f.variable)) {
          const MFraction& value = known.at(f.variable);
          there.roots.push_back({MFraction::variable(v.ring, f.variable) - value,
                                 v.ring->name(f.variable) + " = " + to_string(value)});
        }
      all.push_back(std::move(there));
    } catch (const DomainError&) {
      continue; // a pole on the whole subspace
    }
  return all;
}

} // namespace kov
