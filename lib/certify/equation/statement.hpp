#pragma once
// The statement of an accepted certificate, as lines of text made from the parsed data alone:
// docs/theory/certificates.md 4 and strata_certificates.md 8.  The Python checker prints the same.

#include "certify/strata/check.hpp"

namespace kov::certify {

[[nodiscard]] std::vector<std::string> statement(const Certificate& c);
[[nodiscard]] std::vector<std::string> statement(const StrataCertificate& c,
                                                 const StrataAccepted& found);

/// The data of a step, in formulas: "omega = (1)/(z) + p'/p, p = z^2 + 1".
[[nodiscard]] std::string shown(const Rule& rule);

/// "y'' = (num/den) y", with the parentheses that it needs.
/// Example equation_text("z + a", "1")  // -> y'' = (z + a) y
/// Example equation_text("-3/16", "z^2")  // -> y'' = ((-3/16)/z^2) y
[[nodiscard]] std::string equation_text(const std::string& num, const std::string& den);

/// f in K[z]; the generator is called a.
[[nodiscard]] std::string over_field(const Poly& f);

/// A text of others in quotes; what is not printable ASCII becomes one '?' for each character.
[[nodiscard]] std::string quoted(const std::string& text);

} // namespace kov::certify
