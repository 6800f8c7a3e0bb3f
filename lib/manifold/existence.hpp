#pragma once
// Is there a phase curve for the functions that the symbols stand for?
//
// Only the gradient and the relations of a symbol are known, so that a point of the ideal belongs
// to *some* functions with these gradients: u = 2 v has points, and none if both are exp(x).
//
// docs/theory/mechanics.md (1)

#include "manifold/invariant_manifold.hpp"

namespace kov {

/// The symbols for which a point of the phase curve was not proved to exist, as "u, v"; empty: the
/// curve has points whatever functions with these gradients and relations are meant.
[[nodiscard]] std::string unchecked_functions(const VectorField& v, const InvariantManifold& m);

/// The hypothesis that is open then, "that the phase curve has points for the functions meant by u";
/// empty: none is.
[[nodiscard]] std::string existence_not_checked(const VectorField& v, const InvariantManifold& m);
/// The same of unchecked_functions().
[[nodiscard]] std::string existence_not_checked(const std::string& functions);

/// A sine, cosine, exponential, ... whose argument is 0 all along the curve, and which does not have
/// its value there: "cos(a*q) is 1 there, and c is not".  The curve has no points then.  Empty: none.
[[nodiscard]] std::string contradicted_function(const VectorField& v, const InvariantManifold& m);

} // namespace kov
