#pragma once
// For the meter: about how long a polynomial is, at no cost.

#include "exact/flint.hpp"

#include <flint/fmpz_mpoly.h>

namespace kov {

/// Terms, each as long as the first number in machine words.
[[nodiscard]] inline double quick_size(const fmpz_mpoly_struct* f) noexcept {
  const double words = f->length > 0 ? static_cast<double>(fmpz_size(f->coeffs)) : 1;
  return static_cast<double>(f->length) * (words > 1 ? words : 1);
}

} // namespace kov
