#include "flow/scene/effects_needed.hpp"
#include "exact/lists.hpp"

#include <algorithm>
#include <set>

namespace kov::flow {
namespace {

// The variables that a set of formulas needs, with those that these need in their motion.
class Needed {
public:
  explicit Needed(const SystemScene& s) : v_(s.system.field), meanings_(s.meanings) {
    add(s.section.value);
    for (const SceneFormula& f : s.plot)
      add(f.value);
    if (s.where) add(s.where->value);
  }
  void add(const MFraction& f) {
    for (const std::size_t variable : used_variables(f))
      add(variable);
  }
  [[nodiscard]] bool has(std::size_t variable) const { return all_.contains(variable); }
  /// All of it, but for parameters and constants.
  [[nodiscard]] bool has_all_of(const MFraction& f) const {
    const auto used = used_variables(f);
    return std::ranges::all_of(used, [&](std::size_t i) { return has(i) || is_fixed(i); });
  }

private:
  [[nodiscard]] bool is_fixed(std::size_t i) const {
    const auto among = [i](const std::vector<std::size_t>& list) { return is_among(i, list); };
    return among(v_.parameters) || among(v_.constants);
  }

  void add(std::size_t variable) {
    if (!all_.insert(variable).second) return;
    for (std::size_t j = 0; j < v_.dimension(); ++j)
      if (v_.coordinates[j] == variable) add(v_.components[j]);
    for (const FunctionMeaning& m : meanings_)
      if (m.variable == variable) add(m.argument);
    for (const FunctionSymbol& f : v_.functions) {
      if (f.variable != variable) continue;
      for (std::size_t j = 0; j < v_.dimension(); ++j)
        if (!is_zero(f.gradient[j])) {
          add(f.gradient[j]);
          add(v_.coordinates[j]);
        }
    }
  }

  const VectorField& v_;
  const std::vector<FunctionMeaning>& meanings_;
  std::set<std::size_t> all_;
};

// Keeps the members whose place is true.
template <class T> void keep(std::vector<T>& all, const std::vector<bool>& which) {
  std::vector<T> kept;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (which[i]) kept.push_back(all[i]);
  all = std::move(kept);
}

void keep_coordinates(VectorField& v, const Needed& needed, const std::vector<bool>& which) {
  std::erase_if(v.functions, [&](const FunctionSymbol& f) { return !needed.has(f.variable); });
  for (FunctionSymbol& f : v.functions)
    keep(f.gradient, which);
  std::erase_if(v.relations, [&](const MPoly& r) { return !needed.has_all_of(MFraction(r)); });
  keep(v.components, which);
  if (v.poisson) {
    keep(*v.poisson, which);
    for (auto& row : *v.poisson)
      keep(row, which);
  }
  keep(v.coordinates, which);
}

} // namespace

std::vector<SceneFormula> watched(const SystemScene& s) {
  std::vector<SceneFormula> all = s.integrals();
  if (s.system.field.functions.empty()) return all;
  Needed needed(s); // every coordinate moves, whatever is drawn
  for (const MFraction& f : s.system.field.components)
    needed.add(f);
  for (const std::size_t i : s.system.field.coordinates)
    needed.add(MFraction::variable(s.system.ring(), i));
  for (const auto& level : s.levels)
    needed.add(level.function.value);
  for (const SceneFormula& f : s.start)
    needed.add(f.value);
  std::erase_if(all, [&](const SceneFormula& f) { return !needed.has_all_of(f.value); });
  return all;
}

SystemScene without_idle_coordinates(const SystemScene& s) {
  const bool whole_states = !s.states.empty() && s.seeds.empty() && s.columns == 0 &&
                            s.random == 0 && !s.scan && s.start.empty();
  if (!whole_states || s.indicator != Indicator::none || s.exponents > 0) return s;
  Needed needed(s);
  for (const SceneFormula& f : watched(s))
    needed.add(f.value);
  for (const auto& level : s.levels)
    needed.add(level.function.value);
  std::vector<bool> which;
  for (const std::size_t i : s.system.field.coordinates)
    which.push_back(needed.has(i));
  if (std::ranges::all_of(which, [](bool b) { return b; })) return s;
  SystemScene less = s;
  keep_coordinates(less.system.field, needed, which);
  std::erase_if(less.system.claims,
                [&](const SystemClaim& c) { return !needed.has_all_of(c.value); });
  std::erase_if(less.meanings, [&](const FunctionMeaning& m) { return !needed.has(m.variable); });
  for (auto& state : less.states)
    keep(state, which);
  return less;
}

} // namespace kov::flow
