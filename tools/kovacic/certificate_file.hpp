#pragma once
// Commands that answer many questions write their certificates into a directory.

#include "settings.hpp"

#include <string>

namespace kov::cli {

/// Writes DIR/name.json, DIR = --certificate, and returns the path.  What cannot stand in the name
/// of a file becomes '-'.  Throws InputError if the file cannot be written.
std::string file_certificate(const Settings& settings, const std::string& name,
                             const std::string& json);

} // namespace kov::cli
