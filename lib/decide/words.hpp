#pragma once
// Every sentence about a decision: read from its values, never read back.

#include "decide/decide.hpp"

namespace kov {

/// Why the answer holds, or "undecided: ..."
[[nodiscard]] std::string reason(const Decision& d);
/// The same with another name for the variable.
[[nodiscard]] std::string reason(const Decision& d, const std::string& variable);
/// In the place of a step: what is said of all of them.
inline constexpr int whole_algorithm = -1;
/// "case 1, step 2, families": of a line of the derivation.
[[nodiscard]] std::string name(const kovacic::Step& s);
/// Why it was taken back.
[[nodiscard]] std::string to_string(const Withdrawn& why);
/// Why the solutions are not there: "not asked for", or a limit.
[[nodiscard]] std::string to_string(const SolutionsMissing& why);

/// A solution in print: an exponential with its logarithmic derivative, or the minimal polynomial
/// of y'/y over K(z), ascending.
struct PrintedSolution {
  std::string y, omega;
  std::vector<std::string> minimal_polynomial;
};
/// All of them, in order, of at most `most_bytes` (0: without limit).  Throws OutOfBudget
[[nodiscard]] std::vector<PrintedSolution>
printed_solutions(const Decision& d, std::size_t most_bytes, const Budget& budget = {});

} // namespace kov
