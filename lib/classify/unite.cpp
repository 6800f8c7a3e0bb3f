#include "classify/unite.hpp"

#include "integrals/known.hpp"
#include "study/parameter_split.hpp"

#include <algorithm>

namespace kov {
namespace {

constexpr std::size_t most_united = 40; // each is compared with each other

bool is_plain(const ClassifiedStratum& x) {
  return x.status == StratumStatus::integrable && x.special.empty() && x.constants.empty();
}

// All equations of the other hold on the set, and one of its inequations fails.
bool adjoins(const ParameterSet& set, const ParameterSet& other) {
  const auto vanishes = [&](const MPoly& p) { return set.vanishes(p); };
  return std::ranges::all_of(other.equations(), vanishes) &&
         std::ranges::any_of(other.inequations(), vanishes);
}

bool serve_on(const System& s, const ClassifiedStratum& x, const ParameterSet& where,
              const Budget& budget) {
  return are_enough(s, where, x.integrals, x.field_components, budget);
}

// Without the inequations that its integrals do not need.
void look_around(const System& s, ClassifiedStratum& x, const Budget& budget) {
  for (const MPoly& p : x.where.proper_inequations()) {
    ParameterSet larger = without_inequation(x.around ? *x.around : x.where, p);
    if (serve_on(s, x, larger, budget)) x.around = std::move(larger);
  }
}

} // namespace

void unite_integrable(const System& s, SystemClassification& c, const Budget& budget) {
  if (std::ranges::count_if(c.strata, is_plain) > static_cast<long>(most_united)) return;
  std::vector<ClassifiedStratum> done, left;
  for (const ClassifiedStratum& x : c.strata)
    (is_plain(x) ? left : done).push_back(x);
  std::ranges::stable_sort(left, {},
                           [](const ClassifiedStratum& x) { return x.where.equations().size(); });
  while (!left.empty()) {
    ClassifiedStratum first = std::move(left.front());
    left.erase(left.begin());
    std::vector<ParameterSet> sets{first.where};
    for (std::size_t i = 0; i < left.size();) {
      const bool near = std::ranges::any_of(
          sets, [&](const ParameterSet& set) { return adjoins(left[i].where, set); });
      if (near && serve_on(s, first, left[i].where, budget)) {
        sets.push_back(left[i].where);
        left.erase(left.begin() + static_cast<long>(i));
      } else {
        ++i;
      }
    }
    auto whole = united(sets);
    if (whole.size() < sets.size() && !std::ranges::all_of(whole, [&](const ParameterSet& set) {
          return serve_on(s, first, set, budget);
        }))
      whole = std::move(sets);
    for (ParameterSet& set : whole) {
      done.push_back(first);
      done.back().where = std::move(set);
    }
  }
  c.strata = std::move(done);
  const auto is_open = [](const ClassifiedStratum& x) { return x.status == StratumStatus::open; };
  if (std::ranges::any_of(c.strata, is_open)) return; // it may lie around
  for (ClassifiedStratum& x : c.strata)
    if (is_plain(x)) look_around(s, x, budget);
}

} // namespace kov
