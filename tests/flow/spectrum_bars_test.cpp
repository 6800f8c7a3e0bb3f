// The errors of all Lyapunov exponents, where the exponents are known (at length: kovacic-bars, docs/accuracy.md).

#include "flow/scene/system_section.hpp"

#include "symbol/document.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace kov::flow::spectrum_bars_test {
namespace {

SystemSection drawn(const std::string& text) {
  return simulate(read_system_scenes(parse_document(text, "test.toml")).front());
}

const std::string all_of_them = "tolerance = '10^-10'\nerrors = false\nindicator = 'megno'\n"
                                "exponents = 'all'\n";

std::string henon_heiles(const std::string& energy, const std::string& more) {
  return "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
         "hamiltonian = '(u^2 + v^2)/2 + (x^2 + y^2)/2 + x^2*y - y^3/3'\n[scene]\nsection = 'x'\n"
         "plot = ['y', 'v']\nlevels = {H = '" +
         energy + "'}\nrange = [['-1/2', '9/10'], ['-1/2', '1/2']]\ngrid = [7, 5]\n" + all_of_them +
         more;
}

struct Covered {
  int all = 0, by_one = 0, by_two = 0;
  void add(double rate, double error, double truth) {
    ++all;
    by_one += std::abs(rate - truth) <= error ? 1 : 0;
    by_two += std::abs(rate - truth) <= 2 * error ? 1 : 0;
  }
  [[nodiscard]] double one() const { return by_one / std::max(1.0, double(all)); }
  [[nodiscard]] double two() const { return by_two / std::max(1.0, double(all)); }
};

// Long parts of loose tolerance: the deviation that shrinks must not be drowned by the one that grows.  The truth is the
// mean over all orbits of the one chaotic sea.
TEST(SpectrumBars, ChaoticOrbits) {
  for (const int crossings : {150, 2500}) {
    Covered outer, inner;
    std::vector<std::vector<Spectrum::Exponent>> found;
    double mean = 0;
    for (const DrawnOrbit& o :
         drawn(henon_heiles("1/6", "crossings = " + std::to_string(crossings) + "\n")).orbits) {
      if (o.ended != Ended::crossings || !(o.indicators.megno > 8)) continue;
      ASSERT_EQ(o.spectrum.exponents.size(), 4U);
      found.push_back(o.spectrum.exponents);
      mean += o.spectrum.exponents[0].rate;
      EXPECT_NEAR(o.spectrum.exponents[3].rate, -o.spectrum.exponents[0].rate,
                  0.02 * o.spectrum.exponents[0].rate + 20 / o.time);
    }
    if (found.size() < 8) continue; // nearly all of them escape
    mean /= static_cast<double>(found.size());
    for (const auto& e : found)
      for (const std::size_t i : {0U, 1U, 2U, 3U})
        (i % 3 == 0 ? outer : inner).add(e[i].rate, e[i].error, i == 0 ? mean : i == 3 ? -mean : 0);
    EXPECT_GE(outer.two(), 0.85) << crossings;
    EXPECT_GE(inner.two(), 0.95) << crossings;
  }
}

TEST(SpectrumBars, RegularOrbits) {
  for (const int crossings : {100, 1000}) {
    Covered all;
    double bars = 0, time = 0;
    for (const DrawnOrbit& o :
         drawn(henon_heiles("1/20", "crossings = " + std::to_string(crossings) + "\n")).orbits)
      for (const auto& e : o.spectrum.exponents) {
        all.add(e.rate, e.error, 0);
        bars += e.error;
        time = o.time;
      }
    ASSERT_GE(all.all, 30);
    EXPECT_GE(all.two(), 0.95) << crossings;
    EXPECT_LE(bars / all.all, 25 / time) << crossings; // and say something
  }
}

TEST(SpectrumBars, TheLorenzSystem) {
  for (const int time : {100, 500}) {
    std::string starts;
    for (int k = 0; k < 12; ++k)
      starts += (k > 0 ? ", " : "") + std::string("['") + std::to_string(10 + k) + "/10', 2, 20]";
    Covered all;
    double bars = 0;
    for (const DrawnOrbit& o :
         drawn("[system]\nkind = 'vector-field'\ncoordinates = ['x', 'y', 'z']\n[system.field]\n"
               "x = '10*(y - x)'\ny = '28*x - y - x*z'\nz = 'x*y - 8*z/3'\n[scene]\n"
               "plot = ['x', 'y']\nsection = 'z - 27'\n" +
               all_of_them + "states = [" + starts + "]\ntime = " + std::to_string(time) + "\n")
             .orbits) {
      const double truth[] = {0.90563, 0, -41.0 / 3 - 0.90563};
      for (std::size_t i = 0; i < 3; ++i) {
        all.add(o.spectrum.exponents[i].rate, o.spectrum.exponents[i].error, truth[i]);
        bars += o.spectrum.exponents[i].error;
      }
    }
    ASSERT_EQ(all.all, 36);
    EXPECT_GE(all.one(), 0.68) << time;
    EXPECT_GE(all.two(), 0.95) << time;
    EXPECT_LE(bars / all.all, 15.0 / time) << time;
  }
}

} // namespace
} // namespace kov::flow::spectrum_bars_test
