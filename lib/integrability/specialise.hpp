#pragma once
// A system at special values of its parameters, which may depend on the other parameters.

#include "integrability/check.hpp"

namespace kov {

/// The parameters of `values` replaced everywhere that check_manifold looks at, and removed from
/// the list of parameters.  Errors  DomainError: something has no value there
[[nodiscard]] System at_values(const System& s, const Substitution& values);
[[nodiscard]] ManifoldSpec at_values(const ManifoldSpec& spec, const Substitution& values);
[[nodiscard]] std::vector<ClaimReport> at_values(std::vector<ClaimReport> claims,
                                                 const Substitution& values);

} // namespace kov
