#pragma once
// A system at a centre c in the variable t, z = c + scale t, with Gaussian integer coefficients:
//
//   den_i(t) dY_i/dt = sum_j num_ij(t) Y_j        (the factor `scale` is in num)
//
// Over Q, and for a centre of few bits, the integers are exact and small, so that a product of a
// long number by a coefficient costs no more than reading the long number.  Otherwise they are
// rounded, and `error` bounds what was lost.

#include "monodromy/differential_system.hpp"
#include "monodromy/magnitude.hpp"

namespace kov::monodromy {

/// Ascending coefficients re + i im.
struct GaussianPoly {
  std::vector<Integer> re, im;
  [[nodiscard]] long length() const noexcept { return static_cast<long>(re.size()); }
};

struct LocalRow {
  GaussianPoly den; ///< den(0) != 0
  std::vector<GaussianPoly> num;
  Magnitude error; ///< of every coefficient
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
  /// Requires c and scale exact (dyadic).  The integers have about `bits` bits behind den_i(0).
  /// Errors  Imprecise when den_i(c) cannot be told from 0
  [[nodiscard]] LocalSystem at(const ComplexBall& c, const Ball& scale, long bits) const;

private:
  struct Embedded {
    std::vector<ComplexBall> den;
    std::vector<std::vector<ComplexBall>> num;
  };
  std::vector<Embedded> rows_;
  long precision_;
};

} // namespace kov::monodromy
