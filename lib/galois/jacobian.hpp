#pragma once
// Divisor classes on a hyperelliptic curve S^2 = G(x) over F_p, G squarefree of odd degree 2g+1.

#include "exact/budget.hpp"
#include "exact/modular.hpp"

#include <optional>

namespace kov {

[[nodiscard]] NmodPoly remainder(const NmodPoly& a, const NmodPoly& b);
[[nodiscard]] NmodPoly monic(const NmodPoly& f);

/// Mumford's pair: u monic, deg v < deg u <= g, u | v^2 - G; the class of sum (P_i - infinity) over
/// the roots x_i of u with S = v(x_i).  The neutral class is (1, 0).
struct DivisorClass {
  NmodPoly u;
  NmodPoly v;
  friend bool operator==(const DivisorClass&, const DivisorClass&) = default;
};

/// The group of the classes of degree 0.
///
/// Given   const auto mod1009 = [](const Poly& f) { return *PrimeIdeal{1009, 0}.reduce(f); };
/// Given   const Jacobian curve(mod1009(pow(z, 3) + 1));
/// Example curve.order({mod1009(z - 2), mod1009(3)}, {})  // -> 6
/// Example curve.multiply({mod1009(z - 2), mod1009(3)}, 6) == curve.zero()  // -> yes
class Jacobian {
public:
  /// Requires G squarefree of odd degree, p odd.
  explicit Jacobian(NmodPoly g) : g_(std::move(g)), genus_((degree(g_) - 1) / 2) {}

  [[nodiscard]] long genus() const noexcept { return genus_; }
  [[nodiscard]] DivisorClass zero() const;
  /// The class of any pair with u | v^2 - G, reduced (Cantor 1987).
  [[nodiscard]] DivisorClass reduce(DivisorClass d) const;
  [[nodiscard]] DivisorClass add(const DivisorClass& a, const DivisorClass& b) const;
  [[nodiscard]] DivisorClass multiply(const DivisorClass& a, const Integer& n) const;
  /// The order of a class: giant steps over the Hasse-Weil bound (1 + sqrt p)^(2g).
  /// Unset when that bound is beyond 10^9 and the order beyond 4000.
  [[nodiscard]] std::optional<Integer> order(const DivisorClass& a, const Budget& budget) const;

private:
  NmodPoly g_;
  long genus_;
};

} // namespace kov
