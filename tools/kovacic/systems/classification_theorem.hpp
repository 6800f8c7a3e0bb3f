#pragma once
// A classification as a theorem file, and as one certificate.

#include "commands.hpp"
#include "study/classification.hpp"
#include "systems/mechanics.hpp"
#include "theorem/theorem.hpp"

#include <functional>

namespace kov::cli {

/// Where the system of a formula is written: "t.system.toml" beside "t.toml".
[[nodiscard]] std::string system_file_beside(const std::string& theorem_file);

/// The report of the classification as it is now; of a page: with the steps that were proved again.
using ReportAgain = std::function<Report(const TheoremResult*)>;

/// Proves again what was found, as the theorem that --as-theorem writes: its class of first integrals and its steps
/// on trust are those of the certificate, and every output tells them.  Writes what --as-theorem and
/// --certificate ask for; what came of it is told in the report.  What our own judge refuses is withdrawn.
/// Errors  Contradiction, InputError; other errors are told: there is no certificate
void prove_again(const Settings& settings, const ClassifyArguments& arguments, const System& s,
                 SystemClassification& c, Report& report, const ReportAgain& again);

} // namespace kov::cli
