#pragma once
// Is y'' = r y the equation U'' = r1 U after a gauge, y = sqrt(g) (a U + b U'), a, b, g in K(z)?
//
// b sqrt(g) is a product of a solution of the one with one of the other, so that its order at each
// place is bounded by the exponents there; with that, a and b are polynomials of bounded degree and
//
//   2 a' + b'' + (r1 - r) b = 0,   a'' + (r1 - r) a + 2 r1 b' + r1' b = 0
//
// (sqrt(g) in a and b) is a linear system over K.
//
// Source  docs/theory/pullback.md, 1 and 2

#include "linode/singularities.hpp"

#include <optional>

namespace kov::pullback {

struct Gauge {
  Poly g = Poly(1); ///< squarefree
  RationalFunction a, b;
};

/// Nothing found proves nothing: exponents are shifted by at most 64, and at most five places may
/// leave open whether they divide g.
/// Throws  OutOfBudget
/// Given   const RationalFunction airy(z);
/// Example find_gauge(singularities(airy), singularities(airy))->a  // -> 1
[[nodiscard]] std::optional<Gauge> find_gauge(const Singularities& s, const Singularities& s1,
                                              const Budget& budget = {});

} // namespace kov::pullback
