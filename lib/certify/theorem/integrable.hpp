#pragma once
// Enough first integrals of a family where some of its parameters are functions of the others:
// theorem_certificates.md 13.

#include "certify/theorem/fact.hpp"

namespace kov::certify {

/// A multiple of f by a number, less multiples of the equations: from the last variable to the first it is
/// divided by the first of those whose last variable this is, with a number as its leading coefficient there.
[[nodiscard]] MPoly modulo_equations(MPoly f, const std::vector<MPoly>& equations, Arithmetic& a);

/// For a writer: the polynomial of which a coefficient is shown not to vanish.  rank: of the bracket, or
/// of the fields.   Errors  Refused
[[nodiscard]] MPoly minor_of(const StepPlace& x, const ClaimedIntegrals& c, bool rank,
                             const std::vector<std::size_t>& columns, Arithmetic& a);

} // namespace kov::certify
