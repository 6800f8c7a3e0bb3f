// The [[expect]] blocks of a scene.

#include "flow/chaos/periodic_orbit.hpp"
#include "flow/scene/scan.hpp"
#include "flow/scene/system_section.hpp"
#include "symbol/document.hpp"
#include "systems/case_file.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace kov::cli {
namespace {

// What a block asks for, and what came out.
class Comparison {
public:
  void item(const std::string& wanted, const std::string& is, bool met) {
    wanted_ += (wanted_.empty() ? "" : ", ") + wanted;
    if (!met) found_ += (found_.empty() ? "" : ", ") + is;
  }
  void count(const std::string& kind, const std::optional<long>& wanted, long is) {
    if (wanted)
      item(fmt::format("{} {}", *wanted, kind), fmt::format("{} {}", is, kind), *wanted == is);
  }
  [[nodiscard]] Expected expected(const std::string& source) const {
    return {wanted_ + (source.empty() ? "" : "  (" + source + ")"), found_.empty(), found_};
  }

private:
  std::string wanted_, found_;
};

void compare_fixed_points(Comparison& c, const flow::SceneExpectation& x,
                          const flow::PeriodicOrbits& found) {
  const auto count = [&](flow::Stability s) {
    return std::ranges::count_if(found.orbits, [&](const auto& p) { return p.stability == s; });
  };
  c.count("elliptic", x.elliptic, count(flow::Stability::elliptic));
  c.count("hyperbolic", x.hyperbolic, count(flow::Stability::hyperbolic));
  c.count("inverse hyperbolic", x.inverse_hyperbolic, count(flow::Stability::inverse_hyperbolic));
  if (!x.proved) return;
  const auto open = std::ranges::find_if(found.orbits, [](const auto& p) { return !p.proved; });
  c.item("all proved", open == found.orbits.end() ? "" : "not proved: " + to_string(open->why),
         open == found.orbits.end());
}

} // namespace

std::vector<Expected> test_system_scenes(const Entry& document) {
  std::vector<Expected> all;
  for (const flow::SystemScene& scene : flow::read_system_scenes(document)) {
    if (scene.expect.empty()) continue;
    flow::SystemSection run;
    if (scene.scan) {
      const flow::ScanResult scan = flow::simulate_scan(scene, {});
      run.drift = scan.drift;
      run.orbits.assign(scan.early, {});
      for (flow::DrawnOrbit& o : run.orbits)
        o.ended = flow::Ended::singular;
    } else {
      run = flow::simulate(scene);
    }
    for (const auto& x : scene.expect) {
      Comparison c;
      c.count("points", x.points, static_cast<long>(run.points.size()));
      c.count("singular", x.singular, static_cast<long>(run.count(flow::Ended::singular)));
      if (x.drift)
        c.item("drift at most " + x.drift->text(), fmt::format("drift {:.1e}", run.drift),
               run.drift <= x.drift->as<double>());
      if (x.never_crossed)
        c.item("never crossed", fmt::format("{} crossings", run.points.size()), run.points.empty());
      if (x.of_fixed_points()) {
        flow::PeriodicOptions options;
        options.prove = x.proved;
        compare_fixed_points(c, x, flow::periodic_orbits(scene, options));
      }
      Expected e = c.expected(x.source);
      if (!scene.name.empty()) e.name = scene.name + ": " + e.name;
      all.push_back(std::move(e));
    }
  }
  return all;
}

CaseReport test_case(const Settings& settings, const std::string& path) {
  const Entry document = read_document(path);
  if (has_format(document, "theorem")) return test_theorem(settings, path);
  const bool scenes = flow::has_system_scenes(document);
  CaseReport report;
  if (!has_format(document, "scene"))
    report = is_equation_file(document) ? check_equation(settings, document)
                                        : check_system_file(settings, path);
  if (report.json.is_object()) // a limit, before anything could be compared
    report.expected.push_back(
        {.name = "decided", .met = false, .found = report.json.value("reason", "a limit")});
  if (scenes) {
    const std::vector<Expected> all = test_system_scenes(document);
    report.expected.insert(report.expected.end(), all.begin(), all.end());
  }
  return report;
}

} // namespace kov::cli
