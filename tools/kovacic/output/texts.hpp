#pragma once
// The files of tools/kovacic/texts, which are part of the program.

#include <string_view>
#include <vector>

namespace kov::cli {

/// "" if there is none.
/// Example text_file("new/scan.toml").starts_with("#")  // -> yes
[[nodiscard]] std::string_view text_file(std::string_view name);
/// The names of all, with their folders.
[[nodiscard]] std::vector<std::string_view> text_files();

} // namespace kov::cli
