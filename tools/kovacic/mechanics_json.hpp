#pragma once
// JSON of the stages of the mechanics pipeline.  Exact values are strings that parse back.

#include "integrability/check.hpp"

#include <nlohmann/json.hpp>

namespace kov::cli {

using Json = nlohmann::ordered_json;

[[nodiscard]] Json json_of(const LinearSystem& s);
[[nodiscard]] Json json_of(const ScalarEquation& e);
/// p, q, r, variable, parameters, change, ...
[[nodiscard]] Json json_of(const System& s, const AlgebraicOde& ode);
[[nodiscard]] Json json_of(const Decision& d);
[[nodiscard]] Json json_of(const System& s, const BlockReport& b);
[[nodiscard]] Json json_of(const System& s, const ManifoldReport& m);
[[nodiscard]] Json json_of(const ClaimReport& c);
[[nodiscard]] Json json_of_field(const System& s);

[[nodiscard]] std::string claim_kind(Claim::Kind k);
/// "M2' = ..., M3' = ..." lines are made from this by the text output.
[[nodiscard]] std::string join(const std::vector<std::string>& words, const std::string& between);

} // namespace kov::cli
