// Sections of any system: the scenes of a system file.

#include "flow/scene/system_section.hpp"
#include "certify/homoclinic/check.hpp"
#include "exact/lists.hpp"
#include "output/page_width.hpp"
#include "sections/chaos_report.hpp"
#include "sections/plot.hpp"
#include "sections/scan_report.hpp"
#include "sections/section_files.hpp"
#include "sections/section_page.hpp"
#include "sections/section_report.hpp"
#include "symbol/document.hpp"
#include "symbol/suggest.hpp"

#include <fmt/core.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>

namespace kov::cli {
namespace {

using flow::Ended;
using flow::Indicator;
using flow::SystemScene;
using flow::SystemSection;

// The form whose sign colours the orbits.
std::string form_of(const flow::Scene& s) {
  std::string sum;
  for (std::size_t i = 0; i < 3; ++i)
    if (const std::string factor = (*s.sign_of)[i].text(); factor != "0")
      sum += fmt::format("{}{} M{}", sum.empty() ? "" : " + ", factor, i + 1);
  return sum;
}

// A column has no spaces.
std::string column(const std::string& text) {
  std::string name;
  for (const char c : text)
    if (c != ' ' && c != '"') name += c;
  return name;
}

bool has_errors(const SystemSection& r) {
  return std::ranges::any_of(r.points, [](const auto& p) { return p.error >= 0; });
}

void write_points(const std::string& path, const SystemScene& s, const SystemSection& r) {
  write_whole(path, [&](std::ofstream& out) {
    if (const std::string missing = partial(r); !missing.empty())
      fmt::print(out, "# {}\n", missing);
    fmt::print(out, "# {}\n", s.title);
    for (const std::string& line : caption(s, r))
      fmt::print(out, "# {}\n", line);
    for (const std::string& line : remarks(s, r))
      fmt::print(out, "# {}\n", line);
    const std::string colour = colour_of(s);
    const bool errors = has_errors(r);
    if (errors) fmt::print(out, "# error: of the point, in units of the size of what is drawn\n");
    fmt::print(out, "orbit t {} {}{}{}{}\n", column(s.plot[0].text), column(s.plot[1].text),
               colour.empty() ? "" : " ", colour, errors ? " error" : "");
    const int n = flow::digits_shown(s.tolerance, s.digits);
    for (const auto& p : r.points) {
      std::string last =
          colour.empty() ? "" : fmt::format(" {:.6g}", indicator_of(s, r.orbits[p.orbit]));
      if (errors) last += fmt::format(" {:.1e}", p.error);
      if (p.digits.empty())
        fmt::print(out, "{} {:.{}g} {:.{}g} {:.{}g}{}\n", p.orbit, p.t, n, p.at[0],
                   std::max(1, n - digits_lost(p, 0)), p.at[1], std::max(1, n - digits_lost(p, 1)),
                   last);
      else
        fmt::print(out, "{} {}{}\n", p.orbit, p.digits, last);
    }
  });
}

std::string motion_columns(const SystemScene& s) {
  std::string text;
  for (long i = 1; i <= s.exponents; ++i)
    text += fmt::format(" lyapunov_{0} lyapunov_{0}_error", i);
  if (s.exponents > 1) text += " log10_sali";
  for (long i = 2; i <= s.exponents; ++i)
    text += fmt::format(" log10_gali_{}", i);
  return text + (s.winding ? " winding winding_error" : "");
}

std::string motion_of(const SystemScene& s, const flow::DrawnOrbit& o) {
  std::string text;
  const auto number = [&](bool known, double x) {
    text += known ? fmt::format(" {:.12g}", x) : " -";
  };
  const auto n = static_cast<std::size_t>(s.exponents);
  const bool known = o.spectrum.exponents.size() == n;
  for (std::size_t i = 0; i < n; ++i) {
    number(known, known ? o.spectrum.exponents[i].rate : 0);
    number(known, known ? o.spectrum.exponents[i].error : 0);
  }
  if (n > 1) number(known, o.spectrum.log_sali);
  for (std::size_t i = 0; i + 1 < n; ++i)
    number(known, known ? o.spectrum.log_gali[i] : 0);
  if (s.winding) {
    number(!(o.winding.error < 0), o.winding.turns);
    number(!(o.winding.error < 0), o.winding.error);
  }
  return text;
}

void write_orbits(const std::string& path, const SystemScene& s, const SystemSection& r) {
  write_whole(path, [&](std::ofstream& out) {
    if (const std::string missing = partial(r); !missing.empty())
      fmt::print(out, "# {}\n", missing);
    const bool with = s.has_tangent();
    fmt::print(out,
               "orbit {}_0 {}_0 crossings tangencies steps time drift{}{} rest_from inside_from "
               "ended_by\n",
               column(s.plot[0].text), column(s.plot[1].text),
               with ? " lyapunov lyapunov_error fli megno" : "", motion_columns(s));
    for (std::size_t i = 0; i < r.orbits.size(); ++i) {
      const auto& o = r.orbits[i];
      const auto& c = o.indicators;
      const std::string chaos = with ? fmt::format(" {:.6g} {:.2g} {:.6g} {:.6g}", c.lyapunov,
                                                   c.lyapunov_error, c.fli, c.megno)
                                     : "";
      const auto since = [](double t) {
        return t < 0 ? std::string("-") : fmt::format("{:.8g}", t);
      };
      fmt::print(out, "{} {:.12g} {:.12g} {} {} {} {:.8g} {:.2e}{}{} {} {} {}\n", i, o.start[0],
                 o.start[1], o.crossings, o.tangencies, o.steps, o.time, o.drift, chaos,
                 motion_of(s, o), since(o.rest_from), since(o.inside_from), word(o.ended));
    }
  });
}

class SystemJob {
public:
  SystemJob(const std::string& file, const SystemScene& scene, const Settings& settings,
            const SectionArguments& o, double seconds)
      : file_(file), scene_(scene), settings_(settings), o_(o),
        name_(scene.name.empty() ? name_of_files(file) : scene.name),
        base_(base_of_files(settings, name_)), interrupt_(seconds) {}

  int run() {
    simulate();
    if (!settings_.quiet && settings_.format != "json") summary();
    if (const std::string wrong = complaint(); !wrong.empty()) {
      complain(settings_, file_ + ": " + wrong);
      return result_.points.empty() && result_.count(Ended::lost) == 0 && shortfall(result_).empty()
                 ? exit_input
                 : exit_undecided;
    }
    const bool whole = proofs();
    const int code = pictures();
    if (shortfall(result_).empty()) return whole ? code : std::max(code, int(exit_undecided));
    if (interrupt_.flag()->load() && !interrupt_.timed_out()) return exit_interrupted; // by hand
    complain(settings_, file_ + ": the result is partial, and its files say so");
    return exit_undecided;
  }

private:
  void write(const SystemSection& r) const {
    write_points(base_ + ".dat", scene_, r);
    write_orbits(base_ + ".orbits.dat", scene_, r);
  }

  void simulate() {
    const auto begun = Clock::now();
    auto written = begun;
    double cost = 0;
    OrbitProgress progress(name_, "orbits", !settings_.quiet);
    flow::SystemSectionOptions options;
    options.threads = o_.threads;
    options.lanes = o_.lanes;
    options.stop = interrupt_.flag();
    options.progress = [&](std::size_t done, std::size_t all) { progress(done, all); };
    options.finished_some = [&](const SystemSection& so_far) { // what a crash must not take away
      if (seconds_since(written) < std::max(10.0, 20 * cost)) return;
      const auto now = Clock::now();
      write(so_far);
      cost = seconds_since(now);
      written = Clock::now();
    };
    result_ = flow::simulate(scene_, options);
    seconds_ = seconds_since(begun);
    write(result_);
  }

  // What is wrong with the result, in words; empty if nothing.
  [[nodiscard]] std::string complaint() const {
    if (result_.points.empty() && result_.count(Ended::steps) > 0)
      return fmt::format("no crossing within the limit of steps, which {} of {} orbits reached (a "
                         "'time' has no such limit)",
                         result_.count(Ended::steps), result_.orbits.size());
    if (result_.drift > scene_.drift.as<double>())
      return fmt::format("the integrals drift by {:.1e}, more than the {} that the scene allows; "
                         "no picture is drawn ({})",
                         result_.drift, scene_.drift.text(),
                         result_.drift > 1e-3 && result_.integrals.back() == "functions" &&
                                 result_.drifts.back() == result_.drift
                             ? "a function has left its branch, or is not what 'means' says"
                         : result_.count(flow::Ended::lost) > 0
                             ? "lower the tolerance, or more 'digits'"
                             : "lower the tolerance");
    if (result_.points.empty() && !result_.stopped) return never_crossed(scene_, result_);
    return {};
  }

  static void say(const std::string& line) {
    fmt::print("{}", for_standard_output("  " + line + "\n"));
  }

  void summary() const {
    fmt::print("{}{}\n", file_, scene_.name.empty() ? "" : ": " + scene_.name);
    if (!scene_.title.empty()) say(scene_.title);
    for (const std::string& line : caption(scene_, result_))
      say(line);
    if (result_.skipped > 0) say(outside_of_level(scene_, result_));
    for (const std::string& line : remarks(scene_, result_))
      say(line);
    if (scene_.has_tangent()) say(chaos_of(result_));
    if (scene_.exponents > 0) say(spectrum_text(result_));
    if (scene_.winding && !scene_.return_map) say(winding_text(result_));
    if (const std::string missing = partial(result_); !missing.empty()) say(missing);
    fmt::print("  {:.2f} s; data {}.dat\n", seconds_, base_);
  }

  [[nodiscard]] int pictures() const {
    PlanePlot plot;
    const std::string missing = partial(result_);
    plot.title = scene_.title + (missing.empty() ? "" : "  [" + missing + "]");
    plot.caption = caption(scene_, result_);
    for (const std::string& line : remarks(scene_, result_))
      plot.caption.push_back(line);
    for (std::size_t i = 0; i < 2; ++i) {
      plot.labels[i] = scene_.plot[i].text;
      plot.columns[i] = column(scene_.plot[i].text);
    }
    plot.angle = scene_.angle;
    if (scene_.range && !scene_.return_map) { // what runs away does not set the axes
      plot.range.emplace();
      for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t k = 0; k < 2; ++k)
          (*plot.range)[i][k] = (*scene_.range)[i][k].as<double>();
    }
    plot.turned = scene_.sphere.has_value();
    plot.plain = scene_.body != nullptr;
    if (scene_.sign_of) plot.form = form_of(scene_.body->scene);
    plot.colour = to_string(scene_.indicator);
    plot.colour_label = scene_.indicator == Indicator::lyapunov ? "largest Lyapunov exponent"
                        : scene_.indicator == Indicator::fli    ? "fast Lyapunov indicator"
                        : scene_.indicator == Indicator::sali ? "log10 SALI (far below 0: chaotic)"
                                                              : "mean MEGNO (2: regular)";
    plot.logarithmic = scene_.indicator == Indicator::megno;
    plot.points = result_.points.size();
    plot.errors = has_errors(result_);
    plot.marks = marks_;
    plot.manifolds = manifolds_;
    return draw(settings_, o_, interrupt_, base_, [&](std::vector<std::string> formats) {
      const bool with_page = std::erase(formats, "html") > 0;
      std::vector<std::string> drawn = draw_plane(base_, plot, formats);
      if (with_page) drawn.push_back(write_page(plot));
      return drawn;
    });
  }

  // Periodic orbits and homoclinic points; false: not all that was asked for is proved.
  bool proofs() {
    const bool any = o_.fixed_points || o_.homoclinic || !o_.rectangle.empty();
    if ((!any || result_.stopped) && settings_.format != "json") return true;
    flow::PeriodicOrbits orbits;
    flow::Homoclinic homoclinic;
    std::string text;
    if (o_.fixed_points) {
      orbits = periodic_orbits();
      write_periodic_orbits(base_ + ".fixed.dat", scene_, orbits);
      for (const auto& o : orbits.orbits)
        marks_.insert({kind_of(o), o.proved});
      text += proof_text(scene_, orbits);
    }
    std::optional<flow::FixedPointsInRectangle> all;
    if (!o_.rectangle.empty()) {
      all = all_fixed_points();
      text += proof_text(scene_, *all, o_.rectangle);
    }
    if (o_.homoclinic) {
      homoclinic = homoclinic_point();
      write_homoclinic(base_ + ".homoclinic.dat", scene_, homoclinic);
      manifolds_ = !homoclinic.unstable.empty();
      text += proof_text(scene_, homoclinic);
    }
    if (settings_.format == "json")
      text = json_of(scene_, o_.fixed_points ? &orbits : nullptr,
                     o_.homoclinic ? &homoclinic : nullptr, all ? &*all : nullptr,
                     json_of(scene_, result_)) +
             "\n";
    if (settings_.format == "json" || !settings_.quiet) fmt::print("{}", text);
    return !orbits.stopped && (!o_.homoclinic || homoclinic.proof) && (!all || complete(*all));
  }

  [[nodiscard]] flow::PeriodicOrbits periodic_orbits() const {
    auto written = Clock::now();
    OrbitProgress progress(name_, "proofs", !settings_.quiet);
    flow::PeriodicOptions options;
    options.period = o_.period;
    options.stop = interrupt_.flag();
    options.progress = [&](const flow::PeriodicOrbits& so_far, std::size_t proofs) {
      progress(proofs, so_far.orbits.size());
      if (seconds_since(written) < 10) return;
      flow::PeriodicOrbits copy = so_far; // what a crash must not take away
      copy.stopped = true;
      write_periodic_orbits(base_ + ".fixed.dat", scene_, copy);
      written = Clock::now();
    };
    return flow::periodic_orbits(scene_, options);
  }

  // With a certificate that is written, if our own judge accepts it: he keeps a cone on a region that the
  // finder need not look at, and so the region is made smaller.
  [[nodiscard]] flow::Homoclinic homoclinic_point() const {
    flow::HomoclinicOptions options;
    options.period = o_.period;
    options.stop = interrupt_.flag();
    if (settings_.certificate.empty()) return flow::homoclinic(scene_, options);
    options.bits = 128;
    std::optional<flow::Homoclinic> refused;
    for (const int smaller : {16, 32, 8}) {
      options.smaller = smaller;
      flow::Homoclinic found = flow::homoclinic(scene_, options);
      if (found.stopped) return found;
      if (!found.proof) {
        if (!refused) refused = std::move(found);
        continue;
      }
      const std::string certificate = certificate_of(scene_, found);
      const auto verdict =
          certify::check_homoclinic(certify::read_homoclinic_certificate(certificate));
      if (const auto* no = std::get_if<certify::Rejected>(&verdict)) {
        refused = flow::Homoclinic{};
        refused->why = flow::NotProved::refused;
        refused->by_checker = no->step + ": " + no->why;
        continue;
      }
      write_file(settings_.certificate, certificate);
      return found;
    }
    return *refused;
  }

  [[nodiscard]] flow::FixedPointsInRectangle all_fixed_points() const {
    const auto& r = o_.rectangle;
    flow::RectangleOptions options;
    options.period = o_.period;
    options.stop = interrupt_.flag();
    return flow::fixed_points_in(
        scene_, {{{r[0].c_str(), r[1].c_str()}, {r[2].c_str(), r[3].c_str()}}}, options);
  }

  // "orbit 3 from (0.1, 0.2): 300 crossings until t = 2000, drift 1e-14; ended by crossings"
  [[nodiscard]] std::string text_of(std::size_t i) const {
    const flow::DrawnOrbit& o = result_.orbits[i];
    const auto& c = o.indicators;
    const std::string chaos =
        !scene_.has_tangent() || o.ended == flow::Ended::lost
            ? ""
            : fmt::format("; Lyapunov exponent {:.3g} +- {:.1g}, MEGNO {:.3g}, FLI {:.3g}",
                          c.lyapunov, c.lyapunov_error, c.megno, c.fli);
    const std::string still =
        (o.rest_from < 0 ? "" : fmt::format("; at rest from t = {:.6g} on", o.rest_from)) +
        (o.inside_from < 0 ? ""
                           : fmt::format("; in the section from t = {:.6g} on", o.inside_from));
    return fmt::format("orbit {} from ({:.6g}, {:.6g}): {} crossings until t = {:.6g}, drift "
                       "{:.1e}{}{}; ended by: {}",
                       i, o.start[0], o.start[1], o.crossings, o.time, o.drift, chaos, still,
                       word(o.ended));
  }

  static void add_point(SectionPage::Orbit& o, const flow::DrawnPoint& p) {
    if (o.right == o.points.size() && p.error <= flow::visible_error) ++o.right;
    o.points.push_back(p.at);
  }

  [[nodiscard]] std::string write_page(const PlanePlot& plot) const {
    SectionPage page{plot.title, plot.caption, plot.labels, {}, plot.logarithmic, {}};
    if (!plot.colour.empty()) page.colour_label = plot.colour_label;
    for (std::size_t i = 0; i < result_.orbits.size(); ++i)
      page.orbits.push_back({text_of(i), indicator_of(scene_, result_.orbits[i]), {}});
    for (const auto& p : result_.points)
      add_point(page.orbits[p.orbit], p);
    write_whole(base_ + ".html", [&](std::ofstream& out) { out << section_page(page); });
    return base_ + ".html";
  }

  std::string file_;
  const SystemScene& scene_;
  const Settings& settings_;
  const SectionArguments& o_;
  std::string name_, base_;
  Interrupt interrupt_;
  SystemSection result_;
  double seconds_ = 0;
  std::set<FixedPointMark> marks_; ///< of the periodic points
  bool manifolds_ = false;         ///< there are arcs to draw
};

std::vector<SystemScene> wanted(std::vector<SystemScene> scenes, const SectionArguments& o,
                                const std::string& file) {
  if (o.names.empty()) return scenes;
  std::vector<std::string> names;
  for (const SystemScene& s : scenes)
    names.push_back(s.name);
  for (const std::string& name : o.names)
    if (!is_among(name, names))
      throw InputError(file, 0, 0, 1, "there is no scene '" + name + "'",
                       "scenes: " + enumerate(names));
  std::erase_if(scenes, [&](const SystemScene& s) { return !is_among(s.name, o.names); });
  return scenes;
}

} // namespace

int system_sections(const Settings& settings, const SectionArguments& arguments,
                    const std::string& file, const Entry& document, double seconds) {
  const auto begun = Clock::now();
  int code = exit_decided;
  const std::vector<SystemScene> scenes = [&] {
    try {
      return wanted(flow::read_system_scenes(document), arguments, file);
    } catch (const OutOfBudget& e) {
      throw InputError(file, 0, 0, 1, e.what());
    }
  }();
  for (const SystemScene& scene : scenes) {
    for (const auto& [given, option] : {std::pair{arguments.homoclinic, "--homoclinic"},
                                        std::pair{!arguments.rectangle.empty(), "--in"}})
      if (given && scene.body)
        throw InputError(file, 0, 0, 1, std::string(option) + " is for scenes of a system file");
    if (!scene.scan &&
        (arguments.fixed_points || arguments.homoclinic || !arguments.rectangle.empty()))
      static_cast<void>(flow::SectionSurface(scene)); // refused before the orbits
    if (!scene.scan && !arguments.part.empty())
      throw InputError(file, 0, 0, 1, "--part is for a scene with a scan",
                       "name such a scene with --scene");
    const double left = seconds > 0 ? std::max(seconds - seconds_since(begun), 1e-3) : 0;
    code = std::max(code, scene.scan ? scan_section(file, scene, settings, arguments, left)
                                     : SystemJob(file, scene, settings, arguments, left).run());
    if (code == exit_interrupted) break;
  }
  return code;
}

} // namespace kov::cli
