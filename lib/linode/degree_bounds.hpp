#pragma once
// Closed-form degree bounds from local data alone: often they settle an equation with no algebra.
//
//   D_1  the largest degree of P in an exponential solution y = P prod (z-c)^alpha_c exp(...)
//   D_m  the largest degree of P in a rational solution v = P prod q^e_q of the m-th symmetric
//        power
//
// Source  docs/theory/local_exponents.md, 2 to 4

#include "linode/singularities.hpp"

#include <string>
#include <vector>

namespace kov {

/// Why the exponents at the places leave no solution: local_exponents.md, 2.2 and 3.2.
struct Obstruction {
  enum class Kind : std::uint8_t {
    odd_order,            ///< of r at `place`: no exponential solution (3.1)
    no_integral_exponent, ///< of Sym^m at `place` (2.1)
    negative_degree       ///< `degree` < 0 of the polynomial part
  };
  Kind kind = Kind::negative_degree;
  long m = 1;         ///< of the symmetric power; 1: exponential solutions
  PlaceIndex place{}; ///< where it is seen; negative_degree: not used
  Integer degree{};   ///< the bound D_m, for negative_degree
};

/// The necessary form of an exponential solution.
struct ExponentialShape {
  std::optional<Obstruction> obstruction{}; ///< set: there is none
  long denominator = 0;                     ///< N_den = sum deg q max(1, nu_q)
  long degree = 0;                          ///< D_1; negative = impossible
  long nu_infinity = 0; ///< degree of the polynomial part of y'/y, 0 if infinity is not irregular
};

/// The necessary form of a rational solution of Sym^m.  Shape: e parallel to Singularities::finite.
struct InvariantShape {
  long m = 0;
  std::optional<Obstruction> obstruction{}; ///< set: there is none but 0
  std::vector<long> e;                      ///< least admissible integer exponents
  long tau = 0;                             ///< greatest admissible growth exponent at infinity
  long degree = 0;                          ///< D_m = tau - sum deg q e_q; negative = impossible
};

/// The shape of every exponential solution of the equation of s, or why there is none.
/// Cost    one enclosure of each irrational exponent difference
/// Source  docs/theory/local_exponents.md, 3
/// Given   const Singularities airy = singularities(z);
/// Example exponential_shape(singularities(z*z + 3)).degree  // -> 1
/// Example to_string(*exponential_shape(airy).obstruction, airy)
///         // -> the order of r at infinity is odd (-1), so that no exponential solution exists
[[nodiscard]] ExponentialShape exponential_shape(const Singularities& s);
/// The same for the rational solutions of Sym^m.
/// Requires m even, m >= 2.
/// Source  docs/theory/local_exponents.md, 2
/// Example invariant_shape(singularities(RationalFunction(2, z*z)), 2)  // -> {2, none, {-2}, 4, 6}
[[nodiscard]] InvariantShape invariant_shape(const Singularities& s, long m);

/// An upper bound of the sum of |Re Delta_c| (or |Re eps_c|) over all roots c of the place, with
/// 2^-40 to spare; exact when the exponent difference is rational.
[[nodiscard]] Rational real_part_sum(const Singularity& s);

/// A place named for people: "z^2 - 2 = 0", "z = 1", "infinity".
[[nodiscard]] std::string place_name(const Singularity& s, const std::string& variable = "z");
/// "the order of r at z = 1 is odd (3), so that no exponential solution exists", ...
[[nodiscard]] std::string to_string(const Obstruction& o, const Singularities& s,
                                    const std::string& variable = "z");

} // namespace kov
