#pragma once
// How long an orbit stays on an invariant plane c.M = 0 (paper, eq. (HAdarbus); c is the scene's
// `sign_of`).
//
// The plane of a Darboux polynomial is invariant but need not be stable: c.M' = p c.M with a factor
// p whose mean along the orbit may be positive.  An orbit that starts on the plane leaves it only
// because numbers are rounded, after a time of about (number of digits) ln 10/mean(p): it grows
// with the precision, without any limit.

#include "bench/effort.hpp"

namespace kov::flow {

/// The time of the first crossing with |c.M| > 1/100, for the orbit that starts on the plane over
/// l; `until` if there is none.
///
/// Shape   digits: of Arithmetic::mpfr; the others have their own
/// Errors  InputError: the scene has no `sign_of`, or the level has no point there
[[nodiscard]] double escape_time(const SystemScene& scene, Arithmetic arithmetic, int digits,
                                 const Quantity& l, double until);

} // namespace kov::flow
