#pragma once
// The scene of a body as one of the general engine.

#include "flow/scene/own_units.hpp"
#include "flow/scene/system_scene.hpp"

namespace kov::flow {

/// The body on e(3), in own units: coordinates N = M - B, then Gamma, along axes of which the third is the section's.
/// The section map is that of the scene; nothing is said of its orbits.
[[nodiscard]] SystemScene system_of(const Scene& scene, const OwnUnits& units);

} // namespace kov::flow
