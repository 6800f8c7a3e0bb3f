#pragma once
// The files of lib/report/texts, which are part of the library.

#include <string_view>

namespace kov::report {

/// "" if there is none.
[[nodiscard]] std::string_view text_file(std::string_view name);

} // namespace kov::report
