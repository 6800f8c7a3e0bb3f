#pragma once
// kovacic section FILE... -o DIR: Poincare sections.

#include "process/settings.hpp"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace kov {
class Entry;
}

namespace kov::cli {

struct SectionArguments {
  std::vector<std::string> files;
  std::vector<std::string> formats; ///< empty: png, svg and pdf if gnuplot is there
  int threads = 1;
  int lanes = 0; ///< 0: what is fastest here
  bool fixed_points = false, homoclinic = false;
  bool resume = false;                ///< of a scan: what an earlier run has finished is kept
  std::string part;                   ///< of a scan: "K/N", the K-th of N parts; empty: all of it
  int period = 1;                     ///< of the points that are looked for
  std::vector<std::string> rectangle; ///< where all fixed points are wanted; empty: nowhere
  std::vector<std::string> names;     ///< of the scenes of a system file; empty: all
};

/// The options of the sub-command.
void declare_section(CLI::App& command, SectionArguments& arguments);
/// Data, script and pictures of every scene, in the directory settings.output.  Throws InputError.
int section(const Settings& settings, const SectionArguments& arguments);

/// The scenes of a system file, or the one that names a system.
int system_sections(const Settings& settings, const SectionArguments& arguments,
                    const std::string& file, const Entry& document, double seconds);

} // namespace kov::cli
