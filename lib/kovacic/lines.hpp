#pragma once
// Case 1, families for y itself (Kovacic 1986, §3.1), over the field K of the equation.
//
// Finds every line y with y'/y in K(z): one family for each choice of a local form at every place.
// When the choices are many and the exponent differences rational, y^N is looked for instead, N the
// common denominator of those differences: all of its exponents at one place differ by integers, so
// that only the choices at irregular places and at irrational differences remain.  With exactly one
// line the products of N solutions that a character multiplies are the multiples of y^N
// (docs/theory/descent.md (5d)).

#include "kovacic/outcome.hpp"
#include "kovacic/trace.hpp"
#include "linode/singularities.hpp"

namespace kov::kovacic {

/// Exponential, ExponentialPair{every_line} or nothing.
///
/// Small degrees come first: a line of small degree is found although other families allow immense
/// ones.
///
/// Requires not two lines exactly (the second symmetric power has been searched); if there are two,
///          an Exponential is one of them, and "nothing" means nothing
/// Throws   OutOfBudget
/// Source   [Kovacic1986] §3.1 steps 1 - 3; docs/theory/descent.md (5)
/// Example  std::get<Exponential>(*rational_lines(singularities(z*z + 3), {}, nullptr)).omega
///          // -> (z^2 + 1)/z
[[nodiscard]] std::optional<Outcome> rational_lines(const Singularities& s, const Budget& budget,
                                                    Trace* trace);

} // namespace kov::kovacic
