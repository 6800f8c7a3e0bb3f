#pragma once
// Polynomials in one variable over the functions on a set of parameters that equations describe: common
// factors that exist there only.  The caller proves what is found.

#include "parameters/conditions.hpp"
#include "proof/algebra/arithmetic.hpp"

namespace kov {

/// Given   const Ring plane = make_ring({"w", "t"});
/// Given   const MPoly w = MPoly::variable(plane, "w"), t = MPoly::variable(plane, "t");
/// Given   const MPoly one(plane, Integer(1)), squares = t * t + one;
/// Given   const ModuloStratum there(plane, 0, {{squares, Sign::zero}});
/// Example degree(there.common(w * w + one, w - t), 0)  // -> 1
/// Example degree(there.common(w * w - one, w - t), 0)  // -> 0
class ModuloStratum {
public:
  /// w: the variable; given: what is known of the others.
  ModuloStratum(Ring ring, std::size_t w, const std::vector<Condition>& given);

  [[nodiscard]] bool has_equations() const { return !equations_.empty(); }
  /// Every coefficient is 0 there.
  [[nodiscard]] bool vanishes(const MPoly& f) const;
  /// The greatest common factor there, up to a factor without w.
  [[nodiscard]] MPoly common(MPoly f, MPoly g) const;
  /// q and s, without w, such that s f - q d has a smaller degree than d.
  [[nodiscard]] std::pair<MPoly, MPoly> divided(const MPoly& f, const MPoly& d) const;
  /// q, the number n of divisions and s such that s f - q d^n vanishes there, with the largest n.
  struct DivisorPower {
    MPoly rest, scale;
    long order = 0;
  };
  [[nodiscard]] DivisorPower order(MPoly f, const MPoly& d) const;
  /// f without factors that do not contain w.
  [[nodiscard]] MPoly primitive(const MPoly& f) const;
  [[nodiscard]] MPoly content(const MPoly& f) const;

private:
  [[nodiscard]] MPoly lead(const MPoly& f) const;
  [[nodiscard]] MPoly power_of_w(std::size_t e) const;
  /// Without leading terms that are 0 there, up to a number.
  [[nodiscard]] MPoly stripped(const MPoly& f) const;

  Ring ring_;
  std::size_t w_;
  std::vector<MPoly> equations_;
};

} // namespace kov
