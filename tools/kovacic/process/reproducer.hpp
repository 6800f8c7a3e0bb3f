#pragma once
// A mistake of the program leaves a file from which it can be repeated.

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace kov::cli {

/// Keeps the command line for the reproducer.
void remember_command(int argc, char** argv);
/// An internal check that failed, a verdict that was withdrawn, two methods that disagree: writes
/// kovacic-reproducer-HASH.json and says on standard error where.  `input` is what no file on the
/// command line holds, e.g. a line of a batch.  Never throws.
void leave_reproducer(const std::string& what, const std::string& input = {});

/// The file as text: format "kovacic-reproducer/1" with the command, the input, the contents of
/// the (small) files that the command names, the version and what happened.
[[nodiscard]] std::string reproducer(const std::vector<std::string>& command,
                                     const std::string& what, const std::string& input);
/// Writes it into the first of the directories that can be written; the path, or "".
[[nodiscard]] std::string write_reproducer(const std::string& text,
                                           const std::vector<std::string>& directories);

} // namespace kov::cli
