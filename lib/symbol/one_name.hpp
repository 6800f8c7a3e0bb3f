#pragma once
// Which words of a formula are one name.  People leave out signs: in xy'' = y, sin2x and ax the words are products.

#include <string>
#include <string_view>

namespace kov {

/// A letter or the name of a Greek one (also hbar and ell), with an index: x, y1, x_0, psi, theta12, Omega_m, u_.
/// Every other word may be a product, and is a name only where somebody says so.
/// Example is_one_name("theta1")  // -> yes
/// Example is_one_name("xy")  // -> no
/// Example is_one_name("x2y")  // -> no
[[nodiscard]] bool is_one_name(std::string_view word);

/// The product that a word of several letters may be; sin(...) for sin.
/// Example as_product("xy")  // -> x*y
/// Example as_product("sin2x")  // -> sin(2*x)
/// Example as_product("xpsi1")  // -> x*psi1
[[nodiscard]] std::string as_product(std::string_view word);

} // namespace kov
