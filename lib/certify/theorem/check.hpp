#pragma once
// The judge of certificates of a theorem, kovacic-theorem/1: docs/theory/theorem_certificates.md.
// It links lib/exact only and searches for nothing.

#include "certify/equation/check.hpp"
#include "literature/integral_class.hpp"

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace kov::certify {

struct TheoremAccepted {
  std::vector<std::string> theorems; ///< ids of those of the literature, used and not proved here
  std::size_t unchecked = 0;         ///< hypotheses of these that nothing checks
  std::size_t trusted = 0;           ///< steps that nothing repeats
  std::size_t open = 0;              ///< regions of which nothing is said
  std::vector<std::string> statement;
  std::vector<IntegralClass> excluded; ///< the statement says "not integrable" with these at once
};

/// Throws InvalidArgument on what is not a certificate of this format.  Rejected::step is the step
/// with its rule.
/// Cost  counted polynomial products (Arithmetic), of all steps together
[[nodiscard]] std::variant<TheoremAccepted, Rejected> check_theorem(std::string_view text);

} // namespace kov::certify
