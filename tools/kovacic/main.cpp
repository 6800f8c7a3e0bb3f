// The command line of kovacic: flags, sub-commands, exit codes.  No mathematics.

#include "bench.hpp"
#include "case_file.hpp"
#include "commands.hpp"
#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "interrupt.hpp"
#include "jets/obstruction.hpp"
#include "page_width.hpp"
#include "progress.hpp"
#include "reproducer.hpp"
#include "section.hpp"
#include "symbol/given_text.hpp"
#include "symbol/suggest.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <unistd.h>

namespace kov::cli {
namespace {

constexpr const char* examples =
    R"(Is a mechanical system integrable?  If not, a proof.  And y'' = r(z) y, solved or proved unsolvable.

  kovacic classify -H 'p1^2/2 + p2^2/2 + q1^2*q2 + b*q2^3/3'   for which b is it integrable?
  kovacic solve "x y'' + y' + x y = 0"                         any linear equation of second order
)";

constexpr const char* footer =
    R"(Exit codes: 0 decided, 1 a "no" from check, test, prove or verify, 2 usage or input error,
3 undecided, 4 internal error, 130 interrupted (143 by SIGTERM).  More: kovacic COMMAND --help, kovacic explain)";

// A check that does not add its own words to --help.
CLI::Validator silent(CLI::Validator check) { return check.description(""); }

// 0 to most.
CLI::Validator number(double most, const std::string& what) {
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

bool is_a_file(const std::string& name) {
  std::error_code none;
  return std::filesystem::is_regular_file(name, none);
}

// "y'' = x*y" in the place of a file.
bool is_an_equation(const std::string& file) {
  return !file.empty() && file != "-" && !is_a_file(file) && !file.ends_with(".toml") &&
         (file.find_first_of("'=^*(") != std::string::npos || file.front() == '[');
}

// "-hbar^2/2 psi'' = E psi" is no cluster of flags: a blank before it keeps it from CLI11.
void shield_equations(std::vector<std::string>& arguments) {
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-";
  constexpr std::string_view takes_formula = "er", no_beginning = "^*/' =";
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    std::string& a = arguments[i];
    const bool minus = a.size() > 1 && a[0] == '-' && a[1] != '-';
    if (!minus || a.find_first_not_of(plain) == std::string::npos || a[1] == 'o') continue;
    const bool value = takes_formula.find(a[1]) != std::string_view::npos && a.size() > 2 &&
                       no_beginning.find(a[2]) == std::string_view::npos; // -r'z^2'
    static const std::vector<std::string> options{"-e", "--ode", "-r", "--p", "--q", "--base"};
    const bool wanted = is_among(arguments[i - 1], options);
    if (!value && !wanted) a.insert(0, 1, ' ');
  }
}

struct CommandLine {
  Settings settings;
  SolveArguments solve_arguments;
  LameArguments lame_arguments;
  PotentialArguments potential_arguments;
  MonodromyArguments monodromy_arguments;
  IntegralsArguments integrals_arguments;
  SpectrumArguments spectrum_arguments;
  ClassifyArguments classify_arguments;
  SectionArguments section_arguments;
  BenchArguments bench_arguments;
  OneLineArguments one_line;
  std::vector<std::string> files;
  std::string word;
  std::vector<std::string> explained;
  std::string stage = "r";
  std::optional<double> timeout;
  std::set<std::string> pages;               ///< the commands whose answers are cut to a page
  std::map<std::string, double> time_limits; ///< of the commands, in seconds, without --timeout

  // Each command declares the flags that it obeys; the others are refused.

  void output_flags(CLI::App& command) {
    command.add_option("-o,--output", settings.output, "write to a file")->type_name("FILE");
    command.add_option("--color", settings.color, "auto, always or never (see also NO_COLOR)")
        ->check(silent(CLI::IsMember({"auto", "always", "never"})))
        ->type_name("WHEN");
  }
  // Free names: a,b or the option twice.
  static void parameters_flag(CLI::App& command, std::vector<std::string>& names,
                              const std::string& words) {
    command.add_option("--parameter,--parameters", names, words)
        ->type_name("NAMES")
        ->delimiter(',')
        ->expected(1)
        ->take_all();
  }
  void assume_flag(CLI::App& command) {
    command
        .add_option("--assume", settings.assume,
                    "parameters: \"a > 0\", \"n not an integer\", \"c complex\" (repeatable)")
        ->type_name("SENTENCE")
        ->expected(1)
        ->take_all();
  }
  // A system: its file, or a formula.
  void system_flags(CLI::App& command, std::string& file) {
    command.add_option("FILE", file, "a system file; - is standard input")->type_name("");
    one_line_flags(command);
  }
  // Instead of a system file.
  void one_line_flags(CLI::App& command) {
    command.add_option("-H,--hamiltonian", one_line.hamiltonian, "H(q, p) instead of a file")
        ->type_name("FORMULA");
    command.add_option("-L,--lagrangian", one_line.lagrangian, "L(q, q') instead of a file")
        ->type_name("FORMULA");
    command
        .add_option("--coordinates", one_line.coordinates,
                    "with -H, -L: q1,q2,... (else guessed from the letters)")
        ->delimiter(',')
        ->type_name("NAMES");
    command
        .add_option("--momenta,--velocities", one_line.rates, "of the coordinates, in their order")
        ->delimiter(',')
        ->type_name("NAMES");
    parameters_flag(command, one_line.parameters, "with -H, -L: the free constants");
    assume_flag(command);
  }
  // Throws unless there is just one of a file and a formula.
  void settle_input(const CLI::App& command, std::vector<std::string>& files) {
    std::string first = files.empty() ? "" : files.front();
    settle_input(command, first);
    if (files.empty()) files.push_back(first);
  }
  void settle_input(const CLI::App& command, std::string& file) {
    if (one_line.given() != file.empty())
      throw CLI::ValidationError(command.get_name(),
                                 one_line.given() ? "a file or a formula is expected, not both"
                                                  : "a file is expected, or a formula: -H 'p^2/2 + "
                                                    "q^4'");
    if (one_line.given()) file = take_one_line(settings, one_line);
  }
  void quiet_flag(CLI::App& command) {
    command.add_flag("-q,--quiet", settings.quiet, "the answer only");
  }
  // An answer with this flag is a page without it.
  void verbose_flag(CLI::App& command) {
    pages.insert(command.get_name());
    command.add_flag("-v,--verbose", settings.verbose,
                     "every stratum, level and formula in full, and times");
  }
  void format_flag(CLI::App& command, const std::vector<std::string>& formats,
                   const std::string& description) {
    command.add_option("--format", settings.format, description)
        ->check(silent(CLI::IsMember(formats)))
        ->type_name("F");
  }
  void set_flag(CLI::App& command) {
    command.add_option("--set", settings.set, "give a name a value: --set a=1/2 (repeatable)")
        ->type_name("NAME=VALUE")
        ->expected(1)
        ->take_all();
  }
  void manifold_flag(CLI::App& command) {
    command.add_option("--manifold", settings.manifold, "system files: only this manifold")
        ->type_name("NAME");
  }
  void order_flag(CLI::App& command, const std::string& otherwise) {
    command
        .add_option("--order", settings.order,
                    "variational equations up to this order, 1 to 7 (" + otherwise + ")")
        ->check(silent(CLI::Range(1, jets::largest_order)))
        ->type_name("K");
  }
  // What is reasonable to wait for unasked: a minute for a question, ten for a theorem; 0 = any
  // time.
  void time_flag(CLI::App& command, double seconds, const std::string& words) {
    time_limits[command.get_name()] = seconds;
    const std::string unasked = seconds > 0 ? " (default " + Budget::number(seconds) + ")" : "";
    command.add_option("--timeout", timeout, words + unasked + "; 0 = no limit")
        ->check(number(1e9, "a number of seconds"))
        ->type_name("S");
  }
  void process_flags(CLI::App& command, double seconds = 60,
                     const std::string& words = "seconds for each question") {
    time_flag(command, seconds, words);
    command.add_option("--memory", settings.memory, "ceiling in MiB (default 4096); 0 = none")
        ->check(number(1L << 30, "a number of MiB"))
        ->type_name("MIB");
  }
  void work_flag(CLI::App& command) {
    command
        .add_option("--max-work", settings.max_work,
                    "products of terms in one search (default 1e8)")
        ->check(number(1e18, "a number of products"))
        ->type_name("N");
  }
  void budget_flags(CLI::App& command, double seconds = 60) {
    process_flags(command, seconds);
    work_flag(command);
    command.add_option("--max-degree", settings.max_degree, "largest degree of a polynomial")
        ->check(number(1e12, "a degree"))
        ->type_name("N");
    command.add_option("--max-families", settings.max_families, "largest number of families")
        ->check(number(1e18, "a number of families"))
        ->type_name("N");
  }
  void method_flags(CLI::App& command) {
    command.add_option("--case", settings.only_case, "say whether this case of Kovacic's occurs")
        ->check(silent(CLI::IsMember({"1", "2", "3"})))
        ->type_name("1|2|3");
    command.add_option("--method", settings.method, "automatic, kovacic, engines or all (compare)")
        ->check(silent(CLI::IsMember({"automatic", "kovacic", "engines", "all"})))
        ->type_name("M");
  }
  void exit_verdict_flag(CLI::App& command) {
    command.add_flag("--exit-verdict", settings.exit_verdict,
                     "exit 10: not abelian, 20: abelian, 0: undecided or depends");
  }

  // solve and check
  void solver_flags(CLI::App& command, const std::vector<std::string>& formats,
                    const std::string& words) {
    set_flag(command);
    budget_flags(command);
    method_flags(command);
    command
        .add_option("--max-print", settings.max_print,
                    "print solutions up to this size (default 4); 0 = any")
        ->check(number(1L << 30, "a number of MiB"))
        ->type_name("MIB");
    command.add_flag("--trace", settings.trace, "show every step");
    command.add_flag("--second-opinion", settings.second_opinion,
                     "also say what certified monodromy matrices prove");
    format_flag(command, formats, words);
    exit_verdict_flag(command);
    quiet_flag(command);
    verbose_flag(command);
    output_flags(command);
    command
        .add_option("--certificate", settings.certificate,
                    "write the proof (check, --batch: a directory)")
        ->type_name("FILE");
  }

  void declare_families(CLI::App& app) {
    CLI::App* lame = app.add_subcommand("lame", "Lame's equation, with numbers or a condition");
    lame->add_option("FILE", lame_arguments.file, "a file with a [lame] table")->type_name("");
    lame->add_option("-n", lame_arguments.n, "y_tt = (N(N+1) wp(t; g2, g3) + B) y")->type_name("N");
    lame->add_option("--alpha", lame_arguments.alpha, "N(N+1), instead of -n")->type_name("A");
    lame->add_option("--B", lame_arguments.b, "what is not given stays a name")->type_name("B");
    lame->add_option("--g2", lame_arguments.g2, "a number or a formula")->type_name("G");
    lame->add_option("--g3", lame_arguments.g3, "a number or a formula")->type_name("G");
    set_flag(*lame);
    budget_flags(*lame);
    format_flag(*lame, {"text", "json"}, "text or json");
    exit_verdict_flag(*lame);
    verbose_flag(*lame);
    output_flags(*lame);

    CLI::App* potential =
        app.add_subcommand("potential", "eigenvalues of integrable homogeneous potentials");
    potential->add_option("--degree", potential_arguments.degree, "of the potential, not 0")
        ->required()
        ->type_name("K");
    potential->add_option("--eigenvalue", potential_arguments.eigenvalue, "only this one")
        ->type_name("L");
    process_flags(*potential);
    format_flag(*potential, {"text", "json"}, "text or json");
    exit_verdict_flag(*potential);
    verbose_flag(*potential);
    output_flags(*potential);
  }

  void declare_spectrum(CLI::App& app) {
    SpectrumArguments& a = spectrum_arguments;
    CLI::App* command =
        app.add_subcommand("spectrum", "for which E is there a Liouvillian solution?");
    command->add_option("-r", a.r, "y'' = R y")->type_name("R(z)");
    command->add_option("-e,--ode", a.ode, "a linear equation, e.g. y'' = (z^2 - E)*y")
        ->type_name("EQUATION");
    command->add_option("--for", a.energy, "the parameter that is asked for (E)")
        ->type_name("NAME");
    command->add_option("--variable", a.variable, "its name, if not clear (z)")->type_name("NAME");
    command->add_option("--unknown", a.unknown, "name of the unknown function, if not clear (y)")
        ->type_name("NAME");
    assume_flag(*command);
    command
        ->add_option("--levels", a.levels,
                     "how many integers N are written out (1 to 20); default 4")
        ->check(number(20, "a number of levels"))
        ->type_name("N");
    set_flag(*command);
    budget_flags(*command);
    format_flag(*command, {"text", "json"}, "text or json");
    quiet_flag(*command);
    verbose_flag(*command);
    output_flags(*command);
  }

  void declare_monodromy(CLI::App& app) {
    MonodromyArguments& a = monodromy_arguments;
    CLI::App* command = app.add_subcommand("monodromy", "monodromy matrices with proven radii");
    command->add_option("-r", a.r, "y'' = R y")->type_name("R(z)");
    command->add_option("-e,--ode", a.ode, "a linear equation, e.g. y'' = z*y")
        ->type_name("EQUATION");
    command->add_option("--p", a.p, "with --q: y'' + P y' + Q y = 0")->type_name("P(z)");
    command->add_option("--q", a.q, "with --p")->type_name("Q(z)");
    command->add_option("--variable", a.variable, "its name, if not clear (z)")->type_name("NAME");
    command->add_option("--unknown", a.unknown, "name of the unknown function, if not clear (y)")
        ->type_name("NAME");
    command->add_option("--minpoly", a.minpoly, "a constant by its polynomial: a^2 - 5")
        ->type_name("POLY");
    command->add_option("--digits", a.digits, "every radius is at most 10^-N (default 30)")
        ->type_name("N");
    command->add_option("--base", a.base, "the base point x + y*I, dyadic")->type_name("POINT");
    command
        ->add_option("--elliptic-time", a.time,
                     "with -r: y'' is by the time t with (dz/dt)^2 = F(z); --system needs no F")
        ->expected(0, 1)
        ->type_name("F(z)");
    command->add_option("--system", a.system, "a system file: its variational equation")
        ->type_name("FILE");
    command->add_option("--stage", a.stage, "with --system: ve (the default), or nve")
        ->check(silent(CLI::IsMember({"ve", "nve"})))
        ->type_name("STAGE");
    command->add_option("--certificate", settings.certificate, "write what is proved to a file")
        ->type_name("FILE");
    manifold_flag(*command);
    set_flag(*command);
    process_flags(*command);
    format_flag(*command, {"text", "json"}, "text or json");
    verbose_flag(*command);
    output_flags(*command);
  }

  void declare_integrals(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("integrals", "first integrals of a system, for all parameter values");
    system_flags(*command, integrals_arguments.file);
    command
        ->add_option("--degree", integrals_arguments.degree,
                     "in the momenta (without momenta: in all variables); default 2")
        ->check(silent(CLI::Range(1, 20)))
        ->type_name("D");
    command
        ->add_option("--coefficients", integrals_arguments.coefficients,
                     "degree of the coefficients in the coordinates")
        ->check(silent(CLI::Range(0, 60)))
        ->type_name("E");
    set_flag(*command);
    process_flags(*command);
    format_flag(*command, {"text", "json"}, "text or json");
    verbose_flag(*command);
    output_flags(*command);
  }

  void declare_classify(CLI::App& app) {
    ClassifyArguments& a = classify_arguments;
    CLI::App* command =
        app.add_subcommand("classify", "for which parameters is a system integrable?");
    system_flags(*command, a.file);
    command
        ->add_option("--degree", a.degree,
                     "of first integrals; default 4, and 6 for small "
                     "systems without free parameters")
        ->check(silent(CLI::Range(1, 20)))
        ->type_name("D");
    command->add_flag("--only-file", a.only_file, "no solutions but the manifolds of the file");
    command
        ->add_option("--as-theorem", a.as_theorem,
                     "write what is found as a theorem file, for prove")
        ->type_name("OUT.toml");
    command
        ->add_option("--certificate", settings.certificate,
                     "write the whole as one certificate, for verify")
        ->type_name("OUT.json");
    command->add_flag("--plan", a.plan,
                      "only what is tried, in this order, and with how much work");
    order_flag(*command, "5");
    set_flag(*command);
    process_flags(*command, 600, "seconds for the whole file");
    work_flag(*command);
    format_flag(*command, {"text", "json", "tex", "html"},
                "text, json, tex or html (also: -o NAME.html)");
    quiet_flag(*command);
    verbose_flag(*command);
    output_flags(*command);
  }

  void report_flags(CLI::App& command) {
    format_flag(command, {"text", "json", "tex", "html"},
                "text, json, tex or html (also: -o NAME.html)");
    process_flags(command, 600, "seconds in all");
    work_flag(command);
    quiet_flag(command);
    verbose_flag(command);
    output_flags(command);
  }

  void declare(CLI::App& app) {
    app.description(examples);
    app.footer(footer);
    app.set_version_flag("--version", std::string("version"),
                         "the version of kovacic and of its libraries");
    app.require_subcommand(1);
    app.get_formatter()->column_width(32);

    CLI::App* solve = app.add_subcommand("solve", "one scalar equation of second order");
    solve->add_option("FILE", solve_arguments.file, "an equation file; - is standard input")
        ->type_name("");
    solve->add_option("-r", solve_arguments.r, "y'' = R y")->type_name("R(z)");
    solve->add_option("-e,--ode", solve_arguments.ode, "a linear equation, e.g. y'' = z*y")
        ->type_name("EQUATION");
    solve->add_option("--p", solve_arguments.p, "with --q: y'' + P y' + Q y = 0")
        ->type_name("P(z)");
    solve->add_option("--q", solve_arguments.q, "with --p")->type_name("Q(z)");
    solve->add_option("--variable", solve_arguments.variable, "its name, if not clear (z)")
        ->type_name("NAME");
    solve
        ->add_option("--unknown", solve_arguments.unknown,
                     "name of the unknown function, if not clear (y)")
        ->type_name("NAME");
    solve->add_option("--minpoly", solve_arguments.minpoly, "a constant by its polynomial: a^2 - 5")
        ->type_name("POLY");
    assume_flag(*solve);
    parameters_flag(*solve, solve_arguments.parameters, "free names (repeatable)");
    solve->add_option("--batch", solve_arguments.batch, "JSON lines in, JSON lines out; - is stdin")
        ->type_name("FILE.jsonl");
    solve->add_option("--jobs", settings.jobs, "--batch: lines at the same time (default: cores)")
        ->check(number(1024, "a number of processes"))
        ->type_name("N");
    solve->add_flag("--resume", solve_arguments.resume,
                    "--batch: go on behind the answers that -o has from a run that ended early");
    solve->add_flag("--no-times", solve_arguments.no_times,
                    "--batch: leave out the times, so that each run writes the same bytes");
    solve->add_flag("--polynomial-of-y", settings.polynomial_of_y,
                    "A4, S4, A5: also the polynomial of y itself, not only that of y'/y");
    solve->add_flag("--complex", settings.complex, "exp(I*x) instead of cos(x) and sin(x)");
    solve->add_flag("--special-functions", settings.special_functions,
                    "--batch: also solutions in Airy's, Bessel's, Whittaker's functions and 2F1");
    solver_flags(*solve, {"text", "json", "tex", "sympy", "maxima", "maple", "mathematica", "sage"},
                 "text, json, tex, sympy, maxima, maple, mathematica or sage");

    declare_families(app);
    declare_spectrum(app);
    declare_monodromy(app);

    CLI::App* check = app.add_subcommand("check", "files: the answer and what was expected");
    check->add_option("FILE", files, "equation or system files; - is standard input")
        ->type_name("");
    one_line_flags(*check);
    solver_flags(*check, {"text", "json", "tex"}, "text, json or tex");
    manifold_flag(*check);
    order_flag(*check, "1");

    CLI::App* show = app.add_subcommand("show", "a system file up to a stage of the reduction");
    system_flags(*show, word);
    show->add_option("--stage", stage, "system, lowest, ve, nve, ode or r (default)")
        ->check(silent(CLI::IsMember({"system", "lowest", "ve", "nve", "ode", "r"})))
        ->type_name("STAGE");
    manifold_flag(*show);
    set_flag(*show);
    process_flags(*show);
    work_flag(*show);
    format_flag(*show, {"text", "json"}, "text or json");
    output_flags(*show);

    CLI::App* find =
        app.add_subcommand("find-manifolds", "invariant sets of a system, most of them linear");
    system_flags(*find, word);
    set_flag(*find);
    process_flags(*find);
    work_flag(*find);
    format_flag(*find, {"text", "json"}, "text or json");
    find->add_flag("-v,--verbose", settings.verbose, "every set as a block to paste");
    output_flags(*find);

    declare_integrals(app);
    declare_classify(app);

    CLI::App* test = app.add_subcommand("test", "run the [[expect]] blocks of files (TAP)");
    test->add_option("DIR|FILE", files, "default: cases")->type_name("");
    set_flag(*test);
    budget_flags(*test, 600);
    method_flags(*test);
    order_flag(*test, "1");
    quiet_flag(*test);
    output_flags(*test);

    CLI::App* verify = app.add_subcommand("verify", "check a certificate independently");
    verify->add_option("CERT", files, "a certificate; - is stdin")->required()->type_name("");
    verify->add_flag("--strict", settings.strict,
                     "refuse steps on trust and hypotheses that nothing checks");
    verify->add_flag("--needs", settings.needs, "what must be believed, in five lines");
    verify->add_flag("--explain", settings.explain, "the steps, and what was checked of each");
    process_flags(*verify, 600);
    format_flag(*verify, {"text", "json"}, "text or json, one line for each file");
    quiet_flag(*verify);
    output_flags(*verify);

    CLI::App* prove =
        app.add_subcommand("prove", "a theorem file: what rests on what, and a report");
    prove->add_option("FILE", word, "a theorem file")->required()->type_name("");
    report_flags(*prove);
    prove->add_option("--certificate", settings.certificate, "write the certificates of the steps")
        ->type_name("DIR");

    CLI::App* report = app.add_subcommand("report", "a system file as a report");
    system_flags(*report, word);
    set_flag(*report);
    manifold_flag(*report);
    order_flag(*report, "1");
    report_flags(*report);

    CLI::App* section =
        app.add_subcommand("section", "Poincare sections: data and pictures (-o DIR)");
    declare_section(*section, section_arguments);
    one_line_flags(*section);
    set_flag(*section);
    section->add_option("--energy", settings.energy, "of a system without a scene: H (default 1/8)")
        ->type_name("E");
    format_flag(*section, {"text", "json"}, "text or json (of what is proved)");
    section
        ->add_option("--certificate", settings.certificate,
                     "--homoclinic: write the proof, of one scene")
        ->type_name("FILE");
    time_flag(*section, 0, "seconds in all; what is done is kept and marked PARTIAL");
    quiet_flag(*section);
    output_flags(*section);

    CLI::App* measure =
        app.add_subcommand("bench", "what accuracy costs: tables and charts (-o DIR)");
    declare_bench(*measure, bench_arguments);
    output_flags(*measure);

    CLI::App* make = app.add_subcommand("new", "an annotated file to start from");
    make->add_option("KIND", word,
                     "ode, hamiltonian, euler-poisson, lagrangian, poisson, vector-field, theorem, "
                     "scene or scan")
        ->type_name("");
    one_line_flags(*make);
    output_flags(*make);

    CLI::App* explain = app.add_subcommand("explain", "what a word in an answer means");
    explain->add_option("WORD", explained, "e.g. SL2, NVE, first integral, budget")->type_name("");
    output_flags(*explain);
  }

  int run(const CLI::App& app) {
    const std::string command = app.get_name();
    settings.timeout = timeout.value_or(time_limits[command]);
    settings.one_page = pages.contains(command);
    set_page_width(settings.output.empty() || settings.output == "-");
    set_colours(settings.style().color);
    if (!settings.quiet) show_that_it_works(command, settings.timeout);
    if (command == "solve") {
      if (solve_arguments.file.starts_with(" -")) solve_arguments.file.erase(0, 1);
      if (is_an_equation(solve_arguments.file) && !solve_arguments.ode)
        std::swap(solve_arguments.ode.emplace(), solve_arguments.file);
      return solve(settings, solve_arguments);
    }
    if (command == "lame") return lame(settings, lame_arguments);
    if (command == "potential") return potential(settings, potential_arguments);
    if (command == "monodromy") return monodromy(settings, monodromy_arguments);
    if (command == "check") {
      settle_input(app, files);
      return check(settings, files);
    }
    if (command == "show") {
      settle_input(app, word);
      return show(settings, word, stage);
    }
    if (command == "find-manifolds") {
      settle_input(app, word);
      return find_manifolds(settings, word);
    }
    if (command == "spectrum") return spectrum(settings, spectrum_arguments);
    if (command == "integrals") {
      settle_input(app, integrals_arguments.file);
      return integrals(settings, integrals_arguments);
    }
    if (command == "classify") {
      if (!classify_arguments.plan) settle_input(app, classify_arguments.file);
      return classify(settings, classify_arguments);
    }
    if (command == "test") return test(settings, files);
    if (command == "verify") return verify(settings, files);
    if (command == "prove") return prove(settings, word);
    if (command == "report") {
      settle_input(app, word);
      return report_system(settings, word);
    }
    if (command == "section") {
      settle_input(app, section_arguments.files);
      return section(settings, section_arguments);
    }
    if (command == "bench") return bench(settings, bench_arguments);
    if (command == "new") {
      const std::string kind = one_line.given() ? std::exchange(word, {}) : "";
      settle_input(app, word);
      if (kind == "scene") settings.given = with_scene(settings, *settings.given);
      if (!kind.empty() && kind != "scene")
        throw CLI::ValidationError("new", "with -H, -L there is one kind more: scene");
      return make_new(settings, word);
    }
    return explain(settings, CLI::detail::join(explained, " "));
  }
};

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* sub : app.get_subcommands({}))
    names.push_back(sub->get_name());
  return names;
}

// What the arguments are about: the sub-command that was named, or the program.
const CLI::App& meant(const CLI::App& app, const std::vector<std::string>& arguments) {
  for (const CLI::App* sub : app.get_subcommands({}))
    if (!arguments.empty() && sub->get_name() == arguments.front()) return *sub;
  return app;
}

std::string option_hint(const CLI::App& app, const std::string& flag) {
  std::vector<std::string> known;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames())
      known.push_back("--" + name);
    for (const std::string& name : option->get_snames())
      known.push_back("-" + name);
  }
  if (const auto near = nearest(flag, known)) return "did you mean " + *near + "?";
  return "see: kovacic " + (app.get_parent() != nullptr ? app.get_name() + " " : "") + "--help";
}

bool known_elsewhere(const CLI::App& app, const std::string& flag) {
  const auto commands = app.get_subcommands({});
  return std::ranges::any_of(commands, [&](const CLI::App* command) {
    return command->get_option_no_throw(flag) != nullptr;
  });
}

int usage_error(const CLI::App& app, const Settings& settings, const CLI::ParseError& error,
                const std::vector<std::string>& arguments) {
  const CLI::App& sub = meant(app, arguments);
  const std::vector<std::string> commands = command_names(app);
  if (sub.get_parent() == nullptr && !arguments.empty() && arguments.front().front() != '-') {
    const auto near = nearest(arguments.front(), commands);
    complain(settings, "unknown command '" + arguments.front() + "'",
             near ? "did you mean " + *near + "?" : "commands: " + enumerate(commands));
    return exit_input;
  }
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError)) {
    const std::vector<std::string> extra = sub.remaining();
    const std::string first = extra.empty() ? std::string("?") : extra.front();
    const bool flag = first.starts_with('-');
    if (flag && known_elsewhere(app, first.substr(0, first.find('=')))) {
      complain(settings, sub.get_name() + " has no use for " + first.substr(0, first.find('=')),
               "see: kovacic " + sub.get_name() + " --help");
      return exit_input;
    }
    complain(settings, (flag ? "unknown option '" : "unexpected argument '") + first + "'",
             flag ? option_hint(sub, first.substr(0, first.find('='))) : option_hint(sub, ""));
    return exit_input;
  }
  std::string message = error.what();
  std::ranges::replace(message, '\n', ' ');
  if (const auto at = message.find(": 1 required "); at != std::string::npos)
    message = message.substr(0, at) + " needs a value";
  if (arguments.empty()) message = "a command is expected: " + enumerate(commands);
  complain(settings, message,
           "see: kovacic " + (sub.get_parent() != nullptr ? sub.get_name() + " " : "") + "--help");
  return exit_input;
}

int main(int argc, char** argv) {
  remember_command(argc, argv);
  CommandLine line;
  CLI::App app;
  app.name("kovacic");
  line.declare(app);
  try {
    std::vector<std::string> arguments(argv + std::min(1, argc), argv + argc);
    const auto names = command_names(app);
    if (!arguments.empty() && is_a_file(arguments.front()) && !is_among(arguments.front(), names))
      arguments.insert(arguments.begin(), command_for(arguments.front()));
    if (!arguments.empty() && (arguments.front() == "-H" || arguments.front() == "-L"))
      arguments.insert(arguments.begin(), "classify");
    if (!arguments.empty() && (arguments.front() == "solve" || arguments.front() == "monodromy" ||
                               arguments.front() == "spectrum"))
      shield_equations(arguments);
    std::ranges::reverse(arguments); // as CLI11 takes them
    app.parse(std::move(arguments));
    catch_interrupts();
    // files are read in a child process, which has no standard error
    tell_readings([told = std::set<std::string>(), to = ::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3)](
                      const std::string& reading) mutable {
      if (told.insert(reading).second) ::dprintf(to, "kovacic: %s\n", printable(reading).c_str());
    });
    const int exit = line.run(*app.get_subcommands().front());
    return exit == exit_interrupted && ending_signal == SIGTERM ? exit_terminated : exit;
  } catch (const CLI::CallForVersion&) {
    return version();
  } catch (const CLI::Success& help) {
    return app.exit(help); // --help, on standard output
  } catch (const CLI::ParseError& error) {
    return usage_error(app, line.settings, error,
                       std::vector<std::string>(argv + std::min(1, argc), argv + argc));
  } catch (const InputError& error) {
    return report(line.settings, error);
  } catch (const std::exception& error) {
    complain(line.settings, "internal error: " + std::string(error.what()),
             "this is an error of the program, not of the input");
    leave_reproducer(error.what());
    return exit_internal;
  }
}

} // namespace
} // namespace kov::cli

int main(int argc, char** argv) { return kov::cli::main(argc, argv); }
