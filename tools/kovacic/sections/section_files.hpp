#pragma once
// What every section leaves behind: files that appear when they are complete, a line of progress, pictures.

#include "flow/orbit/steps.hpp"
#include "process/interrupt.hpp"
#include "sections/section.hpp"

#include <chrono>
#include <fstream>
#include <functional>

namespace kov::cli {

/// Calls write(std::ofstream&); the file appears when it is complete.
void write_whole(const std::string& path, const std::function<void(std::ofstream&)>& write);
/// How the orbit ended, as a column has it.
[[nodiscard]] const char* word(flow::Ended e);
/// "section" for the standard input, else the name of the file without its ending.
[[nodiscard]] std::string name_of_files(const std::string& file);
/// DIR/name; makes the directory.
[[nodiscard]] std::string base_of_files(const Settings& settings, const std::string& name);

using Clock = std::chrono::steady_clock;
[[nodiscard]] inline double seconds_since(Clock::time_point begun) {
  return std::chrono::duration<double>(Clock::now() - begun).count();
}

/// "  asymmetric_sliding  32 of 72 orbits, 3 s left" on a terminal, at most ten times a second.
class OrbitProgress {
public:
  OrbitProgress(std::string name, std::string what, bool on);
  void operator()(std::size_t done, std::size_t all);
  ~OrbitProgress();

private:
  std::string name_, what_;
  bool on_;
  Clock::time_point begun_ = Clock::now(), shown_{};
};

/// Draws the formats that are asked for (those that could be drawn are returned by `picture`), says which pictures
/// there are and what is missing.  Returns the exit code.
int draw(const Settings& settings, const SectionArguments& arguments, const Interrupt& interrupt,
         const std::string& base,
         const std::function<std::vector<std::string>(const std::vector<std::string>&)>& picture);

} // namespace kov::cli
