#pragma once
// Computing with square roots of functions of parameters: names r with r^2 = f, f a function of the
// names before.

#include "exact/multivariate.hpp"

namespace kov {

class Roots {
public:
  using Root = std::pair<std::size_t, MFraction>;
  explicit Roots(std::vector<Root> squares = {}) : squares_(std::move(squares)) {}

  [[nodiscard]] const std::vector<Root>& all() const { return squares_; }
  /// p with r^2 replaced by f, as a fraction.
  [[nodiscard]] MFraction reduced(const MPoly& p) const;
  [[nodiscard]] MFraction reduced(const MFraction& f) const {
    return kov::is_zero(f) ? f : reduced(f.num()) / reduced(f.den());
  }
  [[nodiscard]] bool vanishes(const MFraction& f) const { return is_zero(reduced(f.num())); }
  /// A polynomial without roots that vanishes wherever p does: the product over the conjugates.
  [[nodiscard]] MPoly norm(const MPoly& p) const { return norm_and_factor(p).first; }
  /// The norm, with the polynomial that p must be multiplied by.
  [[nodiscard]] std::pair<MPoly, MPoly> norm_and_factor(const MPoly& p) const;
  [[nodiscard]] bool uses_root(const MFraction& f) const;

private:
  std::vector<Root> squares_; ///< a root may occur in the squares of later ones
};

} // namespace kov
