// kovacic test [DIR|FILE]...: every [[expect]] block is one test, in TAP (Test Anything Protocol).

#include "commands.hpp"
#include "systems/case_file.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

namespace kov::cli {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> case_files(const std::vector<std::string>& paths) {
  std::vector<std::string> files;
  for (const std::string& path : paths) {
    std::error_code failed;
    if (!fs::exists(path, failed))
      throw InputError(path, 0, 0, 1, "there is no such file or directory");
    if (!is_directory(path)) {
      files.push_back(path);
      continue;
    }
    std::vector<std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(path))
      if (entry.is_regular_file() && entry.path().extension() == ".toml")
        found.push_back(entry.path().string());
    std::ranges::sort(found);
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

struct Tally {
  std::FILE* out = stdout;
  int number = 0;
  int failed = 0, skipped = 0;
  int exit = exit_decided;
};

void line(const Settings& settings, Tally& tally, bool ok, const std::string& name,
          const std::string& diagnosis = {}) {
  ++tally.number;
  if (!ok) ++tally.failed;
  if (ok && settings.quiet) return;
  std::fprintf(tally.out, "%s %d - %s\n", ok ? "ok" : "not ok", tally.number, name.c_str());
  std::size_t begin = 0;
  while (begin < diagnosis.size()) {
    const std::size_t end = std::min(diagnosis.find('\n', begin), diagnosis.size());
    std::fprintf(tally.out, "# %s\n", diagnosis.substr(begin, end - begin).c_str());
    begin = end + 1;
  }
  std::fflush(tally.out);
}

void run(const Settings& settings, const std::string& file, Tally& tally) {
  try {
    const CaseReport report = test_case(settings, file);
    for (const Expected& e : report.expected)
      line(settings, tally, e.met, file + ": " + e.name, e.met ? "" : "found " + e.found);
    if (report.expected.empty()) {
      line(settings, tally, true, file + " # SKIP nothing is expected");
      ++tally.skipped;
    }
    if (report.exit >= exit_internal) tally.exit = report.exit;
  } catch (const InputError& e) {
    line(settings, tally, false, file + ": readable", render(e));
    tally.exit = worse(tally.exit, exit_input);
  }
}

} // namespace

int test(const Settings& settings, const std::vector<std::string>& paths) {
  Tally tally;
  const bool to_file = !settings.output.empty() && settings.output != "-";
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(
      to_file ? std::fopen(settings.output.c_str(), "wb") : nullptr, std::fclose);
  const InputError unwritten(to_file ? settings.output : "standard output", 0, 0, 1,
                             "the file cannot be written");
  if (to_file && !file) return report(settings, unwritten);
  if (to_file) tally.out = file.get();
  try {
    Settings quiet = settings;
    quiet.format = "text";
    std::fprintf(tally.out, "TAP version 13\n");
    for (const std::string& path :
         case_files(paths.empty() ? std::vector<std::string>{"cases"} : paths)) {
      run(quiet, path, tally);
      if (tally.exit == exit_interrupted) return exit_interrupted;
    }
  } catch (const InputError& e) {
    return report(settings, e);
  }
  const int asked = tally.number - tally.skipped;
  std::fprintf(tally.out, "1..%d\n# %d of %d expectations met\n", tally.number,
               asked - tally.failed, asked);
  if (std::fflush(tally.out) != 0 || std::ferror(tally.out) != 0)
    return report(settings, unwritten);
  if (tally.exit >= exit_input) return tally.exit;
  return tally.failed > 0 ? exit_no : exit_decided;
}

} // namespace kov::cli
