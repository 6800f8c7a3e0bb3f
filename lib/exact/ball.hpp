#pragma once
// Certified enclosures: a real or complex midpoint with a proven radius (Arb).

#include "exact/flint.hpp"
#include "exact/integer.hpp"

#include <string>

namespace kov {

/// A real ball; the precision in bits travels with the operations that make it.
class Ball {
public:
  Ball() noexcept { arb_init(v_); }
  Ball(const Ball& o) : Ball() { arb_set(v_, o.v_); }
  Ball(Ball&& o) noexcept : Ball() { arb_swap(v_, o.v_); }
  Ball& operator=(Ball o) noexcept {
    arb_swap(v_, o.v_);
    return *this;
  }
  ~Ball() { arb_clear(v_); }
  [[nodiscard]] const arb_struct* raw() const noexcept { return v_; }
  [[nodiscard]] arb_struct* raw() noexcept { return v_; }

protected:
  arb_t v_;
};

/// A rectangle in the complex plane: a ball for each part.
class ComplexBall {
public:
  ComplexBall() noexcept { acb_init(v_); }
  ComplexBall(const ComplexBall& o) : ComplexBall() { acb_set(v_, o.v_); }
  ComplexBall(ComplexBall&& o) noexcept : ComplexBall() { acb_swap(v_, o.v_); }
  ComplexBall& operator=(ComplexBall o) noexcept {
    acb_swap(v_, o.v_);
    return *this;
  }
  ~ComplexBall() { acb_clear(v_); }
  [[nodiscard]] const acb_struct* raw() const noexcept { return v_; }
  [[nodiscard]] acb_struct* raw() noexcept { return v_; }

private:
  acb_t v_;
};

/// A rational number >= every point of the ball (dyadic, exact).  Requires a finite ball.
/// Given   Ball root; arb_sqrt_ui(root.raw(), 2, 30);
/// Example upper_bound(root) * upper_bound(root) > 2  // -> yes
[[nodiscard]] Rational upper_bound(const Ball& x);
/// A rational number <= every point of the ball.  Requires a finite ball.
/// Example lower_bound(root) * lower_bound(root) < 2  // -> yes
[[nodiscard]] Rational lower_bound(const Ball& x);

} // namespace kov
