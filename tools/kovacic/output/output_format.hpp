#pragma once
// The format of a report.

#include "process/settings.hpp"

#include <string>

namespace kov::cli {

/// --format, or what the name of the output file says: "text", "html", "tex", "json".
[[nodiscard]] std::string output_format(const Settings& settings);

} // namespace kov::cli
