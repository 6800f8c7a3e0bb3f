#pragma once
// y'' = r y with SL(2) is not solved by quadratures, but perhaps by functions with a name:
//
//   y = sqrt(h) (A u(f) + B u'(f)),   u'' = R(x) u,   A, B, f, h in K(z),
//
// for R of Airy, Bessel, Weber, Whittaker or Riemann.
//
// Source  docs/theory/pullback.md, with proofs

#include "closed/classical.hpp"
#include "linode/singularities.hpp"

#include <optional>

namespace kov {

struct SpecialSolution {
  Classical family = Classical::airy;
  RationalFunction standard; ///< R, in its variable x
  RationalFunction f;        ///< x = f(z)
  Poly h = Poly(1);          ///< squarefree
  RationalFunction a, b;     ///< A and B
};

/// Nothing found proves nothing.  f has degree at most 6 in Riemann's equation and two of the
/// fibres above 0, 1, infinity consist of places where D is not an integer or there is a logarithm.
/// A solution that is found has passed `satisfies`.
/// Throws  OutOfBudget
/// Example special_solution(singularities(z))->family  // -> Airy
[[nodiscard]] std::optional<SpecialSolution> special_solution(const Singularities& s,
                                                              const Budget& budget = {});

/// y'' = r y, by differentiating y twice with u'' = R u: an identity in K(z) for each of u, u'.
[[nodiscard]] bool satisfies(const SpecialSolution& y, const RationalFunction& r);

} // namespace kov
