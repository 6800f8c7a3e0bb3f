#include "section.hpp"

#include "commands.hpp"
#include "exact/lists.hpp"
#include "flow/scene/simulate.hpp"
#include "flow/scene/system_scene.hpp"
#include "flow/section/fixed_points.hpp"
#include "page_width.hpp"
#include "plot.hpp"
#include "section_files.hpp"
#include "symbol/document.hpp"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace kov::cli {
namespace {

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

std::string orders(const flow::Section& r) {
  return r.least_order == r.order ? fmt::format("{}", r.order)
                                  : fmt::format("{} to {}", r.least_order, r.order);
}

// Two lines: the mechanics; the numerics.
std::vector<std::string> caption(const Scene& s, const flow::Section& r) {
  const bool g_is_half = s.section.side > 0;
  const bool up = g_is_half ? s.section.falling : s.section.rising;
  const bool down = g_is_half ? s.section.rising : s.section.falling;
  std::string body =
      fmt::format("{} tip, I = {}, lever {}, mass {}, gravity {}", s.sliding ? "sliding" : "fixed",
                  moments(s), list(s.lever), s.mass.text(), s.gravity.text());
  if (!is_zero(s.gyrostat)) body += ", B = " + list(s.gyrostat);
  body +=
      fmt::format("; H = {}, F1 = {}, F2 = {}", s.energy.text(), s.length.text(), s.casimir.text());
  const std::string axis = s.section.axis == 2 ? "" : fmt::format(", axis {}", s.section.axis + 1);
  return {body,
          fmt::format("g = {}, {}{}; {} orbit{}, {} point{}; Taylor order {}, {}, tolerance {}; "
                      "drift {:.1e}",
                      g_is_half ? "pi/2" : "3pi/2",
                      up && down ? "both directions"
                      : up       ? "dg/dt > 0"
                                 : "dg/dt < 0",
                      axis, r.orbits.size(), r.orbits.size() == 1 ? "" : "s", r.points.size(),
                      r.points.size() == 1 ? "" : "s", orders(r), r.arithmetic, s.tolerance.text(),
                      r.drift)};
}

// The form whose sign colours the orbits; empty without one.
std::string form(const Scene& s) {
  std::string sum;
  for (std::size_t i = 0; s.sign_of && i < 3; ++i)
    if (const std::string factor = (*s.sign_of)[i].text(); factor != "0")
      sum += fmt::format("{}{} M{}", sum.empty() ? "" : " + ", factor, i + 1);
  return sum;
}

// What is missing in a result, in words; empty if nothing is.
std::string shortfall(const flow::Section& r) {
  const auto ended = [&](flow::Ended how) {
    return std::ranges::count_if(r.orbits, [&](const auto& o) { return o.ended == how; });
  };
  std::string text;
  if (r.stopped)
    text = fmt::format("{} of {} orbits were stopped before their end", ended(flow::Ended::stopped),
                       r.orbits.size());
  if (const std::size_t n = r.cut_short(); n > 0)
    text +=
        fmt::format("{}{} of {} orbits ended at the limit of {} before their last crossing",
                    text.empty() ? "" : "; ", n, r.orbits.size(), r.has_time ? "points" : "steps");
  return text;
}

std::string partial(const flow::Section& r) {
  const std::string missing = shortfall(r);
  return missing.empty() ? "" : "PARTIAL: " + missing;
}

void write_data(const std::string& path, const Scene& s, const flow::Section& r) {
  write_whole(path, [&](std::ofstream& out) {
    if (const std::string missing = partial(r); !missing.empty())
      fmt::print(out, "# {}\n", missing);
    fmt::print(out, "# {}\n", s.title);
    for (const std::string& line : caption(s, r))
      fmt::print(out, "# {}\n", line);
    fmt::print(out, "# l in radian, t and G in the units of the scene, L/G without unit; sign of "
                    "the form 'sign_of' at the start of the orbit\n");
    fmt::print(out, "orbit t l L/G G sign\n");
    const int n = flow::digits_shown(s.tolerance, s.digits);
    for (const auto& p : r.points) {
      const int sign = r.orbits[p.orbit].sign;
      if (p.digits.empty())
        fmt::print(out, "{} {:.{}g} {:.{}g} {:.{}g} {:.{}g} {}\n", p.orbit, p.t, n, p.l, n, p.y, n,
                   p.g_size, n, sign);
      else
        fmt::print(out, "{} {} {}\n", p.orbit, p.digits, sign);
    }
  });
}

void write_orbits(const std::string& path, const flow::Section& r) {
  write_whole(path, [&](std::ofstream& out) {
    if (const std::string missing = partial(r); !missing.empty())
      fmt::print(out, "# {}\n", missing);
    fmt::print(out, "orbit l0 L0/G0 G0 crossings tangencies steps time drift_H drift_F1 drift_F2 "
                    "ended_by\n");
    for (std::size_t i = 0; i < r.orbits.size(); ++i) {
      const auto& o = r.orbits[i];
      fmt::print(out, "{} {:.12g} {:.12g} {:.12g} {} {} {} {:.8g} {:.2e} {:.2e} {:.2e} {}\n", i,
                 o.l, o.y, o.g_size, o.crossings, o.tangencies, o.steps, o.time, o.drift[0],
                 o.drift[1], o.drift[2], word(o.ended));
    }
  });
}

// A column has no spaces.
std::string one_word(flow::Stability s) {
  std::string text = to_string(s);
  std::ranges::replace(text, ' ', '-');
  return text;
}

constexpr const char* partial_points = "PARTIAL: stopped before the search and the proofs ended";

void write_fixed_points(const std::string& path, const flow::FixedPoints& found) {
  write_whole(path, [&](std::ofstream& out) {
    if (found.stopped) fmt::print(out, "# {}\n", partial_points);
    fmt::print(out, "# fixed points of the section map; error: proved distance from the exact "
                    "point in l and in L/G (inf: not proved)\n");
    fmt::print(out, "l L/G error kind trace trace_error multiplier_re multiplier_im G period\n");
    for (const auto& f : found.points)
      fmt::print(out, "{:.17g} {:.17g} {:.1e} {} {:.15g} {:.1e} {:.12g} {:.12g} {:.12g} {:.12g}\n",
                 f.l, f.y, f.proved ? f.error : INFINITY, one_word(f.stability), f.trace,
                 f.proved ? f.trace_error : INFINITY, f.multiplier[0], f.multiplier[1], f.g_size,
                 f.period);
  });
}

// Decimals that an error bound justifies.
int decimals(double error) {
  return error > 0 ? std::clamp(static_cast<int>(-std::log10(error)), 1, 16) : 16;
}

std::string line_of(const flow::FixedPoint& f) {
  const auto shown = [](double x) { return std::abs(x) < 5e-13 ? 0.0 : x; };
  const int n = f.proved ? decimals(f.error) : 10;
  const int m = f.proved ? std::min(decimals(f.trace_error), 14) : 8;
  const std::string multipliers =
      f.multiplier[1] == 0
          ? fmt::format("{:.{}f}, {:.{}f}", f.multiplier[0], m, 1 / f.multiplier[0], m)
          : fmt::format("{:.{}f} +- {:.{}f} i", f.multiplier[0], m, f.multiplier[1], m);
  return fmt::format("l = {:.{}f}  L/G = {:.{}f}  period {:.10g}  {:18}  multipliers {}  {}",
                     shown(f.l), n, shown(f.y), n, f.period, to_string(f.stability), multipliers,
                     f.proved
                         ? fmt::format("proved: +-{:.0e}, trace +-{:.0e}", f.error, f.trace_error)
                         : "not proved: " + to_string(f.why));
}

// "1 cell", "2 cells"
std::string cells(int n) { return fmt::format("{} cell{}", n, n == 1 ? "" : "s"); }

// What the grid says about points that the list below may lack.
void print_indices(const flow::FixedPoints& found) {
  if (found.stopped) return fmt::print("  {}\n", partial_points);
  fmt::print("  sum of indices {} over {} of the grid\n", found.index_sum, cells(found.cells));
  if (const int n = found.cells_without_index)
    fmt::print("  {} without an index: the map jumps there, leaves the sheet of the level, or has "
               "fixed points on the border\n",
               cells(n));
  if (const int n = found.unexplained_cells)
    fmt::print("  {} whose index the points found in it do not make up: some were missed\n",
               cells(n));
  if (found.curve_cells > 0)
    fmt::print("  curves of fixed points ({})\n", cells(found.curve_cells));
}

void print_fixed_points(const flow::FixedPoints& found) {
  const auto count = [&](flow::Stability s) {
    return std::ranges::count_if(found.points, [&](const auto& f) { return f.stability == s; });
  };
  if (found.degenerate)
    return fmt::print("  the section map is the identity on most of the section\n");
  fmt::print("  fixed points of the section map: {} elliptic (stable), {} hyperbolic",
             count(flow::Stability::elliptic), count(flow::Stability::hyperbolic));
  if (const auto n = count(flow::Stability::inverse_hyperbolic))
    fmt::print(", {} inverse hyperbolic", n);
  if (const auto n = count(flow::Stability::parabolic)) fmt::print(", {} parabolic", n);
  fmt::print("\n");
  print_indices(found);
  if (found.at_poles > 0)
    fmt::print("  the map also tends to a steady rotation at L/G = +-1, where l has no meaning\n");
  for (const auto& f : found.points)
    fmt::print("    {}\n", line_of(f));
}

// What is wrong with the result, in words; empty if nothing.
std::string complaint(const Scene& s, const flow::Section& r) {
  for (std::size_t i = 0; i < r.orbits.size(); ++i)
    if (r.orbits[i].ended == flow::Ended::broken)
      return fmt::format("orbit {} could not be continued beyond t = {:.6g}", i, r.orbits[i].time);
  if (r.points.empty() && !r.stopped && s.time)
    return fmt::format("the section is never crossed: {} orbits, none within t = {}",
                       r.orbits.size(), s.time->text());
  if (r.drift > s.drift.as<double>())
    return fmt::format("the integrals drift by {:.1e}, more than the {} that the scene allows; no "
                       "picture is drawn (lower the tolerance)",
                       r.drift, s.drift.text());
  return {};
}

// One scene on its way to the files.
class Job {
public:
  Job(const std::string& file, const Entry& document, const Settings& settings,
      const SectionArguments& o, double seconds)
      : file_(file), settings_(settings), o_(o), scene_(flow::read_scene(document)),
        name_(name_of_files(file)), interrupt_(seconds) {
    if (o.fixed_points && scene_.section.falling && scene_.section.rising)
      throw InputError(file, 0, 0, 1, "--fixed-points needs one direction of crossing, not both",
                       "direction = \"upward\" or \"downward\"");
    base_ = base_of_files(settings, name_);
  }

  int run() {
    simulate();
    const std::string wrong = complaint(scene_, result_);
    if (!settings_.quiet) summary();
    if (!wrong.empty()) {
      complain(settings_, file_ + ": " + wrong);
      return result_.points.empty() ? exit_input : exit_undecided;
    }
    bool whole = shortfall(result_).empty();
    if (o_.fixed_points && !result_.stopped) whole = fixed_points() && whole;
    const int code = pictures();
    if (whole) return code;
    if (interrupt_.flag()->load() && !interrupt_.timed_out()) return exit_interrupted; // by hand
    complain(settings_, file_ + ": the result is partial, and its files say so");
    return exit_undecided;
  }

private:
  std::string file_;
  const Settings& settings_;
  const SectionArguments& o_;
  Scene scene_;
  std::string name_, base_;
  Interrupt interrupt_;
  flow::Section result_;
  double seconds_ = 0;
  std::set<FixedPointMark> marks_; ///< of the fixed points

  void write(const flow::Section& r) const {
    write_data(base_ + ".dat", scene_, r);
    write_orbits(base_ + ".orbits.dat", r);
  }

  void simulate() {
    const auto begun = Clock::now();
    auto written = begun;
    double cost = 0;
    OrbitProgress progress(name_, "orbits", !settings_.quiet);
    flow::SimulateOptions options;
    options.threads = o_.threads;
    options.lanes = o_.lanes;
    options.stop = interrupt_.flag();
    options.progress = [&](std::size_t done, std::size_t all) { progress(done, all); };
    options.finished_some = [&](const flow::Section& so_far) { // what a crash must not take away
      if (seconds_since(written) < std::max(10.0, 20 * cost)) return;
      const auto now = Clock::now();
      flow::Section copy = so_far;
      copy.stopped = true;
      write(copy);
      cost = seconds_since(now);
      written = Clock::now();
    };
    result_ = flow::simulate(scene_, options);
    seconds_ = seconds_since(begun);
    write(result_);
  }

  static void say(const std::string& line) {
    fmt::print("{}", for_standard_output("  " + line + "\n"));
  }

  void summary() const {
    fmt::print("{}\n  {}\n", file_, scene_.title);
    for (const std::string& line : caption(scene_, result_))
      say(line);
    if (result_.skipped > 0)
      say(fmt::format("{} of {} starting points lie outside the level H = {}", result_.skipped,
                      result_.skipped + result_.orbits.size(), scene_.energy.text()));
    if (const std::string missing = partial(result_); !missing.empty()) say(missing);
    fmt::print("  {:.2f} s; data {}.dat\n", seconds_, base_);
  }

  // false: stopped before the end
  bool fixed_points() {
    const std::string path = base_ + ".fixed.dat";
    auto written = Clock::now();
    flow::FixedPoints found;
    {
      OrbitProgress progress(name_, "proofs", !settings_.quiet);
      flow::FixedPointOptions options;
      options.stop = interrupt_.flag();
      options.progress = [&](const flow::FixedPoints& so_far, std::size_t proofs) {
        progress(proofs, so_far.points.size());
        if (seconds_since(written) < 10) return;
        flow::FixedPoints copy = so_far; // what a crash must not take away
        copy.stopped = true;
        write_fixed_points(path, copy);
        written = Clock::now();
      };
      found = flow::fixed_points(scene_, options);
    }
    write_fixed_points(path, found);
    for (const auto& f : found.points)
      marks_.insert({one_word(f.stability), f.proved});
    if (!settings_.quiet) print_fixed_points(found);
    return !found.stopped;
  }

  [[nodiscard]] int pictures() const {
    const std::string missing = partial(result_);
    const std::string title = scene_.title + (missing.empty() ? "" : "  [" + missing + "]");
    const SectionPlot plot{title, caption(scene_, result_), form(scene_), marks_};
    return draw(settings_, o_, interrupt_, base_, [&](const std::vector<std::string>& formats) {
      return draw_section(base_, plot, formats);
    });
  }
};

} // namespace

void declare_section(CLI::App& command, SectionArguments& a) {
  command.add_option("FILE", a.files, "scenes, and system files with [scene]; - is standard input")
      ->type_name("");
  command
      .add_option("--pictures", a.formats,
                  "png,svg,pdf (the default), html (a page, for a system file) or none")
      ->delimiter(',')
      ->check(CLI::IsMember({"png", "svg", "pdf", "html", "none"}).description(""))
      ->type_name("LIST");
  command.add_flag("--resume", a.resume, "go on with a scan where it was stopped or killed");
  command
      .add_option("--part", a.part,
                  "the K-th of N parts of a scan, into a file of its own; --resume merges them")
      ->type_name("K/N");
  command.add_option("-j,--jobs", a.threads, "threads")
      ->check(CLI::Range(1, 256).description(""))
      ->type_name("N");
  command.add_flag("--fixed-points", a.fixed_points,
                   "find and prove fixed points of the section map, with their stability");
  command.add_flag("--homoclinic", a.homoclinic,
                   "prove chaos: a transverse homoclinic point (system files)");
  command
      .add_option("--period", a.period, "of --fixed-points, --in and --homoclinic (system files)")
      ->check(CLI::Range(1, 64).description(""))
      ->type_name("N");
  command
      .add_option("--in", a.rectangle,
                  "prove which are all fixed points of the N-th return in this rectangle of the "
                  "picture (system files)")
      ->delimiter(',')
      ->expected(4)
      ->type_name("A,B,C,D");
  command.add_option("--scene", a.names, "only these scenes of a system file")
      ->delimiter(',')
      ->type_name("NAMES");
  command
      .add_option("--lanes", a.lanes,
                  "orbits at a time in a thread: 1, 4, 8; 0 = what is fastest here")
      ->check(CLI::IsMember({0, 1, 4, 8}).description(""))
      ->type_name("N");
}

namespace {

// The scene that was chosen for a system without one.
void tell_scene(const Entry& document) {
  const Entry& scene = document.at("scene").array().front();
  std::string chosen = scene.at("section").string() + " = 0";
  for (const char* key : {"levels", "set"})
    if (const Entry* table = scene.find(key))
      for (const auto& [name, value] : table->members())
        chosen += ", " + name + " = " + value.string();
  std::fprintf(stderr,
               "kovacic: no scene: drawn on %s (--energy, --set; kovacic new scene -H '...' "
               "writes it as a file)\n",
               printable(chosen).c_str());
}

} // namespace

int section(const Settings& settings, const SectionArguments& arguments) {
  int code = exit_decided;
  const auto begun = Clock::now();
  for (const std::string& file : arguments.files) {
    const double left = settings.timeout - seconds_since(begun);
    const double seconds = settings.timeout > 0 ? std::max(left, 1e-3) : 0;
    Entry document = settings.document(file);
    const bool has_scene = !is_system_document(document) || flow::has_system_scenes(document);
    if (has_scene && (!settings.energy.empty() || !settings.set.empty()))
      throw InputError(file, 0, 0, 1, "--energy and --set are for a system without a scene",
                       "the scene says it: levels = { H = ... }, set = { ... }");
    if (!has_scene) {
      document = parse_document(with_scene(settings, document.file_text()), file);
      if (!settings.quiet) tell_scene(document);
    }
    const bool page = is_among("html", arguments.formats);
    if (page && !flow::has_system_scenes(document))
      throw InputError(file, 0, 0, 1, "pages (html) are for scenes of a system file");
    if (!flow::has_system_scenes(document))
      for (const auto& [wanted, option] : {std::pair{!arguments.part.empty(), "--part"},
                                           std::pair{arguments.homoclinic, "--homoclinic"},
                                           std::pair{!arguments.rectangle.empty(), "--in"},
                                           std::pair{arguments.period > 1, "--period"}})
        if (wanted)
          throw InputError(file, 0, 0, 1, std::string(option) + " is for scenes of a system file");
    code = std::max(code, flow::has_system_scenes(document)
                              ? system_sections(settings, arguments, file, document, seconds)
                              : Job(file, document, settings, arguments, seconds).run());
    if (code == exit_interrupted) break;
  }
  return code;
}

} // namespace kov::cli
