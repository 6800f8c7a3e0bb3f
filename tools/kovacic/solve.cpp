// kovacic solve: one scalar equation.

#include "answer.hpp"
#include "commands.hpp"
#include "equation/equation_file.hpp"
#include "present.hpp"

namespace kov::cli {
namespace {

OriginPtr option_origin(const std::string& option, const std::string& text,
                        const std::string& what) {
  return origin_of_text(option, text, what);
}

std::optional<Expression> formula(const std::string& option, const std::string& text,
                                  bool equation = false) {
  if (text.empty()) return std::nullopt;
  const OriginPtr origin = option_origin(option, text, "");
  return parse_expression(origin->text, origin, equation);
}

Question from_options(const Settings& settings, const SolveArguments& a) {
  Question q;
  q.text.r = formula("-r", a.r);
  q.text.ode = formula("-e", a.ode, true);
  q.text.p = formula("--p", a.p);
  q.text.q = formula("--q", a.q);
  q.text.minpoly = formula("--minpoly", a.minpoly);
  q.text.variable = a.variable;
  q.text.set = settings.settings();
  return q;
}

Question from_file(const Settings& settings, const SolveArguments& a) {
  const Entry document = read_document(a.file);
  if (!is_equation_file(document))
    throw InputError(a.file, 0, 0, 1, "this file describes a system, not one equation",
                     "write: kovacic check " + a.file);
  EquationFile file = read_equation_file(document);
  Question q;
  q.text = std::move(file.text);
  q.text.set = settings.settings();
  q.id = a.file;
  if (!a.variable.empty()) q.text.variable = a.variable;
  if (!a.minpoly.empty()) q.text.minpoly = formula("--minpoly", a.minpoly);
  return q;
}

} // namespace

int solve(const Settings& settings, const SolveArguments& a) {
  if (!a.batch.empty()) return batch(settings, a.batch);
  const bool one_liner = !a.r.empty() || !a.ode.empty() || !a.p.empty() || !a.q.empty();
  if (one_liner == !a.file.empty()) {
    complain(settings,
             one_liner ? "a file and a one-line equation are both given" : "no equation is given",
             "write e.g. kovacic solve -r 'z'   or   kovacic solve -e \"y'' = z*y\"   or   kovacic "
             "solve FILE");
    return exit_input;
  }
  Solver solver(fixed_question(
                    [&] { return one_liner ? from_options(settings, a) : from_file(settings, a); }),
                settings);
  const Answer answer = solver.answer("");
  return present(settings, answer, one_liner ? "" : a.file);
}

} // namespace kov::cli
