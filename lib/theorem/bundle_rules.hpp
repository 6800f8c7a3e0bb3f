#pragma once
// The members of the steps `splitting` and `lowest-order` (docs/theory/theorem_certificates.md 6, 7).

#include "splitting/perturbation.hpp"
#include "theorem/bundle_family.hpp"

namespace kov {

/// small: the three parameters that are made small.
/// Errors  DomainError: there is no rule for it, or no proof is found that a sum of residues is not 0; OutOfBudget
[[nodiscard]] Json::Object splitting_members(const BundleFamily& y, const EulerPerturbation& p,
                                             const std::vector<std::string>& small,
                                             const std::vector<Condition>& region,
                                             const Budget& budget);

/// All but `of`.  weights: of the coordinates, in the ring of the system
/// Errors  DomainError: what is not shown; OutOfBudget
[[nodiscard]] Json::Object lowest_order_members(const BundleFamily& whole, const BundleFamily& low,
                                                const Weights& weights, const Budget& budget);

/// The names stand for themselves, or for their values.
[[nodiscard]] PlaceMap identity_map(const System& s);

} // namespace kov
