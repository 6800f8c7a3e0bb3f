#pragma once
// "Did you mean ...?"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace kov {

/// The candidate nearest to `name` (edits and neighbouring swaps, case nearly ignored), if
/// it is near enough to be meant: at most a third of the length, and at least one edit.
/// Given   const std::vector<std::string> kinds{"hamiltonian", "lagrangian", "poisson"};
/// Example nearest("hamiltonion", kinds)  // -> hamiltonian
/// Example nearest("euler", kinds)  // -> none
[[nodiscard]] std::optional<std::string> nearest(std::string_view name,
                                                 std::span<const std::string> candidates);

/// "a, b and c"
/// Example enumerate(kinds)  // -> hamiltonian, lagrangian and poisson
[[nodiscard]] std::string enumerate(std::span<const std::string> names);

} // namespace kov
