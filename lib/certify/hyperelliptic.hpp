#pragma once
// Divisor classes on s^2 = f over F_p, deg f = 2g+1 (one point at infinity): Cantor's algorithm.
// Source  [Cantor1987]; f need not be monic.

#include "exact/modular.hpp"

namespace kov::certify {

/// The sum of the points (x, s(x)) over the roots x of u, minus deg u times infinity; u | s^2 - f.
struct Divisor {
  NmodPoly u, s;
};

class HyperellipticCurve {
public:
  explicit HyperellipticCurve(NmodPoly f) : f_(std::move(f)) {}

  [[nodiscard]] long genus() const { return (degree(f_) - 1) / 2; }
  [[nodiscard]] Divisor zero() const;
  [[nodiscard]] bool is_zero(const Divisor& d) const { return degree(d.u) == 0; }
  /// The reduced divisor (deg u <= g) of the same class.
  [[nodiscard]] Divisor reduce(Divisor d) const;
  [[nodiscard]] Divisor add(const Divisor& a, const Divisor& b) const;
  [[nodiscard]] Divisor multiple(Divisor d, const Integer& k) const; ///< Requires k >= 0.

private:
  NmodPoly f_;
};

/// The model in X = 1/(z - c), Y = s X^(g+1), where c is a root of f and deg f = 2g+2.
[[nodiscard]] NmodPoly send_to_infinity(const NmodPoly& f, mp_limb_t c);
/// The same points in that model.  Refuses if one of them is (c, 0).
[[nodiscard]] Divisor send_to_infinity(const Divisor& d, mp_limb_t c, long genus);

} // namespace kov::certify
