#pragma once
// The answer for all parameters at once, as JSON and as text.

#include "answer/solve.hpp"
#include "equations/result.hpp"

#include <ostream>

namespace kov::cli {

/// The list under the key "strata", and what was left open or taken on trust beside it.
void put_strata(Json& j, const strata::StrataAnswer& a);
/// Lines "stratum / group / because", from the JSON: one for each stratum, or for each answer.
void print_strata(std::ostream& out, const Json& j, bool whole);
/// The steps of a derivation under the key "trace", if there are any, and from there to lines.
void put_trace(Json& j, const kovacic::Trace& trace);
void print_trace(std::ostream& out, const Json& j);
/// The result of an equation with free parameters.  unknown: of the given equation.
[[nodiscard]] Json family_result(const Json& id, const answer::Family& family,
                                 const std::string& unknown);

} // namespace kov::cli
