#pragma once
// The [[expect]] blocks of a system file.

#include "study/study.hpp"

#include <span>

namespace kov::study {

/// The expectations that these manifolds do not fulfil, in words; empty if one of them is as expected.
/// Requires an expectation read with the same parameter values as they.
[[nodiscard]] std::string unmet(const SystemExpectation& x, std::span<const CurveStudy> manifolds);
/// "A = 1, C = 3/2: non-integrable, group SL2 (Lemma 3)"
/// Given   SystemExpectation said; said.where = {{"A", "1"}}, said.group = "SL2";
/// Example describe(said)  // -> A = 1: the stages, group SL2
[[nodiscard]] std::string describe(const SystemExpectation& x);

} // namespace kov::study
