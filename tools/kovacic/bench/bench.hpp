#pragma once
// kovacic bench accuracy|certainty|escape -o DIR: what accuracy costs, as tables and work-precision
// diagrams.

#include "process/settings.hpp"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace kov::cli {

struct BenchArguments {
  std::string what = "accuracy"; ///< accuracy, certainty or escape
  std::string scene = "cases/sliding_top/scenes/bench/asymmetric_sliding_32.toml";
  std::string peers; ///< the program of tools/bench/peers.cpp; empty: without other integrators
  double seconds = 30;
  std::vector<std::string> formats = {"png"};
};

void declare_bench(CLI::App& command, BenchArguments& arguments);
int bench(const Settings& settings, const BenchArguments& arguments);

/// Integrators: accuracy.dat, accuracy.txt, pictures of drift and error against time.
int bench_accuracy(const Settings& settings, const BenchArguments& arguments);
/// Proofs: certainty.dat and its picture.
int bench_certainty(const Settings& settings, const BenchArguments& arguments);

/// The time until an orbit leaves an invariant plane, against the precision: escape.dat and its
/// picture.
int bench_escape(const Settings& settings, const BenchArguments& arguments);

} // namespace kov::cli
