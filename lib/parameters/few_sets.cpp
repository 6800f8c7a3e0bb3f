#include "parameters/few_sets.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "parameters/signs.hpp"

#include <algorithm>

namespace kov {
namespace {

constexpr std::size_t most_places = 40; // each is compared with each other

// The set without those that cover it.
std::vector<Set> without(const Set& set, const std::vector<Set>& covers) {
  std::vector<Set> left{set};
  for (const Set& cover : covers) {
    std::vector<Set> next;
    for (const Set& part : left) {
      auto outside = split(part, cut_of(cover), [](const MPoly&) { return true; }).outside;
      std::move(outside.begin(), outside.end(), std::back_inserter(next));
    }
    left = std::move(next);
  }
  return left;
}

template <class T> bool same_elements(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() &&
         std::ranges::all_of(a, [&](const auto& c) { return is_among(c, b); });
}

// On the small one the conditions of the large one are those of the small one.
bool agree(const Set& large, const Set& small) {
  if (large.is_algebraic() && small.is_algebraic()) return true;
  const auto here = small.without_statements().where(large.statements());
  return here && same_elements(here->statements(), small.statements());
}

// b = a and b = -a, all else alike, as b^2 = a^2.
std::optional<Set> up_to_sign(const Set& a, const Set& b) {
  const auto here = a.equations(), there = b.equations();
  if (here.size() != there.size() || !same_elements(a.statements(), b.statements()) ||
      !same_elements(inequations(a), inequations(b)))
    return std::nullopt;
  std::vector<MPoly> only_here, only_there;
  Set both = a.plain();
  for (const MPoly& p : here)
    if (is_among(p, there))
      both = both.where_zero(p);
    else
      only_here.push_back(p);
  std::ranges::copy_if(there, std::back_inserter(only_there),
                       [&](const MPoly& p) { return !is_among(p, here); });
  if (only_here.size() != 1 || only_there.size() != 1) return std::nullopt;
  const auto product = kov::up_to_sign(only_here.front(), only_there.front());
  if (!product) return std::nullopt;
  return both.where_zero(*product).with_inequations(inequations(a)).where(a.statements());
}

class Union {
public:
  Union(std::vector<Set> all, const std::vector<MPoly>& assumed, const Assumptions& known)
      : all_(std::move(all)), assumed_(assumed), known_(known) {}

  std::vector<Set> simplified() {
    for (std::size_t i = 0; i < all_.size(); ++i)
      while (drop_an_inequation(i)) {
      }
    for (std::size_t i = all_.size(); i-- > 0;)
      if (is_covered(all_[i], i)) all_.erase(all_.begin() + static_cast<long>(i));
    for (std::size_t i = all_.size(); i-- > 0;)
      for (std::size_t j = 0; j < i; ++j)
        if (auto both = up_to_sign(all_[j], all_[i])) {
          all_[j] = *std::move(both);
          all_.erase(all_.begin() + static_cast<long>(i));
          break;
        }
    return std::move(all_);
  }

private:
  // First those whose hole is empty: they may need the others for that.
  bool drop_an_inequation(std::size_t i) {
    return drop_one(i, [&](const Set& hole, const MPoly&) { return has_no_point(hole); }) ||
           drop_one(i, [&](const Set& hole, const MPoly& p) {
             return may_be_dropped(i, p) || is_on_another(hole, i);
           });
  }
  template <class Promising> bool drop_one(std::size_t i, const Promising& promising) {
    const Set here = all_[i];
    for (const MPoly& p : here.inequations()) {
      if (is_assumed(p)) continue;
      // those that others imply stay: of b = 2*a, a != 0, b != 0 the last can go if a != 0 is assumed
      auto others = here.inequations();
      std::erase(others, p);
      Set larger = here.with_inequations(others);
      const Set hole = larger.without_statements().where_zero(p);
      if (!promising(hole, p) || !is_covered_by(hole, agreeing_with(larger, i))) continue;
      all_[i] = std::move(larger);
      return true;
    }
    return false;
  }
  [[nodiscard]] bool is_covered_by(const Set& set, const std::vector<Set>& covers) const {
    if (has_no_point(set)) return true;
    const auto left = without(set, covers);
    return std::ranges::all_of(left, [&](const Set& part) { return has_no_point(part); });
  }
  // True only if proved: no values, or an equation of which the assumptions and inequations give the sign.
  [[nodiscard]] bool has_no_point(const Set& set) const {
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
      if (j != i && is_zero(all_[j].restrict(p))) return true;
    const Set& where = all_[i];
    const auto& others = where.inequations();
    const auto factors = [&](const MPoly& f) {
      const MFraction here = where.restrict(f);
      return is_zero(here) ? std::vector{MPoly(f.ring())} : irreducible_parts(here.num());
    };
    const auto here = factors(p);
    return std::ranges::any_of(
        others, [&](const MPoly& q) { return !(q == p) && same_elements(factors(q), here); });
  }
  // Cheap: as far as equations say.
  bool is_on_another(const Set& more, std::size_t i) const {
    for (std::size_t j = 0; j < all_.size(); ++j) {
      const auto equations = all_[j].equations();
      if (j != i &&
          std::ranges::all_of(equations, [&](const MPoly& f) { return is_zero(more.restrict(f)); }))
        return true;
    }
    return false;
  }
  // The sets that agree; nothing is said of a place where another set is met that does not.
  std::vector<Set> agreeing_with(const Set& place, std::size_t i) const {
    std::vector<Set> sets;
    for (std::size_t j = 0; j < all_.size(); ++j)
      if (j != i && agree(place, all_[j])) sets.push_back(all_[j].without_statements());
    return sets;
  }
  bool is_covered(const Set& small, std::size_t i) const {
    for (std::size_t j = 0; j < all_.size(); ++j)
      if (j != i && agree(all_[j], small) &&
          is_covered_by(small.without_statements(), {all_[j].without_statements()}))
        return true;
    return false;
  }

  std::vector<Set> all_;
  const std::vector<MPoly>& assumed_;
  const Assumptions& known_;
};

} // namespace

std::vector<Set> in_few_words(std::vector<Set> all, const std::vector<MPoly>& assumed,
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
