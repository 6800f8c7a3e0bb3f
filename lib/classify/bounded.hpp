#pragma once
// Real parameters: a difference that is bounded takes finitely many of its special values.
//
// Source  docs/theory/classify.md (2)

#include "literature/trusted.hpp"
#include "parameters/set.hpp"
#include "system/system.hpp"

namespace kov {

/// The values of one Delta^2, and what that rests on.
struct BoundedValues {
  std::size_t condition = 0; ///< in the list
  CommonValues values;
  std::vector<Trusted> trusted; ///< on which the decision over the reals rests
};
/// One of the statements of the set that holds for finitely many Delta^2 only, as the real
/// parameters of the set with larger ones are refuted.  Another Delta that is never v is special
/// only at a distance from v: that is used.  Unset: none is found.
/// Cost   a few decisions of Z3 for each condition
[[nodiscard]] std::optional<BoundedValues> bounded_values(const System& s, const Set& where);

} // namespace kov
