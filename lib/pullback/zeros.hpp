#pragma once
// The point where f = 0 says what the regular exponent of the standard equation is.

#include "linode/singularities.hpp"
#include "linode/value_at.hpp"

#include <vector>

namespace kov::pullback {

/// A place and the multiplicity of the zero of f there.
struct Zero {
  Singularity place;
  long multiplicity = 1;
};

/// The zeros of f, with what s has there.
/// Throws  OutOfBudget
[[nodiscard]] std::vector<Zero> zeros_of(const RationalFunction& f, const Singularities& s,
                                         const Budget& budget = {});

/// The possible values of D^2 at x = 0 for `multiplicity` D = D(place) + j, 0 <= j < multiplicity, at
/// the zero of least multiplicity.
[[nodiscard]] std::vector<NfElem> squares_at_zero(const std::vector<Zero>& zeros);

/// The same for D + j, 0 <= j < 2 multiplicity.
[[nodiscard]] std::vector<NfElem> squares_and_odd_shifts(const std::vector<Zero>& zeros);

} // namespace kov::pullback
