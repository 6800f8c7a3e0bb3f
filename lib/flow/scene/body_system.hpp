#pragma once
// The scene of a body as one of the general engine.

#include "flow/scene/system_scene.hpp"

namespace kov::flow {

/// The body on e(3), in own units: coordinates N = M - B, then Gamma, along axes of which the third is the section's;
/// l and L/G are the longitude of N and its height over its length.  (The general engine takes the units of a system as
/// they are; but N = 10^120 in the units of a scene is allowed, and its cube is no double.)
///
/// Errors  InputError: own_units.hpp
[[nodiscard]] SystemScene system_of(const Scene& scene);

} // namespace kov::flow
