#pragma once
// Formulas of the program's own syntax as LaTeX and MathML; text that is not a formula is escaped.

#include "symbol/written.hpp"

#include <string>

namespace kov::report {

enum class Markup : std::uint8_t { text, tex, html };

/// The formula, or a list of formulas separated by ", ", in mathematical markup.  A text that does not
/// parse is set as text.
[[nodiscard]] std::string formula(const std::string& source, Markup m);
/// One formula on one line, without fractions: for labels of pictures.
[[nodiscard]] std::string label(const std::string& source, Markup m);
/// The text before a formula: a name as a formula ("c12", "x'"), else prose.
[[nodiscard]] std::string heading(const std::string& source, Markup m);
/// Prose with its formulas: "Let mu > 0", "along p_x = 0".
/// Example prose("if mu > 0", Markup::tex)  // -> if $\mu  > 0$
[[nodiscard]] std::string prose(const std::string& source, Markup m);
/// A formula with all its fractions, to stand inside of mathematics; `instead` writes what stands otherwise in an answer.
/// Example in_markup(parse_expression("(-r)*sqrt(n)/exp(2*x)", "f"), Markup::tex)  // -> -\frac{r\, \sqrt{n}}{\exp\left(2\, x\right)}
[[nodiscard]] std::string in_markup(const Expression& e, Markup m, const Instead& instead = {});
/// A letter of formulas: omega_1, p_x.
/// Example tex_name("q1")  // -> q_{1}
[[nodiscard]] std::string tex_name(const std::string& name);
/// Names of files, of steps, and commands, escaped.
[[nodiscard]] std::string verbatim(const std::string& source, Markup m);
/// A formula of a page is whole, unless nobody could read it.
inline constexpr std::size_t longest_on_a_page = 20000;
/// Formulas whose text is longer than this are cut (0: never).
[[nodiscard]] std::string shortened(const std::string& source, std::size_t length);

} // namespace kov::report
