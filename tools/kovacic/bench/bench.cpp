#include "bench/bench.hpp"

#include <CLI/CLI.hpp>

namespace kov::cli {

void declare_bench(CLI::App& command, BenchArguments& a) {
  command
      .add_option("WHAT", a.what,
                  "accuracy (integrators), certainty (proofs), escape (from a plane)")
      ->check(CLI::IsMember({"accuracy", "certainty", "escape"}).description(""))
      ->type_name("");
  command.add_option("--scene", a.scene, "a scene: with a time (accuracy), with sign_of (escape)")
      ->type_name("FILE");
  command
      .add_option("--peers", a.peers,
                  "accuracy: the program kovacic-peers (tools/bench/accuracy builds it)")
      ->type_name("PROGRAM");
  command.add_option("--seconds", a.seconds, "a method stops after a run that took longer")
      ->check(CLI::PositiveNumber.description(""))
      ->type_name("S");
  command.add_option("--pictures", a.formats, "png (the default), svg, pdf or none")
      ->delimiter(',')
      ->check(CLI::IsMember({"png", "svg", "pdf", "none"}).description(""))
      ->type_name("LIST");
}

int bench(const Settings& settings, const BenchArguments& arguments) {
  if (arguments.what == "escape") return bench_escape(settings, arguments);
  return arguments.what == "accuracy" ? bench_accuracy(settings, arguments)
                                      : bench_certainty(settings, arguments);
}

} // namespace kov::cli
