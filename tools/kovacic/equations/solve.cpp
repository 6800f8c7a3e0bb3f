// kovacic solve: one scalar equation.

#include "commands.hpp"
#include "equation/equation_file.hpp"
#include "equation/parametric_equation.hpp"
#include "equations/answer.hpp"
#include "equations/present.hpp"
#include "exact/lists.hpp"

#include <algorithm>

namespace kov::cli {
namespace {

Question from_options(const Settings& settings, const SolveArguments& a) {
  EquationText given;
  given.variable = a.variable;
  given.unknown = a.unknown;
  given.parameters = a.parameters;
  given.set = settings.settings();
  given.assume = assumed_texts(settings.assume, "--assume");
  return {asked_equation({a.r, a.ode, a.p, a.q, a.minpoly}, std::move(given), Door::options)};
}

Question from_file(const Settings& settings, const SolveArguments& a, const Entry& document) {
  if (!is_equation_file(document))
    throw InputError(a.file, 0, 0, 1, "this file describes a system, not one equation",
                     "write: kovacic check " + a.file);
  Question q{read_equation_file(document).asked};
  q.text.set = settings.settings();
  q.id = a.file;
  if (!a.variable.empty()) q.text.variable = a.variable;
  if (!a.unknown.empty()) q.text.unknown = a.unknown;
  if (a.minpoly) q.text.minpoly = parse_expression(*a.minpoly, "--minpoly");
  add_assumptions(q.text, assumed_texts(settings.assume, "--assume"));
  return q;
}

// An option that lines of a batch would not obey; "" if there is none.
std::string not_in_a_batch(const Settings& settings, const SolveArguments& a) {
  if (!settings.set.empty()) return "--set";
  if (!a.variable.empty()) return "--variable";
  if (!a.unknown.empty()) return "--unknown";
  if (a.minpoly) return "--minpoly";
  if (!a.parameters.empty()) return "--parameter";
  if (!settings.assume.empty()) return "--assume";
  if (settings.trace) return "--trace";
  if (settings.exit_verdict) return "--exit-verdict";
  if (settings.verbose > 0) return "--verbose";
  return settings.format == "text" || settings.format == "json" ? ""
                                                                : "--format " + settings.format;
}

} // namespace

int solve(const Settings& settings, const SolveArguments& a) {
  const bool one_liner = a.r || a.ode || a.p || a.q;
  if (one_liner + !a.file.empty() + !a.batch.empty() != 1) {
    complain(settings,
             one_liner || !a.file.empty() ? "two equations are given" : "no equation is given",
             "write e.g. kovacic solve -r 'z'   or   kovacic solve -e \"y'' = z*y\"   or   kovacic "
             "solve FILE");
    return exit_input;
  }
  if (!a.batch.empty()) {
    if (a.resume && (settings.output.empty() || settings.output == "-")) {
      complain(settings, "--resume needs the file of the answers", "write: -o FILE");
      return exit_input;
    }
    if (const std::string no = not_in_a_batch(settings, a); !no.empty()) {
      complain(settings, no + " says nothing to --batch",
               "each line has its own keys: variable, unknown, minpoly, parameters, assumptions; "
               "the answers "
               "are JSON");
      return exit_input;
    }
    Settings many = settings;
    many.in_a_batch = true;
    return batch(many, {a.batch, a.resume, a.no_times});
  }
  if (a.resume || a.no_times) {
    complain(settings, std::string(a.resume ? "--resume" : "--no-times") + " is for --batch");
    return exit_input;
  }
  if (settings.jobs > 0) {
    complain(settings, "--jobs is for --batch", "one equation is decided by one process");
    return exit_input;
  }
  std::optional<Entry> document;
  if (!one_liner) document = read_document(a.file);
  Solver solver(fixed_question([&] {
                  return one_liner ? from_options(settings, a) : from_file(settings, a, *document);
                }),
                settings);
  return present(settings, solver.answer(""), one_liner ? "" : a.file);
}

} // namespace kov::cli
