#pragma once
// The common part of several lists of statements: one difference is special.
//
// Source  docs/theory/classify.md (2)

#include "parameters/statement.hpp"

namespace kov {

/// A statement that holds in all parts, each a conjunction: one number is in classes, or rational.  Unset: none
/// is seen.
/// Given   const MFraction a = MFraction::variable(make_ring({"a"}), 0);
/// Given   const Statement halves{SumIn{{a}, {{Rational(1, 2), Rational(2)}}}};
/// Given   const Statement other{SomeIn{{a}, Classes{half_integers}}};
/// Example to_string({*necessary_condition({{halves}, {other}})})  // -> sqrt(a) is in 1/2 + Z
[[nodiscard]] std::optional<SomeIn>
necessary_condition(const std::vector<std::vector<Statement>>& parts);

} // namespace kov
