#include "sections/section_files.hpp"

#include "symbol/input_error.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include <unistd.h>

namespace kov::cli {

namespace fs = std::filesystem;

void write_whole(const std::string& path, const std::function<void(std::ofstream&)>& write) {
  const std::string beside = path + ".part";
  std::ofstream out(beside);
  write(out);
  close_file(out, beside);
  std::error_code wrong;
  fs::rename(beside, path, wrong);
  if (wrong) throw InputError(path, 0, 0, 1, "cannot be written: " + wrong.message());
}

const char* word(flow::Ended e) {
  switch (e) {
  case flow::Ended::time:
    return "time";
  case flow::Ended::crossings:
    return "crossings";
  case flow::Ended::steps:
    return "steps";
  case flow::Ended::stopped:
    return "stopped";
  case flow::Ended::singular:
    return "singular";
  case flow::Ended::idle:
    return "idle";
  case flow::Ended::escaped:
    return "escaped";
  case flow::Ended::lost:
    return "lost";
  default:
    return "broken";
  }
}

std::string name_of_files(const std::string& file) {
  return file == "-" ? "section" : fs::path(file).stem().string();
}

std::string base_of_files(const Settings& settings, const std::string& name) {
  const fs::path directory = settings.output.empty() ? "." : settings.output;
  make_directory(directory.string());
  return (directory / name).string();
}

OrbitProgress::OrbitProgress(std::string name, std::string what, bool on)
    : name_(std::move(name)), what_(std::move(what)), on_(on && isatty(2) != 0) {}

void OrbitProgress::operator()(std::size_t done, std::size_t all) {
  const auto now = Clock::now();
  if (!on_ || (done < all && now - shown_ < std::chrono::milliseconds(100))) return;
  shown_ = now;
  const double spent = seconds_since(begun_);
  const double left =
      done == 0 ? 0 : spent * static_cast<double>(all - done) / static_cast<double>(done);
  fmt::print(stderr, "\r\033[K  {}  {} of {} {}, {:.0f} s left", name_, done, all, what_, left);
  std::fflush(stderr);
}

OrbitProgress::~OrbitProgress() {
  if (on_) fmt::print(stderr, "\r\033[K");
}

int draw(const Settings& settings, const SectionArguments& arguments, const Interrupt& interrupt,
         const std::string& base,
         const std::function<std::vector<std::string>(const std::vector<std::string>&)>& picture) {
  std::vector<std::string> formats = arguments.formats;
  if (formats.empty()) formats = {"png", "svg", "pdf"};
  std::erase(formats, "none");
  std::ranges::sort(formats);
  formats.erase(std::unique(formats.begin(), formats.end()), formats.end());
  if (interrupt.timed_out() && !formats.empty()) { // gnuplot knows no time limit
    formats.clear();
    complain(settings, "the time is over: no picture is drawn", "gnuplot " + base + ".gp draws it");
  }
  const auto drawn = picture(formats);
  for (const std::string& one : drawn)
    if (!settings.quiet) fmt::print("  picture {}\n", one);
  if (drawn.size() == formats.size()) return exit_decided;
  complain(settings,
           fmt::format("{} of {} pictures were drawn: gnuplot is missing, or fails", drawn.size(),
                       formats.size()),
           "install gnuplot-nox; gnuplot " + base + ".gp draws them later");
  return arguments.formats.empty() ? exit_decided : exit_input;
}

} // namespace kov::cli
