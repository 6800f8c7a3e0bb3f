#pragma once
// The sub-commands on system files share this: one job in a supervised child process, and the
// pieces of text and JSON that several of them print.

#include "equations/answer.hpp"
#include "exact/lists.hpp"
#include "integrability/report.hpp"
#include "integrals/find.hpp"
#include "process/settings.hpp"

#include <nlohmann/json.hpp>

#include <functional>

namespace kov::cli {

using Json = nlohmann::ordered_json;

/// An array with f of each entry: of a function, or a member.
template <std::ranges::input_range All, class F>
[[nodiscard]] Json list_of(const All& all, const F& f) {
  return mapped<Json>(all, f);
}

/// What a job on a system file leaves behind.
struct Report {
  int exit = exit_decided;
  std::string text;
  Json json;
  std::string limit = {};   ///< why there is no answer; empty: there is one
  std::string at_work = {}; ///< on the way: the stage that begins
};
/// The stage of such a report, as a child sends it; empty: it names none, or this is another text.
[[nodiscard]] std::string stage_in(std::string_view early);

/// Jobs on one system file, in a child process under the limits of the settings, each job under its
/// own.  Input errors are thrown here; a limit that was reached gives an undecided report, an
/// internal error is printed.  What a job has said before a limit, Ctrl-C or a crash is in the report.
class FileWorker {
public:
  /// Takes what is known before the end: it is the answer if a limit ends the job.
  using SoFar = std::function<void(const Report&)>;
  /// Runs in the child, which is replaced after a limit.
  using Work = std::function<Report(std::string_view job, const SoFar& so_far)>;

  FileWorker(const Settings& settings, const std::string& file, Work work);
  [[nodiscard]] Report ask(std::string_view job);

private:
  const Settings& settings_;
  std::string file_;
  TextWorker worker_;
};

/// One job.
[[nodiscard]] Report supervised(const Settings& settings, const std::string& file,
                                const std::function<Report()>& work);
/// One job that says on the way what it knows; `limit` of the report then says what ended it.
[[nodiscard]] Report supervised(const Settings& settings, const std::string& file,
                                const std::function<Report(const FileWorker::SoFar&)>& work);

/// Writes the text, or the JSON where that is asked for.  Returns the exit code.
int written_report(const Settings& settings, const Report& report);

/// --set as the reader of system files wants it.
[[nodiscard]] ParameterValues parameter_values(const Settings& settings);

/// As texts.
template <std::ranges::input_range All> [[nodiscard]] Json texts(const All& all) {
  return list_of(all, [](const auto& x) { return to_string(x); });
}
/// Null for none.
[[nodiscard]] Json text_or_null(const std::string& text);
/// "hamiltonian", "casimir" or "integral".
[[nodiscard]] const char* kind_of(const FoundIntegral& f);
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
