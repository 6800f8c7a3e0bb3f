#pragma once
// Which first integrals a verdict excludes.
//
// Source  docs/theory/mechanics.md (6), "Class of first integrals"

#include "exact/rational_function.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace kov {

struct System;
struct ManifoldReport;
struct InvariantManifold;

/// Meromorphic near the phase curve, and where a place of r is irregular also at the points that its
/// closure adds: at infinity, at equilibria, and at poles of the system.
enum class IntegralClass : std::uint8_t { meromorphic, meromorphic_at_infinity };
[[nodiscard]] std::string to_string(IntegralClass c); ///< "meromorphic", ...

/// The class that is left where y'' = r y has a non-abelian identity component.
/// Example integral_class(RationalFunction(2, z*z))  // -> meromorphic
/// Example integral_class(z)
///         // -> meromorphic also at the ends of the phase curve (points at infinity, equilibria, poles of the system)
[[nodiscard]] IntegralClass integral_class(const RationalFunction& r);

/// What is excluded, after the decision of all blocks.
struct ExcludedIntegrals {
  IntegralClass integrals = IntegralClass::meromorphic;
  /// Coordinates and function symbols that change along the phase curve and on which nothing
  /// depends: integrals that contain them are not excluded.
  std::vector<std::size_t> without;
};
/// Those coordinates and symbols, whatever is excluded.
[[nodiscard]] std::vector<std::size_t> moving_and_left_out(const System& s,
                                                           const InvariantManifold& m);
[[nodiscard]] ExcludedIntegrals excluded_integrals(const System& s, const ManifoldReport& report);

} // namespace kov
