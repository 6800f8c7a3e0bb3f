#include "strata/needed.hpp"

namespace kov::strata {
namespace {

std::optional<SomeIn> some_in(const Leaf& leaf, const std::vector<PlaceIndex>& places,
                              std::optional<Classes> classes) {
  SomeIn some{{}, std::move(classes)};
  for (const PlaceIndex i : places) {
    const auto& chi = place_at(*leaf.scheme, i).chi;
    if (chi.size() != 2) return std::nullopt;
    some.squares.push_back(-(chi[0] / chi[1]));
  }
  return some.squares.empty() ? std::nullopt : std::optional(some);
}

} // namespace

std::optional<SomeIn> needed(const Leaf& leaf, const SomeDifference& open) {
  auto some = some_in(leaf, open.places, Classes{multiples_of_a_half});
  if (some) some->or_all_rational = !open.torus;
  return some;
}

std::optional<SomeIn> needed(const Leaf& leaf) {
  if (!leaf.scheme || !leaf.open) return std::nullopt;
  if (const auto* some = std::get_if<SomeDifference>(&*leaf.open)) return needed(leaf, *some);
  if (const auto* one = std::get_if<RationalDifference>(&*leaf.open))
    return some_in(leaf, {one->place}, std::nullopt);
  if (const auto* one = std::get_if<IntegralDifference>(&*leaf.open))
    return some_in(leaf, {one->place}, Classes{one->twice ? multiples_of_a_half : all_integers});
  return std::nullopt;
}

} // namespace kov::strata
