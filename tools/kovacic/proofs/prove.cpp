// kovacic prove FILE: a theorem file, step by step, and its report.

#include "theorem/prove.hpp"
#include "commands.hpp"
#include "equations/answer.hpp"
#include "equations/present.hpp"
#include "exact/error.hpp"
#include "process/settings.hpp"
#include "proofs/certificate_file.hpp"
#include "report/render_theorem.hpp"
#include "study/study.hpp"
#include "symbol/given_text.hpp"
#include "systems/mechanics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <unistd.h>

namespace kov::cli {

namespace {

std::string rendered(const TheoremResult& t, const std::string& format, bool verbose) {
  if (format == "json") return report::theorem_json(t);
  if (format == "tex") return report::theorem_tex(t);
  if (format == "html") return report::theorem_html(t);
  return report::theorem_text(t,
                              verbose ? report::TheoremDetail::whole : report::TheoremDetail::tree);
}

// --certificate OUT.json: the whole theorem as one certificate.  What is not proved has none.
void write_bundle(const Settings& settings, const TheoremResult& result) {
  if (result.bundle.empty()) {
    if (!result.complete_but_for_words()) return;
    throw InputError("", 0, 0, 1, settings.certificate + " is not written: " + result.no_bundle,
                     "--certificate DIRECTORY writes the certificates of the steps");
  }
  write_file(settings.certificate, laid_out(result.bundle) + "\n");
}

// --certificate DIR: the certificates of the steps, as ID.json, ID-2.json, ...
void write_certificates(const Settings& settings, const TheoremResult& result) {
  if (settings.certificate.empty()) return;
  if (settings.certificate.ends_with(".json")) return write_bundle(settings, result);
  make_directory(settings.certificate);
  for (const NodeResult& n : result.nodes)
    for (std::size_t i = 0; i < n.certificates.size(); ++i)
      file_certificate(settings, n.node.id + (i == 0 ? "" : "-" + std::to_string(i + 1)),
                       n.certificates[i]);
}

// A manifold that is none is an error of its file.
int exit_of(const TheoremResult& result) {
  if (std::ranges::any_of(result.nodes,
                          [](const NodeResult& n) { return n.found && n.found->refused > 0; }))
    return exit_input;
  if (result.count(NodeStatus::refuted) > 0) return exit_no;
  return result.complete() ? exit_decided : exit_undecided;
}

using ReadTheorem = std::function<Theorem()>; // in the child as well: files may be hostile

// Runs in a child process, whose standard error is not ours: the terminal is `screen`, or -1.
int run_steps(const Settings& settings, const ReadTheorem& read, int screen, std::ostream& out,
              const Worker::Early& early) {
  const std::string format = settings.format;
  ProveOptions options;
  options.decide = settings.solver_options();
  options.progress = [&](const NodeResult& n, const TheoremResult& so_far) {
    if (screen >= 0)
      (void)::dprintf(screen, "%-9s %5.1f s  %s\n", to_string(n.status).c_str(), n.seconds,
                      n.node.title.c_str());
    early(rendered(so_far, format, settings.verbose > 0));
  };
  TheoremResult result = kov::prove(read(), options);
  result.program = program_version() + " with " + libraries();
  write_certificates(settings, result);
  out << rendered(result, format, settings.verbose > 0);
  if (settings.certificate.ends_with(".json") && result.bundle.empty() && format == "text")
    out << settings.certificate << " is not written: the theorem is not proved\n";
  return exit_of(result);
}

int run(const Settings& settings, const std::string& file, const ReadTheorem& read) {
  static_cast<void>(for_children(file));
  const int screen = !settings.quiet && isatty(STDERR_FILENO) != 0 ? ::dup(STDERR_FILENO) : -1;
  const TextAnswer a = limited(settings, [&](std::ostream& out, const Worker::Early& early) {
    return run_steps(settings, read, screen, out, early);
  });
  if (screen >= 0) ::close(screen);
  if (a.error) throw *a.error;
  if (a.exit >= exit_internal) {
    Answer failure;
    failure.exit = a.exit;
    failure.internal = a.internal;
    report_failure(settings, failure);
    if (!a.early.empty()) write_output(settings, a.early); // the steps that were reached
    return a.exit;
  }
  if (!a.limit.empty()) {
    fmt::print(stderr, "{}: {}{}\n", file, a.limit,
               a.early.empty() ? "" : "; the steps that were reached are shown");
    if (a.early.empty()) return exit_undecided;
  }
  write_output(settings, a.limit.empty() ? a.text : a.early);
  return a.exit;
}

} // namespace

int prove(const Settings& settings, const std::string& file) {
  return run(settings, file, [&] { return read_theorem(read_document(file)); });
}

namespace {

std::string at(const ParameterValues& values) {
  std::string text;
  for (const auto& [name, value] : values)
    text += (text.empty() ? " at " : ", ") + name + " = " + value;
  return text;
}

} // namespace

namespace {

// A system file by itself: its claims and its verdict, in the same form.
Theorem theorem_of_system(const Settings& settings, const std::string& file,
                          const Entry& document) {
  const System s = read_system(document, parameter_values(settings));
  Theorem t;
  t.file = file;
  t.title = s.title;
  t.system = file.substr(folder_of(file).size());
  t.cite = s.cite;
  const auto add = [&](NodeKind kind, const std::string& id, const std::string& title,
                       const ParameterValues& where) -> TheoremNode& {
    TheoremNode& n = t.nodes.emplace_back();
    n.kind = kind;
    n.id = id;
    n.title = title;
    n.file = t.system;
    n.where = n.place.at = where;
    return n;
  };
  if (!s.manifolds.empty())
    for (const ParameterValues& where : study::rounds(s, parameter_values(settings))) {
      const std::size_t number = t.nodes.size();
      TheoremNode& verdict = add(NodeKind::case_file,
                                 "verdict" + (number == 0 ? "" : "-" + std::to_string(number + 1)),
                                 "The verdict" + at(where), where);
      verdict.expect = "any";
      verdict.manifold = settings.manifold;
      verdict.order = std::max(settings.order, 1);
    }
  if (!s.claims.empty()) add(NodeKind::claims, "claims", "The claims", parameter_values(settings));
  if (t.nodes.empty())
    throw document.error("the file has neither claims nor manifolds",
                         "kovacic classify finds both and writes pages, too");
  return t;
}

} // namespace

int report_system(const Settings& settings, const std::string& file) {
  const Entry document = settings.document(file);
  if (has_format(document, "theorem")) return prove(settings, file);
  return run(settings, file, [&] { return theorem_of_system(settings, file, document); });
}

} // namespace kov::cli
