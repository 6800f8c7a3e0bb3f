// The error of a Lyapunov exponent, against the same orbit followed for much longer.

#include "flow/scene/system_section.hpp"

#include "symbol/document.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace kov::flow::exponent_bars_test {
namespace {

SystemSection exponents(const std::string& energy, int crossings) {
  return simulate(
      read_system_scenes(
          parse_document("[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\n"
                         "momenta = ['u', 'v']\n"
                         "hamiltonian = '(u^2 + v^2)/2 + (x^2 + y^2)/2 + x^2*y - y^3/3'\n[scene]\n"
                         "section = 'x'\nplot = ['y', 'v']\nlevels = {H = '" +
                             energy + "'}\nrange = [['-1/2', '9/10'], ['-1/2', '1/2']]\n" +
                             "grid = [12, 9]\ntolerance = '10^-10'\nindicator = 'lyapunov'\n"
                             "errors = false\ncrossings = " +
                             std::to_string(crossings) + "\n",
                         "test.toml"))
          .front());
}

struct Coverage {
  int all = 0, within_two = 0;
  double exponents = 0, errors = 0;
  [[nodiscard]] double part() const { return within_two / std::max(1.0, static_cast<double>(all)); }
};

void count(Coverage& c, const Indicators& i, double truth) {
  ++c.all;
  c.within_two += std::abs(i.lyapunov - truth) <= 2 * i.lyapunov_error ? 1 : 0;
  c.exponents += truth;
  c.errors += i.lyapunov_error;
}

TEST(ExponentBars, CoverWhatTheyShould) {
  Coverage chaotic, regular;
  for (const char* energy : {"1/8", "7/50", "1/6"}) {
    const SystemSection some = exponents(energy, 300), many = exponents(energy, 4000);
    for (std::size_t i = 0; i < some.orbits.size(); ++i) {
      const Indicators &short_run = some.orbits[i].indicators,
                       &long_run = many.orbits[i].indicators;
      if (some.orbits[i].ended != Ended::crossings) continue; // from E = 1/6 on orbits escape
      if (short_run.megno > 5 && long_run.megno > 20) count(chaotic, short_run, long_run.lyapunov);
      if (long_run.megno < 3) count(regular, short_run, 0);
    }
  }
  EXPECT_GE(chaotic.all, 100);
  EXPECT_GE(chaotic.part(), 0.85);
  EXPECT_LE(chaotic.part(), 0.99);
  EXPECT_LE(chaotic.errors, 0.4 * chaotic.exponents); // and say something
  EXPECT_GE(regular.all, 30);
  EXPECT_GE(regular.part(), 0.95);
  EXPECT_LE(regular.errors / regular.all, 0.01);
}

} // namespace
} // namespace kov::flow::exponent_bars_test
