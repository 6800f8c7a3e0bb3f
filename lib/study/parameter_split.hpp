#pragma once
// A set of parameter values cut along polynomials.

#include "integrals/stratum.hpp"

#include <functional>

namespace kov {

/// The parts are disjoint and not empty; together they are the set.
struct SetParts {
  std::vector<ParameterSet> inside, outside;
};

/// Tells which irreducible polynomials in the parameters may vanish somewhere.
using MayVanish = std::function<bool(const MPoly&)>;

/// Inside: all of `zero` vanish, and of each list in `not_all_zero` some polynomial does not.
/// Errors  OutOfBudget, of the sets
/// Given   const Ring ring = make_ring({"a", "b"});
/// Given   const MPoly a = MPoly::variable(ring, "a"), b = MPoly::variable(ring, "b");
/// Given   const ParameterSet all(ring, {0, 1});
/// Given   const MayVanish any = [](const MPoly&) { return true; };
/// Example split_set(all, {}, {{a, b}}, any).inside.size()  // -> 2
/// Example split_set(all, {}, {{a, b}}, any).outside.size()  // -> 1
/// Example split_set(all, {a*b}, {}, any).inside.size()  // -> 2
[[nodiscard]] SetParts split_set(const ParameterSet& where, const std::vector<MPoly>& zero,
                                 const std::vector<std::vector<MPoly>>& not_all_zero,
                                 const MayVanish& may_vanish);

/// The equations of the set that do not follow from `known` and the ones before, simple ones first.
/// Example proper_equations(all.where_zero(a*a).where_zero(a), {}).size()  // -> 1
[[nodiscard]] std::vector<MPoly> proper_equations(const ParameterSet& where,
                                                  const std::vector<MPoly>& known);
/// The factors that do not vanish on the set, each as a function on it, and without constants.
/// Example inequations(all.where_zero(b).where_nonzero(a - b))  // -> {a}
[[nodiscard]] std::vector<MPoly> inequations(const ParameterSet& where);

/// Fewer sets with the same union: W with p = 0 and W with p != 0 are W.
/// Example united({all.where_zero(a), all.where_nonzero(a)}).size()  // -> 1
[[nodiscard]] std::vector<ParameterSet> united(std::vector<ParameterSet> sets);

/// Parameters as rational functions of the others, from the equations of the set that are linear in
/// one with a slope that vanishes nowhere there.  `left`: the equations that were not solved.
struct SolvedSet {
  Substitution values;
  std::vector<MPoly> left;
};
/// Example to_string(solve(all.where_zero(a - b*b)).values.at(0))  // -> b^2
[[nodiscard]] SolvedSet solve(const ParameterSet& where);

/// Disjoint parts, one for each factor that an equation has when others are solved: on c = a^2 - 1,
/// c = 3 these are a = 2 and a = -2.  The set itself if there are none.
/// Example by_factors(all.where_zero(b - a*a).where_zero(b - MPoly(ring, Integer(4))), any).size()  // -> 2
/// Example by_factors(all.where_zero(b - a*a), any).size()  // -> 1
[[nodiscard]] std::vector<ParameterSet> by_factors(const ParameterSet& where,
                                                   const MayVanish& may_vanish);

} // namespace kov
