#pragma once
// Changes of scale: where all variables, the time and the parameters have weights for which the
// system is homogeneous, a parameter that is not 0 can be made 1.
//
// Source  docs/theory/classify.md (9)

#include "study/exclusion.hpp"

namespace kov {

/// The system at a = 1, b = 1, ...; the other parameters p stand for p a^-i b^-j ...
struct ScaledSystem {
  std::vector<std::size_t> ones; ///< a, b, ...; not 0
  Substitution values;           ///< of these
  Substitution back;             ///< p -> p a^-i b^-j ..., for the others that change
  System system;

  /// In the parameters before; what holds where the system at a = 1, ... is excluded.
  [[nodiscard]] Exclusion before(Exclusion e) const;
  [[nodiscard]] std::vector<MPoly> before(std::vector<MPoly> all) const;
};

/// With as many parameters made 1 as possible, of those that occur; unset: none can be.
/// Given   const System quartic = read_system(parse_document("system = {kind = 'hamiltonian', "
///             "coordinates = ['x', 'y'], momenta = ['u', 'v'], parameters = ['a', 'b'], "
///             "hamiltonian = '(u^2 + v^2)/2 + a*x^2 + b*x^2*y^2 + y^4'}", "quartic.toml"));
/// Example scaled(quartic)->ones.size()  // -> 1
[[nodiscard]] std::optional<ScaledSystem> scaled(const System& s);

} // namespace kov
