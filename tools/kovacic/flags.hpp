#pragma once
// What can be asked on the command line, and the flags by which it is.

#include "bench/bench.hpp"
#include "commands.hpp"
#include "jets/obstruction.hpp"
#include "sections/section.hpp"

#include <CLI/CLI.hpp>

#include <map>
#include <optional>
#include <set>
#include <sstream>

namespace kov::cli {

/// Everything that flags set; each command reads its own.
struct Asked {
  Settings settings;
  SolveArguments solve;
  LameArguments lame;
  PotentialArguments potential;
  MonodromyArguments monodromy;
  IntegralsArguments integrals;
  SpectrumArguments spectrum;
  ClassifyArguments classify;
  SectionArguments section;
  BenchArguments bench;
  OneLineArguments one_line;
  std::vector<std::string> files;
  std::string word;
  std::vector<std::string> explained;
  std::string stage = "r";
  std::optional<double> timeout;
  std::map<std::string, std::vector<std::string>> formats; ///< of the commands that have some
  std::set<std::string> pages;               ///< the commands whose answers are cut to a page
  std::map<std::string, double> time_limits; ///< of the commands, in seconds, without --timeout
};

// A check that does not add its own words to --help.
inline CLI::Validator silent(CLI::Validator check) { return check.description(""); }

// 0 to most.
inline CLI::Validator number(double most, const std::string& what) {
  return CLI::Validator(
      [most, what](const std::string& text) {
        std::istringstream in(text);
        double value = -1;
        in >> value;
        const bool ok = in && in.eof() && value >= 0 && value <= most;
        return ok ? std::string() : what + " is expected, not '" + text + "'";
      },
      "");
}

/// Declares flags of one command, which obeys them; others are refused.
class Flags {
public:
  Flags(CLI::App& command, Asked& asked) : command_(command), asked_(asked) {}

  void output() {
    command_.add_option("-o,--output", asked_.settings.output, "write to a file")
        ->type_name("FILE");
    command_
        .add_option("--color", asked_.settings.color, "auto, always or never (see also NO_COLOR)")
        ->check(silent(CLI::IsMember({"auto", "always", "never"})))
        ->type_name("WHEN");
  }
  // One equation, in each way that the arguments have room for.
  template <class Arguments> void equation(Arguments& a) {
    command_.add_option("-r", a.r, "y'' = R y")->type_name("R(z)");
    const bool has_file = requires { a.file; }; // else it stands by itself, too
    command_
        .add_option(has_file ? "-e,--ode" : "-e,--ode,EQUATION", a.ode,
                    "a linear equation, e.g. y'' = z*y")
        ->type_name("EQUATION");
    if constexpr (requires { a.p; }) {
      command_.add_option("--p", a.p, "with --q: y'' + P y' + Q y = 0")->type_name("P(z)");
      command_.add_option("--q", a.q, "with --p")->type_name("Q(z)");
    }
    command_.add_option("--variable", a.variable, "its name, if not clear (z)")->type_name("NAME");
    command_.add_option("--unknown", a.unknown, "name of the unknown function, if not clear (y)")
        ->type_name("NAME");
    if constexpr (requires { a.minpoly; })
      command_.add_option("--minpoly", a.minpoly, "a constant by its polynomial: a^2 - 5")
          ->type_name("POLY");
  }
  // Free names: a,b or the option twice.
  void parameters(std::vector<std::string>& names, const std::string& words) {
    command_.add_option("--parameter,--parameters", names, words)
        ->type_name("NAMES")
        ->delimiter(',')
        ->expected(1)
        ->take_all();
  }
  void assume() {
    command_
        .add_option("--assume", asked_.settings.assume,
                    "parameters: \"a > 0\", \"n not an integer\", \"c complex\" (repeatable)")
        ->type_name("SENTENCE")
        ->expected(1)
        ->take_all();
  }
  // A system: its file, or a formula.
  void system(std::string& file) {
    command_.add_option("FILE", file, "a system file; - is standard input")->type_name("");
    one_line();
  }
  // Instead of a system file.
  void one_line() {
    command_
        .add_option("-H,--hamiltonian", asked_.one_line.hamiltonian, "H(q, p) instead of a file")
        ->type_name("FORMULA");
    command_
        .add_option("-L,--lagrangian", asked_.one_line.lagrangian, "L(q, q') instead of a file")
        ->type_name("FORMULA");
    command_
        .add_option("--coordinates", asked_.one_line.coordinates,
                    "with -H, -L: q1,q2,... (else guessed from the letters)")
        ->delimiter(',')
        ->type_name("NAMES");
    command_
        .add_option("--momenta,--velocities", asked_.one_line.rates,
                    "of the coordinates, in their order")
        ->delimiter(',')
        ->type_name("NAMES");
    parameters(asked_.one_line.parameters, "with -H, -L: the free constants");
    assume();
  }
  void quiet() { command_.add_flag("-q,--quiet", asked_.settings.quiet, "the answer only"); }
  // An answer with this flag is a page without it.
  void verbose() {
    asked_.pages.insert(command_.get_name());
    command_.add_flag("-v,--verbose", asked_.settings.verbose,
                      "every stratum, level and formula in full, and times");
  }
  void format(const std::vector<std::string>& formats, const std::string& description) {
    asked_.formats[command_.get_name()] = formats;
    command_.add_option("--format", asked_.settings.format, description)
        ->check(silent(CLI::IsMember(formats)))
        ->type_name("F");
  }
  void set() {
    command_
        .add_option("--set", asked_.settings.set, "give a name a value: --set a=1/2 (repeatable)")
        ->type_name("NAME=VALUE")
        ->expected(1)
        ->take_all();
  }
  void manifold() {
    command_.add_option("--manifold", asked_.settings.manifold, "system files: only this manifold")
        ->type_name("NAME");
  }
  void order(const std::string& otherwise) {
    command_
        .add_option("--order", asked_.settings.order,
                    "variational equations up to this order, 1 to 7 (" + otherwise + ")")
        ->check(silent(CLI::Range(1, jets::largest_order)))
        ->type_name("K");
  }
  // What is reasonable to wait for unasked: a minute for a question, ten for a theorem; 0 = any
  // time.
  void time(double seconds, const std::string& words) {
    asked_.time_limits[command_.get_name()] = seconds;
    const std::string unasked = seconds > 0 ? " (default " + Budget::number(seconds) + ")" : "";
    command_.add_option("--timeout", asked_.timeout, words + unasked + "; 0 = no limit")
        ->check(number(1e9, "a number of seconds"))
        ->type_name("S");
  }
  void process(double seconds = 60, const std::string& words = "seconds for each question") {
    time(seconds, words);
    command_
        .add_option("--memory", asked_.settings.memory, "ceiling in MiB (default 4096); 0 = none")
        ->check(number(1L << 30, "a number of MiB"))
        ->type_name("MIB");
  }
  void work() {
    command_
        .add_option("--max-work", asked_.settings.max_work,
                    "products of terms in one search (default 1e8)")
        ->check(number(1e18, "a number of products"))
        ->type_name("N");
  }
  void budget(double seconds = 60) {
    process(seconds);
    work();
    command_
        .add_option("--max-degree", asked_.settings.max_degree, "largest degree of a polynomial")
        ->check(number(1e12, "a degree"))
        ->type_name("N");
    command_
        .add_option("--max-families", asked_.settings.max_families, "largest number of families")
        ->check(number(1e18, "a number of families"))
        ->type_name("N");
  }
  void method() {
    command_
        .add_option("--case", asked_.settings.only_case,
                    "say whether this case of Kovacic's occurs")
        ->check(silent(CLI::IsMember({"1", "2", "3"})))
        ->type_name("1|2|3");
    command_
        .add_option("--method", asked_.settings.method,
                    "automatic, kovacic, engines or all (compare)")
        ->check(silent(CLI::IsMember({"automatic", "kovacic", "engines", "all"})))
        ->type_name("M");
  }
  void exit_verdict() {
    command_.add_flag("--exit-verdict", asked_.settings.exit_verdict,
                      "exit 10: not abelian, 20: abelian, 0: undecided or depends");
  }

  // solve and check
  void solver(const std::vector<std::string>& formats, const std::string& words) {
    set();
    budget();
    method();
    command_
        .add_option("--max-print", asked_.settings.max_print,
                    "print solutions up to this size (default 4); 0 = any")
        ->check(number(1L << 30, "a number of MiB"))
        ->type_name("MIB");
    command_.add_flag("--trace", asked_.settings.trace, "show every step");
    command_.add_flag("--second-opinion", asked_.settings.second_opinion,
                      "also say what certified monodromy matrices prove");
    format(formats, words);
    exit_verdict();
    quiet();
    verbose();
    output();
    command_
        .add_option("--certificate", asked_.settings.certificate,
                    "write the proof (check, --batch: a directory)")
        ->type_name("FILE");
  }

  void report() {
    format({"text", "json", "tex", "html"}, "text, json, tex or html (also: -o NAME.html)");
    process(600, "seconds in all");
    work();
    quiet();
    verbose();
    output();
  }

private:
  CLI::App& command_;
  Asked& asked_;
};

} // namespace kov::cli
