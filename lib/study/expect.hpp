#pragma once
// The claims and [[expect]] blocks of a system file as tests.

#include "study/study.hpp"

#include <span>

namespace kov::study {

struct ExpectationResult {
  std::string file;
  long line = 0;
  std::string name;    ///< source, or what is claimed
  std::string message; ///< what was found instead; empty: it is as expected
};

/// The expectations that these manifolds do not fulfil, in words; empty if one of them is as expected.
/// Requires an expectation read with the same parameter values as they.
[[nodiscard]] std::string unmet(const SystemExpectation& x, std::span<const CurveStudy> manifolds);
/// "A = 1, C = 3/2: non-integrable, group SL2 (Lemma 3)"
/// Given   SystemExpectation said; said.where = {{"A", "1"}}, said.group = "SL2";
/// Example describe(said)  // -> A = 1: the stages, group SL2
[[nodiscard]] std::string describe(const SystemExpectation& x);

/// Each claim must be proved (or refuted, where the file says holds = false), at the values of the first
/// [[expect]]; each of them is asked with its own values.   Errors  InputError
[[nodiscard]] std::vector<ExpectationResult> test_file(const std::string& path,
                                                       const StudyOptions& options = {});

} // namespace kov::study
