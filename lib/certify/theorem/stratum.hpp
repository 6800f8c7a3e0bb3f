#pragma once
// Statements about a family where some of its parameters are functions of the others, in its own
// coordinates: theorem_certificates.md 12, 13.

#include "certify/theorem/fact.hpp"

namespace kov::certify {

/// The place of a step: the parameters of X that are put in, and the conditions besides.
struct FamilyStratum {
  const Family* family = nullptr;
  ParameterFunctions at;
  Conditions region;

  /// n p - P = 0 for each parameter put in, then the region.
  [[nodiscard]] Conditions conditions() const;
};

/// Parameters of Y that X has not, as functions of the parameters of X that are left.
using LevelValues = std::map<std::string, PhaseFunction>;

/// Refuses unless the system Y is X on the stratum, and what is asked of its parameters holds there for
/// these values of levels, and for some values of the others.
void need_restriction(const FamilyStratum& x, const Target& y, const LevelValues& levels,
                      const Node& shown, Arithmetic& a, std::size_t& nodes_left);

/// First integrals of X on the stratum, independent and in involution, as many as are needed.
[[nodiscard]] ClaimedIntegrals need_integrable(const FamilyStratum& x, Keys& data, Arithmetic& a,
                                               std::size_t& nodes_left);

/// A multiple of f by a number, less multiples of the equations: from the last variable to the first it is
/// divided by the first of those whose last variable this is, with a number as its leading coefficient there.
[[nodiscard]] MPoly modulo_equations(MPoly f, const std::vector<MPoly>& equations, Arithmetic& a);

/// For a writer: the polynomial of which a coefficient is shown not to vanish.  rank: of the bracket, or
/// of the fields.   Errors  Refused
[[nodiscard]] MPoly minor_of(const FamilyStratum& x, const ClaimedIntegrals& c, bool rank,
                             const std::vector<std::size_t>& columns, Arithmetic& a);

} // namespace kov::certify
