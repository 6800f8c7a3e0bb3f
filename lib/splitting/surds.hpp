#pragma once
// Q(x1, ..., xn) with square roots: variables of the ring that stand for one.
//
// s^2 = D with D free of s and of the surds that come later in the list, D no square in the field
// below (the caller's claim; reduce() never divides by an element of norm 0, it throws).  After
// reduce() a value is a polynomial of degree <= 1 in each surd over a denominator without surds,
// and
// == decides equality.

#include "exact/multivariate.hpp"

#include <vector>

namespace kov {

struct SurdSymbol {
  std::size_t variable = 0;
  MFraction square;
};

class SurdField {
public:
  SurdField(Ring ring, std::vector<SurdSymbol> surds);

  [[nodiscard]] const Ring& ring() const noexcept { return ring_; }
  /// The canonical form.   Errors  DomainError when the denominator is zero in the field
  [[nodiscard]] MFraction reduce(const MFraction& f) const;
  [[nodiscard]] bool is_zero(const MFraction& f) const { return kov::is_zero(reduce(f)); }
  /// f with the surd replaced by its negative.
  [[nodiscard]] MFraction conjugate(const MFraction& f, std::size_t variable) const;
  /// The parts of a canonical f = f0 + f1 s.
  [[nodiscard]] std::pair<MFraction, MFraction> parts(const MFraction& f,
                                                      std::size_t variable) const;

private:
  [[nodiscard]] MFraction reduce_powers(const MPoly& f) const;

  Ring ring_;
  std::vector<SurdSymbol> surds_;
};

} // namespace kov
