#pragma once
// Hamiltonian systems on e(3)*: rigid bodies with coordinates M, Gamma.
//
// Source  docs/theory/moves.md (3)

#include "system/system.hpp"

#include <array>

namespace kov {

/// H = (M1^2/A + M2^2/B + M3^2/C)/2 + ..., in coordinates with the bracket of e(3) or its negative; A, B, C
/// are different, and each is positive: a number times powers of parameters that have signs.
struct FreeBody {
  std::array<std::size_t, 6> coordinates; ///< M1 M2 M3 Gamma1 Gamma2 Gamma3
  std::array<MFraction, 3> moments;       ///< A, B, C
};

/// Unset: the system is none, or has function symbols.
[[nodiscard]] std::optional<FreeBody> free_body(const System& s);
/// Is the bracket that of e(3), or its negative, which is that of the time that runs backwards?
[[nodiscard]] bool has_bracket_of_e3(const VectorField& v);
/// 1 or -1: the file says that it is positive or negative; 0: it says neither.
[[nodiscard]] int assumed_sign(const System& s, std::size_t parameter);
/// The sign of a number times powers of parameters that have signs; 0: p is another polynomial.
[[nodiscard]] int sign_of_monomial(const System& s, const MPoly& p);

} // namespace kov
