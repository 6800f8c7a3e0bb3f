#pragma once
// A system at a centre c in the variable t, z = c + scale t:
//
//   den_i(t) dY_i/dt = sum_j num_ij(t) Y_j        (the factor `scale` is in num)
//
// Over Q, and for a centre of few bits, the coefficients are exact and short, so that a product of
// a long number by a coefficient costs no more than reading the long number.

#include "monodromy/differential_system.hpp"

namespace kov::monodromy {

/// Ascending coefficients of a polynomial, side by side in memory.
using Coefficients = std::vector<ComplexBall>;

struct LocalRow {
  Coefficients den; ///< den(0) does not contain 0
  std::vector<Coefficients> num;
};

struct LocalSystem {
  std::vector<LocalRow> rows;
  long degree = 0; ///< the largest degree of a coefficient
  [[nodiscard]] long size() const noexcept { return static_cast<long>(rows.size()); }
};

/// A system whose coefficients are embedded in C once, at one precision.
class EmbeddedSystem {
public:
  /// Over Q the coefficients are exact whatever `bits` is.
  EmbeddedSystem(const DifferentialSystem& s, long bits);

  [[nodiscard]] long size() const noexcept { return static_cast<long>(rows_.size()); }
  /// Coefficients longer than `bits` bits are rounded.  Requires c and scale exact (dyadic).
  /// Errors  Imprecise when den_i(c) cannot be told from 0
  [[nodiscard]] LocalSystem at(const ComplexBall& c, const Ball& scale, long bits) const;

private:
  std::vector<LocalRow> rows_;
  long precision_;
};

/// f(t + c), by Horner's scheme: additions and products only, so that exact numbers stay exact.
[[nodiscard]] Coefficients shifted(Coefficients f, const ComplexBall& c, long bits);

} // namespace kov::monodromy
