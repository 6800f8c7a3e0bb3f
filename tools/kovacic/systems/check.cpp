// kovacic check FILE...: the whole way for each file, and its expectations.

#include "commands.hpp"
#include "equation/equation_file.hpp"
#include "report/render_theorem.hpp"
#include "systems/case_file.hpp"

#include <algorithm>
#include <cstdio>

namespace kov::cli {
namespace {

std::string expectation_lines(const Settings& settings, const std::vector<Expected>& expected) {
  const bool color = settings.style().color;
  std::string s;
  for (const Expected& e : expected) {
    const std::string mark = e.met ? "ok" : e.limit ? "open" : "FAILED";
    s += "  expect    " + (color ? (e.met ? "\033[32m" : "\033[1;31m") + mark + "\033[0m" : mark) +
         "  " + wrapped(e.name, 14 + mark.size()) + "\n";
    if (!e.met) s += "            found  " + wrapped(e.found, 19) + "\n";
  }
  return s;
}

bool lacks_manifolds(const Entry& document) {
  return !has_format(document, "theorem") && !has_format(document, "scene") &&
         !is_equation_file(document) && document.find("system") != nullptr &&
         document.find("manifold") == nullptr;
}

// A system without manifolds: with those that are found.
Settings with_manifolds(const Settings& settings, const std::string& file) {
  Settings with = settings;
  const Entry document = settings.document(file);
  if (!lacks_manifolds(document)) return with;
  with.given = document.file_text();
  const ProposedManifolds proposed = propose_manifolds(with, file);
  *with.given += "\n" + proposed.blocks;
  if (proposed.blocks.empty())
    with.no_manifolds = proposed.note;
  else if (!settings.quiet)
    std::fprintf(stderr, "kovacic: %s has no [[manifold]]: %s\n", printable(file).c_str(),
                 printable(proposed.note).c_str());
  return with;
}

} // namespace

int check(const Settings& settings, const std::vector<std::string>& files) {
  const bool is_page = settings.format == "tex" || settings.format == "html";
  if (is_page && files.size() == 1) {
    const Entry document = settings.document(files.front());
    if (document.find("system") != nullptr && !is_equation_file(document))
      return report_system(settings, files.front());
  }
  int exit = settings.nothing_yet();
  std::string text;
  Json all = Json::array();
  for (const std::string& file : files) {
    CaseReport report;
    bool nothing_studied = false;
    try {
      const Settings with = with_manifolds(settings, file);
      nothing_studied = !with.no_manifolds.empty();
      report = check_case(with, file);
    } catch (const InputError& e) {
      exit = worse(exit, kov::cli::report(settings, e));
      continue;
    }
    if (!text.empty() && !report.text.empty()) text += "\n";
    text += report.text;
    if (settings.format == "text") text += expectation_lines(settings, report.expected);
    Json expectations = Json::array();
    int code = report.exit;
    if (nothing_studied && report.expected.empty() && !settings.exit_verdict)
      code = worse(code, exit_undecided);
    for (const Expected& e : report.expected) {
      expectations.push_back({{"expect", e.name}, {"met", e.met}, {"found", e.found}});
      if (!e.met) code = worse(code, e.limit ? exit_undecided : exit_no);
    }
    if (report.json.is_object()) // a system: one object for all its manifolds
      all.push_back(report.json);
    else
      all.push_back({{"file", file}, {"results", report.json}, {"expectations", expectations}});
    exit = worse(exit, code);
    if (exit == exit_interrupted) break;
  }
  if (settings.format == "html") text = report::html_page(files.front(), text);
  if (settings.format == "json") text = indented(all.size() == 1 ? all.front() : all);
  write_output(settings, text);
  return exit;
}

} // namespace kov::cli
