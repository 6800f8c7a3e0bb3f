// kovacic-core: the program with check, classify, solve and what else is small, which tools/run builds first.
// It builds the whole program for the sub-commands that are missing here.

#include "bench/bench.hpp"
#include "commands.hpp"
#include "exact/error.hpp"
#include "sections/section.hpp"
#include "systems/classification_report.hpp"

namespace kov::cli {
namespace {

[[noreturn]] int missing() {
  throw InputError("kovacic-core", 0, 0, 1, "this needs the whole program",
                   "tools/setup release kovacic");
}

} // namespace

void declare_section(CLI::App& /*command*/, SectionArguments& /*arguments*/) {}
void declare_bench(CLI::App& /*command*/, BenchArguments& /*arguments*/) {}
int section(const Settings& /*settings*/, const SectionArguments& /*arguments*/) { missing(); }
int bench(const Settings& /*settings*/, const BenchArguments& /*arguments*/) { missing(); }
int test(const Settings& /*settings*/, const std::vector<std::string>& /*paths*/) { missing(); }
int verify(const Settings& /*settings*/, const std::vector<std::string>& /*paths*/) { missing(); }
int prove(const Settings& /*settings*/, const std::string& /*file*/) { missing(); }
int report_system(const Settings& /*settings*/, const std::string& /*file*/) { missing(); }
int monodromy(const Settings& /*settings*/, const MonodromyArguments& /*arguments*/) { missing(); }
int lame(const Settings& /*settings*/, const LameArguments& /*arguments*/) { missing(); }
int spectrum(const Settings& /*settings*/, const SpectrumArguments& /*arguments*/) { missing(); }
int potential(const Settings& /*settings*/, const PotentialArguments& /*arguments*/) { missing(); }
std::string classification_page(const System& /*s*/, const SystemClassification& /*c*/,
                                const std::string& /*format*/, const TheoremResult* /*proved*/) {
  missing();
}

} // namespace kov::cli
