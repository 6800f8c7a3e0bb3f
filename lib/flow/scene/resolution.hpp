#pragma once
// How much of the state is left where it matters: angles that may be kept within a turn, and close encounters.

#include "flow/scene/system_scene.hpp"

#include <optional>

namespace kov::flow {

/// Coordinates that nothing but sin, cos, ... of them and an angle of the picture depend on: whole turns may be dropped.
/// As places among the coordinates.
[[nodiscard]] std::vector<std::uint32_t> turning_angles(const SystemScene& s,
                                                        const std::vector<SceneFormula>& watched);

/// A turn as a sum of three numbers, of which the first two have few digits.
template <class R> [[nodiscard]] std::array<R, 3> turn_in_parts();

/// Has a state digits enough for an encounter?  It has not where rounding makes more than 2^-10 of what the field
/// divides by or of the argument of a root, or of an integral as large as it was at the start.
class Resolution {
public:
  Resolution(const Field& f, const SystemScene& s, const std::vector<SceneFormula>& integrals);
  [[nodiscard]] bool operator()(const double* start, const double* x, double roundoff);

private:
  struct Part {
    Evaluator<double> value;
    TermSize size;
  };
  std::vector<Part> parts_;
  std::vector<TermSize> integrals_;
};

} // namespace kov::flow
