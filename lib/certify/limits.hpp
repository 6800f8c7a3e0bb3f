#pragma once
// Sizes above which a certificate is refused: they keep hostile input from running for ever.  The
// Python checker has the same numbers.

#include <cstddef>

namespace kov::certify {

inline constexpr std::size_t max_length = 200001; ///< coefficients of a polynomial
inline constexpr std::size_t max_steps = 1000;
inline constexpr std::size_t max_places = 20000;
inline constexpr double max_work = 4e9;    ///< elementary operations of one series
inline constexpr long max_sym = 200;       ///< m of Sym^m
inline constexpr long max_irregular = 200; ///< nu of a pole of order 2 nu

} // namespace kov::certify
