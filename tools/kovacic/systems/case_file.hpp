#pragma once
// A file with expectations: what `check` and `test` do with one.

#include "equation/equation_file.hpp"
#include "equations/answer.hpp"

#include <string>
#include <vector>

namespace kov::cli {

/// One [[expect]] block compared with what was found.
struct Expected {
  std::string name; ///< "group SL2, case 4 (Kovacic1986, ex. 1)"
  bool met = false;
  std::string found;  ///< what came out instead; empty if met
  bool limit = false; ///< not met because of a limit: neither yes nor no
};

struct CaseReport {
  std::string text; ///< for a terminal, or LaTeX
  Json json;
  std::vector<Expected> expected;
  int exit = exit_decided;
};

/// The answer for the file, and (equation files) its expectations.  Input errors are thrown.
/// The command that a file asks for by itself (kovacic FILE): prove, section, solve or classify.
[[nodiscard]] std::string command_for(const std::string& path);
[[nodiscard]] CaseReport check_case(const Settings& settings, const std::string& path);
/// The expectations of the file only (test_scene.cpp).
[[nodiscard]] CaseReport test_case(const Settings& settings, const std::string& path);
/// The steps of a theorem file, and that its proof is complete.
[[nodiscard]] CaseReport test_theorem(const Settings& settings, const std::string& path);

[[nodiscard]] CaseReport check_equation(const Settings& settings, const Entry& document);
/// System files (a [system] table).
[[nodiscard]] CaseReport check_system_file(const Settings& settings, const std::string& path);
/// The expectations of the scenes of a system file, or of the one of a file of its own.
[[nodiscard]] std::vector<Expected> test_system_scenes(const Entry& document);

} // namespace kov::cli
