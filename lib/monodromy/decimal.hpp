#pragma once
// Enclosures as decimal numbers; what the rounding to decimals loses is part of the radius.

#include "monodromy/ball_matrix.hpp"
#include "monodromy/point.hpp"

#include <string>
#include <utility>

namespace kov::monodromy {

/// Digits behind the point that are written for an accuracy of 10^-digits.
[[nodiscard]] constexpr long written_digits(long digits) { return digits + 3; }

/// The midpoint, real and imaginary part, rounded to written_digits(digits).
[[nodiscard]] std::pair<std::string, std::string> decimals(const acb_struct* z, long digits);
/// An upper bound "2.1e-34" of |entry - decimals| for every entry.
[[nodiscard]] std::string decimal_radius(const BallMatrix& m, long digits);
/// A dyadic point, all digits.
[[nodiscard]] std::pair<std::string, std::string> exact_decimals(const Point& p);

} // namespace kov::monodromy
