#pragma once
// A scene with a scan, from the simulation to its files.

#include "flow/scene/scan.hpp"
#include "sections/section.hpp"

namespace kov::cli {

/// Returns the exit code.  Throws InputError.
int scan_section(const std::string& file, const flow::SystemScene& scene, const Settings& settings,
                 const SectionArguments& arguments, double seconds);

} // namespace kov::cli
