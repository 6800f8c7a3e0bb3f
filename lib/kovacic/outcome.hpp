#pragma once
// The possible answers of the algorithm.  Everything is written over the field K of the equation, also
// where the solutions live over an extension of it (docs/theory/descent.md).

#include "exact/rational_function.hpp"
#include "exact/truth.hpp"

#include <cstdint>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace kov::kovacic {

/// Case 1, exactly one exponential line: y = exp(int omega), omega in K(z).
struct Exponential {
  RationalFunction omega;
};

/// Case 1, a diagonal group: v = y1 y2 in K(z), and omega = (v' +- w)/(2v) with w^2 in K, nonzero.
/// The two lines are conjugate over K(w) when w_squared is not a square in K.
struct ExponentialPair {
  RationalFunction v;
  NfElem w_squared;
  bool every_line = false; ///< the group is {1} or {+-1}: every solution is exponential
};

/// Case 2: omega^2 - phi omega + phi'/2 + phi^2/2 - r = 0.
struct Imprimitive {
  RationalFunction phi;
};

/// Case 2 with the quaternion group: the product, of degree 6, of its three quadratics, when they
/// are conjugate over a cubic extension of K (or too many families would separate them).
struct ImprimitiveTriple {
  std::vector<RationalFunction> riccati; ///< monic, ascending
};

enum class Primitive : std::uint8_t { tetrahedral = 4, octahedral = 6, icosahedral = 12 };

/// Case 3: the minimal polynomial of omega over K(z), monic, ascending.  Its degree is 4, 6 or 12;
/// it is 6 for the tetrahedral group when the two orbits of four lines are conjugate over K.
struct Algebraic {
  Primitive group = Primitive::tetrahedral;
  std::vector<RationalFunction> riccati;
};

/// Case 4: the group is SL(2, C).
struct NoLiouvillian {};

using Outcome = std::variant<Exponential, ExponentialPair, Imprimitive, ImprimitiveTriple,
                             Algebraic, NoLiouvillian, Unable>;

/// 1 ... 4; nothing for Unable.
/// Example case_of(NoLiouvillian{})  // -> 4
[[nodiscard]] std::optional<int> case_of(const Outcome& outcome);

} // namespace kov::kovacic
