#pragma once
// Several solutions of one system, each with what it excludes, as one theorem.
//
// Source  docs/theory/classify.md (1, 7)

#include "study/exclusion.hpp"

#include <stop_token>

namespace kov {

/// Each exclusion is cut out of what those before it have left; the rest is open.  Every point of the
/// parameter space is in one stratum.
/// Errors  InvalidArgument: contradictory assumptions
/// Given   const System free = read_system(parse_document("system = {kind = 'hamiltonian', "
///             "coordinates = ['q'], momenta = ['p'], parameters = ['a'], "
///             "hamiltonian = 'p^2/2 + a*q^2'}", "free.toml"));
/// Example together(free, {}).strata.size()  // -> 1
[[nodiscard]] SystemClassification together(const System& s, const std::vector<Exclusion>& all,
                                            const std::stop_token& stop = {});

} // namespace kov
