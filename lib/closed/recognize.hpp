#pragma once
// Is y'' = r y a classical equation, up to a Moebius map of z (a gauge y = u sqrt(M') belongs to
// it)?
//
//   places                                        family
//   infinity only, irregular                      constant, Airy, Weber, polynomial
//   two regular                                   Euler
//   three regular                                 Riemann
//   four regular, three of them with Delta = 1/2  Lame: the fourth one goes to infinity, the sum
//                                                 of the others to 0, without splitting them
//   four regular                                  Heun
//   one irregular of order 4, one regular         Whittaker, Bessel
//   one of order 3, one regular                   Bessel in sqrt(x)
//
// Equations that depend on (z - c)^2 only are tried in that variable, too.
//
// Each recognition is proved: the canonical equation is computed from the parameters and compared
// with the transformed r exactly.
//
// Source  docs/theory/recognition.md

#include "closed/classical.hpp"
#include "closed/closed_answer.hpp"
#include "closed/moebius.hpp"
#include "linode/singularities.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace kov {

/// A classical equation with its parameters, and what its closed answer says.
struct Recognized {
  Classical family = Classical::heun;
  std::string equation; ///< the canonical form, in x: "y'' = (1/4 - k/x + (m^2-1/4)/x^2) y"
  /// Names and exact values, in the order of the canonical form: n, B, g2, g3.
  std::vector<std::pair<std::string, std::string>> parameters;
  std::optional<Moebius> z_of_x =
      std::nullopt; ///< unset where the places are conjugate and no map is needed
  std::optional<ClosedAnswer> answer = std::nullopt;
  /// Set if r depends on (z - c)^2 only and (z - c)^2 = M(x) is meant: then `answer` is about the
  /// identity component, which is the same in a finite extension, and not about the group.
  std::optional<NfElem> centre = std::nullopt;
};

/// Nothing for other equations.  Requires r != 0.
/// Cost  a few operations with polynomials of degree <= 8; larger denominators are not looked at
[[nodiscard]] std::optional<Recognized> recognize(const Singularities& s,
                                                  const Budget& budget = {});
/// The same from r, also for r = 0 (nothing is recognised).  places: those of r, where they are
/// known already.
/// Example recognize(RationalFunction(2 - z*z, z*z))->family  // -> Bessel
/// Example recognize(RationalFunction(2 - z*z, z*z))->parameters  // -> {{m, 3/2}, {a, -1}}
/// Example recognize(RationalFunction(1, z*z*(z - 1)*(z - 1)*(z - 2)*(z - 3)))->family  // -> Heun
[[nodiscard]] std::optional<Recognized> recognize(const RationalFunction& r,
                                                  const Budget& budget = {},
                                                  const Singularities* places = nullptr);

} // namespace kov
