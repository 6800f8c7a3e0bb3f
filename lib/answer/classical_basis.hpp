#pragma once
// Two solutions of y'' + p y' + q y = 0, p and q in Q(parameters)(z), in functions that have a name:
//
//   x^2 r = C + A x^e                x = z - c    sqrt(x) J, Y (or I, K) of order sqrt(1+4C)/e, at 2 sqrt(-A) x^(e/2)/e
//   x^2 r = A x^3                                 Ai, Bi of A^(1/3) x
//   x^2 r = B x^2 + A x^4                         parabolic cylinder functions D of (4A)^(1/4) x
//   x^2 r = C + B x^e + A x^(2e)                  Kummer's M, U of 2 sqrt(A) x^e/e
//   three regular places                          2F1, Legendre's P and Q
//
// with r = p'/2 + p^2/4 - q, times exp(-1/2 int p).  Functions are called what mpmath calls them: besselj(n, x), hyp1f1(a, b, x),
// hyperu, hyp2f1(a, b, c, x), legenp(n, m, x), legenq, pcfd(n, x), airyai, airybi.
//
// Source  DLMF chapters 9, 10, 12, 13, 14, 15; docs/theory/recognition.md

#include "closed/classical.hpp"
#include "exact/budget.hpp"
#include "symbol/formula.hpp"

#include <optional>
#include <string>
#include <vector>

namespace kov::answer {

struct ClassicalBasis {
  Classical family = Classical::bessel;
  Expression first, second;
  std::vector<MPoly>
      nonzero; ///< of the parameters: the equation is of this family where none vanishes
  std::vector<std::string>
      unless; ///< "n is a negative integer": there the two are not defined, or not independent
};

/// Nothing for other equations, and where exp(-1/2 int p) has no closed form.
/// Cost    one factorisation, and operations with polynomials of degree <= 8 in z
/// Given   const Ring ring = make_ring({"z", "n"});
/// Given   const MFraction x = MFraction::variable(ring, 0), n = MFraction::variable(ring, 1);
/// Given   const MFraction one(ring, Rational(1));
/// Example written(classical_basis(one / x, one - n * n / (x * x), 0)->first)  // -> besselj(n, z)
/// Example written(classical_basis(MFraction(ring), -x, 0)->second)  // -> airybi(z)
[[nodiscard]] std::optional<ClassicalBasis> classical_basis(const MFraction& p, const MFraction& q,
                                                            std::size_t z);

} // namespace kov::answer
