#pragma once
// What is proved about the section map of a system file, in words and as data: periodic orbits, homoclinic points.

#include "flow/chaos/all_fixed_points.hpp"
#include "flow/chaos/homoclinic.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace kov::cli {

/// BASE.fixed.dat: one line for each point of each orbit.
void write_periodic_orbits(const std::string& path, const flow::SystemScene& s,
                           const flow::PeriodicOrbits& found);
[[nodiscard]] std::string proof_text(const flow::SystemScene& s, const flow::PeriodicOrbits& found);

/// BASE.homoclinic.dat: the orbit, and arcs of both manifolds (these in double, not proved).
void write_homoclinic(const std::string& path, const flow::SystemScene& s,
                      const flow::Homoclinic& found);
/// Exactly what is proved, and by which theorem what follows; or what failed.
[[nodiscard]] std::string proof_text(const flow::SystemScene& s, const flow::Homoclinic& found);
/// "exactly 3", or where it is undecided, for each sheet.  `rectangle`: as it was asked for.
[[nodiscard]] std::string proof_text(const flow::SystemScene& s,
                                     const flow::FixedPointsInRectangle& all,
                                     const std::vector<std::string>& rectangle);
/// Each sheet that was found over the middle is decided.
[[nodiscard]] bool complete(const flow::FixedPointsInRectangle& all);
/// One JSON object, without a line break at its end.  `simulation`: what section_report.hpp says of the orbits.
[[nodiscard]] std::string json_of(const flow::SystemScene& s, const flow::PeriodicOrbits* orbits,
                                  const flow::Homoclinic* homoclinic,
                                  const flow::FixedPointsInRectangle* all,
                                  const nlohmann::ordered_json& simulation);
/// docs/theory/chaos.md has the format.  Requires found.proof.
/// Errors  InputError: the system is none of those that the format has
[[nodiscard]] std::string certificate_of(const flow::SystemScene& s, const flow::Homoclinic& found);

/// "elliptic", "inverse-hyperbolic", "undecided"
[[nodiscard]] std::string kind_of(const flow::PeriodicOrbit& o);

} // namespace kov::cli
