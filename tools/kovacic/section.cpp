#include "section.hpp"

#include "flow/simulate.hpp"
#include "interrupt.hpp"
#include "plot.hpp"
#include "symbol/input_error.hpp"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <fmt/ostream.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include <unistd.h>

namespace kov::cli {
namespace {

namespace fs = std::filesystem;
using flow::Scene;

std::string list(const std::array<flow::Quantity, 3>& v) {
  return "(" + v[0].text() + ", " + v[1].text() + ", " + v[2].text() + ")";
}

bool is_zero(const std::array<flow::Quantity, 3>& v) {
  return v[0].as<double>() == 0 && v[1].as<double>() == 0 && v[2].as<double>() == 0;
}

std::string moments(const Scene& s) {
  bool full = false;
  for (std::size_t i = 0; i < 3; ++i)
    full = full || s.inertia[i][(i + 1) % 3].as<double>() != 0;
  if (!full) return list({s.inertia[0][0], s.inertia[1][1], s.inertia[2][2]});
  return "(" + list(s.inertia[0]) + ", " + list(s.inertia[1]) + ", " + list(s.inertia[2]) + ")";
}

// Two lines: the mechanics; the numerics.
std::vector<std::string> caption(const Scene& s, const flow::Section& r) {
  const bool g_is_half = s.section.side > 0;
  const bool up = g_is_half ? s.section.falling : s.section.rising;
  const bool down = g_is_half ? s.section.rising : s.section.falling;
  std::string body = fmt::format("{} tip, I = {}, L = {}, m = {}, g = {}",
                                 s.sliding ? "sliding" : "fixed", moments(s), list(s.lever),
                                 s.mass.text(), s.gravity.text());
  if (!is_zero(s.gyrostat)) body += ", B = " + list(s.gyrostat);
  body += fmt::format("; H = {}, F1 = {}, F2 = {}", s.energy.text(), s.length.text(),
                      s.casimir.text());
  const std::string axis = s.section.axis == 2 ? "" : fmt::format(", axis {}", s.section.axis + 1);
  return {body, fmt::format("g = {}, {}{}; {} orbits, {} points; Taylor order {}, {}, tolerance {}; "
                            "drift {:.1e}",
                            g_is_half ? "pi/2" : "3pi/2",
                            up && down ? "both directions" : up ? "dg/dt > 0" : "dg/dt < 0", axis,
                            r.orbits.size(), r.points.size(), r.order, r.arithmetic,
                            s.tolerance.text(), r.drift)};
}

void write_data(const fs::path& path, const Scene& s, const flow::Section& r) {
  std::ofstream out(path);
  fmt::print(out, "# {}\n", s.title);
  for (const std::string& line : caption(s, r))
    fmt::print(out, "# {}\n", line);
  fmt::print(out, "# l in radian, t and G in the units of the scene, L/G without unit; sign of the form "
                  "'sign_of' at the start of the orbit\n");
  fmt::print(out, "orbit t l L/G G sign\n");
  for (const auto& p : r.points)
    fmt::print(out, "{} {:.12g} {:.12g} {:.12g} {:.12g} {}\n", p.orbit, p.t, p.l, p.y, p.g_size,
               r.orbits[p.orbit].sign);
  if (!out) throw Error("cannot write " + path.string());
}

void write_orbits(const fs::path& path, const flow::Section& r) {
  std::ofstream out(path);
  fmt::print(out, "orbit l0 L0/G0 G0 crossings tangencies steps time drift_H drift_F1 drift_F2\n");
  for (std::size_t i = 0; i < r.orbits.size(); ++i) {
    const auto& o = r.orbits[i];
    fmt::print(out, "{} {:.12g} {:.12g} {:.12g} {} {} {} {:.8g} {:.2e} {:.2e} {:.2e}\n", i, o.l, o.y,
               o.g_size, o.crossings, o.tangencies, o.steps, o.time, o.drift[0], o.drift[1],
               o.drift[2]);
  }
  if (!out) throw Error("cannot write " + path.string());
}

// "  asymmetric_sliding  32 of 72 orbits, 3 s left" on a terminal, at most ten times a second.
class Progress {
public:
  Progress(std::string name, bool on) : name_(std::move(name)), on_(on && isatty(2) != 0) {}
  void operator()(std::size_t done, std::size_t all) {
    const auto now = Clock::now();
    if (!on_ || (done < all && now - shown_ < std::chrono::milliseconds(100))) return;
    shown_ = now;
    const double spent = std::chrono::duration<double>(now - begun_).count();
    const double left = done == 0 ? 0 : spent * static_cast<double>(all - done) / static_cast<double>(done);
    fmt::print(stderr, "\r\033[K  {}  {} of {} orbits, {:.0f} s left", name_, done, all, left);
    std::fflush(stderr);
  }
  ~Progress() {
    if (on_) fmt::print(stderr, "\r\033[K");
  }

private:
  using Clock = std::chrono::steady_clock;
  std::string name_;
  bool on_;
  Clock::time_point begun_ = Clock::now(), shown_{};
};

// What is wrong with the result, in words; empty if nothing.
std::string complaint(const Scene& s, const flow::Section& r) {
  if (r.points.empty() && !r.stopped)
    return fmt::format("the section is never crossed: {} orbits, none within {}", r.orbits.size(),
                       s.time ? "t = " + s.time->text() : std::string("the limit of steps"));
  for (std::size_t i = 0; i < r.orbits.size(); ++i)
    if (r.orbits[i].ended == flow::Ended::broken)
      return fmt::format("orbit {} could not be continued beyond t = {:.6g}", i, r.orbits[i].time);
  if (r.drift > s.drift.as<double>())
    return fmt::format("the integrals drift by {:.1e}, more than the {} that the scene allows; no "
                       "picture is drawn (lower the tolerance)",
                       r.drift, s.drift.text());
  return {};
}

int one_scene(const std::string& file, const SectionOptions& o) {
  const Scene scene = flow::read_scene(file);
  const std::string name = file == "-" ? "section" : fs::path(file).stem().string();
  Interrupt interrupt;
  flow::Section result;
  const auto begun = std::chrono::steady_clock::now();
  {
    Progress progress(name, !o.quiet);
    flow::SimulateOptions options;
    options.threads = o.threads;
    options.lanes = o.lanes;
    options.stop = interrupt.flag();
    options.progress = [&](std::size_t done, std::size_t all) { progress(done, all); };
    result = flow::simulate(scene, options);
  }
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  fs::create_directories(o.directory);
  const fs::path base = fs::path(o.directory) / name;
  write_data(base.string() + ".dat", scene, result);
  write_orbits(base.string() + ".orbits.dat", result);
  const std::string wrong = complaint(scene, result);
  if (!o.quiet) {
    fmt::print("{}\n  {}\n", file, scene.title);
    for (const std::string& line : caption(scene, result))
      fmt::print("  {}\n", line);
    if (result.skipped > 0)
      fmt::print("  {} places of the grid are not on the level\n", result.skipped);
    fmt::print("  {:.2f} s; data {}.dat\n", seconds, base.string());
  }
  if (!wrong.empty()) {
    fmt::print(stderr, "{}: {}\n", file, wrong);
    return result.points.empty() ? 2 : 3;
  }
  const SectionPlot plot{scene.title, caption(scene, result), scene.sign_of.has_value()};
  for (const std::string& picture : draw_section(base.string(), plot, o.formats))
    if (!o.quiet) fmt::print("  picture {}\n", picture);
  return result.stopped ? 130 : 0;
}

} // namespace

int run_section(const SectionOptions& options) {
  int code = 0;
  for (const std::string& file : options.files) {
    code = std::max(code, one_scene(file, options));
    if (code == 130) break;
  }
  return code;
}

int run_section(int argc, char** argv) {
  CLI::App app("Poincare sections of a scene: data, gnuplot script and, if gnuplot is there, pictures");
  app.name("kovacic section");
  SectionOptions o;
  app.add_option("FILE", o.files, "scene files (TOML, format scene/1); - is standard input")
      ->required();
  app.add_option("-o,--output", o.directory, "directory for NAME.dat, NAME.gp, NAME.png, ...");
  app.add_option("--format", o.formats, "pictures to draw: png, svg, pdf")
      ->delimiter(',')
      ->check(CLI::IsMember({"png", "svg", "pdf", "none"}));
  app.add_option("-j", o.threads, "threads")->check(CLI::Range(1, 256));
  app.add_option("--lanes", o.lanes, "orbits at a time in one thread (the answer does not depend on it)")
      ->check(CLI::IsMember({1, 4, 8}));
  app.add_flag("-q,--quiet", o.quiet, "no summary, no progress");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  }
  return run_section(o);
}

} // namespace kov::cli
