#pragma once
// The part of the picture over the level: the window of a scene that names none.

#include "flow/scene/system_scene.hpp"

namespace kov::flow {

/// The box is grown from [-1, 1]^2, each side by itself, until the part of the level around its middle ends inside, and
/// then fitted to that part.  A side along which it does not end stays [-1, 1].
[[nodiscard]] std::array<std::array<Quantity, 2>, 2> window_over_level(const SystemScene& scene);

} // namespace kov::flow
