#pragma once
// The claims and [[expect]] blocks of a system file as tests.

#include "integrability/check.hpp"

namespace kov {

struct ExpectationResult {
  std::string file;
  long line = 0;
  std::string name; ///< source, or what is claimed
  bool passed = false;
  std::string message; ///< what was found instead
  double seconds = 0;
};

/// What the report does not fulfil, in words; empty if one of its manifolds is as expected.
/// Requires an expectation read with the same parameter values as the report.
[[nodiscard]] std::string unmet(const SystemExpectation& x, const CheckReport& report);
/// "A = 1, C = 3/2: non-integrable, group SL2 (Lemma 3)"
/// Given   SystemExpectation said; said.where = {{"A", "1"}}, said.group = "SL2";
/// Example describe(said)  // -> A = 1: the stages, group SL2
[[nodiscard]] std::string describe(const SystemExpectation& x);

/// Each claim must be proved (or refuted, where the file says holds = false); each [[expect]] is
/// run with its own parameter values.   Errors  InputError
[[nodiscard]] std::vector<ExpectationResult> test_system_file(const std::string& path,
                                                              const CheckOptions& options = {});

} // namespace kov
