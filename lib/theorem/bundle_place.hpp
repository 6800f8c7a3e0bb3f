#pragma once
// Changes of variables, as a certificate of a theorem has them (docs/theory/theorem_certificates.md 4).

#include "certify/theorem/fact.hpp"
#include "theorem/bundle_family.hpp"

namespace kov {

/// The rule for the certificate of a system.
/// Errors  DomainError, InvalidArgument
[[nodiscard]] certify::Said said_by(const std::string& certificate);

/// The members MAP of a step, with the values of levels that the map leaves open.
/// Errors  DomainError: what is not shown; OutOfBudget
[[nodiscard]] Json::Object map_members(const BundleFamily& x, const PartPlace& there,
                                       const PlaceMap& map, const certify::Target& y,
                                       const Budget& budget);

} // namespace kov
