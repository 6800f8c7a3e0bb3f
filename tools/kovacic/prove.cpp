// kovacic prove FILE: a theorem file, step by step, and its report.

#include "theorem/prove.hpp"
#include "commands.hpp"
#include "exact/error.hpp"
#include "report/render_theorem.hpp"
#include "settings.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <unistd.h>

namespace kov::cli {
namespace {

// --format, or what the name of the output file says.
std::string format_of(const Settings& settings) {
  for (const char* ending : {"html", "tex", "json"})
    if (settings.format == "text" && settings.output.ends_with(std::string(".") + ending))
      return ending;
  return settings.format;
}

std::string rendered(const TheoremResult& t, const std::string& format) {
  if (format == "json") return report::theorem_json(t);
  if (format == "tex") return report::theorem_tex(t);
  if (format == "html") return report::theorem_html(t);
  return report::theorem_text(t);
}

} // namespace

int prove(const Settings& settings, const std::string& file) {
  const Theorem theorem = read_theorem(read_document(file));
  ProveOptions options;
  options.decide = settings.solver_options();
  if (!settings.quiet && isatty(STDERR_FILENO) != 0)
    options.progress = [](const NodeResult& n) {
      fmt::print(stderr, "{:9} {:5.1f} s  {}\n", to_string(n.status), n.seconds,
                 n.node.title.empty() ? n.node.id : n.node.title);
    };
  const TheoremResult result = kov::prove(theorem, options);
  write_output(settings, rendered(result, format_of(settings)));
  if (settings.verbose > 0) fmt::print(stderr, "{:.1f} s\n", result.seconds);
  if (result.count(NodeStatus::refuted) > 0) return exit_no;
  return result.complete() ? exit_decided : exit_undecided;
}

} // namespace kov::cli
