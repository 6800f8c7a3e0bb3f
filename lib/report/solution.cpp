#include "report/solution.hpp"

#include "answer/notation.hpp"
#include "symbol/expression.hpp"

namespace kov::report {
namespace {

std::string enclosed(const std::string& s, Markup m) {
  return m == Markup::tex ? "\\left(" + s + "\\right)"
                          : "<mrow><mo>(</mo>" + s + "<mo>)</mo></mrow>";
}

// J with n below it; 2F1 has its numbers on both sides.
std::string letter(const answer::InBooks& f, Markup m) {
  const auto script = [&](const std::optional<Expression>& e) {
    return e ? solution(*e, m) : std::string("<none/>");
  };
  if (m == Markup::tex) {
    std::string name = f.letter == "2F1"      ? "{}_2F_1"
                       : f.letter.size() == 1 ? f.letter
                                              : "\\operatorname{" + f.letter + "}";
    if (f.below) name += "_{" + script(f.below) + "}";
    return f.above ? name + "^{" + script(f.above) + "}" : name;
  }
  if (f.letter == "2F1")
    return "<mmultiscripts><mi>F</mi><mn>1</mn><none/><mprescripts/><mn>2</mn><none/></"
           "mmultiscripts>";
  const std::string name = "<mi>" + f.letter + "</mi>";
  if (!f.below && !f.above) return name;
  return "<mmultiscripts>" + name + script(f.below) + script(f.above) + "</mmultiscripts>";
}

std::string special(const answer::InBooks& f, Markup m) {
  std::string arguments;
  for (std::size_t i = 0; i < f.arguments.size(); ++i) {
    const std::string sign = i < f.parameters || f.parameters == 0 ? "," : ";";
    if (i > 0) arguments += m == Markup::tex ? sign + " " : "<mo>" + sign + "</mo>";
    arguments += solution(f.arguments[i], m);
  }
  return letter(f, m) + enclosed(arguments, m);
}

std::string integral(const Expression& e, Markup m) {
  const bool tex = m == Markup::tex;
  std::string inside = solution(e.operand(0), m);
  if (e.operand(0).kind() == Expression::Kind::sum) inside = enclosed(inside, m);
  const std::string by = e.operands().size() > 1 ? solution(e.operand(1), m) : "z";
  return tex ? "\\int " + inside + "\\,d" + by
             : "<mo>&int;</mo>" + inside + "<mspace width=\"0.12em\"/><mi>d</mi>" + by;
}

} // namespace

std::string solution(const Expression& e, Markup m) {
  using Kind = Expression::Kind;
  return in_markup(e, m, [m](const Expression& x) -> std::optional<std::string> {
    const bool tex = m == Markup::tex;
    if (x.kind() == Kind::name && x.name() == "I") return tex ? "\\mathrm{i}" : "<mi>i</mi>";
    if (x.kind() != Kind::call) return std::nullopt;
    if (const auto f = answer::in_books(x)) return special(*f, m);
    if (x.name() == "int") return integral(x, m);
    if (x.name() != "root") return std::nullopt; // its approximation is left out
    return (tex ? "\\operatorname{root}" : "<mi>root</mi>") +
           enclosed(solution(x.operand(0), m), m);
  });
}

} // namespace kov::report
