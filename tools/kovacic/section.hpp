#pragma once
// kovacic section FILE... -o DIR: Poincare sections.

#include <string>
#include <vector>

namespace kov::cli {

struct SectionOptions {
  std::vector<std::string> files;
  std::string directory = ".";
  std::vector<std::string> formats = {"png", "svg", "pdf"}; ///< drawn if gnuplot is there
  int threads = 1;
  int lanes = 8;
  bool quiet = false;
  bool fixed_points = false;
};

/// Returns the exit code.  Throws InputError for a bad scene.
int run_section(const SectionOptions& options);
/// The same from the words of the command line after "section".
int run_section(int argc, char** argv);

} // namespace kov::cli
