#pragma once
// The answer for all parameters at once, as JSON and as text.

#include "equation/parametric_equation.hpp"
#include "equations/result.hpp"
#include "strata/decide_strata.hpp"

#include <ostream>

namespace kov::cli {

/// The list under the key "strata", and what was left open or taken on trust beside it.
void put_strata(Json& j, const strata::StrataAnswer& a);
/// Solutions of the given equation on each stratum where they have a closed form, under its key "solutions".
/// Solutions on the general stratum, or in functions with a name, stand as in put_answer.
void put_solutions_of_strata(Json& j, const answer::Given& given, const ParametricEquation& f,
                             const strata::StrataAnswer& all, const answer::Style& style,
                             const Budget& budget);
/// Lines "stratum / group / because", from the JSON: one for each stratum, or for each answer.
void print_strata(std::ostream& out, const Json& j, bool whole);
/// The steps of a derivation under the key "trace", if there are any, and from there to lines.
void put_trace(Json& j, const kovacic::Trace& trace);
void print_trace(std::ostream& out, const Json& j);
/// The result of an equation with free parameters.
[[nodiscard]] Json family_result(const Json& id, const ParametricEquation& f,
                                 const strata::StrataAnswer& a);

/// What came out on a part of the parameters; null where there is no equation, or none is known.
struct PartResult {
  EquationPart part;
  Json result;
};
/// "a != 0, b = 0"
[[nodiscard]] std::string in_words(const EquationPart& part);
/// One result of those of all parts.  whole: there are no others.  unknown: of the given equation.
[[nodiscard]] Json together(const std::vector<PartResult>& all, bool whole,
                            const std::string& unknown);

} // namespace kov::cli
