#pragma once
// The answer for all parameters at once, as JSON and as text.

#include "result.hpp"
#include "strata/decide_strata.hpp"

#include <ostream>

namespace kov::cli {

/// The list under the key "strata", and what was left open or taken on trust beside it.
void put_strata(Json& j, const strata::StrataAnswer& a);
/// Lines "stratum / group / because" as in the report of one equation.
void put_strata(std::ostream& out, const strata::StrataAnswer& a);

} // namespace kov::cli
