#include "strata/uniform.hpp"

#include "closed/statement.hpp"
#include "strata/bounds.hpp"

#include <algorithm>

namespace kov::strata {
namespace {

constexpr int most_splits = 16;

// The answer over Q(parameters): whatever has to be decided is not 0.
template <class T, class Ask> std::optional<T> over_functions(ParametrisedSet& generic, Ask ask) {
  for (int i = 0; i < most_splits; ++i) {
    auto answer = ask();
    if (auto* found = std::get_if<T>(&answer)) return std::move(*found);
    generic = generic.where_nonzero(std::get<Needs>(answer).p);
  }
  return std::nullopt;
}

// f, a polynomial in z, is the zero polynomial at no point.
bool is_somewhere_nonzero(const MPoly& f, std::size_t z, const ParametrisedSet& region) {
  const auto c = coefficients(f, z);
  return std::ranges::any_of(c, [&](const MPoly& one) { return is_plainly_nonzero(one, region); });
}

} // namespace

std::optional<Leaf> abelian_for_all(const MFraction& r, std::size_t z,
                                    const ParametrisedSet& region, const Budget& budget) {
  ParametrisedSet generic = region;
  const auto s = over_functions<Scheme>(generic, [&] { return scheme(r, z, generic, budget); });
  if (!s) return std::nullopt;
  for (const long m : {2L, 4L}) {
    const auto form = invariant_bound(*s, m).form;
    if (!form || form->degree >= most_unknowns) continue;
    using Found = std::optional<ParametricInvariant>;
    auto v =
        over_functions<Found>(generic, [&] { return find_invariant(*s, *form, generic, budget); });
    if (!v || !*v) continue;
    const bool defined = is_somewhere_nonzero((*v)->p, z, region) &&
                         std::ranges::all_of(s->finite, [&](const ParametricPlace& p) {
                           return is_plainly_nonzero(coefficients(p.q, z).back(), region);
                         });
    if (!defined) continue;
    Leaf leaf;
    leaf.abelian = Truth::yes;
    leaf.by = Conclusion::invariant;
    leaf.bound = GroupBound::torus_normaliser_or_T;
    leaf.scheme = std::make_shared<const Scheme>(*s);
    leaf.because.push_back(InvariantFound{**std::move(v)});
    return leaf;
  }
  return std::nullopt;
}

} // namespace kov::strata
