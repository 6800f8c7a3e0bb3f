// kovacic solve: one scalar equation.

#include "answer.hpp"
#include "commands.hpp"
#include "equation/assumptions.hpp"
#include "equation/equation_file.hpp"
#include "equation/parametric_equation.hpp"
#include "exact/lists.hpp"
#include "pasted_question.hpp"
#include "present.hpp"

#include <algorithm>

namespace kov::cli {
namespace {

std::vector<AssumedText> assumed(const SolveArguments& a) {
  std::vector<AssumedText> all;
  for (const std::string& text : a.assume)
    all.push_back({text, origin_of_text("--assume", text), ""});
  return all;
}

// The names in the assumptions that occur in the equation are parameters, unless they are its
// variable.
void add_assumptions(Question& q, const SolveArguments& a) {
  const auto names = settable_names(q.text);
  for (const AssumedText& sentence : assumed(a)) {
    q.text.assume.push_back(sentence);
    for (const std::string& name : names_in_assumption(sentence))
      if (name != (q.text.variable.empty() ? "z" : q.text.variable) &&
          std::ranges::binary_search(names, name))
        q.text.parameters.push_back(name);
  }
}

// If the variable was named, the other names are parameters.
void take_parameters(Question& q, const SolveArguments& a) {
  if (a.variable.empty() || !q.text.ode || q.text.minpoly) return;
  std::vector<std::string> before = q.text.parameters;
  take_all_parameters(q.text);
  std::vector<std::string> taken;
  for (const std::string& name : q.text.parameters)
    if (!is_among(name, before)) taken.push_back(name);
  if (taken.empty()) return;
  auto note = std::ranges::find(q.notes, ReadingNote::What::names, &ReadingNote::what);
  if (note == q.notes.end())
    note = q.notes.insert(note, {ReadingNote::What::names, {"", q.text.variable}});
  note->of.insert(note->of.end(), taken.begin(), taken.end());
}

Question from_options(const Settings& settings, const SolveArguments& a) {
  EquationText given;
  given.variable = a.variable;
  given.unknown = a.unknown;
  given.parameters = a.parameters;
  given.set = settings.settings();
  given.assume = assumed(a);
  PastedQuestion pasted = read_options({a.r, a.ode, a.p, a.q, a.minpoly}, std::move(given));
  Question q;
  q.text = std::move(pasted.text);
  q.text.assume.clear();
  q.given = std::move(pasted.given);
  q.read_as = std::move(pasted.read_as);
  q.notes = std::move(pasted.notes);
  q.right_side = std::move(pasted.right_side);
  q.whole = std::move(pasted.whole);
  add_assumptions(q, a);
  take_parameters(q, a);
  return q;
}

Question from_file(const Settings& settings, const SolveArguments& a, const Entry& document) {
  if (!is_equation_file(document))
    throw InputError(a.file, 0, 0, 1, "this file describes a system, not one equation",
                     "write: kovacic check " + a.file);
  EquationFile file = read_equation_file(document);
  Question q;
  q.text = std::move(file.text);
  q.text.set = settings.settings();
  q.id = a.file;
  if (!a.variable.empty()) q.text.variable = a.variable;
  if (!a.unknown.empty()) q.text.unknown = a.unknown;
  if (a.minpoly) q.text.minpoly = parse_expression(*a.minpoly, "--minpoly");
  add_assumptions(q, a);
  return q;
}

// An option that lines of a batch would not obey; "" if there is none.
std::string not_in_a_batch(const Settings& settings, const SolveArguments& a) {
  if (!settings.set.empty()) return "--set";
  if (!a.variable.empty()) return "--variable";
  if (!a.unknown.empty()) return "--unknown";
  if (a.minpoly) return "--minpoly";
  if (!a.parameters.empty()) return "--parameter";
  if (!a.assume.empty()) return "--assume";
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
