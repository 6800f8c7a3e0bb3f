#pragma once
// 1/2, which exponents of classical equations are full of.

#include "exact/integer.hpp"

namespace kov {

/// Example half + half  // -> 1
inline const Rational half(1, 2);

} // namespace kov
