#pragma once
// HTML files of sections and scans: a page of tools/kovacic/texts with data.  No network, no library.

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace kov::cli {

/// The page with `data` for @DATA@, and the colours for light and dark paper.
[[nodiscard]] std::string data_page(const std::string& name, const std::string& data);
/// For a script element: no character of it can end that.
[[nodiscard]] std::string script_text(const nlohmann::json& j);

} // namespace kov::cli
