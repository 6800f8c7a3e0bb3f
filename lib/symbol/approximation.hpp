#pragma once
// The second argument of root(p(x), approx): which of the roots is meant.

#include "exact/algebraic.hpp"
#include "symbol/expression.hpp"

#include <optional>

namespace kov {

/// A rational complex number re + im*I.
struct Point {
  Rational re, im;
};

/// Decimals are allowed here: the point only chooses.  Throws InputError.
[[nodiscard]] Point read_approximation(const Expression& e);
/// The root nearest to p; nothing when two are equally near (as far as 4096 bits tell).
/// Example approximate_text(*nearest_root(roots({-2, 0, 1}), {1, 0}))  // -> 1.41421356
/// Example nearest_root(roots({-2, 0, 1}), {0, 0}).has_value()  // -> no
[[nodiscard]] std::optional<QQbar> nearest_root(const std::vector<QQbar>& all, const Point& p);
/// An approximation of a that chooses a among its conjugates: "1.25992105", "0.5 - 0.866025404*I".
[[nodiscard]] std::string approximate_text(const QQbar& a);

} // namespace kov
