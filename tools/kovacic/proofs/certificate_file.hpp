#pragma once
// Commands that answer many questions write their certificates into a directory.

#include "process/settings.hpp"

#include <string>
#include <string_view>

namespace kov::cli {

/// The same JSON for a reader: a line for each member of an object and for each object in an array;
/// arrays of numbers stay in one line.
[[nodiscard]] std::string laid_out(std::string_view json);

/// What cannot stand in the name of a file becomes '-'; 200 characters at most.
[[nodiscard]] std::string file_name(const std::string& name);

/// The file of the second opinion's certificate, beside the one of the answer: "airy.json" becomes
/// "airy.loops.json".
[[nodiscard]] std::string loops_file(const std::string& certificate);

/// Writes DIR/name.json, DIR = --certificate, and returns the path.  Throws InputError if the file cannot be written.
std::string file_certificate(const Settings& settings, const std::string& name,
                             const std::string& json);

} // namespace kov::cli
