#pragma once
// Every sentence about a decision: read from its values, never read back.

#include "decide/decide.hpp"

namespace kov {

/// Why the answer holds, or "undecided: ..."
[[nodiscard]] std::string reason(const Decision& d);
/// The same with another name for the variable.
[[nodiscard]] std::string reason(const Decision& d, const std::string& variable);
/// Why it was taken back.
[[nodiscard]] std::string to_string(const Withdrawn& why);
/// Why the solutions are not there: "not asked for", or a limit.
[[nodiscard]] std::string to_string(const SolutionsMissing& why);

/// A solution in print: an exponential with its logarithmic derivative, or the minimal polynomial
/// of y'/y over K(z), ascending.
struct PrintedSolution {
  std::string y, omega;
  std::vector<std::string> minimal_polynomial;
  std::string note; ///< what is said of the constants; may be empty
};
/// All of them, of at most `most_bytes` (0: without limit).  Throws OutOfBudget
[[nodiscard]] std::vector<PrintedSolution>
printed_solutions(const Decision& d, std::size_t most_bytes, const Budget& budget = {});

} // namespace kov
