#pragma once
// Equations whose solutions have names, and what y'' = r y becomes of them by x = f(z).

#include "closed/classical.hpp"
#include "exact/budget.hpp"
#include "linode/singularities.hpp"

#include <functional>

namespace kov::pullback {

/// u'' = r(x) u in x = f(z): one pair that may be tried.
struct Candidate {
  Classical family = Classical::airy;
  RationalFunction standard; ///< r(x)
  RationalFunction f;
};

/// Told of each candidate; true ends the search.
using Try = std::function<bool(const Candidate&)>;

/// f'^2 r(f) - S(f)/2, S the Schwarzian: of u(f)/sqrt(f').  Requires f not constant.
/// Example pulled_back(z, z*z)  // -> (16*z^6 + 3)/(4*z^2)
[[nodiscard]] RationalFunction pulled_back(const RationalFunction& r, const RationalFunction& f);

/// y'' = a x y: f^3 is known from the principal parts of the square root of r.
bool try_airy(const Singularities& s, const Try& tell, const Budget& budget);
/// y'' = (1/x + c/x^2) y: half of each principal part of f is known, and its zeros.
bool try_bessel_of_root(const Singularities& s, const Try& tell, const Budget& budget);
/// y'' = (a + b/x + c/x^2) y, and Weber's equation where f is a square.
bool try_whittaker(const Singularities& s, const Try& tell, const Budget& budget);

/// Riemann's equation: the fibres above 0, 1 and infinity consist of places of r, in two of them
/// without exception.
bool try_riemann(const Singularities& s, const Try& tell, const Budget& budget);

} // namespace kov::pullback
