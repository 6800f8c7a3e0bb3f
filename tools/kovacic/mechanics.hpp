#pragma once
// The sub-commands on system files share this: one job in a supervised child process, and the
// pieces of text and JSON that several of them print.

#include "integrability/check.hpp"
#include "settings.hpp"

#include <nlohmann/json.hpp>

#include <functional>

namespace kov::cli {

using Json = nlohmann::ordered_json;

/// What a job on a system file leaves behind.
struct Report {
  int exit = exit_decided;
  std::string text;
  Json json;
};

/// Runs `work` in a child process under the limits of the settings.  Input errors are thrown here;
/// a limit that was reached gives an undecided report, an internal error is printed.
[[nodiscard]] Report supervised(const Settings& settings, const std::string& file,
                                const std::function<Report()>& work);

/// --set as the reader of system files wants it.
[[nodiscard]] ParameterValues parameter_values(const Settings& settings);

[[nodiscard]] Json json_of(const LinearSystem& s);
[[nodiscard]] Json json_of(const NormalVariationalEquation& e);
/// p, q, r, variable, parameters, change, ...
[[nodiscard]] Json json_of(const System& s, const AlgebraicOde& ode);
[[nodiscard]] Json json_of(const System& s, const BlockReport& b);
[[nodiscard]] Json json_of(const System& s, const ManifoldReport& m);
[[nodiscard]] Json json_of(const ClaimReport& c);
/// Parameters, relations, the components of the field, the Hamiltonian.
[[nodiscard]] Json json_of_field(const System& s);
/// "integral F3", "darboux G", ...
[[nodiscard]] std::string title_of(const SystemClaim& claim);

} // namespace kov::cli
