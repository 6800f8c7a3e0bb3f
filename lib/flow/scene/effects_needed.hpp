#pragma once
// Only the effects that a scene calls for: what nothing drawn or watched depends on is not integrated.

#include "flow/scene/system_scene.hpp"

namespace kov::flow {

/// The scene without the coordinates that its section, its picture, its integrals and the motion of the other
/// coordinates do not depend on, and without the functions that are left over.  Only where whole states are given and
/// no indicator asks for every direction; otherwise the scene as it is.
[[nodiscard]] SystemScene without_idle_coordinates(const SystemScene& s);

/// The integrals that the motion and the picture have the functions for: no other function is integrated to watch one.
[[nodiscard]] std::vector<SceneFormula> watched(const SystemScene& s);

} // namespace kov::flow
