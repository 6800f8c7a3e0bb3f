// A scan of a scene: one number of each orbit over a line or a plane of starts or parameters.

#include "sections/scan_report.hpp"

#include "sections/plot.hpp"
#include "sections/scan_files.hpp"
#include "sections/section_files.hpp"
#include "sections/section_report.hpp"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace kov::cli {
namespace {

using flow::ScanResult;
using flow::ScanValue;
using flow::SystemScene;

const char* label_of(ScanValue of) {
  switch (of) {
  case ScanValue::megno:
    return "mean MEGNO (2: regular)";
  case ScanValue::lyapunov:
    return "largest Lyapunov exponent";
  case ScanValue::fli:
    return "fast Lyapunov indicator";
  case ScanValue::crossings:
    return "crossings";
  default:
    return "time of the end";
  }
}

std::string axes_text(const flow::Scan& scan) {
  std::string text;
  for (const flow::ScanAxis& a : scan.axes)
    text += fmt::format("{}{} from {} to {} in {} cells", text.empty() ? "" : ", ", a.name,
                        a.from.text(), a.to.text(), a.count);
  return text;
}

ColourRange colours_of(const SystemScene& s, const std::vector<double>& values) {
  std::vector<double> known;
  for (const double x : values)
    if (std::isfinite(x)) known.push_back(x);
  ColourRange range;
  if (known.empty()) return range;
  const auto quantile = [&](double part) {
    const auto place =
        known.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(known.size() - 1));
    std::nth_element(known.begin(), place, known.end());
    return *place;
  };
  if (s.scan->of == ScanValue::megno)
    return {0.1, 40, true}; // with 2, regular motion, in the middle
  range = {quantile(0.01), quantile(0.99), false};
  if (!(range.high > range.low))
    range.high = range.low + std::max(1e-3, 1e-3 * std::abs(range.low));
  return range;
}

// "3/8": the third of eight parts.
struct ScanPart {
  std::size_t number = 1, all = 1;
};

ScanPart part_of(const std::string& text) {
  if (text.empty()) return {};
  const std::size_t slash = text.find('/');
  const auto number = [&](const std::string& digits) -> std::size_t {
    if (digits.empty() || digits.size() > 6 ||
        digits.find_first_not_of("0123456789") != std::string::npos)
      throw InputError("--part", 0, 0, 1, "a part is written K/N, and not '" + text + "'",
                       "for example --part 1/8, ..., --part 8/8");
    return std::stoul(digits);
  };
  const ScanPart part{number(text.substr(0, slash)),
                      number(slash == std::string::npos ? "" : text.substr(slash + 1))};
  if (part.number < 1 || part.number > part.all)
    throw InputError("--part", 0, 0, 1, "there is no part " + text, "the parts are 1/N, ..., N/N");
  return part;
}

class ScanJob {
public:
  ScanJob(const std::string& file, const SystemScene& scene, const Settings& settings,
          const SectionArguments& o, double seconds)
      : file_(file), scene_(scene), settings_(settings), o_(o),
        name_(scene.name.empty() ? name_of_files(file) : scene.name),
        base_(base_of_files(settings, name_)), part_(part_of(o.part)), path_(journal_path()),
        journal_(path_, about()), interrupt_(seconds) {}

  int run() {
    simulate();
    if (result_.stopped) {
      complain(settings_, file_ + ": stopped; what is finished is in " + path_,
               "the same line with --resume goes on");
      return interrupt_.timed_out() ? int(exit_undecided) : int(exit_interrupted);
    }
    if (!o_.part.empty()) {
      if (!settings_.quiet) part_summary();
      return exit_decided;
    }
    write();
    if (settings_.format == "json")
      fmt::print("{}\n", json().dump(2));
    else if (!settings_.quiet)
      summary();
    if (const std::string wrong = complaint(); !wrong.empty()) {
      complain(settings_, file_ + ": " + wrong);
      return result_.orbits == 0 ? exit_input : exit_undecided;
    }
    return pictures();
  }

private:
  [[nodiscard]] std::string journal_path() const {
    return o_.part.empty() ? base_ + ".scan-part"
                           : fmt::format("{}.{}-of-{}.scan-part", base_, part_.number, part_.all);
  }

  // All that the numbers depend on.
  [[nodiscard]] std::string about() const {
    const auto mechanics = mechanics_text(scene_);
    std::string starts;
    for (const MFraction& component : scene_.system.field.components)
      starts += to_string(component) + "\n";
    for (const auto& seed : scene_.seeds)
      starts += " " + seed[0].text() + "," + seed[1].text();
    for (const auto& state : scene_.states)
      for (const auto& x : state)
        starts += " " + x.text();
    return fmt::format("{}\n{}\n{} {} {} {} {}\n{}\n", scene_.system.title, mechanics,
                       axes_text(*scene_.scan), static_cast<int>(scene_.scan->of), scene_.crossings,
                       scene_.time ? scene_.time->text() : "-", scene_.tolerance.text(), starts);
  }

  void simulate() {
    const auto begun = Clock::now();
    OrbitProgress progress(name_, "cells", !settings_.quiet);
    flow::ScanOptions options;
    options.threads = o_.threads;
    options.lanes = o_.lanes;
    options.stop = interrupt_.flag();
    options.part = part_.number - 1;
    options.parts = part_.all;
    if (o_.resume)
      options.kept = kept();
    else
      journal_.remove();
    options.progress = [&](std::size_t done, std::size_t all) { progress(done, all); };
    options.finished = [&](std::size_t number, const flow::ScanBlock& block) {
      journal_.append(number, block);
    };
    result_ = flow::simulate_scan(scene_, options);
    seconds_ = seconds_since(begun);
  }

  // Of this part, or of all parts and of a run of the whole.
  [[nodiscard]] std::map<std::size_t, flow::ScanBlock> kept() const {
    auto all = journal_.kept();
    if (o_.part.empty())
      for (const std::string& path : journals_of_parts(base_))
        all.merge(journal_.kept_in(path));
    return all;
  }

  void write() {
    std::vector<std::size_t> shape;
    for (const auto& axis : scene_.scan->axes)
      shape.insert(shape.begin(), axis.count);
    write_npy(base_ + ".npy", result_.values, shape);
    write_whole(base_ + ".scan.json", [&](std::ofstream& out) { out << json().dump(2) << "\n"; });
    journal_.remove();
    if (!o_.resume) return;
    std::error_code ignored;
    for (const std::string& path : journals_of_parts(base_))
      std::filesystem::remove(path, ignored);
  }

  [[nodiscard]] std::vector<std::string> lines() const {
    std::vector<std::string> all{
        mechanics_text(scene_),
        fmt::format("{} over {}", label_of(scene_.scan->of), axes_text(*scene_.scan)),
        fmt::format("{} orbits, {:.6g} crossings; Taylor order {}, {}, tolerance {}; {}",
                    result_.orbits + result_.early, result_.crossings, result_.order,
                    result_.arithmetic, scene_.tolerance.text(),
                    result_.integrals.empty() ? std::string("no integrals to check")
                                              : fmt::format("drift of {}: at most {:.1e}",
                                                            result_.integrals, result_.drift))};
    std::string rest;
    if (result_.empty > 0) rest = fmt::format("in {} cells no orbit starts", result_.empty);
    if (result_.early > 0)
      rest += fmt::format("{}{} orbits end early, in a singularity", rest.empty() ? "" : "; ",
                          result_.early);
    if (!rest.empty()) all.push_back(rest + " (grey)");
    return all;
  }

  void part_summary() const {
    fmt::print("{}{}\n  part {} of {}: ", file_, scene_.name.empty() ? "" : ": " + scene_.name,
               part_.number, part_.all);
    if (std::filesystem::exists(path_))
      fmt::print("{:.2f} s; finished blocks {}\n", seconds_, path_);
    else
      fmt::print("no cells, since a part has whole blocks of {}\n", flow::scan_block);
  }

  void summary() const {
    fmt::print("{}{}\n", file_, scene_.name.empty() ? "" : ": " + scene_.name);
    if (!scene_.title.empty()) fmt::print("  {}\n", scene_.title);
    for (const std::string& line : lines())
      fmt::print("  {}\n", line);
    fmt::print("  {:.2f} s; data {}.npy\n", seconds_, base_);
  }

  [[nodiscard]] nlohmann::ordered_json json() const {
    nlohmann::ordered_json axes = nlohmann::ordered_json::array();
    for (const auto& a : scene_.scan->axes)
      axes.push_back({{"name", a.name},
                      {"from", a.from.as<double>()},
                      {"to", a.to.as<double>()},
                      {"cells", a.count}});
    return {{"scan", label_of(scene_.scan->of)},
            {"title", scene_.title},
            {"mechanics", mechanics_text(scene_)},
            {"axes", axes},
            {"orbits", result_.orbits},
            {"empty_cells", result_.empty},
            {"ended_early", result_.early},
            {"crossings", result_.crossings},
            {"drift", result_.drift},
            {"array", std::filesystem::path(base_ + ".npy").filename().string()}};
  }

  [[nodiscard]] std::string complaint() const {
    if (result_.orbits == 0) return "no orbit of the scan comes to an end that has a number";
    if (result_.drift > scene_.drift.as<double>())
      return fmt::format(
          "the integrals drift by {:.1e}, more than the {} that the scene allows; no "
          "picture is drawn (lower the tolerance)",
          result_.drift, scene_.drift.text());
    return {};
  }

  [[nodiscard]] int pictures() const {
    const ScanPlot plot{scene_.title, lines(), scene_.scan->axes, label_of(scene_.scan->of),
                        colours_of(scene_, result_.values)};
    return draw(settings_, o_, interrupt_, base_, [&](std::vector<std::string> formats) {
      const bool with_page = std::erase(formats, "html") > 0;
      std::vector<std::string> drawn = draw_scan(base_, plot, formats);
      if (with_page) {
        write_whole(base_ + ".html",
                    [&](std::ofstream& out) { out << scan_page(plot, result_.values); });
        drawn.push_back(base_ + ".html");
      }
      return drawn;
    });
  }

  std::string file_;
  const SystemScene& scene_;
  const Settings& settings_;
  const SectionArguments& o_;
  std::string name_, base_;
  ScanPart part_;
  std::string path_; ///< of the journal
  ScanJournal journal_;
  Interrupt interrupt_;
  ScanResult result_;
  double seconds_ = 0;
};

} // namespace

int scan_section(const std::string& file, const SystemScene& scene, const Settings& settings,
                 const SectionArguments& arguments, double seconds) {
  for (const auto& [wanted, option] : {std::pair{arguments.fixed_points, "--fixed-points"},
                                       std::pair{arguments.homoclinic, "--homoclinic"},
                                       std::pair{!arguments.rectangle.empty(), "--in"}})
    if (wanted)
      throw InputError(file, 0, 0, 1, std::string(option) + " is not for a scene with a scan",
                       "name another scene with --scene");
  return ScanJob(file, scene, settings, arguments, seconds).run();
}

} // namespace kov::cli
