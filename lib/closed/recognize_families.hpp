#pragma once
// The parts of recognize.hpp, by the kind of the places.

#include "closed/recognize.hpp"

namespace kov::recognition {

/// A square root in the field, where that is quick to see (degree <= 4).
[[nodiscard]] std::optional<NfElem> root_in(const NfElem& square);
/// A square root as text: "3/2", "sqrt(5)".
[[nodiscard]] std::string root_text(const NfElem& square);
/// The map that takes x to M(N(x)).
[[nodiscard]] Moebius composed(const Moebius& m, const Moebius& n);

/// Regular places only: two, three or four of them.
[[nodiscard]] std::optional<Recognized> regular(const Singularities& s, long places,
                                                const Budget& budget);
/// One irregular place, rational.
[[nodiscard]] std::optional<Recognized> irregular(const Singularities& s, long regular_places);

} // namespace kov::recognition
