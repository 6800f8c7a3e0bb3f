#include "answer/notation.hpp"
#include "exact/joined.hpp"
#include "output/render.hpp"
#include "report/formula.hpp"

#include "symbol/expression.hpp"

#include <set>

namespace kov::cli {
namespace {

using Kind = Expression::Kind;

enum Level { of_sum, of_product, of_power, of_atom, of_nothing };

Level level(const Expression& e) {
  switch (e.kind()) {
  case Kind::equation:
  case Kind::sum:
  case Kind::negate:
    return of_sum;
  case Kind::product:
    return of_product;
  case Kind::power:
    return of_power;
  default:
    return of_atom;
  }
}

std::string tex(const Expression& e);

std::string tex(const Expression& e, Level least) {
  return level(e) < least ? "\\left(" + tex(e) + "\\right)" : tex(e);
}

std::string tex_name(const std::string& name) {
  return name == "I" ? "\\mathrm{i}" : report::tex_name(name);
}

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

std::string tex_call(const Expression& e) {
  if (const auto special = answer::in_books(e)) return tex_special(*special);
  const std::string inside = tex(e.operand(0));
  if (e.name() == "sqrt") return "\\sqrt{" + inside + "}";
  static const std::set<std::string> named{"exp", "log",  "sin",  "cos",
                                           "tan", "sinh", "cosh", "tanh"};
  if (named.contains(e.name())) return "\\" + e.name() + "\\left(" + inside + "\\right)";
  if (e.name() == "int")
    return "\\int " + tex(e.operand(0), of_product) + "\\,d" +
           (e.operands().size() > 1 ? tex(e.operand(1), of_product) : "z");
  if (e.name() == "root")
    return "\\operatorname{root}\\left(" + inside + "\\right)"; // the approximation is left out
  std::string list = joined(e.operands(), [&](const Expression& x) { return tex(x); });
  return tex_name(e.name()) + "\\left(" + list + "\\right)";
}

std::string tex(const Expression& e) {
  switch (e.kind()) {
  case Kind::number:
    return to_string(e.number());
  case Kind::decimal:
    return e.name();
  case Kind::name:
    return tex_name(e.name());
  case Kind::negate:
    return "-" + tex(e.operand(0), of_product);
  case Kind::sum: {
    std::string s;
    for (const Expression& term : e.operands()) {
      const std::string t = tex(term);
      s += s.empty() || t.front() == '-' ? t : "+" + t;
    }
    return s;
  }
  case Kind::product: {
    std::string s;
    for (const Expression& factor : e.operands()) {
      const std::string t = tex(factor, of_product);
      const bool digits = !t.empty() && t.front() >= '0' && t.front() <= '9';
      s += s.empty() ? t : (digits ? "\\cdot " : "\\,") + t;
    }
    return s;
  }
  case Kind::quotient:
    return "\\frac{" + tex(e.operand(0)) + "}{" + tex(e.operand(1)) + "}";
  case Kind::power:
    return tex(e.operand(0), e.operand(0).kind() == Kind::quotient ? of_nothing : of_atom) + "^{" +
           tex(e.operand(1)) + "}";
  case Kind::call:
    return tex_call(e);
  case Kind::derivative:
    return tex(e.operand(0), of_atom) + std::string(static_cast<std::size_t>(e.order()), '\'');
  case Kind::equation:
    return tex(e.operand(0)) + " = " + tex(e.operand(1));
  }
  return {};
}

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
    const std::string group = x.at("group_text"), abelian = x.at("abelian");
    s += "\\item[" + joined_texts(x.at("conditions"), "for all parameters") + "] ";
    if (x.contains("equation"))
      s += "Here the equation is " + prose(x.at("equation").get<std::string>()) + ". ";
    s += (group.empty() ? "" : "The group is " + prose(group) + ". ") +
         std::string("Its identity component is ") +
         (abelian == "yes"  ? "abelian"
          : abelian == "no" ? "not abelian"
                            : "abelian or not: undecided") +
         ": ";
    s += prose(x.at("reason").get<std::string>()) + ".\n";
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
  std::string polynomial;
  for (std::size_t i = c.size(); i-- > 0;) {
    const std::string text = c[i].get<std::string>();
    if (text == "0") continue;
    const std::string power = i == 0   ? ""
                              : i == 1 ? unknown
                                       : unknown + "^{" + std::to_string(i) + "}";
    if (!polynomial.empty()) polynomial += " + ";
    polynomial +=
        text == "1" && i > 0 ? power : "\\left(" + tex_of_formula(text) + "\\right)" + power;
  }
  return polynomial;
}

std::string polynomial_of_y_tex(const Json& result) {
  if (!result.contains("polynomial_of_y")) return {};
  const Json& y = result.at("polynomial_of_y");
  const FreshLetters letter = letters_beside(result);
  const std::string x = tex_name(letter("X"));
  if (y.contains("missing"))
    return "No polynomial of $" + tex_name(unknown_of(result)) +
           "$: " + prose(y.at("missing").get<std::string>()) + ".\n";
  const bool given = y.contains("given_factor");
  const std::string factor = y.at(given ? "given_factor" : "factor").get<std::string>();
  return "\\[ " + tex_name(is_transformed(result) && !given ? letter("u") : unknown_of(result)) +
         "^{" + y.at("power").dump() +
         "} = " + (factor == "1" ? "" : "\\left(" + tex_of_formula(factor) + "\\right)") + x +
         ",\\quad " + polynomial_tex(y.at("polynomial"), x) + " = 0 \\]\n";
}

std::string solutions_tex(const Json& result) {
  std::string s;
  const FreshLetters letter = letters_beside(result);
  const std::string u = tex_name(is_transformed(result) ? letter("u") : unknown_of(result)),
                    y = tex_name(result.contains("whole")
                                     ? result.at("whole").at("unknown").get<std::string>()
                                     : unknown_of(result)),
                    w = tex_name(letter("w"));
  if (result.at("liouvillian").is_array())
    for (const Json& x : result.at("liouvillian"))
      if (x.contains("minimal_polynomial"))
        s += "\\[ " + w + " = " + u + "'/" + u + ":\\quad " +
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
  const std::string unknown = tex_name(unknown_of(result));
  const bool given = result.value("equation", Json()).is_string();
  if (given) s += "\\[ " + tex_of_formula(result.at("equation").get<std::string>()) + " \\]\n";
  s += solutions_tex(result);
  if (std::string here = about_given(result);
      !here.empty() && (!given || result.at("given").size() > 1)) {
    here[0] = 'T';
    s += prose(here) + ".\n";
  }
  if (!result.at("r").is_null() && (!given || is_transformed(result))) {
    const std::string r = result.at("r").get<std::string>();
    const std::string body = tex_of_formula(r);
    const bool sum = r.find(' ') != std::string::npos && body.find("\\frac") != 0;
    const std::string y = is_transformed(result) ? tex_name(letters_beside(result)("u")) : unknown;
    if (given) s += "What follows is about its normal form:\n";
    s += "\\[ " + y + "'' = " + (sum ? "\\left(" + body + "\\right)" : body) + "\\," + y + " \\]\n";
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
  s += prose(result.at("reason").get<std::string>()) + "\n";
  if (result.contains("second_opinion"))
    s += "A second opinion: " + prose(result.at("second_opinion").at("text").get<std::string>()) +
         ".\n";
  return s + polynomial_of_y_tex(result);
}

} // namespace kov::cli
