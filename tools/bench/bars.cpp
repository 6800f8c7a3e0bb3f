// kovacic-bars [TIMES [LONGEST]]: how often the bars of Lyapunov exponents cover.  One line for each family and length of the runs:
//   family length exponent orbits within_1 within_2 truth bar     (percent; truth and bar: means)
// Truths: 0 where the flow or a regular orbit says so; closed forms; otherwise runs of the same orbits that are TIMES as long (8);
// LONGEST: returns of a run of Henon and Heiles (1000).

#include "flow/scene/system_section.hpp"
#include "symbol/document.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>

namespace kov::bench {
namespace {

using namespace kov::flow;

SystemSection drawn(const std::string& text) {
  return simulate(read_system_scenes(parse_document(text, "bars.toml")).front());
}

struct Coverage {
  long all = 0, one = 0, two = 0;
  double truth = 0, bar = 0;
  void add(double rate, double error, double wanted) {
    const double off = std::abs(rate - wanted);
    ++all;
    one += off <= error ? 1 : 0;
    two += off <= 2 * error ? 1 : 0;
    truth += wanted;
    bar += error;
  }
};

class Table {
public:
  Table(std::string family, long length) : family_(std::move(family)), length_(length) {}
  void add(const std::string& exponent, double rate, double error, double wanted) {
    rows_[exponent].add(rate, error, wanted);
  }
  void add(const Spectrum& s, const std::vector<double>& wanted) {
    for (std::size_t i = 0; i < s.exponents.size() && i < wanted.size(); ++i)
      add(std::to_string(i + 1), s.exponents[i].rate, s.exponents[i].error, wanted[i]);
  }
  void print() const {
    for (const auto& [exponent, c] : rows_) {
      const double n = static_cast<double>(c.all);
      std::printf("%s %ld %s %ld %.0f %.0f %.4g %.3g\n", family_.c_str(), length_, exponent.c_str(),
                  c.all, 100 * static_cast<double>(c.one) / n, 100 * static_cast<double>(c.two) / n,
                  c.truth / n, c.bar / n);
    }
    std::fflush(stdout);
  }

private:
  std::string family_;
  long length_;
  std::map<std::string, Coverage> rows_;
};

// ---- Henon and Heiles: chaotic and regular orbits ----

SystemSection henon_heiles(const std::string& energy, long crossings, const std::string& more) {
  return drawn("[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
               "hamiltonian = '(u^2 + v^2)/2 + (x^2 + y^2)/2 + x^2*y - y^3/3'\n[scene]\n"
               "section = 'x'\nplot = ['y', 'v']\nlevels = {H = '" +
               energy + "'}\nrange = [['-1/2', '9/10'], ['-1/2', '1/2']]\ngrid = [12, 9]\n" +
               "tolerance = '10^-10'\nerrors = false\nindicator = 'megno'\ncrossings = " +
               std::to_string(crossings) + "\n" + more);
}

void henon_heiles(long times, long longest) {
  std::vector<long> lengths;
  for (const long n : {100L, 300L, 1000L, 3000L})
    if (n <= longest) lengths.push_back(n);
  std::vector<Table> chaotic, regular;
  for (const long n : lengths) {
    chaotic.emplace_back("chaotic", n);
    regular.emplace_back("regular", n);
  }
  for (const char* energy : {"1/8", "7/50", "1/6"}) {
    for (std::size_t k = 0; k < lengths.size(); ++k) {
      const SystemSection some = henon_heiles(energy, lengths[k], "exponents = 'all'\n");
      const SystemSection many = henon_heiles(energy, lengths[k] * times, "");
      for (std::size_t i = 0; i < some.orbits.size(); ++i) {
        const DrawnOrbit &o = some.orbits[i], &longer = many.orbits[i];
        if (o.ended != Ended::crossings) continue;
        if (o.indicators.megno > 5 && longer.indicators.megno > 20) {
          const double l = longer.indicators.lyapunov;
          chaotic[k].add(o.spectrum, {l, 0, 0, -l});
          chaotic[k].add("megno's", o.indicators.lyapunov, o.indicators.lyapunov_error, l);
        } else if (longer.indicators.megno < 3) {
          regular[k].add(o.spectrum, {0, 0, 0, 0});
          regular[k].add("megno's", o.indicators.lyapunov, o.indicators.lyapunov_error, 0);
        }
      }
    }
  }
  for (const auto* tables : {&chaotic, &regular})
    for (const Table& t : *tables)
      t.print();
}

// ---- systems that lose energy ----

// n starts near one another, with the indicator as well
std::string starts(const std::vector<double>& at, int n) {
  std::string all;
  for (int k = 0; k < n; ++k) {
    all += all.empty() ? "[" : ", [";
    for (std::size_t i = 0; i < at.size(); ++i) {
      char text[64];
      std::snprintf(
          text, sizeof text, "%s'%ld/10000'", i > 0 ? ", " : "",
          std::lround(10000 * (at[i] + 0.3 * std::sin(1.7 * k + 2.3 * static_cast<double>(i)))));
      all += text;
    }
    all += "]";
  }
  return "states = [" + all + "]\n";
}

std::string lorenz(long time, int n) {
  return "[system]\nkind = 'vector-field'\ncoordinates = ['x', 'y', 'z']\n[system.field]\n"
         "x = '10*(y - x)'\ny = '28*x - y - x*z'\nz = 'x*y - 8*z/3'\n[scene]\nplot = ['x', 'y']\n"
         "section = 'z - 27'\ntolerance = '10^-10'\nerrors = false\nindicator = 'megno'\nexponents "
         "= 'all'\n" +
         starts({1, 2, 20}, n) + "time = " + std::to_string(time) + "\n";
}

// x'' + x'/5 - x + x^3 = 3/10 cos(t)
std::string duffing(long time, int n) {
  return "[system]\nkind = 'vector-field'\ncoordinates = ['x', 'v', 'p']\n[system.field]\nx = 'v'\n"
         "v = 'x - x^3 - v/5 + 3*c/10'\np = '1'\n[[system.function]]\nname = 'c'\nmeans = "
         "'cos(p)'\n"
         "derivative = { p = '-s' }\n[[system.function]]\nname = 's'\nmeans = 'sin(p)'\n"
         "derivative = { p = 'c' }\n[scene]\nplot = ['x', 'v']\nsection = 's'\nwhere = 'c'\n"
         "tolerance = '10^-10'\nerrors = false\nindicator = 'megno'\nexponents = 'all'\n" +
         starts({0.5, 0.1, 0}, n) + "time = " + std::to_string(time) + "\n";
}

void dissipative(long times) {
  for (const long time : {50L, 200L, 800L}) {
    Table t("Lorenz", time);
    for (const DrawnOrbit& o : drawn(lorenz(time, 60)).orbits) {
      t.add(o.spectrum, {0.90563, 0, -41.0 / 3 - 0.90563});
      t.add("megno's", o.indicators.lyapunov, o.indicators.lyapunov_error, 0.90563);
    }
    t.print();
  }
  double mean = 0, orbits = 0;
  for (const DrawnOrbit& o : drawn(duffing(3000 * times, 8)).orbits)
    if (!o.spectrum.exponents.empty()) {
      mean += o.spectrum.exponents[0].rate;
      orbits += 1;
    }
  mean /= orbits;
  for (const long time : {200L, 800L, 3000L}) {
    Table t("Duffing", time);
    for (const DrawnOrbit& o : drawn(duffing(time, 60)).orbits) {
      t.add(o.spectrum, {mean, 0, -0.2 - mean});
      t.add("megno's", o.indicators.lyapunov, o.indicators.lyapunov_error, mean);
    }
    t.print();
  }
}

// ---- x' = A x: the real parts of the eigenvalues ----

void linear() {
  for (const long time : {20L, 100L, 500L}) {
    Table t("linear", time);
    for (int k = 0; k < 60; ++k) {
      // [[a, b, 1], [-b, a, c], [0, 0, d]]: a +- b i and d
      const double a = std::lround(100 * std::sin(1.3 * k)) / 200.0,
                   b = std::lround(100 * (1 + std::cos(2.1 * k))) / 100.0,
                   c = std::lround(100 * std::sin(0.7 * k)) / 50.0,
                   d = std::lround(100 * std::cos(1.9 * k)) / 200.0;
      char text[1024];
      std::snprintf(
          text, sizeof text,
          "[system]\nkind = 'vector-field'\ncoordinates = ['x', 'y', 'z']\n[system.field]\n"
          "x = '%ld*x/200 + %ld*y/100 + z'\ny = '-%ld*x/100 + %ld*y/200 + %ld*z/100'\nz = "
          "'%ld*z/200'\n[scene]\nplot = ['x', 'y']\nsection = 'x - 10^300'\nerrors = "
          "false\nstates = [['1/3', '1/5', '1/7']]\ntime = %ld\nexponents = 'all'\n",
          std::lround(200 * a), std::lround(100 * b), std::lround(100 * b), std::lround(200 * a),
          std::lround(100 * c), std::lround(200 * d), time);
      std::vector<double> wanted{a, a, d};
      std::sort(wanted.rbegin(), wanted.rend());
      t.add(drawn(text).orbits[0].spectrum, wanted);
    }
    t.print();
  }
}

} // namespace
} // namespace kov::bench

int main(int argc, char** argv) {
  const long times = argc > 1 ? std::atol(argv[1]) : 8,
             longest = argc > 2 ? std::atol(argv[2]) : 1000;
  std::printf("family length exponent orbits within_1 within_2 truth bar\n");
  kov::bench::linear();
  kov::bench::henon_heiles(times, longest);
  kov::bench::dissipative(times);
}
