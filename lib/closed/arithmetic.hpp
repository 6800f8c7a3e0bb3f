#pragma once
// Statements on numbers, decided at one point of the parameters.
//
// Source  docs/theory/strata.md, 10

#include "exact/poly.hpp"
#include "parameters/statement.hpp"

#include <functional>

namespace kov {

/// The value of a function of the parameters at one point.
using ValueAt = std::function<NfElem(const MFraction&)>;
/// Decided exactly: rational numbers, or roots of polynomials over the field of the values.
/// Throws  what `value` throws
[[nodiscard]] bool is_so(const Statement& s, const ValueAt& value);

/// The same about three numbers that are known together, by (T - x1^2)(T - x2^2)(T - x3^2): those of conjugate
/// places.  A square that is not in Q is that of no rational number.
[[nodiscard]] bool is_so_of_three(const Assertion& s, const Poly& squares);

} // namespace kov
