#include "study/places.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "parameters/signs.hpp"
#include "study/parameter_split.hpp"
#include "study/pieces.hpp"
#include "system/vector_field.hpp"

#include <algorithm>

namespace kov {
namespace {

constexpr std::size_t most_places = 40; // each is compared with each other

// The set without those that cover it.
std::vector<ParameterSet> without(const ParameterSet& set,
                                  const std::vector<ParameterSet>& covers) {
  std::vector<ParameterSet> left{set};
  for (const ParameterSet& cover : covers) {
    std::vector<std::vector<MPoly>> nonzero;
    for (const MPoly& p : cover.inequations())
      nonzero.push_back({p});
    std::vector<ParameterSet> next;
    for (const ParameterSet& part : left) {
      auto outside =
          split_set(part, cover.equations(), nonzero, [](const MPoly&) { return true; }).outside;
      std::move(outside.begin(), outside.end(), std::back_inserter(next));
    }
    left = std::move(next);
  }
  return left;
}

// Inequations that others imply stay: of b = 2*a, a != 0, b != 0 the last can go if a != 0 is assumed.
ParameterSet without_condition(const ParameterSet& set, const MPoly& p) {
  ParameterSet larger = set.plain();
  for (const MPoly& f : set.equations())
    larger = larger.where_zero(f);
  for (const MPoly& f : set.inequations())
    if (!(f == p)) larger = larger.where_nonzero(f);
  return larger;
}

// Its irreducible factors, up to a constant.
MPoly primitive(const MFraction& f) {
  return is_zero(f) ? MPoly(f.ring()) : squarefree_part(f.num());
}

bool same_elements(const std::vector<DifferenceCondition>& a,
                   const std::vector<DifferenceCondition>& b) {
  return a.size() == b.size() &&
         std::ranges::all_of(a, [&](const auto& c) { return is_among(c, b); });
}

// On the small one the conditions of the large one are those of the small one.
bool agree(const ParameterPlace& large, const ParameterPlace& small) {
  if (large.special.empty() && small.special.empty()) return true;
  const auto here = on_part({large.where, large.special, {}}, small.where);
  return here && same_elements(here->special, small.special);
}

class Union {
public:
  Union(std::vector<ParameterPlace> all, const std::vector<MPoly>& assumed,
        const Assumptions& known)
      : all_(std::move(all)), assumed_(assumed), known_(known) {}

  std::vector<ParameterPlace> simplified() {
    for (std::size_t i = 0; i < all_.size(); ++i)
      while (drop_an_inequation(i)) {
      }
    for (std::size_t i = all_.size(); i-- > 0;)
      if (is_covered(all_[i], i)) all_.erase(all_.begin() + static_cast<long>(i));
    return std::move(all_);
  }

private:
  // First those whose hole is empty: they may need the others for that.
  bool drop_an_inequation(std::size_t i) {
    return drop_one(i,
                    [&](const ParameterSet& hole, const MPoly&) { return has_no_point(hole); }) ||
           drop_one(i, [&](const ParameterSet& hole, const MPoly& p) {
             return may_be_dropped(i, p) || is_on_another(hole, i);
           });
  }
  template <class Promising> bool drop_one(std::size_t i, const Promising& promising) {
    const ParameterPlace here = all_[i];
    for (const MPoly& p : here.where.inequations()) {
      if (is_assumed(p)) continue;
      ParameterPlace larger{without_condition(here.where, p), here.special};
      const ParameterSet hole = larger.where.where_zero(p);
      if (!promising(hole, p) || !is_covered_by(hole, agreeing_with(larger, i))) continue;
      all_[i] = std::move(larger);
      return true;
    }
    return false;
  }
  [[nodiscard]] bool is_covered_by(const ParameterSet& set,
                                   const std::vector<ParameterSet>& covers) const {
    if (has_no_point(set)) return true;
    const auto left = without(set, covers);
    return std::ranges::all_of(left, [&](const ParameterSet& part) { return has_no_point(part); });
  }
  // True only if proved: no values, or an equation of which the assumptions and inequations give the sign.
  [[nodiscard]] bool has_no_point(const ParameterSet& set) const {
    if (set.is_empty()) return true;
    if (known_.real.empty() && known_.conditions.empty()) return false;
    const SignProver signs(set.ring(), known_.conditions, set.inequations(), known_.real);
    const auto equations = set.equations();
    return std::ranges::any_of(equations, [&](const MPoly& f) { return signs.is_never_zero(f); });
  }
  [[nodiscard]] bool is_assumed(const MPoly& p) const { return is_among(p, assumed_); }
  // Cheap: where p = 0 there is another place, or p is one of the other inequations on the set.
  bool may_be_dropped(std::size_t i, const MPoly& p) const {
    for (std::size_t j = 0; j < all_.size(); ++j)
      if (j != i && is_zero(all_[j].where.restrict(p))) return true;
    const ParameterSet& where = all_[i].where;
    const auto& others = where.inequations();
    const MPoly here = primitive(where.restrict(p));
    return std::ranges::any_of(
        others, [&](const MPoly& q) { return !(q == p) && primitive(where.restrict(q)) == here; });
  }
  // Cheap: as far as equations say.
  bool is_on_another(const ParameterSet& more, std::size_t i) const {
    for (std::size_t j = 0; j < all_.size(); ++j) {
      const auto equations = all_[j].where.equations();
      if (j != i &&
          std::ranges::all_of(equations, [&](const MPoly& f) { return is_zero(more.restrict(f)); }))
        return true;
    }
    return false;
  }
  // The sets that agree; nothing is said of a place where another set is met that does not.
  std::vector<ParameterSet> agreeing_with(const ParameterPlace& place, std::size_t i) const {
    std::vector<ParameterSet> sets;
    for (std::size_t j = 0; j < all_.size(); ++j)
      if (j != i && agree(place, all_[j])) sets.push_back(all_[j].where);
    return sets;
  }
  bool is_covered(const ParameterPlace& small, std::size_t i) const {
    for (std::size_t j = 0; j < all_.size(); ++j)
      if (j != i && agree(all_[j], small) && is_covered_by(small.where, {all_[j].where}))
        return true;
    return false;
  }

  std::vector<ParameterPlace> all_;
  const std::vector<MPoly>& assumed_;
  const Assumptions& known_;
};

} // namespace

std::vector<ParameterPlace> in_few_words(std::vector<ParameterPlace> all,
                                         const std::vector<MPoly>& assumed,
                                         const Assumptions& known) {
  if (all.size() > most_places) return all;
  try {
    return Union(all, assumed, known).simplified();
  } catch (const OutOfBudget&) {
    return all;
  } catch (const DomainError&) { // a condition has no meaning where it was looked at
    return all;
  }
}

} // namespace kov
