#include "command_table.hpp"

#include <filesystem>
#include <utility>

namespace kov::cli {
namespace {

// "y'' = x*y" in the place of a file.
bool is_an_equation(const std::string& file) {
  std::error_code none;
  return !file.empty() && file != "-" && !std::filesystem::is_regular_file(file, none) &&
         !file.ends_with(".toml") &&
         (file.find_first_of("'=^*(") != std::string::npos || file.front() == '[');
}

// Throws unless there is just one of a file and a formula.
void settle_input(const CLI::App& command, Asked& asked, std::string& file) {
  if (asked.one_line.given() != file.empty())
    throw CLI::ValidationError(command.get_name(),
                               asked.one_line.given()
                                   ? "a file or a formula is expected, not both"
                                   : "a file is expected, or a formula: -H 'p^2/2 + "
                                     "q^4'");
  if (asked.one_line.given()) file = take_one_line(asked.settings, asked.one_line);
}
void settle_input(const CLI::App& command, Asked& asked, std::vector<std::string>& files) {
  std::string first = files.empty() ? "" : files.front();
  settle_input(command, asked, first);
  if (files.empty()) files.push_back(first);
}

constexpr Command all_commands[] = {
    {"solve", "one scalar equation of second order",
     [](CLI::App& c, Flags& flags, Asked& asked) {
       c.add_option("FILE", asked.solve.file, "an equation file; - is standard input")
           ->type_name("");
       flags.equation(asked.solve);
       flags.assume();
       flags.parameters(asked.solve.parameters, "free names (repeatable)");
       c.add_option("--batch", asked.solve.batch, "JSON lines in, JSON lines out; - is stdin")
           ->type_name("FILE.jsonl");
       c.add_option("--jobs", asked.settings.jobs,
                    "--batch: lines at the same time (default: cores)")
           ->check(number(1024, "a number of processes"))
           ->type_name("N");
       c.add_flag("--resume", asked.solve.resume,
                  "--batch: go on behind the answers that -o has from a run that ended early");
       c.add_flag("--no-times", asked.solve.no_times,
                  "--batch: leave out the times, so that each run writes the same bytes");
       c.add_flag("--polynomial-of-y", asked.settings.polynomial_of_y,
                  "A4, S4, A5: also the polynomial of y itself, not only that of y'/y");
       c.add_flag("--complex", asked.settings.complex, "exp(I*x) instead of cos(x) and sin(x)");
       c.add_flag("--special-functions", asked.settings.special_functions,
                  "--batch: also solutions in Airy's, Bessel's, Whittaker's functions and 2F1");
       flags.solver(
           {"text", "json", "tex", "html", "sympy", "maxima", "maple", "mathematica", "sage"},
           "text, json, tex, html (also: -o NAME.html), sympy, maxima, maple, mathematica or sage");
     },
     [](const CLI::App&, Asked& asked) {
       if (asked.solve.file.starts_with(" -")) asked.solve.file.erase(0, 1);
       if (is_an_equation(asked.solve.file) && !asked.solve.ode)
         std::swap(asked.solve.ode.emplace(), asked.solve.file);
       return solve(asked.settings, asked.solve);
     }},
    {"lame", "Lame's equation, with numbers or a condition",
     [](CLI::App& c, Flags& flags, Asked& asked) {
       c.add_option("FILE", asked.lame.file, "a file with a [lame] table")->type_name("");
       c.add_option("-n", asked.lame.n, "y_tt = (N(N+1) wp(t; g2, g3) + B) y")->type_name("N");
       c.add_option("--alpha", asked.lame.alpha, "N(N+1), instead of -n")->type_name("A");
       c.add_option("--B", asked.lame.b, "what is not given stays a name")->type_name("B");
       c.add_option("--g2", asked.lame.g2, "a number or a formula")->type_name("G");
       c.add_option("--g3", asked.lame.g3, "a number or a formula")->type_name("G");
       flags.set();
       flags.budget();
       flags.format({"text", "json"}, "text or json");
       flags.exit_verdict();
       flags.verbose();
       flags.output();
     },
     [](const CLI::App&, Asked& asked) { return lame(asked.settings, asked.lame); }},
    {"potential", "eigenvalues of integrable homogeneous potentials",
     [](CLI::App& c, Flags& flags, Asked& asked) {
       c.add_option("--degree", asked.potential.degree, "of the potential, not 0")
           ->required()
           ->type_name("K");
       c.add_option("--eigenvalue", asked.potential.eigenvalue, "only this one")->type_name("L");
       flags.process();
       flags.format({"text", "json"}, "text or json");
       flags.exit_verdict();
       flags.verbose();
       flags.output();
     },
     [](const CLI::App&, Asked& asked) { return potential(asked.settings, asked.potential); }},
    {"spectrum", "for which E is there a Liouvillian solution?",
     [](CLI::App& c, Flags& flags, Asked& asked) {
       flags.equation(asked.spectrum);
       c.add_option("--for", asked.spectrum.energy, "the parameter that is asked for (E)")
           ->type_name("NAME");
       flags.assume();
       c.add_option("--levels", asked.spectrum.levels,
                    "how many integers N are written out (1 to 20); default 4")
           ->check(number(20, "a number of levels"))
           ->type_name("N");
       flags.set();
       flags.budget();
       flags.format({"text", "json"}, "text or json");
       flags.quiet();
       flags.verbose();
       flags.output();
     },
     [](const CLI::App&, Asked& asked) { return spectrum(asked.settings, asked.spectrum); }},
    {"monodromy", "monodromy matrices with proven radii",
     [](CLI::App& c, Flags& flags, Asked& asked) {
       flags.equation(asked.monodromy);
       c.add_option("--digits", asked.monodromy.digits,
                    "every radius is at most 10^-N (default 30)")
           ->type_name("N");
       c.add_option("--base", asked.monodromy.base, "the base point x + y*I, dyadic")
           ->type_name("POINT");
       c.add_option("--elliptic-time", asked.monodromy.time,
                    "with -r: y'' is by the time t with (dz/dt)^2 = F(z); --system needs no F")
           ->expected(0, 1)
           ->type_name("F(z)");
       c.add_option("--system", asked.monodromy.system, "a system file: its variational equation")
           ->type_name("FILE");
       c.add_option("--stage", asked.monodromy.stage, "with --system: ve (the default), or nve")
           ->check(silent(CLI::IsMember({"ve", "nve"})))
           ->type_name("STAGE");
       c.add_option("--certificate", asked.settings.certificate, "write what is proved to a file")
           ->type_name("FILE");
       flags.manifold();
       flags.set();
       flags.process();
       flags.format({"text", "json"}, "text or json");
       flags.verbose();
       flags.output();
     },
     [](const CLI::App&, Asked& asked) { return monodromy(asked.settings, asked.monodromy); }},
    {"check", "files: the answer and what was expected",
     [](CLI::App& c, Flags& flags, Asked& asked) {
       c.add_option("FILE", asked.files, "equation or system files; - is standard input")
           ->type_name("");
       flags.one_line();
       flags.solver({"text", "json", "tex", "html"},
                    "text, json, tex or html (also: -o NAME.html)");
       flags.manifold();
       flags.order("1");
     },
     [](const CLI::App& app, Asked& asked) {
       settle_input(app, asked, asked.files);
       return check(asked.settings, asked.files);
     }},
    {"show", "a system file up to a stage of the reduction",
     [](CLI::App& c, Flags& flags, Asked& asked) {
       flags.system(asked.word);
       c.add_option("--stage", asked.stage, "system, lowest, ve, nve, ode or r (default)")
           ->check(silent(CLI::IsMember({"system", "lowest", "ve", "nve", "ode", "r"})))
           ->type_name("STAGE");
       flags.manifold();
       flags.set();
       flags.process();
       flags.work();
       flags.format({"text", "json"}, "text or json");
       flags.output();
     },
     [](const CLI::App& app, Asked& asked) {
       settle_input(app, asked, asked.word);
       return show(asked.settings, asked.word, asked.stage);
     }},
    {"find-manifolds", "invariant sets of a system, most of them linear",
     [](CLI::App& c, Flags& flags, Asked& asked) {
       flags.system(asked.word);
       flags.set();
       flags.process();
       flags.work();
       flags.format({"text", "json"}, "text or json");
       c.add_flag("-v,--verbose", asked.settings.verbose, "every set as a block to paste");
       flags.output();
     },
     [](const CLI::App& app, Asked& asked) {
       settle_input(app, asked, asked.word);
       return find_manifolds(asked.settings, asked.word);
     }},
    {"integrals", "first integrals of a system, for all parameter values",
     [](CLI::App& c, Flags& flags, Asked& asked) {
       flags.system(asked.integrals.file);
       c.add_option("--degree", asked.integrals.degree,
                    "in the momenta (without momenta: in all variables); default 4 where that is "
                    "quick, else 2")
           ->check(silent(CLI::Range(1, 20)))
           ->type_name("D");
       c.add_option("--coefficients", asked.integrals.coefficients,
                    "degree of the coefficients in the coordinates")
           ->check(silent(CLI::Range(0, 60)))
           ->type_name("E");
       flags.set();
       flags.process();
       flags.format({"text", "json"}, "text or json");
       flags.verbose();
       flags.output();
     },
     [](const CLI::App& app, Asked& asked) {
       settle_input(app, asked, asked.integrals.file);
       return integrals(asked.settings, asked.integrals);
     }},
    {"classify", "for which parameters is a system integrable?",
     [](CLI::App& c, Flags& flags, Asked& asked) {
       flags.system(asked.classify.file);
       c.add_option("--degree", asked.classify.degree,
                    "of first integrals; default 4, and 6 for small "
                    "systems without free parameters")
           ->check(silent(CLI::Range(1, 20)))
           ->type_name("D");
       c.add_flag("--only-file", asked.classify.only_file,
                  "no solutions but the manifolds of the file");
       c.add_option("--as-theorem", asked.classify.as_theorem,
                    "write what is found as a theorem file, for prove")
           ->type_name("OUT.toml");
       c.add_option("--certificate", asked.settings.certificate,
                    "write the whole as one certificate, for verify")
           ->type_name("OUT.json");
       c.add_flag("--plan", asked.classify.plan,
                  "only what is tried, in this order, and with how much work");
       flags.order("5");
       flags.set();
       flags.process(600, "seconds for the whole file");
       flags.work();
       flags.format({"text", "json", "tex", "html"},
                    "text, json, tex or html (also: -o NAME.html)");
       flags.quiet();
       flags.verbose();
       flags.output();
     },
     [](const CLI::App& app, Asked& asked) {
       if (!asked.classify.plan) settle_input(app, asked, asked.classify.file);
       return classify(asked.settings, asked.classify);
     }},
    {"test", "run the [[expect]] blocks of files (TAP)",
     [](CLI::App& c, Flags& flags, Asked& asked) {
       c.add_option("DIR|FILE", asked.files, "default: cases")->type_name("");
       flags.set();
       flags.budget(600);
       flags.method();
       flags.order("1");
       flags.quiet();
       flags.output();
     },
     [](const CLI::App&, Asked& asked) { return test(asked.settings, asked.files); }},
    {"verify", "check a certificate independently",
     [](CLI::App& c, Flags& flags, Asked& asked) {
       c.add_option("CERT", asked.files, "a certificate; - is stdin")->required()->type_name("");
       c.add_flag("--strict", asked.settings.strict,
                  "refuse steps on trust and hypotheses that nothing checks");
       c.add_flag("--needs", asked.settings.needs, "what must be believed, in five lines");
       c.add_flag("--explain", asked.settings.explain, "the steps, and what was checked of each");
       flags.process(600);
       flags.format({"text", "json"}, "text or json, one line for each file");
       flags.quiet();
       flags.output();
     },
     [](const CLI::App&, Asked& asked) { return verify(asked.settings, asked.files); }},
    {"prove", "a theorem file: what rests on what, and a report",
     [](CLI::App& c, Flags& flags, Asked& asked) {
       c.add_option("FILE", asked.word, "a theorem file")->required()->type_name("");
       flags.report();
       c.add_option("--certificate", asked.settings.certificate,
                    "write the certificates of the steps")
           ->type_name("DIR");
     },
     [](const CLI::App&, Asked& asked) { return prove(asked.settings, asked.word); }},
    {"report", "a system file as a report",
     [](CLI::App&, Flags& flags, Asked& asked) {
       flags.system(asked.word);
       flags.set();
       flags.manifold();
       flags.order("1");
       flags.report();
     },
     [](const CLI::App& app, Asked& asked) {
       settle_input(app, asked, asked.word);
       return report_system(asked.settings, asked.word);
     }},
    {"section", "Poincare sections: data and pictures (-o DIR)",
     [](CLI::App& c, Flags& flags, Asked& asked) {
       declare_section(c, asked.section);
       flags.one_line();
       flags.set();
       c.add_option("--energy", asked.settings.energy,
                    "of a system without a scene: H (default 1/8)")
           ->type_name("E");
       flags.format({"text", "json"}, "text or json (of what is proved)");
       c.add_option("--certificate", asked.settings.certificate,
                    "--homoclinic: write the proof, of one scene")
           ->type_name("FILE");
       flags.time(0, "seconds in all; what is done is kept and marked PARTIAL");
       flags.quiet();
       flags.output();
     },
     [](const CLI::App& app, Asked& asked) {
       settle_input(app, asked, asked.section.files);
       return section(asked.settings, asked.section);
     }},
    {"bench", "what accuracy costs: tables and charts (-o DIR)",
     [](CLI::App& c, Flags& flags, Asked& asked) {
       declare_bench(c, asked.bench);
       flags.output();
     },
     [](const CLI::App&, Asked& asked) { return bench(asked.settings, asked.bench); }},
    {"new", "an annotated file to start from",
     [](CLI::App& c, Flags& flags, Asked& asked) {
       c.add_option("KIND", asked.word,
                    "ode, hamiltonian, euler-poisson, lagrangian, newton, poisson, vector-field, "
                    "theorem, scene or scan")
           ->type_name("");
       flags.one_line();
       flags.output();
     },
     [](const CLI::App& app, Asked& asked) {
       const std::string kind = asked.one_line.given() ? std::exchange(asked.word, {}) : "";
       settle_input(app, asked, asked.word);
       if (kind == "scene")
         asked.settings.given = with_scene(asked.settings, *asked.settings.given);
       if (!kind.empty() && kind != "scene")
         throw CLI::ValidationError("new", "with -H, -L there is one kind more: scene");
       return make_new(asked.settings, asked.word);
     }},
    {"explain", "what a word in an answer means",
     [](CLI::App& c, Flags& flags, Asked& asked) {
       c.add_option("WORD", asked.explained, "e.g. SL2, NVE, first integral, budget")
           ->type_name("");
       flags.output();
     },
     [](const CLI::App&, Asked& asked) {
       return explain(asked.settings, CLI::detail::join(asked.explained, " "));
     }},
};

} // namespace

std::span<const Command> command_table() { return all_commands; }

} // namespace kov::cli
