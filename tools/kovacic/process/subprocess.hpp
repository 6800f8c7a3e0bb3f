#pragma once
// Other programs, found in PATH and started without a shell.

#include <optional>
#include <string>
#include <vector>

namespace kov::cli {

/// Runs a program in a directory, its complaints thrown away: its exit code, or -1 if it cannot be
/// run.
int run_program(const std::vector<std::string>& words, const std::string& directory);
/// What it prints; unset if it cannot be run or fails.
[[nodiscard]] std::optional<std::string> output_of(const std::vector<std::string>& words);

} // namespace kov::cli
