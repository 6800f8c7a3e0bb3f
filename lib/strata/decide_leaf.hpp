#pragma once
// The verdict on one stratum, or what has to be decided first.
//
//   G0 is abelian  <=>  Sym^4 has a rational solution    some place irregular or irrational
//                  <=>  Sym^12 or Sym^n has one          all Delta rational constants, n the least
//                                                        common denominator of the exponents
//                                                        (1 + Delta)/2
//
// and where an exponent difference is open, abelian forces it into an explicit set of rational
// numbers; if its square is bounded that set is finite, and every element is a stratum of its own.
// docs/theory/strata.md, 5 to 7

#include "strata/leaf.hpp"

namespace kov::strata {

/// r in the parameters left in the region.
/// Throws  OutOfBudget
/// Example std::get<Leaf>(decide_leaf(z + a, 0, everywhere)).group->type  // -> SL2
/// Example std::get<Needs>(decide_leaf(a / z, 0, everywhere)).p  // -> a
[[nodiscard]] std::variant<Leaf, Needs> decide_leaf(const MFraction& r, std::size_t z,
                                                    const ParametrisedSet& region,
                                                    const Options& options = {});

/// The same from the places alone, without the closed answers of confluent.hpp.
[[nodiscard]] std::variant<Leaf, Needs> decide_by_places(const std::shared_ptr<const Scheme>& s,
                                                         const ParametrisedSet& region,
                                                         const Budget& budget);

/// The leaf of an equation without parameters.
[[nodiscard]] Leaf leaf_of(const Decision& d);

} // namespace kov::strata
