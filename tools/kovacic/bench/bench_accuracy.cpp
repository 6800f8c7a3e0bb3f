#include "bench/bench.hpp"

#include "bench/effort.hpp"
#include "exact/lists.hpp"
#include "flow/field/field_kernels.hpp"
#include "process/subprocess.hpp"
#include "sections/plot.hpp"
#include "symbol/document.hpp"

#include <fmt/core.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>

namespace kov::cli {
namespace {

namespace fs = std::filesystem;
using flow::Arithmetic;

struct Row {
  std::string method;
  flow::Effort effort;
  [[nodiscard]] double rate() const {
    return static_cast<double>(effort.crossings) / effort.seconds;
  }
};

void show(const Row& r) {
  const flow::Effort& e = r.effort;
  fmt::print("  {:22} {:7.0e}  {:9.4f} s  {:9.0f} crossings/s  drift {:8.1e}  error {:8.1e}{}\n",
             r.method, e.tolerance, e.seconds, r.rate(), e.drift, e.error,
             e.wrong > 0 ? fmt::format("  {} orbits with another number of crossings", e.wrong)
                         : "");
  std::fflush(stdout);
}

struct Sweep {
  Arithmetic arithmetic;
  int from, to, by; ///< digits of the tolerance
};

void our_rows(std::vector<Row>& rows, const flow::SystemScene& scene,
              const flow::Reference& reference, const std::vector<Sweep>& sweeps,
              const std::string& suffix, double seconds) {
  for (const Sweep& s : sweeps)
    for (int digits = s.from; digits <= s.to; digits += s.by) {
      rows.push_back(
          {to_string(s.arithmetic) + suffix, measure(scene, s.arithmetic, digits, reference)});
      show(rows.back());
      if (rows.back().effort.seconds > seconds) break;
    }
}

void write_reference(const fs::path& path, const flow::Reference& reference) {
  std::ofstream out(path);
  for (std::size_t i = 0; i < reference.crossings.size(); ++i) {
    fmt::print(out, "{} {}", i, reference.crossings[i]);
    for (const auto& p : reference.points[i])
      fmt::print(out, " {:.17g} {:.17g}", static_cast<double>(p[0]), static_cast<double>(p[1]));
    fmt::print(out, "\n");
  }
}

// The lines that the other program prints (tools/bench/peers.cpp).
void peer_rows(std::vector<Row>& rows, const BenchArguments& a, const fs::path& reference) {
  const std::vector<std::string> words{a.peers, a.scene, reference.string(),
                                       fmt::format("{}", a.seconds)};
  const std::optional<std::string> lines = output_of(words);
  if (!lines) throw InputError(a.peers, 0, 0, 1, "this program cannot be run, or fails");
  std::istringstream in(*lines);
  std::string method;
  flow::Effort e;
  for (std::string drift, error, tolerance;
       in >> method >> tolerance >> e.seconds >> e.crossings >> e.wrong >> drift >> error;) {
    e.tolerance = std::stod(tolerance);
    e.drift = std::stod(drift); // also "inf"
    e.error = std::stod(error);
    rows.push_back({method, e});
    show(rows.back());
  }
}

// Crossings per second at a given drift, from the two runs around it; unset where the method does
// not arrive.
std::optional<double> rate_at(const std::vector<Row>& rows, const std::string& method,
                              double drift) {
  const Row *above = nullptr, *below = nullptr; // the nearest on each side
  for (const Row& r : rows) {
    if (r.method != method || !std::isfinite(r.effort.drift)) continue;
    if (r.effort.drift > drift && (above == nullptr || r.effort.drift < above->effort.drift))
      above = &r;
    if (r.effort.drift <= drift && (below == nullptr || r.rate() > below->rate())) below = &r;
  }
  if (below == nullptr) return std::nullopt;
  if (above == nullptr || above->rate() < below->rate()) return below->rate();
  const double u =
      std::log(drift / below->effort.drift) / std::log(above->effort.drift / below->effort.drift);
  return std::exp(std::log(below->rate()) * (1 - u) + std::log(above->rate()) * u);
}

std::vector<std::string> methods(const std::vector<Row>& rows) {
  std::vector<std::string> names;
  for (const Row& r : rows)
    add_once(names, r.method);
  return names;
}

std::string summary(const std::vector<Row>& rows) {
  const std::string ours = to_string(Arithmetic::packs);
  std::string text = "crossings per second at a given drift of the integrals, and the ratio of " +
                     ours + " to it\n";
  text += fmt::format("{:24}", "method");
  const double drifts[] = {1e-6, 1e-9, 1e-12};
  for (const double d : drifts)
    text += fmt::format("{:>22}", fmt::format("drift {:.0e}", d));
  text += "\n";
  double best = 0;
  for (const std::string& m : methods(rows)) {
    text += fmt::format("{:24}", m);
    for (const double d : drifts) {
      const auto rate = rate_at(rows, m, d), us = rate_at(rows, ours, d);
      text += fmt::format("{:>22}",
                          rate && us ? fmt::format("{:.0f} ({:.1f})", *rate, *us / *rate) : "-");
    }
    text += "\n";
    if (m.starts_with("odeint")) best = std::max(best, rate_at(rows, m, 1e-9).value_or(0));
  }
  const auto fine = rate_at(rows, ours, 1e-12);
  if (best > 0 && fine)
    text += fmt::format("{} at drift 1e-12 against the best of odeint at 1e-9: {:.1f}\n", ours,
                        *fine / best);
  std::map<std::string, std::pair<double, double>> least;
  for (const Row& r : rows) {
    auto [it, fresh] = least.try_emplace(r.method, INFINITY, INFINITY);
    it->second.first = std::min(it->second.first, r.effort.drift);
    it->second.second = std::min(it->second.second, r.effort.error);
  }
  text += "least drift and least error of the first ten points\n";
  for (const std::string& m : methods(rows))
    text += fmt::format("{:24}{:10.1e}{:10.1e}\n", m, least[m].first, least[m].second);
  return text;
}

void write_rows(const fs::path& path, const flow::SystemScene& scene,
                const std::vector<Row>& rows) {
  std::ofstream out(path);
  fmt::print(out, "# {}; {}, {}\n", scene.title, to_string(flow::best_isa()), scene.file);
  fmt::print(out, "# seconds of the processor; wrong: orbits with another number of crossings than "
                  "the reference; error: "
                  "of the first ten points\n");
  fmt::print(
      out,
      "method tolerance order seconds crossings wrong drift error microseconds_per_crossing\n");
  for (const Row& r : rows)
    fmt::print(out, "{} {:.0e} {} {:.6f} {} {} {:.3e} {:.3e} {:.4g}\n", r.method,
               r.effort.tolerance, r.effort.order, r.effort.seconds, r.effort.crossings,
               r.effort.wrong, r.effort.drift, r.effort.error, 1e6 / r.rate());
  close_file(out, path.string());
}

} // namespace

int bench_accuracy(const Settings& settings, const BenchArguments& a) {
  const flow::SystemScene scene = flow::read_system_scenes(read_document(a.scene)).front();
  if (!scene.time) throw InputError(a.scene, 0, 0, 1, "bench accuracy needs a scene with a time");
  const fs::path directory = settings.output.empty() ? "." : settings.output;
  make_directory(directory.string());
  fmt::print("reference: to t = {}, in pairs of doubles; its first points in 40 digits\n",
             scene.time->text());
  std::fflush(stdout);
  const flow::Reference reference = flow::reference_of(scene, 40);
  const fs::path reference_file =
      fs::temp_directory_path() / fmt::format("kovacic-reference-{}.txt", std::clock());
  write_reference(reference_file, reference);
  std::vector<Row> rows;
  our_rows(rows, scene, reference,
           {{Arithmetic::packs, 4, 17, 1},
            {Arithmetic::one_lane, 4, 17, 1},
            {Arithmetic::extended, 4, 20, 2},
            {Arithmetic::pairs, 6, 30, 3}},
           "", a.seconds);
  if (!a.peers.empty()) peer_rows(rows, a, reference_file);
  fs::remove(reference_file);
  // High precision is slow: fewer orbits, long enough for the first ten points.
  flow::SystemScene few = scene;
  few.columns = few.rows = 2;
  few.time = flow::Quantity("45");
  our_rows(rows, few, flow::reference_of(few, 70), {{Arithmetic::mpfr, 10, 60, 10}}, "", a.seconds);
  write_rows(directory / "accuracy.dat", scene, rows);
  const std::string text = summary(rows);
  write_file((directory / "accuracy.txt").string(), text);
  fmt::print("{}", text);
  const std::string base = (directory / "accuracy").string();
  for (const char* ordinate : {"drift", "error"}) {
    ChartPlot chart;
    chart.title = std::string(ordinate) == "drift"
                      ? "What a small drift of the integrals costs"
                      : "What a small error of the first ten section points costs";
    chart.data = "accuracy.dat";
    chart.x = ordinate;
    chart.x_label = chart.x == "drift" ? "largest relative drift of the integrals"
                                       : "largest error of the first ten points";
    chart.y = "microseconds_per_crossing";
    chart.y_label = "microseconds of the processor for a crossing";
    chart.series_column = "method";
    chart.series = methods(rows);
    chart.falling = true;
    for (const std::string& picture : draw_chart(base + "_" + ordinate, chart, a.formats))
      fmt::print("picture {}\n", picture);
  }
  return exit_decided;
}

} // namespace kov::cli
