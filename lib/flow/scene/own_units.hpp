#pragma once
// A scene in its own units: powers of two of its units of mass, length, time and |Gamma|, in which
// mass, moments of inertia, energy and |Gamma| are about 1.  Every limit of this room (times,
// steps, the noise of a zero) is meant in them, so that the same scene in grams or in solar masses
// has the same section; and since the factors are powers of two, numbers only change their
// exponents.

#include "flow/scene/scene.hpp"

namespace kov::flow {

/// Exponents of two: the scene's number = 2^exponent times the number in own units.
struct OwnUnits {
  long mass = 0, length = 0, time = 0;
  long vertical = 0; ///< of Gamma; the lever carries its inverse
  [[nodiscard]] long inertia() const { return mass + 2 * length; }
  [[nodiscard]] long momentum() const { return inertia() - time; }
  [[nodiscard]] long energy() const { return inertia() - 2 * time; }
};

/// A scene as its file has it, and in its own units.
struct BodyScene {
  Scene scene, own;
  OwnUnits units;
};

/// Errors  InputError: a unit is beyond 10^270 or below 10^-270
[[nodiscard]] OwnUnits own_units(const Scene& scene);
/// The scene with every number in these units; formulas keep their texts.
///
/// Errors  InputError: in its own units a number of the scene is beyond 10^100 (nothing can be
/// computed then)
[[nodiscard]] Scene in_units(const Scene& scene, const OwnUnits& units);

} // namespace kov::flow
