#include "answer/notation.hpp"
#include "exact/joined.hpp"
#include "output/render.hpp"
#include "report/formula.hpp"

#include "symbol/expression.hpp"

namespace kov::cli {
namespace {

using report::tex_name;

std::string tex(const Expression& e);

// J_{n}(x)
std::string tex_special(const answer::InBooks& f) {
  std::string text = f.letter == "2F1"      ? "{}_2F_1"
                     : f.letter.size() == 1 ? f.letter
                                            : "\\operatorname{" + f.letter + "}";
  if (f.below) text += "_{" + tex(*f.below) + "}";
  if (f.above) text += "^{" + tex(*f.above) + "}";
  for (std::size_t i = 0; i < f.arguments.size(); ++i)
    text += (i == 0                                  ? "\\left("
             : i < f.parameters || f.parameters == 0 ? ", "
                                                     : "; ") +
            tex(f.arguments[i]);
  return text + "\\right)";
}

// I, special functions and integrals: they stand in solutions only.
std::optional<std::string> of_a_solution(const Expression& e) {
  using Kind = Expression::Kind;
  if (e.kind() == Kind::name && e.name() == "I") return "\\mathrm{i}";
  if (e.kind() != Kind::call) return std::nullopt;
  if (const auto special = answer::in_books(e)) return tex_special(*special);
  const std::string inside = tex(e.operand(0));
  if (e.name() == "root") // the approximation is left out
    return "\\operatorname{root}\\left(" + inside + "\\right)";
  if (e.name() != "int") return std::nullopt;
  return "\\int " + (e.operand(0).kind() == Kind::sum ? "\\left(" + inside + "\\right)" : inside) +
         "\\,d" + (e.operands().size() > 1 ? tex(e.operand(1)) : "z");
}

std::string tex(const Expression& e) { return report::in_tex(e, of_a_solution); }

// A sentence with its formulas.
std::string prose(const std::string& text) { return report::prose(text, report::Markup::tex); }

std::string group_tex(const Json& group) {
  if (group.is_null()) return "\\text{undecided}";
  const std::string type = group.at("type").get<std::string>();
  const std::string n = group.at("n").is_null()     ? "n"
                        : group.at("n").is_string() ? group.at("n").get<std::string>()
                                                    : group.at("n").dump();
  if (type == "SL2") return "\\mathrm{SL}(2,\\mathbb{C})";
  if (type == "Borel") return "\\mathbb{G}_m\\ltimes\\mathbb{G}_a";
  if (type == "T") return n == "1" ? "\\mathbb{G}_a" : "T_{" + n + "}";
  if (type == "Gm") return "\\mathbb{G}_m";
  if (type == "cyclic") return n == "1" ? "\\{1\\}" : "\\mu_{" + n + "}";
  if (type == "Dinf") return "\\mathbb{D}_\\infty";
  if (type == "D") return "\\mathbb{D}_{" + n + "}";
  if (type == "A4") return "A_4^{\\mathrm{SL}_2}";
  if (type == "S4") return "S_4^{\\mathrm{SL}_2}";
  return "A_5^{\\mathrm{SL}_2}";
}

std::string component_tex(const Json& name) {
  if (name.is_null()) return "\\text{undecided}";
  if (name == "SL2") return "\\mathrm{SL}(2,\\mathbb{C})";
  if (name == "Borel") return "\\mathbb{G}_m\\ltimes\\mathbb{G}_a";
  if (name == "Gm") return "\\mathbb{G}_m";
  if (name == "Ga") return "\\mathbb{G}_a";
  return "\\{1\\}";
}

std::string joined_texts(const Json& texts, const std::string& if_none) {
  std::string all = joined(texts, [&](const Json& t) { return t.get<std::string>(); });
  return prose(all.empty() ? if_none : all);
}

// Over parameters: for which of them, and what on each stratum.
std::string strata_tex(const Json& result) {
  std::string s;
  if (result.contains("contradictory")) s += "No parameters satisfy the assumptions.\n";
  if (const Json& given = result.value("assumed", Json::array()); !given.empty())
    s += "Assumed: " + joined_texts(given, "") + ".\n";
  if (result.contains("domain"))
    s += "There is an equation for " + joined_texts(result.at("domain"), "") + " only.\n";
  if (result.contains("no_equation")) // and a list without items is an error of LaTeX
    return s + prose(result.at("no_equation").get<std::string>()) + ".\n";
  s += "\\begin{description}\n";
  for (const Json& x : result.at("strata")) {
    const std::string group = x.at("group_text");
    s += "\\item[" + joined_texts(x.at("conditions"), "for all parameters") + "] ";
    if (x.contains("equation"))
      s += "Here the equation is " + prose(x.at("equation").get<std::string>()) + ". ";
    s += (group.empty() ? "" : "The group is " + prose(group) + ". ") +
         "Its identity component is " + whether_abelian(x.at("abelian")) + ": " +
         prose(x.at("reason").get<std::string>()) + ".\n";
  }
  for (const Json& u : result.value("unvisited", Json::array()))
    s += "\\item[" + prose(u.get<std::string>()) + "] Open.\n";
  s += "\\end{description}\n";
  if (const Json& steps = result.at("trusted"); !steps.empty())
    s += "On trust: " + joined_texts(steps, "") + ".\n";
  return s;
}

} // namespace

std::string tex_of_formula(const std::string& formula) {
  try {
    return tex(parse_expression(formula, "tex", true));
  } catch (const InputError&) {
    return "\\mathtt{" + report::verbatim(formula, report::Markup::tex) + "}";
  }
}

namespace {

// The polynomial that w satisfies, or X; coefficients ascending.
std::string polynomial_tex(const Json& c, const std::string& unknown) {
  std::string sum;
  for (std::size_t i = c.size(); i-- > 0;) {
    const std::string factor = c[i].get<std::string>();
    if (factor == "0") continue;
    sum += (sum.empty() ? "" : " + ") + (factor == "1" && i > 0 ? "" : "(" + factor + ")");
    if (i > 0) sum += (factor == "1" ? "" : "*") + unknown;
    if (i > 1) sum += "^" + std::to_string(i);
  }
  return tex_of_formula(sum);
}

std::string polynomial_of_y_tex(const Json& result) {
  if (!result.contains("polynomial_of_y")) return {};
  const Json& y = result.at("polynomial_of_y");
  const FreshLetters letter = letters_beside(result);
  const std::string x = letter("X");
  if (y.contains("missing"))
    return "No polynomial of $" + tex_name(unknown_of(result)) +
           "$: " + prose(y.at("missing").get<std::string>()) + ".\n";
  const bool given = y.contains("given_factor");
  const std::string factor = y.at(given ? "given_factor" : "factor").get<std::string>();
  return "\\[ " + tex_name(is_transformed(result) && !given ? letter("u") : unknown_of(result)) +
         "^{" + y.at("power").dump() +
         "} = " + (factor == "1" ? "" : "\\left(" + tex_of_formula(factor) + "\\right)") +
         tex_name(x) + ",\\quad " + polynomial_tex(y.at("polynomial"), x) + " = 0 \\]\n";
}

std::string solutions_tex(const Json& result) {
  std::string s;
  const FreshLetters letter = letters_beside(result);
  const std::string u = tex_name(is_transformed(result) ? letter("u") : unknown_of(result)),
                    y = tex_name(result.contains("whole")
                                     ? result.at("whole").at("unknown").get<std::string>()
                                     : unknown_of(result)),
                    w = letter("w");
  if (result.at("liouvillian").is_array())
    for (const Json& x : result.at("liouvillian"))
      if (x.contains("minimal_polynomial"))
        s += "\\[ " + tex_name(w) + " = " + u + "'/" + u + ":\\quad " +
             polynomial_tex(x.at("minimal_polynomial"), w) + " = 0 \\]\n";
  if (!result.at("solutions").is_array()) return s;
  const Json& all = result.at("solutions");
  for (std::size_t i = 0; i < all.size(); ++i)
    s += "\\[ " + y + (all.size() > 1 ? "_" + std::to_string(i + 1) : std::string()) + " = " +
         tex_of_formula(all[i].get<std::string>()) + " \\]\n";
  return s;
}

} // namespace

std::string tex_of_result(const Json& result, const std::string& title) {
  std::string s;
  if (!title.empty()) s += "\\paragraph{" + prose(title) + "}\n";
  const bool given = result.value("equation", Json()).is_string();
  if (given) {
    s += "\\[ " + tex_of_formula(result.at("equation").get<std::string>());
    if (result.contains("whole"))
      for (const Json& value : result.at("whole").value("values", Json::array()))
        s += ",\\quad " + tex_of_formula(value.get<std::string>());
    s += " \\]\n";
  }
  s += solutions_tex(result);
  if (std::string here = about_given(result);
      !here.empty() && (!given || result.at("given").size() > 1)) {
    here[0] = 'T';
    s += prose(here) + ".\n";
  }
  if (!result.at("r").is_null() && (!given || is_transformed(result))) {
    const std::string u = is_transformed(result) ? letters_beside(result)("u") : unknown_of(result);
    if (given) s += "What follows is about its normal form:\n";
    s += "\\[ " + tex_of_formula(u + "'' = (" + result.at("r").get<std::string>() + ")*" + u) +
         " \\]\n";
  }
  if (result.contains("strata")) return s + strata_tex(result) + polynomial_of_y_tex(result);
  s += "$G = " + group_tex(result.at("group")) +
       "$, $G^0 = " + component_tex(result.at("identity_component")) + "$";
  const std::string abelian = result.at("abelian").get<std::string>();
  s += abelian == "yes"       ? " (abelian).\n"
       : abelian == "no"      ? " (not abelian).\n"
       : abelian == "depends" ? "; whether $G^0$ is abelian depends on the parameters.\n"
                              : "; whether $G^0$ is abelian is undecided.\n";
  if (!result.at("case").is_null())
    s += "Case " + result.at("case").dump() + " of Kovacic's algorithm.\n";
  if (std::string reason = result.at("reason").get<std::string>(); !reason.empty()) {
    if (reason.starts_with("the ")) reason[0] = 'T';
    s += prose(reason) + ".\n";
  }
  if (result.contains("second_opinion"))
    s += "A second opinion: " + prose(result.at("second_opinion").at("text").get<std::string>()) +
         ".\n";
  return s + polynomial_of_y_tex(result);
}

} // namespace kov::cli
