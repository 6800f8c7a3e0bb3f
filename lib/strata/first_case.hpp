#pragma once
// The first case of Kovacic's algorithm on a stratum, as it is done by hand in papers: exponents at
// every place, families whose degree is a natural number, and for degree 0 what the parameters
// would have to satisfy.  An explanation beside the proof: no verdict rests on it.
//
// Source  Kovacic 1986, section 3; the proof of Lemma 3 of the paper on the sliding top

#include "decide/decide.hpp"
#include "places/scheme.hpp"

namespace kov::strata {

/// One sign of Delta for all roots of a factor of the denominator; logarithms are shown, and not used.
/// Cost    2^(number of places) families, at most 4096; a rational function for each of degree 0
/// Given   const Scheme airy = std::get<Scheme>(scheme(z + a, 0, everywhere));
/// Example first_case(airy, everywhere).front().text  // -> infinity: irregular, order 5
[[nodiscard]] kovacic::Trace first_case(const Scheme& s, const ParametrisedSet& region,
                                        const Budget& budget = {});

} // namespace kov::strata
