#include "render.hpp"

#include "present_strata.hpp"
#include "recognized.hpp"

#include <algorithm>
#include <sstream>

namespace kov::cli {
namespace {

struct Paint {
  bool on;
  [[nodiscard]] std::string operator()(const char* code, const std::string& s) const {
    return on ? "\033[" + std::string(code) + "m" + s + "\033[0m" : s;
  }
};

GaloisGroup read_group(const Json& group) {
  GaloisGroup g;
  for (const GroupType t :
       {GroupType::SL2, GroupType::Borel, GroupType::T, GroupType::Gm, GroupType::cyclic,
        GroupType::Dinf, GroupType::D, GroupType::A4, GroupType::S4, GroupType::A5})
    if (to_string(t) == group.at("type").get<std::string>()) g.type = t;
  const Json& n = group.at("n");
  if (n.is_number()) g.n = Integer(n.get<long>());
  if (n.is_string()) g.n = Integer::parse(n.get<std::string>());
  return g;
}

std::string component_text(const std::string& name) {
  if (name == "SL2") return "SL(2, C)";
  if (name == "Gm") return "Gm (a torus)";
  if (name == "Ga") return "Ga (additive)";
  if (name == "Borel") return "the Borel group";
  return name;
}

bool something_decided(const Json& result) {
  const Json& strata = result.at("strata");
  return std::any_of(strata.begin(), strata.end(),
                     [](const Json& s) { return s.at("abelian") != "undecided"; });
}

std::string headline(const Json& result) {
  if (result.contains("strata") && result.at("case").is_null())
    return result.contains("contradictory")   ? "THE ASSUMPTIONS CONTRADICT EACH OTHER"
           : result.at("undecided").is_null() ? "DECIDED FOR ALL PARAMETERS"
           : something_decided(result)        ? "UNDECIDED IN PART"
                                              : "UNDECIDED";
  if (result.at("case").is_null())
    return result.at("undecided").is_null() ? "ANSWERED IN PART" : "UNDECIDED";
  switch (result.at("case").get<int>()) {
  case 1:
    return "REDUCIBLE: an exponential solution exists  (Kovacic's case 1)";
  case 2:
    return "IMPRIMITIVE: y'/y is quadratic over C(z)  (Kovacic's case 2)";
  case 3:
    return "FINITE PRIMITIVE: all solutions are algebraic  (Kovacic's case 3)";
  default:
    return "NO LIOUVILLIAN SOLUTION  (Kovacic's case 4)";
  }
}

std::string with_variable(std::string text, const std::string& variable) {
  if (const auto at = text.find("C(z)"); at != std::string::npos) text.replace(at + 2, 1, variable);
  return text;
}

// A terminal is no place for a thousand coefficients.
std::string shortened(const std::string& formula) {
  constexpr std::size_t longest = 1500;
  if (formula.size() <= longest) return formula;
  return formula.substr(0, longest / 2) + " ... [" + std::to_string(formula.size()) +
         " characters, whole with --format json] ... " +
         formula.substr(formula.size() - longest / 4);
}

// y'' = r y, with parentheses where r is more than a power.
std::string equation_text(const std::string& r, const std::string& y) {
  const std::string left = y + "'' = ";
  if (r == "0") return left + "0";
  if (r == "1" || r == "-1") return left + r.substr(0, r.size() - 1) + y;
  const bool simple = r.find_first_of(" /") == std::string::npos;
  return left + (simple ? r : "(" + r + ")") + " " + y;
}

std::string minimal_polynomial(const Json& coefficients, const std::string& unknown) {
  std::string s;
  for (std::size_t i = coefficients.size(); i-- > 0;) {
    const std::string c = coefficients[i].get<std::string>();
    if (c == "0") continue;
    const std::string power = i == 0 ? "" : i == 1 ? unknown : unknown + "^" + std::to_string(i);
    if (!s.empty()) s += " + ";
    s += c == "1" && i > 0 ? power : "(" + c + ")" + (power.empty() ? "" : "*" + power);
  }
  return s + " = 0";
}

void put_short(std::ostringstream& out, const std::string& label, const std::string& text) {
  out << "  " << label << std::string(label.size() < 10 ? 10 - label.size() : 1, ' ')
      << wrapped(shortened(text), 12) << '\n';
}

std::string note(const Json& solution) {
  return solution.contains("note") ? "   [" + solution.at("note").get<std::string>() + "]" : "";
}

// Of the equation y'' = r y: u where another one was given.
std::string unknown_of(const Json& result) {
  return letters_beside(result)(is_transformed(result) ? "u" : "y");
}

// A polynomial for w = y'/y, and formulas.  What belongs to u'' = r u of a given equation is called
// u.
std::vector<std::string> solution_lines(const Json& result) {
  const Json& known = result.at("solutions");
  std::vector<std::string> lines;
  const FreshLetters letter = letters_beside(result);
  const std::string u = unknown_of(result), w = letter("w");
  for (const Json& s : known)
    if (s.contains("minimal_polynomial"))
      lines.push_back(w + " = " + u + "'/" + u + " satisfies " +
                      minimal_polynomial(s.at("minimal_polynomial"), w) + note(s));
  const bool given = is_transformed(result) && result.at("original").contains("solutions");
  const std::vector<std::string> formulas = solutions_of(result);
  for (std::size_t i = 0; i < formulas.size(); ++i)
    lines.push_back((given ? letter("y") : u) + (formulas.size() > 1 ? std::to_string(i + 1) : "") +
                    " = " + formulas[i] + (formulas.size() == known.size() ? note(known[i]) : ""));
  return lines;
}

void put_polynomial_of_y(std::ostringstream& out, const Json& result) {
  if (!result.contains("polynomial_of_y")) return;
  const Json& y = result.at("polynomial_of_y");
  const FreshLetters letter = letters_beside(result);
  const std::string u = y.contains("given_factor") ? letter("y") : unknown_of(result),
                    x = letter("X");
  if (y.contains("missing"))
    return put_short(out, u, "no polynomial: " + y.at("missing").get<std::string>());
  const std::string factor =
      y.at(y.contains("given_factor") ? "given_factor" : "factor").get<std::string>();
  put_short(out, u,
            u + "^" + y.at("power").dump() + " = " + (factor == "1" ? "" : "(" + factor + ")*") +
                x + " with " + minimal_polynomial(y.at("polynomial"), x));
}

void put_solutions(std::ostringstream& out, const Json& result) {
  if (!result.at("solutions").is_array()) return;
  const std::vector<std::string> lines = solution_lines(result);
  for (std::size_t i = 0; i < lines.size(); ++i)
    put_short(out, i > 0 ? "" : lines.size() > 1 ? "solutions" : "solution", lines[i]);
}

void put_original(std::ostringstream& out, const Json& result) {
  const Json& original = result.at("original");
  const FreshLetters letter = letters_beside(result);
  const std::string factor = original.at("factor").get<std::string>();
  if (factor == "1") return;
  put_short(out, "given",
            letter.in("y'' + p y' + q y = 0 with p = ") + original.at("p").get<std::string>() +
                ", " + letter("q") + " = " + original.at("q").get<std::string>());
  put_short(out, "",
            letter.in("y = u * ") + factor + letter.in(" with u'' = r u; the factor is ") +
                original.at("factor_kind").get<std::string>() +
                "; the identity component is abelian for both equations or for none");
}

// "G = SL(2, C), identity component SL(2, C), not abelian", as much of it as is known.
std::string group_line(const Json& result) {
  std::string line = result.at("group").is_null()
                         ? std::string()
                         : "G = " + letters_beside(result).in(group_text(result.at("group")));
  const auto add = [&](const std::string& text) { line += (line.empty() ? "" : ", ") + text; };
  const Json& component = result.at("identity_component");
  if (!component.is_null())
    add("identity component " + component_text(component.get<std::string>()));
  const std::string abelian = result.at("abelian"),
                    noun = component.is_null() ? "identity component " : "";
  if (abelian == "yes") add(noun + "abelian");
  if (abelian == "no") add(noun + "not abelian"); // "depends": the strata say it
  return line;
}

} // namespace

void put(std::ostream& out, const std::string& label, const std::string& text, std::size_t indent) {
  const std::size_t column = indent + 10;
  out << std::string(indent, ' ') << label
      << std::string(label.size() < 10 ? 10 - label.size() : 1, ' ') << wrapped(text, column)
      << "\n";
}

std::string listed(const Json& texts) {
  std::string all;
  for (const Json& t : texts)
    all += (all.empty() ? "" : ", ") + t.get<std::string>();
  return all;
}

std::string wrapped(const std::string& text, std::size_t indent, std::size_t width) {
  std::string out;
  std::size_t column = indent;
  std::istringstream words(text);
  std::string word;
  bool first = true;
  while (words >> word) {
    if (!first && column + 1 + word.size() > width) {
      out += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (!first) {
      out += ' ';
      ++column;
    }
    out += word;
    column += word.size();
    first = false;
  }
  return out;
}

std::string heading(const std::string& file, const std::string& title) {
  if (title.empty()) return file;
  if (file.size() + 2 + title.size() <= 100) return file + "  " + title;
  return file + "\n  " + wrapped(title, 2);
}

std::string group_text(const Json& group) {
  return group.is_null() ? std::string() : describe(read_group(group));
}

std::string text_of_result(const Json& result, const std::string& title, const Style& style) {
  const Paint paint{style.color};
  std::ostringstream out;
  if (!title.empty()) out << paint("1", title) << '\n';
  for (const auto& [key, label] : {std::pair{"read_as", "read as"}, std::pair{"notes", "note"}})
    for (const Json& words : result.value(key, Json::array()))
      put(out, label, words.get<std::string>());
  const std::string variable =
      result.at("variable").is_null() ? "z" : result.at("variable").get<std::string>();
  if (!result.at("r").is_null())
    out << wrapped(equation_text(shortened(result.at("r").get<std::string>()),
                                 letters_beside(result)("y")),
                   0)
        << '\n';
  if (result.contains("constants"))
    for (const auto& [name, meaning] : result.at("constants").items())
      if (name != "I" && name.find('(') == std::string::npos) // the others say it themselves
        put_short(out, "where", name + " = " + meaning.get<std::string>());
  const bool open = result.at("case").is_null();
  out << "  "
      << paint(open ? "1;33" : "1;32",
               with_variable(letters_beside(result).in(headline(result)), variable))
      << '\n';
  if (const std::string line = group_line(result); !line.empty())
    out << "  " << wrapped(line, 2) << '\n';
  if (style.quiet && result.at("undecided").is_null()) {
    if (const Json given = result.value("assumed", Json::array()); !given.empty())
      put_short(out, "assumed", listed(given));
    return out.str();
  }
  for (const Json& what : result.value("failed", Json::array()))
    put_short(out, "failed", what.get<std::string>());
  if (result.contains("strata")) {
    print_strata(out, result, style.whole || style.trace);
    put_polynomial_of_y(out, result);
    if (result.contains("second_opinion"))
      put_short(out, "monodromy", result.at("second_opinion").at("text").get<std::string>());
    if (const Json& known = result.at("recognized"); !known.is_null())
      if (const std::string text = recognized_text(known); !text.empty())
        put_short(out, "this is", text);
    return out.str();
  }
  if (!result.at("undecided").is_null()) {
    const Json& u = result.at("undecided");
    put_short(out, "open", u.at("detail").get<std::string>());
    if (result.at("reason") != u.at("detail"))
      put_short(out, "because", result.at("reason").get<std::string>());
    put_short(out, "more", way_out(u.at("why"), u.at("detail")));
  } else {
    put_short(out, "because", result.at("reason").get<std::string>());
  }
  if (result.contains("recognized") && !result.at("recognized").is_null() &&
      !result.at("recognized").contains("summary")) // that one is in the reason
    if (const std::string known = recognized_text(result.at("recognized")); !known.empty())
      put_short(out, "this is", known);
  if (result.contains("special_solution"))
    put_short(out, "but", special_text(result.at("special_solution"), unknown_of(result)));
  if (result.contains("second_opinion")) {
    const Json& o = result.at("second_opinion");
    put_short(out, "monodromy", o.at("text").get<std::string>());
    if (o.contains("no_certificate"))
      put_short(out, "no proof", "of that: " + o.at("no_certificate").get<std::string>());
  }
  if (result.contains("original")) put_original(out, result);
  put_solutions(out, result);
  put_polynomial_of_y(out, result);
  const Json failed = result.value("failed", Json::array());
  if (style.solutions && result.contains("no_solutions") &&
      std::find(failed.begin(), failed.end(), result.at("no_solutions")) == failed.end())
    put_short(out, "solutions", "not printed: " + result.at("no_solutions").get<std::string>());
  if (style.trace && result.contains("trace")) {
    out << "  steps\n";
    for (const Json& step : result.at("trace"))
      out << "    " << paint("1", step.at("step").get<std::string>()) << "  "
          << wrapped(step.at("text").get<std::string>(),
                     6 + step.at("step").get<std::string>().size())
          << '\n';
  }
  for (const char* key : {"certificate_file", "loops_certificate_file"})
    if (result.contains(key)) {
      const std::string path = result.at(key).get<std::string>();
      put_short(out, "proof", path + "   verify: kovacic verify " + path);
    }
  return out.str();
}

std::string way_out(const std::string& why, const std::string& detail) {
  static const std::pair<const char*, const char*> flags[] = {{"time limit", "--timeout S"},
                                                              {"memory limit", "--memory MIB"},
                                                              {"work limit", "--max-work N"},
                                                              {"degree limit", "--max-degree N"}};
  const std::string page = "kovacic explain " + why;
  for (const auto& [limit, flag] : flags)
    if (detail.find(limit) != std::string::npos)
      return std::string(flag) + " sets another limit; " + page;
  return page;
}

std::string limit_lines(const std::string& limit) {
  return "  open      " + wrapped(limit, 12) + "\n  more      " + way_out("budget", limit) + "\n";
}

} // namespace kov::cli
