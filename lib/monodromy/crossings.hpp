#pragma once
// The values of the closed formulas at each Stokes direction, and the numbers they are written in.

#include "exact/ball.hpp"
#include "exact/number_field.hpp"

#include <acb.h>

#include <optional>
#include <vector>

namespace kov::monodromy {

// Complex numbers to one precision.
struct Numbers {
  long bits;

  [[nodiscard]] ComplexBall integer(long n) const {
    ComplexBall z;
    acb_set_si(z.raw(), n);
    return z;
  }
  [[nodiscard]] ComplexBall of(const NfElem& a) const { return embed(a, bits); }
  [[nodiscard]] ComplexBall plus(const ComplexBall& a, const ComplexBall& b) const {
    return made(acb_add, a, b);
  }
  [[nodiscard]] ComplexBall minus(const ComplexBall& a, const ComplexBall& b) const {
    return made(acb_sub, a, b);
  }
  [[nodiscard]] ComplexBall times(const ComplexBall& a, const ComplexBall& b) const {
    return made(acb_mul, a, b);
  }
  [[nodiscard]] ComplexBall over(const ComplexBall& a, const ComplexBall& b) const {
    return made(acb_div, a, b);
  }
  [[nodiscard]] ComplexBall half(const ComplexBall& a) const {
    ComplexBall z = a;
    acb_mul_2exp_si(z.raw(), z.raw(), -1);
    return z;
  }
  [[nodiscard]] ComplexBall root(const ComplexBall& a, ulong k) const {
    ComplexBall z;
    acb_root_ui(z.raw(), a.raw(), k, bits);
    return z;
  }
  [[nodiscard]] ComplexBall power(const ComplexBall& a, const ComplexBall& e) const {
    return made(acb_pow, a, e);
  }
  [[nodiscard]] ComplexBall exp(const ComplexBall& a) const { return made(acb_exp, a); }
  // exp(pi i a)
  [[nodiscard]] ComplexBall turn(const ComplexBall& a) const { return made(acb_exp_pi_i, a); }
  // exp(2 pi i k/n)
  [[nodiscard]] ComplexBall root_of_unity(long k, long n) const {
    return turn(over(integer(2 * k), integer(n)));
  }
  [[nodiscard]] ComplexBall reciprocal_gamma(const ComplexBall& a) const {
    return made(acb_rgamma, a);
  }
  [[nodiscard]] ComplexBall sin_pi(const ComplexBall& a) const { return made(acb_sin_pi, a); }
  [[nodiscard]] ComplexBall to(const ComplexBall& a, ulong k) const {
    ComplexBall z;
    acb_pow_ui(z.raw(), a.raw(), k, bits);
    return z;
  }
  [[nodiscard]] ComplexBall pi() const {
    ComplexBall z;
    acb_const_pi(z.raw(), bits);
    return z;
  }
  [[nodiscard]] ComplexBall i() const {
    ComplexBall z;
    acb_onei(z.raw());
    return z;
  }
  [[nodiscard]] ComplexBall twice_cos_pi(const ComplexBall& a) const {
    const ComplexBall cosine = made(acb_cos_pi, a);
    return plus(cosine, cosine);
  }

private:
  template <class F>
  [[nodiscard]] ComplexBall made(F f, const ComplexBall& a, const ComplexBall& b) const {
    ComplexBall c;
    f(c.raw(), a.raw(), b.raw(), bits);
    return c;
  }
  template <class F> [[nodiscard]] ComplexBall made(F f, const ComplexBall& a) const {
    ComplexBall c;
    f(c.raw(), a.raw(), bits);
    return c;
  }
};

// A solution at the base, and its derivative by the variable of the canonical equation.
struct Value {
  ComplexBall y, slope;
};

// One Stokes direction: the recessive solution R, and a dominant one D; above the direction D is
// D + multiplier R.
struct Crossing {
  Ball angle; // arg x
  Value recessive;
  ComplexBall slope_factor; // d(canonical variable)/dz
  ComplexBall wronskian;    // R D' - R' D in the canonical variable
  ComplexBall multiplier;
  /// D below is this times the recessive solution of the direction before, D above the one of the
  /// next direction divided by it.
  std::optional<ComplexBall> phase = std::nullopt;
};

struct Crossings {
  std::vector<Crossing> all;
  ComplexBall formal_trace; // of the formal monodromy
};

} // namespace kov::monodromy
