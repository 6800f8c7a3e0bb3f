#include "section.hpp"

#include "flow/fixed_points.hpp"
#include "flow/simulate.hpp"
#include "interrupt.hpp"
#include "plot.hpp"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <fmt/ostream.h>

#include <algorithm>
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
  return v[0].is_zero() && v[1].is_zero() && v[2].is_zero();
}

std::string moments(const Scene& s) {
  bool full = false;
  for (std::size_t i = 0; i < 3; ++i)
    full = full || !s.inertia[i][(i + 1) % 3].is_zero();
  if (!full) return list({s.inertia[0][0], s.inertia[1][1], s.inertia[2][2]});
  return "(" + list(s.inertia[0]) + ", " + list(s.inertia[1]) + ", " + list(s.inertia[2]) + ")";
}

// Two lines: the mechanics; the numerics.
std::vector<std::string> caption(const Scene& s, const flow::Section& r) {
  const bool g_is_half = s.section.side > 0;
  const bool up = g_is_half ? s.section.falling : s.section.rising;
  const bool down = g_is_half ? s.section.rising : s.section.falling;
  std::string body =
      fmt::format("{} tip, I = {}, L = {}, m = {}, g = {}", s.sliding ? "sliding" : "fixed",
                  moments(s), list(s.lever), s.mass.text(), s.gravity.text());
  if (!is_zero(s.gyrostat)) body += ", B = " + list(s.gyrostat);
  body +=
      fmt::format("; H = {}, F1 = {}, F2 = {}", s.energy.text(), s.length.text(), s.casimir.text());
  const std::string axis = s.section.axis == 2 ? "" : fmt::format(", axis {}", s.section.axis + 1);
  return {body,
          fmt::format("g = {}, {}{}; {} orbits, {} points; Taylor order {}, {}, tolerance {}; "
                      "drift {:.1e}",
                      g_is_half ? "pi/2" : "3pi/2",
                      up && down ? "both directions"
                      : up       ? "dg/dt > 0"
                                 : "dg/dt < 0",
                      axis, r.orbits.size(), r.points.size(), r.order, r.arithmetic,
                      s.tolerance.text(), r.drift)};
}

void write_data(const fs::path& path, const Scene& s, const flow::Section& r) {
  std::ofstream out(path);
  fmt::print(out, "# {}\n", s.title);
  for (const std::string& line : caption(s, r))
    fmt::print(out, "# {}\n", line);
  fmt::print(out,
             "# l in radian, t and G in the units of the scene, L/G without unit; sign of the form "
             "'sign_of' at the start of the orbit\n");
  fmt::print(out, "orbit t l L/G G sign\n");
  for (const auto& p : r.points)
    fmt::print(out, "{} {:.12g} {:.12g} {:.12g} {:.12g} {}\n", p.orbit, p.t, p.l, p.y, p.g_size,
               r.orbits[p.orbit].sign);
  close_file(out, path.string());
}

void write_orbits(const fs::path& path, const flow::Section& r) {
  std::ofstream out(path);
  fmt::print(out, "orbit l0 L0/G0 G0 crossings tangencies steps time drift_H drift_F1 drift_F2\n");
  for (std::size_t i = 0; i < r.orbits.size(); ++i) {
    const auto& o = r.orbits[i];
    fmt::print(out, "{} {:.12g} {:.12g} {:.12g} {} {} {} {:.8g} {:.2e} {:.2e} {:.2e}\n", i, o.l,
               o.y, o.g_size, o.crossings, o.tangencies, o.steps, o.time, o.drift[0], o.drift[1],
               o.drift[2]);
  }
  close_file(out, path.string());
}

void write_fixed_points(const fs::path& path, const flow::FixedPoints& found) {
  std::ofstream out(path);
  fmt::print(out, "# fixed points of the section map; error: proved distance from the exact point "
                  "in l and in L/G "
                  "(inf: not proved)\n");
  fmt::print(out, "l L/G error kind trace trace_error multiplier_re multiplier_im G period\n");
  for (const auto& f : found.points)
    fmt::print(out, "{:.17g} {:.17g} {:.1e} {} {:.15g} {:.1e} {:.12g} {:.12g} {:.12g} {:.12g}\n",
               f.l, f.y, f.proved ? f.error : INFINITY, to_string(f.stability), f.trace,
               f.proved ? f.trace_error : INFINITY, f.multiplier[0], f.multiplier[1], f.g_size,
               f.period);
  close_file(out, path.string());
}

void print_fixed_points(const flow::FixedPoints& found) {
  const auto count = [&](flow::Stability s) {
    return std::count_if(found.points.begin(), found.points.end(),
                         [&](const auto& f) { return f.stability == s; });
  };
  if (found.degenerate)
    return fmt::print("  the section map is the identity on most of the section\n");
  fmt::print("  fixed points of the section map: {} elliptic (stable), {} hyperbolic",
             count(flow::Stability::elliptic), count(flow::Stability::hyperbolic));
  if (const auto n = count(flow::Stability::inverse_hyperbolic))
    fmt::print(", {} inverse hyperbolic", n);
  if (const auto n = count(flow::Stability::parabolic)) fmt::print(", {} parabolic", n);
  fmt::print("; sum of indices of the grid {}\n", found.index_sum);
  if (found.curve_cells > 0)
    fmt::print("  and curves of fixed points ({} cells of the grid)\n", found.curve_cells);
  for (const auto& f : found.points) {
    const auto shown = [](double x) { return std::abs(x) < 5e-13 ? 0.0 : x; };
    const std::string multipliers =
        f.multiplier[1] == 0 ? fmt::format("{:.9f}, {:.9f}", f.multiplier[0], 1 / f.multiplier[0])
                             : fmt::format("{:.9f} +- {:.9f} i", f.multiplier[0], f.multiplier[1]);
    fmt::print("    l = {:.12f}  L/G = {:.12f}  period {:.9f}  {:18}  multipliers {}", shown(f.l),
               shown(f.y), f.period, to_string(f.stability), multipliers);
    fmt::print("  {}\n",
               f.proved ? fmt::format("proved: +-{:.0e}, trace +-{:.0e}", f.error, f.trace_error)
                        : "not proved: " + f.why);
  }
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
    const double left =
        done == 0 ? 0 : spent * static_cast<double>(all - done) / static_cast<double>(done);
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

int one_scene(const std::string& file, const Settings& settings, const SectionArguments& o) {
  const Scene scene = flow::read_scene(file);
  const std::string name = file == "-" ? "section" : fs::path(file).stem().string();
  Interrupt interrupt;
  flow::Section result;
  const fs::path directory = settings.output.empty() ? "." : settings.output;
  make_directory(directory.string());
  const auto begun = std::chrono::steady_clock::now();
  {
    Progress progress(name, !settings.quiet);
    flow::SimulateOptions options;
    options.threads = o.threads;
    options.lanes = o.lanes;
    options.stop = interrupt.flag();
    options.progress = [&](std::size_t done, std::size_t all) { progress(done, all); };
    result = flow::simulate(scene, options);
  }
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  const fs::path base = directory / name;
  write_data(base.string() + ".dat", scene, result);
  write_orbits(base.string() + ".orbits.dat", result);
  const std::string wrong = complaint(scene, result);
  if (!settings.quiet) {
    fmt::print("{}\n  {}\n", file, scene.title);
    for (const std::string& line : caption(scene, result))
      fmt::print("  {}\n", line);
    if (result.skipped > 0)
      fmt::print("  {} places of the grid are not on the level\n", result.skipped);
    fmt::print("  {:.2f} s; data {}.dat\n", seconds, base.string());
  }
  if (!wrong.empty()) {
    complain(settings, file + ": " + wrong);
    return result.points.empty() ? exit_input : exit_undecided;
  }
  if (o.fixed_points && !result.stopped) {
    const flow::FixedPoints found = flow::fixed_points(scene);
    write_fixed_points(base.string() + ".fixed.dat", found);
    if (!settings.quiet) print_fixed_points(found);
  }
  const SectionPlot plot{scene.title, caption(scene, result), scene.sign_of.has_value(),
                         o.fixed_points};
  for (const std::string& picture : draw_section(base.string(), plot, o.formats))
    if (!settings.quiet) fmt::print("  picture {}\n", picture);
  return result.stopped ? exit_interrupted : exit_decided;
}

} // namespace

void declare_section(CLI::App& command, SectionArguments& a) {
  command.add_option("FILE", a.files, "scene files; - is standard input")
      ->required()
      ->type_name("");
  command.add_option("--pictures", a.formats, "png,svg,pdf (the default) or none")
      ->delimiter(',')
      ->check(CLI::IsMember({"png", "svg", "pdf", "none"}).description(""))
      ->type_name("LIST");
  command.add_option("-j", a.threads, "threads")
      ->check(CLI::Range(1, 256).description(""))
      ->type_name("N");
  command.add_flag("--fixed-points", a.fixed_points,
                   "find and prove the fixed points of the section map");
  command
      .add_option("--lanes", a.lanes,
                  "orbits at a time in a thread: 1, 4, 8; the answer is the same")
      ->check(CLI::IsMember({1, 4, 8}).description(""))
      ->type_name("N");
}

int section(const Settings& settings, const SectionArguments& arguments) {
  int code = exit_decided;
  for (const std::string& file : arguments.files) {
    code = std::max(code, one_scene(file, settings, arguments));
    if (code == exit_interrupted) break;
  }
  return code;
}

} // namespace kov::cli
