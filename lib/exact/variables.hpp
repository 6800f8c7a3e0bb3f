#pragma once
// Functions and lists of variables.

#include "exact/lists.hpp"
#include "exact/multivariate.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace kov {

/// Whether f uses one of these variables.
/// Given   const Ring plane = make_ring({"x", "y", "z"});
/// Given   const MPoly x = MPoly::variable(plane, 0), y = MPoly::variable(plane, 1);
/// Example uses_any(x*x, std::vector<std::size_t>{0, 2})  // -> yes
template <class F, class Variables = std::vector<std::size_t>>
[[nodiscard]] bool uses_any(const F& f, const Variables& variables) {
  return std::ranges::any_of(variables, [&](std::size_t i) { return uses(f, i); });
}
/// Whether one of these functions uses the variable.
/// Example any_uses(std::vector{x, y}, 2)  // -> no
template <class Functions>
[[nodiscard]] bool any_uses(const Functions& functions, std::size_t variable) {
  return std::ranges::any_of(functions, [&](const auto& f) { return uses(f, variable); });
}
/// Whether f uses no variables but these.
/// Example uses_only(x*x, std::vector<std::size_t>{0, 2})  // -> yes
template <class F, class Variables = std::vector<std::size_t>>
[[nodiscard]] bool uses_only(const F& f, const Variables& variables) {
  return std::ranges::all_of(used_variables(f),
                             [&](std::size_t i) { return is_among(i, variables); });
}

/// The variables of which these functions use some, each once, as they come.
/// Example used_by_any(std::vector{y, x*y})  // -> {1, 0}
template <class Functions>
[[nodiscard]] std::vector<std::size_t> used_by_any(const Functions& functions) {
  std::vector<std::size_t> all;
  for (const auto& f : functions)
    add_each_once(all, used_variables(f));
  return all;
}

/// The coefficients of f by the powers of these variables that are not 0: f = 0 for all values of them exactly
/// where these are.
/// Example nonzero_coefficients(x*y + y*y + x, {0})  // -> {y^2, y + 1}
[[nodiscard]] inline std::vector<MPoly>
nonzero_coefficients(const MPoly& f, const std::vector<std::size_t>& variables) {
  std::vector<MPoly> parts{f};
  for (const std::size_t i : variables) {
    std::vector<MPoly> finer;
    for (const MPoly& part : parts)
      for (MPoly& c : coefficients(part, i))
        if (!is_zero(c)) finer.push_back(std::move(c));
    parts = std::move(finer);
  }
  return parts;
}

/// g with f = g(x_i^k).  Requires that x_i occurs in no other way.
/// Example in_power(MFraction(x*x + y), 0, 2)  // -> x + y
[[nodiscard]] inline MFraction in_power(const MFraction& f, std::size_t i, std::size_t k) {
  if (k == 1 || !uses(f, i)) return f;
  const auto lowered = [&](const MPoly& p) {
    MPoly sum(p.ring());
    const auto c = coefficients(p, i);
    for (std::size_t e = 0; e < c.size(); e += k)
      sum += c[e] * pow(MPoly::variable(p.ring(), i), e / k);
    return sum;
  };
  return MFraction(lowered(f.num()), lowered(f.den()));
}
/// The largest k for which this can be done with all of them; 0 if x_i occurs in none.
[[nodiscard]] inline std::size_t common_power(const std::vector<MFraction>& all, std::size_t i) {
  std::size_t k = 0;
  for (const MFraction& f : all)
    for (const MPoly& p : {f.num(), f.den()})
      for (long t = 0; t < p.length(); ++t)
        k = std::gcd(k, p.exponents(t)[i]);
  return k;
}

} // namespace kov
