#pragma once
// From BigReal to the number of a run.

#include "flow/number/conversions.hpp"

#include <type_traits>

namespace kov::flow {

/// Example rounded<double>(BigReal(0.5))  // -> 0.5
template <class R> [[nodiscard]] R rounded(const BigReal& x) {
  if constexpr (std::is_same_v<R, BigReal>)
    return x;
  else if constexpr (std::is_same_v<R, Twin1>)
    return to_twin(x);
  else if constexpr (std::is_same_v<R, long double>)
    return mpfr_get_ld(x.raw(), MPFR_RNDN);
  else
    return static_cast<double>(x);
}

} // namespace kov::flow
