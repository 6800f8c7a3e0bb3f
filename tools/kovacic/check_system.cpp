// System files: the mechanics commands under the limits of the settings.

#include "case_file.hpp"
#include "commands.hpp"
#include "integrability/expect.hpp"
#include "mechanics.hpp"
#include "present.hpp"

#include <ostream>

namespace kov::cli {
namespace {

// The child has no standard input.
void need_a_name(const std::string& path) {
  if (path == "-")
    throw InputError(path, 0, 0, 1, "a system file is read by its name, not from standard input");
}

kov::Settings values_of(const Settings& settings) {
  kov::Settings all;
  for (const std::string& s : settings.set) {
    const auto equal = s.find('=');
    if (equal == std::string::npos || equal == 0)
      throw InputError("--set", 1, 1, static_cast<long>(s.size()),
                       "a name with a value is expected", "write e.g. --set a=1/2", s);
    all.emplace_back(s.substr(0, equal), s.substr(equal + 1));
  }
  return all;
}

MechanicsArguments arguments(const Settings& settings, const std::string& path) {
  need_a_name(path);
  MechanicsArguments a;
  a.file = path;
  a.set = values_of(settings);
  a.format = settings.format == "json" ? "json" : "text";
  a.manifold = settings.manifold;
  a.exit_verdict = settings.exit_verdict;
  a.decide = settings.solver_options();
  return a;
}

// The text of a job, or what there is to say when a limit ended it.
std::string text_or_limit(const Settings& settings, const std::string& path, const TextAnswer& a) {
  if (a.limit.empty()) return a.text;
  Json result = {{"format", "kovacic-result/1"}, {"input", {{"file", path}}}};
  set_undecided(result, "budget", a.limit);
  if (settings.format == "json") return result.dump(2) + "\n";
  return path + "\n  UNDECIDED\n  open      " + wrapped(a.limit, 12) +
         "\n  more      kovacic explain budget\n";
}

int run(const Settings& settings, const std::string& path,
        const std::function<int(std::ostream&)>& work) {
  TextAnswer a = limited(settings, work);
  write_output(settings, text_or_limit(settings, path, a));
  Answer failure;
  failure.exit = a.exit;
  failure.error = a.error;
  failure.internal = a.internal;
  report_failure(settings, failure);
  return a.exit;
}

} // namespace

CaseReport check_system_file(const Settings& settings, const std::string& path) {
  const TextAnswer a = limited(settings, [&](std::ostream& out) {
    MechanicsArguments m = arguments(settings, path);
    return run_check(m, out);
  });
  if (a.error) throw *a.error;
  CaseReport report;
  report.exit = a.exit;
  report.text = text_or_limit(settings, path, a);
  if (settings.format == "json") report.json = Json::parse(report.text, nullptr, false);
  if (a.exit == exit_internal || a.exit == exit_interrupted) {
    Answer failure;
    failure.exit = a.exit;
    failure.internal = a.internal;
    report_failure(settings, failure);
  }
  return report;
}

CaseReport test_system_file(const Settings& settings, const std::string& path) {
  need_a_name(path);
  const TextAnswer a = limited(settings, [&](std::ostream& out) {
    CheckOptions options;
    options.decide = settings.solver_options();
    Json all = Json::array();
    for (const ExpectationResult& r : kov::test_system_file(path, options))
      all.push_back({{"name", r.name}, {"met", r.passed}, {"found", r.message}});
    out << dump(all);
    return static_cast<int>(exit_decided);
  });
  if (a.error) throw *a.error;
  CaseReport report;
  report.exit = a.exit;
  if (a.exit != exit_decided) {
    const std::string why = a.limit.empty() ? a.internal : a.limit;
    report.expected.push_back({.name = "decided", .met = false, .found = why});
    return report;
  }
  for (const Json& r : Json::parse(a.text))
    report.expected.push_back({.name = r.at("name"), .met = r.at("met"), .found = r.at("found")});
  return report;
}

int show(const Settings& settings, const std::string& file, const std::string& stage) {
  return run(settings, file, [&](std::ostream& out) {
    MechanicsArguments a = arguments(settings, file);
    a.stage = stage;
    return run_show(a, out);
  });
}

int find_manifolds(const Settings& settings, const std::string& file) {
  return run(settings, file,
             [&](std::ostream& out) { return run_find_manifolds(arguments(settings, file), out); });
}

} // namespace kov::cli
