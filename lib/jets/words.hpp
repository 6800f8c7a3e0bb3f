#pragma once
// The statements of the higher variational equations, in words.

#include "jets/obstruction.hpp"
#include "literature/levels.hpp"
#include "literature/trusted.hpp"

namespace kov::jets {

/// Why the system is not integrable.
[[nodiscard]] std::string reason(const HigherOrders& orders);
/// "for all but countably many values of the energy", or "at the energy H = 1".
[[nodiscard]] Levels level(const HigherObstruction& obstruction);
/// The steps on trust, besides the theorem and exact computation.
[[nodiscard]] std::vector<Trusted> trusted(const HigherObstruction& obstruction);

} // namespace kov::jets
