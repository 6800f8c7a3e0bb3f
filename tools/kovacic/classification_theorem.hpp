#pragma once
// A classification as a theorem file, and as one certificate.

#include "commands.hpp"
#include "mechanics.hpp"
#include "study/classification.hpp"

namespace kov::cli {

/// What --as-theorem and --certificate ask for; what came of it is told in the report.
/// Errors  Contradiction, InputError; other errors are told: there is no certificate
void write_theorem(const Settings& settings, const ClassifyArguments& arguments, const System& s,
                   const SystemClassification& c, Report& report);

} // namespace kov::cli
