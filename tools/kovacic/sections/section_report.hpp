#pragma once
// What the simulation of a scene shows, in words and as data.

#include "flow/scene/system_section.hpp"

#include <nlohmann/json.hpp>

namespace kov::cli {

/// Parameters, levels, the section.
[[nodiscard]] std::string mechanics_text(const flow::SystemScene& s);
/// Two lines, the mechanics and the numerics; a third one where the errors of the points are known.
[[nodiscard]] std::vector<std::string> caption(const flow::SystemScene& s,
                                               const flow::SystemSection& r);
/// "8 of 64 starting points lie outside the level H = 1"
[[nodiscard]] std::string outside_of_level(const flow::SystemScene& s,
                                           const flow::SystemSection& r);
/// "x = 0, x' > 0"
[[nodiscard]] std::string section_text(const flow::SystemScene& s);
/// "the points are right to 1e-06 for the first 16 returns ..."; empty if nothing is known.
[[nodiscard]] std::string accuracy_text(const flow::SystemSection& r);
/// What happened to orbits that did not go on as the others: singularities, rest, the section itself.
[[nodiscard]] std::vector<std::string> remarks(const flow::SystemScene& s,
                                               const flow::SystemSection& r);
/// The largest exponent and how many orbits look chaotic, of those that neither rest nor end early.
[[nodiscard]] std::string chaos_of(const flow::SystemSection& r);
/// All exponents of the orbit with the largest one.  Requires that they were asked for.
[[nodiscard]] std::string spectrum_text(const flow::SystemSection& r);
[[nodiscard]] std::string winding_text(const flow::SystemSection& r);
/// Requires no crossings.
[[nodiscard]] std::string never_crossed(const flow::SystemScene& s, const flow::SystemSection& r);
/// What is missing in a result, in words; empty if nothing is.  With "PARTIAL: " before it.
[[nodiscard]] std::string shortfall(const flow::SystemSection& r);
[[nodiscard]] std::string partial(const flow::SystemSection& r);

/// The column with the colour of an orbit, and its value; empty: none.
[[nodiscard]] std::string colour_of(const flow::SystemScene& s);
[[nodiscard]] double indicator_of(const flow::SystemScene& s, const flow::DrawnOrbit& o);
[[nodiscard]] nlohmann::ordered_json json_of(const flow::SystemScene& s,
                                             const flow::SystemSection& r);

} // namespace kov::cli
