// What certainty costs: y'' = r y with n double poles of exponent difference 1/3, whose group is
// SL(2, C), proved
//   p-curvature      by one small prime;
//   rank-sym12       "Sym^12 has no rational solution", by the rank of a matrix modulo one prime;
//   decided          by the engines, with everything that the answer states;
//   certificate      written down, and accepted by the judge, which shares only lib/exact with
//   the engines; kovacic-1986     by the classical algorithm: all families over Q.
#include "bench/bench.hpp"

#include "decide/certificate.hpp"
#include "galois/classify.hpp"
#include "invariant/invariant.hpp"
#include "kovacic/solve.hpp"
#include "pcurvature/p_curvature.hpp"
#include "sections/plot.hpp"

#include <fmt/core.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <variant>

namespace kov::cli {
namespace {

namespace fs = std::filesystem;

// r = sum over i = 1 ... n of (10/9) (z - i)^-2 + d_i (z - i)^-1: exponent differences 7/3 at every
// finite place, and, by the choice of the last two d_i, 1/3 at infinity.  So the local data allow
// invariants of all degrees: their absence has to be proved.
RationalFunction many_poles(long n) {
  const Rational c = Rational(10) / Rational(9), at_infinity = Rational(-2) / Rational(9);
  std::vector<Rational> d(static_cast<std::size_t>(n));
  Rational sum, moment = Rational(n) * c; // of the d_i; the coefficient of z^-2 at infinity
  for (long i = 1; i <= n - 2; ++i) {
    d[i - 1] = Rational(i % 2 == 0 ? 1 : -1);
    sum += d[i - 1];
    moment += Rational(i) * d[i - 1];
  }
  d[n - 1] = at_infinity - moment + Rational(n - 1) * sum;
  d[n - 2] = -sum - d[n - 1];
  RationalFunction r;
  for (long i = 1; i <= n; ++i) {
    const Poly at = Poly::z() - Poly(i);
    r = r + RationalFunction(Poly(c), at * at) + RationalFunction(Poly(d[i - 1]), at);
  }
  return r;
}

// A proof that is timed; false: it did not decide within the budget.
struct Proof {
  std::string name;
  std::function<bool(const RationalFunction&, const Singularities&, const Budget&)> prove;
};

std::vector<Proof> proofs() {
  const auto rank = [](long m) {
    return [m](const RationalFunction&, const Singularities& s, const Budget& b) {
      return no_invariant(s, m, b).has_value();
    };
  };
  const auto decided = [](const Classification& c) {
    return c.group && c.group->type == GroupType::SL2;
  };
  return {{"p-curvature", [](const RationalFunction&, const Singularities& s,
                             const Budget& b) { return sl2_by_p_curvature(s, 3, b).has_value(); }},
          {"rank-sym12", rank(12)},
          {"decided", [=](const RationalFunction& r, const Singularities&,
                          const Budget& b) { return decided(classify(r, b)); }},
          {"certificate",
           [=](const RationalFunction& r, const Singularities&, const Budget& b) {
             const Classification c = classify(r, b);
             return decided(c) && judged(certificate(c, r, b)).refusal.empty();
           }},
          {"kovacic-1986", [](const RationalFunction&, const Singularities& s, const Budget& b) {
             return std::holds_alternative<kovacic::NoLiouvillian>(kovacic::solve(s, b));
           }}};
}

bool proved(const Proof& p, const RationalFunction& r, const Singularities& s, double seconds) {
  try {
    return p.prove(r, s, Budget::of_seconds(seconds));
  } catch (const OutOfBudget&) {
    return false;
  }
}

} // namespace

int bench_certainty(const Settings& settings, const BenchArguments& a) {
  const fs::path directory = settings.output.empty() ? "." : settings.output;
  make_directory(directory.string());
  std::ofstream out(directory / "certainty.dat");
  fmt::print(out, "# seconds of the processor to prove G = SL(2, C) (or to rule out invariants) "
                  "for n double poles\n");
  fmt::print(out, "method poles seconds\n");
  ChartPlot chart;
  for (const Proof& p : proofs()) {
    chart.series.push_back(p.name);
    for (long n = 4; n <= 64; n *= 2) {
      const RationalFunction r = many_poles(n);
      const Singularities s = singularities(r);
      double seconds = 1e300; // the best of five
      bool good = false;
      for (int turn = 0; turn < 5 && (turn == 0 || (good && seconds < 1)); ++turn) {
        const std::clock_t begun = std::clock();
        good = proved(p, r, s, a.seconds);
        seconds = std::min(seconds, static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC);
      }
      fmt::print("  {:14} n = {:3}  {:9.5f} s{}\n", p.name, n, seconds,
                 good ? "" : "  not decided");
      std::fflush(stdout);
      if (!good) break;
      fmt::print(out, "{} {} {:.6f}\n", p.name, n, seconds);
    }
  }
  close_file(out, (directory / "certainty.dat").string());
  chart.title = "What certainty costs";
  chart.data = "certainty.dat";
  chart.x = "poles";
  chart.x_label = "finite poles of r";
  chart.y = "seconds";
  chart.y_label = "seconds of the processor";
  chart.series_column = "method";
  for (const std::string& picture :
       draw_chart((directory / "certainty").string(), chart, a.formats))
    fmt::print("picture {}\n", picture);
  return exit_decided;
}

} // namespace kov::cli
