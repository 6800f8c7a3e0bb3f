#pragma once
// What a judge has checked, in the words of docs/theory/rules.toml.

#include "proof/text/checked.hpp"

#include <string>
#include <vector>

namespace kov::cli {

/// The steps one after the other: rule, page, what follows, the data, and what was checked.
[[nodiscard]] std::vector<std::string> explained(const std::vector<certify::CheckedStep>& steps);

/// Five lines: the lines of the judge, the rules with their pages, the theorems of the literature (by their ids)
/// with their hypotheses, what is on trust, and the limits of the sentence, as they are given.
[[nodiscard]] std::vector<std::string> needed(const std::vector<certify::CheckedStep>& steps,
                                              const std::vector<std::string>& theorems,
                                              std::size_t trusted, const std::string& limits);

} // namespace kov::cli
