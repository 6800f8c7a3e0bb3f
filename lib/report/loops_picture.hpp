#pragma once
// The plane of a monodromy: singular points, the base point, the loops and the circles of
// convergence of the expansions on the way.  For the eye only.

#include "monodromy/monodromy.hpp"

#include <string>
#include <vector>

namespace kov::report {

/// One SVG file without scripts; places[i] is what the legend calls the i-th loop.
[[nodiscard]] std::string loops_svg(const monodromy::Monodromy& m, const std::string& title,
                                    const std::vector<std::string>& places);

} // namespace kov::report
