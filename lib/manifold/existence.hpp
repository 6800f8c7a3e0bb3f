#pragma once
// Is there a phase curve for the functions that the symbols stand for?
//
// Of a symbol only its gradient and its relations are known, so that a point of the ideal belongs
// to *some* functions with these gradients: u = 2 v has points, and none if both are exp(x).
//
// docs/theory/mechanics.md (1)

#include "manifold/invariant_manifold.hpp"

namespace kov {

/// The symbols for which a point of the phase curve was not proved to exist, as "u, v"; empty: the
/// curve has points whatever functions with these gradients and relations are meant.
[[nodiscard]] std::string unchecked_functions(const VectorField& v, const InvariantManifold& m);

} // namespace kov
