// kovacic-proofs CASES: what certainty costs for points of section maps.  One line for each:
//   fixed SCENE period numerically proved error
//   homoclinic SCENE returns numerically proved error
// Seconds of the processor, the best of three.  fixed: Newton's method in double from a start 1e-3 away, and the proof with
// the stability (periodic_orbit.hpp), means over the orbits that are proved.  homoclinic: the search for crossings of the two
// manifolds in double, and everything with the proof (homoclinic.hpp).

#include "flow/chaos/homoclinic.hpp"
#include "flow/chaos/manifold_arcs.hpp"
#include "symbol/document.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>

namespace kov::bench {
namespace {

using namespace kov::flow;

template <class Work> double seconds_of(const Work& work, int turns = 3) {
  double best = INFINITY;
  for (int turn = 0; turn < turns; ++turn) {
    const std::clock_t begun = std::clock();
    work();
    best = std::min(best, static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC);
  }
  return best;
}

// To the fixed point of P^period near x; true: it is there.
bool newton(QuickMap& quick, const std::vector<double>& x, int period) {
  const Chart chart = chart_at(quick.code(), x);
  double size = 0;
  for (const double c : x)
    size = std::max(size, std::abs(c));
  std::array<double, 2> at{x[chart.free[0]] + 1e-3 * size, x[chart.free[1]] - 1e-3 * size};
  for (int i = 0; i < 20; ++i) {
    const auto from = quick.lifted(chart, at, x);
    const auto image = from ? quick(*from, false, period) : std::nullopt;
    if (!image) return false;
    const auto &a = image->at[chart.free[0]], &b = image->at[chart.free[1]];
    const double p = a.d[0] - 1, q = a.d[1], r = b.d[0], s = b.d[1] - 1, det = p * s - q * r;
    const double u = a.v - at[0], v = b.v - at[1];
    const double du = (s * u - q * v) / det, dv = (p * v - r * u) / det;
    at = {at[0] - du, at[1] - dv};
    if (std::abs(du) + std::abs(dv) < 1e-12 * size) return true;
  }
  return false;
}

void fixed_points(const SystemScene& scene, int period) {
  const SectionSurface surface(scene);
  QuickMap quick(surface);
  PeriodicOptions options;
  options.period = period;
  options.columns = options.rows = 8;
  const EnclosureScope scope(options.bits);
  EnclosedMap map(surface, nullptr);
  double numerically = 0, proved = 0, error = 0;
  int orbits = 0;
  for (const PeriodicOrbit& found : look_for_orbits(scene, quick, options).orbits) {
    PeriodicOrbit one;
    const std::vector<double>& x = found.points[0].x;
    if (orbits == 6 || !newton(quick, x, period)) continue;
    const double by_proof = seconds_of([&] { one = prove_orbit(map, quick, found); });
    if (!one.proved) continue;
    ++orbits;
    proved += by_proof;
    error = std::max(error, one.error);
    numerically += seconds_of([&] { newton(quick, x, period); });
  }
  if (orbits > 0)
    std::printf("fixed %s %d %.3g %.3g %.0e\n", scene.name.c_str(), period, numerically / orbits,
                proved / orbits, error);
  std::fflush(stdout);
}

void homoclinic_points(const SystemScene& scene) {
  Homoclinic found;
  const double whole = seconds_of([&] { found = homoclinic(scene); }, 1);
  if (!found.proof) return;
  const HomoclinicProof& p = *found.proof;
  const SectionSurface surface(scene);
  QuickMap quick(surface);
  LocalFrame frame;
  frame.chart = p.chart;
  frame.near = p.fixed.points[0].x;
  frame.at = {frame.near[p.chart.free[0]], frame.near[p.chart.free[1]]};
  frame.axes = p.axes;
  frame.stretch_unstable = p.stretch_unstable;
  frame.stretch_stable = p.stretch_stable;
  frame.reach = p.reach;
  const double search = seconds_of(
      [&] { static_cast<void>(ManifoldArcs(quick, frame, 60000, nullptr).guesses(12)); }, 1);
  std::printf("homoclinic %s %zu %.3g %.3g %.0e\n", scene.name.c_str(), p.orbit.size() - 1, search,
              whole, p.error);
  std::fflush(stdout);
}

const SystemScene& named(const std::vector<SystemScene>& all, const std::string& name) {
  return *std::ranges::find_if(all, [&](const auto& s) { return s.name == name; });
}

} // namespace
} // namespace kov::bench

int main(int argc, char** argv) {
  using namespace kov::bench;
  const std::string cases = argc > 1 ? argv[1] : "cases";
  const auto henon =
      kov::flow::read_system_scenes(kov::read_document(cases + "/sections/henon_heiles.toml"));
  for (const int period : {1, 2, 3, 5})
    fixed_points(named(henon, "henon_heiles_8"), period);
  homoclinic_points(named(henon, "henon_heiles_8"));
  homoclinic_points(named(henon, "henon_heiles_6"));
}
