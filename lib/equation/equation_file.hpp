#pragma once
// Equation files (format "equation/1"): the [ode] table, assumptions, expectations.

#include "equation/question.hpp"
#include "symbol/document.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace kov {

/// One [[expect]] block: what a source claims.
struct EquationExpectation {
  std::vector<std::pair<std::string, Expression>> where; ///< values of parameters
  std::optional<std::string> outcome; ///< exponential, imprimitive, algebraic, no-liouvillian
  std::optional<std::string> group;
  std::optional<std::string> identity_component;
  std::optional<std::string> abelian; ///< yes, no, undecided
  std::optional<long> kovacic_case;
  std::string source;
  Entry entry; ///< for messages
};

struct EquationFile {
  std::string path;
  std::string title;
  std::vector<std::string> cite;
  AskedEquation asked;
  std::vector<std::pair<std::string, std::string>> assume; ///< quoted in the answer
  std::vector<EquationExpectation> expect;
};

/// Does the document describe a scalar equation (an [ode] table), and not a system?
/// Given   const Entry airy =
///             parse_document("format = 'equation/1'\n[ode]\nr = 'z'\n", "airy.toml");
/// Example is_equation_file(airy)  // -> yes
[[nodiscard]] bool is_equation_file(const Entry& document);

/// Errors  InputError: a wrong format, unknown keys (with the nearest known one), wrong types
/// Example read_equation(read_equation_file(airy).asked.text).normal_form.r  // -> z
/// Example read_equation_file(parse_document("ode = {R = 'z'}", "wrong.toml")).path
///         // -> throws InputError
[[nodiscard]] EquationFile read_equation_file(const Entry& document);

} // namespace kov
