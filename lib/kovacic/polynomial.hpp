#pragma once
// Step 3: the polynomial P.
//
// Let theta be the logarithmic derivative that a family prescribes, S a polynomial with S theta =:
// H and S^2 r =: R polynomials.  If f = P exp(int theta) is a product of m solutions of y'' = r y
// (m = 1: a solution), then with
//
//   P_m = -P,   P_{i-1} = -S P_i' + ((m-i) S' - H) P_i - (m-i)(i+1) R P_{i+1},
//
// P_{-1} = 0; conversely P_{-1} = 0 says that f solves the m-th symmetric power, and
//
//   sum_i S^i P_i w^i/(m-i)! = 0   for the logarithmic derivatives w of those solutions.
//
// The paper prints this for m = 4, 6, 12 with S = prod (z - c); the same lines hold for m = 1
// (P'' + 2 theta P' + ...) and m = 2 (P''' + 3 theta P'' + ...) and for every S as above
// (docs/theory/descent.md (6)).  P_{-1} is linear in P: P_{-1} = sum_k a_k P^(k).  The coefficients
// of P follow from the top, one by one, except where the indicial polynomial at infinity vanishes:
// at most m + 1 free ones.  First modulo one prime (no solution there: no solution), then exactly.
//
// Source  [Kovacic1986] §3.1, §4.1, §5.1 step 3; docs/theory/descent.md (6)

#include "exact/budget.hpp"
#include "exact/modular.hpp"
#include "exact/rational_function.hpp"

#include <optional>
#include <vector>

namespace kov::kovacic {

/// The equation for P, for all families of one case.
/// (y'' = (z^2 + 5) y with theta = z: P'' + 2 z P' - 4 P = 0.)
/// Given   PolynomialStep hermite(1, 1, z*z + 5);
/// Example hermite.solutions(z, 2, {})  // -> {z^2 + 1/2}
/// Example hermite.chain(z*z + Rational(1, 2), z).back()  // -> 0
class PolynomialStep {
public:
  /// Requires S^2 r a polynomial.
  PolynomialStep(long m, Poly S, const RationalFunction& r);

  [[nodiscard]] const Poly& S() const noexcept { return S_; }
  /// S*theta.  Requires: a polynomial.
  [[nodiscard]] Poly times_S(const RationalFunction& theta) const;

  /// A basis over K of all P of degree <= d for H = S theta; may be empty.
  ///
  /// Cost  O(d deg S (m+1)) operations modulo one prime when there is none; the same number over K
  ///       otherwise
  [[nodiscard]] std::vector<Poly> solutions(const Poly& H, long d, const Budget& budget);

  /// P_m, ..., P_0, P_{-1} as element m-i, exactly.  A solution has P_{-1} = 0.
  [[nodiscard]] std::vector<Poly> chain(const Poly& P, const Poly& H) const;

private:
  struct Image { // the data modulo a prime ideal of degree one
    PrimeIdeal prime;
    NmodPoly S;
    NmodPoly R;
  };
  [[nodiscard]] const Image& image();

  long m_;
  Poly S_;
  Poly R_;
  PrimeIdeals primes_;
  std::optional<Image> image_;
};

/// The minimal polynomial sum A_i w^i/(m-i)! of w = y'/y over K(z) from a verified chain: monic,
/// ascending coefficients.  Requires chain(P, H) with P_{-1} = 0.
[[nodiscard]] std::vector<RationalFunction> riccati_polynomial(const std::vector<Poly>& chain,
                                                               const Poly& S);

} // namespace kov::kovacic
