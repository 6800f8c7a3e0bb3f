// kovacic prove FILE: a theorem file, step by step, and its report.

#include "theorem/prove.hpp"
#include "certificate_file.hpp"
#include "commands.hpp"
#include "exact/error.hpp"
#include "mechanics.hpp"
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

// --certificate DIR: the certificates of the steps, as ID.json, ID-2.json, ...
void write_certificates(const Settings& settings, const TheoremResult& result) {
  if (settings.certificate.empty()) return;
  make_directory(settings.certificate);
  for (const NodeResult& n : result.nodes)
    for (std::size_t i = 0; i < n.certificates.size(); ++i)
      file_certificate(settings, n.node.id + (i == 0 ? "" : "-" + std::to_string(i + 1)),
                       n.certificates[i]);
}

int run(const Settings& settings, const Theorem& theorem) {
  ProveOptions options;
  options.decide = settings.solver_options();
  if (!settings.quiet && isatty(STDERR_FILENO) != 0)
    options.progress = [](const NodeResult& n) {
      fmt::print(stderr, "{:9} {:5.1f} s  {}\n", to_string(n.status), n.seconds,
                 n.node.title.empty() ? n.node.id : n.node.title);
    };
  const TheoremResult result = kov::prove(theorem, options);
  write_certificates(settings, result);
  write_output(settings, rendered(result, format_of(settings)));
  if (settings.verbose > 0) fmt::print(stderr, "{:.1f} s\n", result.seconds);
  if (result.count(NodeStatus::refuted) > 0) return exit_no;
  return result.complete() ? exit_decided : exit_undecided;
}

} // namespace

int prove(const Settings& settings, const std::string& file) {
  return run(settings, read_theorem(read_document(file)));
}

// A system file by itself: its claims and its verdict, in the same form.
int report_system(const Settings& settings, const std::string& file) {
  const Entry document = read_document(file);
  if (is_theorem_document(document)) return prove(settings, file);
  const System s = read_system(document, parameter_values(settings));
  const auto slash = file.rfind('/');
  TheoremNode verdict, claims;
  verdict.id = "verdict";
  verdict.title = "The verdict";
  verdict.statement = "The variational equations along " +
                      std::string(s.manifolds.size() == 1 ? "the manifold" : "each manifold") +
                      " of the file.";
  verdict.kind = NodeKind::case_file;
  verdict.expect = "any";
  verdict.manifold = settings.manifold;
  claims.id = "claims";
  claims.title = "The claims";
  claims.statement = "First integrals, Casimir functions and identities that the file claims.";
  claims.kind = NodeKind::claims;
  Theorem t{file, s.title, "A report on the system file " + file + ".", s.cite, {}};
  for (TheoremNode* n : {&verdict, &claims}) {
    n->file = slash == std::string::npos ? file : file.substr(slash + 1);
    n->where = parameter_values(settings);
  }
  if (!s.manifolds.empty()) t.nodes.push_back(verdict);
  if (!s.claims.empty()) t.nodes.push_back(claims);
  if (t.nodes.empty()) throw document.error("the file has neither claims nor manifolds");
  if (t.nodes.size() == 2) t.nodes[0].needs = {"claims"};
  return run(settings, t);
}

} // namespace kov::cli
