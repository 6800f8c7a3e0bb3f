// The invariant plane of the Hess-Appelrot case is unstable: an orbit on it leaves through rounding
// only, and later with every digit more.
#include "bench/bench.hpp"

#include "bench/escape.hpp"
#include "sections/plot.hpp"
#include "symbol/document.hpp"

#include <fmt/core.h>
#include <fmt/ostream.h>

#include <filesystem>
#include <fstream>

namespace kov::cli {
namespace {

namespace fs = std::filesystem;
using flow::Arithmetic;

struct Precision {
  Arithmetic arithmetic;
  int digits;
};
const Precision precisions[] = {{Arithmetic::one_lane, 16}, {Arithmetic::extended, 19},
                                {Arithmetic::pairs, 32},    {Arithmetic::mpfr, 40},
                                {Arithmetic::mpfr, 50},     {Arithmetic::mpfr, 60}};

} // namespace

int bench_escape(const Settings& settings, const BenchArguments& a) {
  const flow::SystemScene scene = flow::read_system_scenes(read_document(a.scene)).front();
  const fs::path directory = settings.output.empty() ? "." : settings.output;
  make_directory(directory.string());
  std::ofstream out(directory / "escape.dat");
  fmt::print(out,
             "# {}: time until an orbit that starts on the invariant plane has left it by 1/100\n",
             scene.title);
  fmt::print(out, "l arithmetic digits time\n");
  ChartPlot chart;
  for (const char* l : {"1/2", "1", "4", "5"}) {
    chart.series.emplace_back(l);
    for (const Precision& p : precisions) {
      const double time = escape_time(scene, p.arithmetic, p.digits, flow::Quantity(l), 2000);
      fmt::print("  l = {:4} {:17} {:3} digits: leaves the plane at t = {:.2f}\n", l,
                 to_string(p.arithmetic), p.digits, time);
      std::fflush(stdout);
      fmt::print(out, "{} {} {} {:.4f}\n", l, to_string(p.arithmetic), p.digits, time);
    }
  }
  close_file(out, (directory / "escape.dat").string());
  chart.title = "Time on the invariant plane: " + scene.title;
  chart.data = "escape.dat";
  chart.x = "digits";
  chart.x_label = "decimal digits of the arithmetic";
  chart.y = "time";
  chart.y_label = "time until |G| > 1/100";
  chart.series_column = "l";
  chart.series_name = "l = ";
  chart.linear_x = true;
  for (const std::string& picture : draw_chart((directory / "escape").string(), chart, a.formats))
    fmt::print("picture {}\n", picture);
  return exit_decided;
}

} // namespace kov::cli
