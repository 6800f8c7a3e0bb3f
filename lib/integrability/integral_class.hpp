#pragma once
// Which first integrals a verdict excludes.
//
// Source  docs/theory/mechanics.md (6), "Class of first integrals"

#include "exact/rational_function.hpp"
#include "literature/integral_class.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace kov {

struct System;
struct ManifoldReport;
struct InvariantManifold;

/// The places where integrals have to be meromorphic if y'' = r y has a non-abelian identity
/// component: near the phase curve, and if a place of r is irregular also at the points that its
/// closure adds.
/// Example integrals_near(RationalFunction(2, z*z)) == IntegralClass::Near::curve  // -> yes
/// Example integrals_near(z) == IntegralClass::Near::closed_curve  // -> yes
[[nodiscard]] IntegralClass::Near integrals_near(const RationalFunction& r);

/// Coordinates and function symbols that change along the phase curve and on which nothing depends.
[[nodiscard]] std::vector<std::size_t> moving_and_left_out(const System& s,
                                                           const InvariantManifold& m);

/// The class of integrals that one equation with a non-abelian identity component excludes along
/// the curve of this name.  is_sl2: its group is SL(2, C), which infinite Abelian covers of the
/// curve keep; with regular places nothing is left out then.  m: null where it is not known.
[[nodiscard]] IntegralClass excluded_integrals(const System& s, const std::string& name,
                                               const InvariantManifold* m, IntegralClass::Near near,
                                               bool is_sl2);
/// The same along the curve of a report, whose function field shows more.
[[nodiscard]] IntegralClass excluded_integrals(const System& s, const ManifoldReport& report,
                                               IntegralClass::Near near, bool is_sl2);
/// The class of integrals that the verdict excludes, after the decision of all blocks.
[[nodiscard]] IntegralClass excluded_integrals(const System& s, const ManifoldReport& report);

} // namespace kov
