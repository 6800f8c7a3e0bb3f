#pragma once
// Higher variational equations by quadratures, along a rational curve whose normal equation has a
// rational solution: all solutions up to some order lie in L = K(I), and then an integral int f, f in
// L, is needed.  If df/dI is not a derivative of an element of L, the identity component is not abelian.
//
// Source  docs/theory/quadratures.md; [MoralesRamisSimo2007] for the theorem on higher orders

#include "integrability/report.hpp"
#include "literature/levels.hpp"
#include "quadratures/primitive_extension.hpp"

namespace kov {

struct QuadratureObstruction {
  int order = 0;        ///< of the variational equation
  LevelChoice level;    ///< of the curve: E = 1
  std::string variable; ///< z as a function on the phase space
  RationalFunction u;   ///< I' by z
  PrimitiveExtension::Element f;
  std::string of;               ///< whose integral it is: "c1*c2^2 in the variation of L"
  std::size_t power = 0;        ///< of I, where df/dI has simple poles that do not go away
  IntegralClass integrals = {}; ///< the class of first integrals that is excluded
  std::string unchecked = {};   ///< a hypothesis that is open, as a clause; or empty
};

struct QuadratureOrders {
  std::optional<QuadratureObstruction> obstruction;
  std::string open; ///< why there is none; empty: the system has parameters, and nothing was asked
};

/// The orders of a system without parameters but levels, whose first variational equation falls into one part
/// along the curve and a normal one of order two.
/// order: the largest one.   Errors  none of limits: they are listed in `open`
[[nodiscard]] QuadratureOrders orders_by_quadratures(const System& s, const ManifoldSpec& m,
                                                     int order, const Budget& budget);
[[nodiscard]] std::string reason(const QuadratureObstruction& o);

} // namespace kov
