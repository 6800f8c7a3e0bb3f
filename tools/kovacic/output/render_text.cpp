#include "exact/joined.hpp"
#include "exact/letters.hpp"
#include "exact/lists.hpp"
#include "output/render.hpp"

#include "equations/present_strata.hpp"
#include "equations/recognized.hpp"
#include "equations/whole.hpp"
#include "output/page_width.hpp"

#include <algorithm>
#include <optional>
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

bool something_decided(const Json& result) {
  const Json& strata = result.at("strata");
  return std::ranges::any_of(strata, [](const Json& s) { return s.at("abelian") != "undecided"; });
}

// Unset: a group of the stratum with a solution that is Liouvillian, or SL(2, C).
std::optional<bool> is_liouvillian(const Json& stratum) {
  if (stratum.at("abelian") == "yes") return true;
  if (!stratum.at("group").is_string()) return std::nullopt;
  return stratum.at("group") != "SL2";
}

std::string for_all_parameters(const Json& result) {
  constexpr std::size_t longest = 150;
  const Json& strata = result.at("strata");
  long some = 0, unknown = 0;
  for (const Json& s : strata) {
    const std::optional<bool> known = is_liouvillian(s);
    some += known == true ? 1 : 0;
    unknown += known ? 0 : 1;
  }
  if (unknown > 0 || some == 0)
    return "DECIDED FOR ALL PARAMETERS whether the identity component is abelian";
  if (some == static_cast<long>(strata.size())) return "LIOUVILLIAN SOLUTIONS for all parameters";
  if (some + 1 == static_cast<long>(strata.size()))
    for (const Json& s : strata)
      if (is_liouvillian(s) == false && s.contains("elsewhere"))
        return "LIOUVILLIAN SOLUTIONS exactly when " + s.at("elsewhere").get<std::string>();
  if (const std::string where = result.value("liouvillian_where", "");
      !where.empty() && where.size() <= longest)
    return "LIOUVILLIAN SOLUTIONS exactly when " + where;
  return "LIOUVILLIAN SOLUTIONS for some parameters";
}

} // namespace

std::string headline(const Json& result) {
  if (result.contains("strata") && result.at("case").is_null())
    return result.contains("contradictory")   ? "THE ASSUMPTIONS CONTRADICT EACH OTHER"
           : result.at("undecided").is_null() ? for_all_parameters(result)
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

namespace {

std::string with_variable(std::string text, const std::string& variable) {
  if (const auto at = text.find("C(z)"); at != std::string::npos) text.replace(at + 2, 1, variable);
  return text;
}

// A thousand coefficients do not belong on a terminal.
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
  put(out, label, shortened(text));
}

std::string note(const Json& solution) {
  return solution.contains("note") ? "   [" + solution.at("note").get<std::string>() + "]" : "";
}

// Of the equation y'' = r y: u where another one was given.
std::string normal_unknown(const Json& result) {
  return is_transformed(result) ? letters_beside(result)("u") : unknown_of(result);
}

// A text of ours, in which y is the unknown of the question.
std::string in_letters(const Json& result, const std::string& text) {
  const FreshLetters letter = letters_beside(result);
  return renamed(letter.in(text), {{letter("y"), unknown_of(result)}});
}

Meaning meaning_of_result(const Json& result) {
  if (result.at("case").is_null()) return Meaning::open;
  return result.at("case").get<int>() == 4 ? Meaning::negative : Meaning::positive;
}

// Polynomials for w = y'/y; u is the unknown of the normal form.
std::vector<std::string> polynomial_lines(const Json& result) {
  std::vector<std::string> lines;
  if (!result.at("liouvillian").is_array()) return lines;
  const FreshLetters letter = letters_beside(result);
  const std::string u = normal_unknown(result), w = letter("w");
  for (const Json& s : result.at("liouvillian"))
    if (s.contains("minimal_polynomial"))
      lines.push_back(w + " = " + u + "'/" + u + " satisfies " +
                      minimal_polynomial(s.at("minimal_polynomial"), w) + note(s));
  return lines;
}

// With a + or - outside of parentheses.
bool is_sum(const std::string& formula) {
  long depth = 0;
  for (std::size_t i = 0; i < formula.size(); ++i) {
    depth += (formula[i] == '(') - (formula[i] == ')');
    if (depth == 0 && i > 0 && (formula[i] == '+' || formula[i] == '-') && formula[i - 1] == ' ')
      return true;
  }
  return false;
}

// y = c1*A + c2*B, or each on its line; then what is to be known about them.
std::vector<std::string> answer_lines(const Json& result) {
  std::vector<std::string> lines;
  if (!result.contains("answer")) return lines;
  const Json& answer = result.at("answer");
  const std::string y = unknown_of(result);
  const FreshLetters letter = letters_beside(result);
  const auto all = answer.at("y").get<std::vector<std::string>>();
  std::string where;
  if (answer.contains("where")) where = "   where " + listed(answer.at("where"));
  const Json given = result.value("given", Json::object());
  std::string rest; // of an equation with a right side
  if (given.contains("right_side")) {
    const std::string particular =
        result.value("whole", Json::object()).value("particular", letter("y_p"));
    rest = particular.starts_with("-") ? " - " + particular.substr(1) : " + " + particular;
  }
  constexpr std::size_t one_line = 88;
  const auto times = [&](const char* c, const std::string& f) {
    if (f == "1") return letter(c);
    return f.starts_with("1/") ? letter(c) + f.substr(1)
                               : letter(c) + "*" + (is_sum(f) ? "(" + f + ")" : f);
  };
  if (all.size() == 2 && (!rest.empty() || all[0].size() + all[1].size() + y.size() < one_line)) {
    lines.push_back(y + " = " + times("c1", all[0]) + " + " + times("c2", all[1]) + rest + where);
  } else {
    for (std::size_t i = 0; i < all.size(); ++i)
      lines.push_back(y + (all.size() > 1 ? std::to_string(i + 1) : "") + " = " + all[i] +
                      (i == 0 ? where : ""));
  }
  if (!rest.empty() && !result.value("whole", Json::object()).contains("particular"))
    lines.push_back(letter("y_p") + " is one solution of the given equation: none was found");
  if (given.contains("substitution") && !answers_whole(result)) // y = -u'/u, u = ...
    lines.front() = given.at("substitution").get<std::string>() + ", " + lines.front();
  if (answer.contains("unless"))
    lines.push_back("a basis unless " +
                    joined(answer.at("unless").get<std::vector<std::string>>(), " or "));
  if (answer.contains("functions")) lines.push_back(answer.at("functions").get<std::string>());
  return lines;
}

void put_polynomial_of_y(std::ostringstream& out, const Json& result) {
  if (!result.contains("polynomial_of_y")) return;
  const Json& y = result.at("polynomial_of_y");
  const FreshLetters letter = letters_beside(result);
  const std::string u = y.contains("given_factor") ? unknown_of(result) : normal_unknown(result),
                    x = letter("X");
  if (y.contains("missing"))
    return put_short(out, u, "no polynomial: " + y.at("missing").get<std::string>());
  const std::string factor =
      y.at(y.contains("given_factor") ? "given_factor" : "factor").get<std::string>();
  put_short(out, u,
            u + "^" + y.at("power").dump() + " = " + (factor == "1" ? "" : "(" + factor + ")*") +
                x + " with " + minimal_polynomial(y.at("polynomial"), x));
}

void put_solutions(std::ostringstream& out, const Json& result, bool whole) {
  std::vector<std::string> lines = answer_lines(result);
  if (lines.empty() || (result.at("case").is_number() && result.at("case").get<int>() == 3)) {
    const auto more = polynomial_lines(result);
    lines.insert(lines.begin(), more.begin(), more.end());
  }
  for (std::size_t i = 0; i < lines.size(); ++i)
    put_short(out, i > 0 ? "" : lines.size() > 1 ? "solutions" : "solution", lines[i]);
  if (whole && result.contains("answer") && result.at("answer").contains("not_read_back"))
    put_short(out, "", "not read back: too long, or without a value at the points that were tried");
}

// " + (1/x) y'", " - y", "" for 0
std::string term_text(const std::string& c, const std::string& y) {
  if (c == "0") return "";
  const bool simple = c.find_first_of(" /") == std::string::npos,
             minus = simple && c.front() == '-';
  const std::string size = minus ? c.substr(1) : c;
  return (minus ? " - " : " + ") + (size == "1" ? "" : (simple ? size : "(" + size + ")") + " ") +
         y;
}

} // namespace

std::string question_text(const Json& result, const std::string& y) {
  if (!is_transformed(result))
    return equation_text(shortened(result.at("r").get<std::string>()), y);
  const Json& original = result.at("original");
  const auto coefficient = [&](const char* key) {
    return shortened(original.at(key).get<std::string>());
  };
  return y + "''" + term_text(coefficient("p"), y + "'") + term_text(coefficient("q"), y) + " = 0";
}

namespace {

// a/16/b
bool divides_twice(const std::string& formula) {
  for (std::size_t i = formula.find('/'); i != std::string::npos; i = formula.find('/', i + 1)) {
    const std::size_t next = formula.find_first_not_of("0123456789", i + 1);
    if (next != std::string::npos && next > i + 1 && formula[next] == '/') return true;
  }
  return false;
}

// The same in fewer words; values that were put in are not lost.
bool is_much_shorter(const std::string& given, const std::string& text) {
  return given.size() + 6 < text.size() && !divides_twice(given) &&
         std::ranges::includes(names_in_text(text), names_in_text(given));
}

// The equation that was given.
void put_question(std::ostringstream& out, const Json& result) {
  std::string text = question_text(result, unknown_of(result));
  if (result.contains("equation") && result.at("equation").is_string()) {
    const std::string given = result.at("equation").get<std::string>();
    const bool as_r =
        !result.contains("original") && !result.contains("given") && !result.contains("strata");
    if (!as_r || is_much_shorter(given, text)) { // (2*x + 1)^3 as it is
      text = shortened(given);
      const Json set = result.value("set", Json::object());
      for (const auto& [name, value] : set.items())
        text += ", " + name + " = " + value.get<std::string>();
    }
  }
  if (result.contains("whole"))
    for (const Json& value : result.at("whole").value("values", Json::array()))
      text += ", " + value.get<std::string>();
  out << wrapped(text, 0) << '\n';
}

// What is decided where that is another one.
void put_decided(std::ostringstream& out, const Json& result) {
  if (!result.contains("given") || result.at("given").size() == 1) return;
  const Json& given = result.at("given");
  std::string how;
  for (const char* key : {"change", "substitution"})
    if (given.contains(key)) how += ", " + given.at(key).get<std::string>();
  if (given.contains("right_side")) how += ", without the right side";
  put_short(out, "decided", question_text(result, unknown_of(result)) + how);
}

// What the group and the reason are about, where another equation was given.
void put_normal_form(std::ostringstream& out, const Json& result) {
  if (!is_transformed(result)) return;
  const FreshLetters letter = letters_beside(result);
  const std::string u = letter("u");
  put_short(out, "in " + u,
            equation_text(result.at("r").get<std::string>(), u) + ", " + unknown_of(result) +
                " = " + u + " * " + result.at("original").at("factor").get<std::string>() +
                ": the group is that of this equation, and the identity component is abelian for "
                "both or for none");
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

std::string labelled(const std::string& label, const std::string& text, std::size_t indent) {
  return std::string(indent, ' ') + label +
         std::string(label.size() < 10 ? 10 - label.size() : 1, ' ') + wrapped(text, indent + 10) +
         "\n";
}

void put(std::ostream& out, const std::string& label, const std::string& text, std::size_t indent) {
  out << labelled(label, text, indent);
}

std::string listed(const Json& texts) {
  return joined(texts, [&](const Json& t) { return t.get<std::string>(); });
}

std::string wrapped(const std::string& text, std::size_t indent, std::size_t width) {
  if (width == 0) width = page_width();
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
  if (file.size() + 2 + title.size() <= page_width() + 2) return file + "  " + title;
  return file + "\n  " + wrapped(title, 2);
}

std::string component_text(const std::string& name) {
  if (name == "SL2") return "SL(2, C)";
  if (name == "Gm") return "Gm (a torus)";
  if (name == "Ga") return "Ga (additive)";
  if (name == "Borel") return "the Borel group";
  return name;
}

std::string group_text(const Json& group) {
  return group.is_null() ? std::string() : describe(read_group(group));
}

std::string whether_abelian(const Json& word) {
  return word == "yes" ? "abelian" : word == "no" ? "not abelian" : "abelian or not: undecided";
}

std::string text_of_result(const Json& result, const std::string& title, const Style& style) {
  const Paint paint{style.color};
  std::ostringstream out;
  if (!title.empty()) out << paint("1", title) << '\n';
  const std::string variable =
      result.at("variable").is_null() ? "z" : result.at("variable").get<std::string>();
  if (!result.at("r").is_null()) put_question(out, result);
  if (result.contains("constants"))
    for (const auto& [name, meaning] : result.at("constants").items())
      if (name != "I" && name.find('(') == std::string::npos) // the others say it themselves
        put_short(out, "where", name + " = " + meaning.get<std::string>());
  std::string head = headline(result);
  if (!result.at("case").is_null()) // the conditions of strata are in the letters of the question
    head = with_variable(in_letters(result, head), variable);
  if (head.size() + 2 > page_width()) head = wrapped(head, 2);
  out << "  " << painted(head, meaning_of_result(result)) << '\n';
  for (const auto& [label, text] : whole_lines(result))
    put_short(out, label, text);
  if (!answers_whole(result)) {
    if (!result.contains("strata")) put_polynomial_of_y(out, result);
    put_solutions(out, result, style.whole);
  }
  if (const std::string line = group_line(result); !line.empty())
    out << "  " << wrapped(line, 2) << '\n';
  if (style.quiet && result.at("undecided").is_null()) {
    if (const Json given = result.value("assumed", Json::array()); !given.empty())
      put_short(out, "assumed", listed(given));
    return out.str() + reading_text(result);
  }
  for (const Json& what : result.value("failed", Json::array()))
    put_short(out, "failed", what.get<std::string>());
  const auto below = [&] {
    put_decided(out, result);
    put_normal_form(out, result);
  };
  if (result.contains("strata")) {
    print_strata(out, result, style.whole || style.trace);
    put_polynomial_of_y(out, result);
    if (result.contains("second_opinion"))
      put_short(out, "monodromy", result.at("second_opinion").at("text").get<std::string>());
    below();
    if (Json known = result.at("recognized"); !known.is_null()) {
      known.erase("summary"); // the strata say it
      if (const std::string text = recognized_text(known); !text.empty())
        put_short(out, "this is", text);
    }
    return out.str() + reading_text(result);
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
  below();
  if (result.contains("recognized") && !result.at("recognized").is_null() &&
      !result.at("recognized").contains("summary")) // that one is in the reason
    if (const std::string known = recognized_text(result.at("recognized")); !known.empty())
      put_short(out, "this is", known);
  if (result.contains("second_opinion")) {
    const Json& o = result.at("second_opinion");
    put_short(out, "monodromy", o.at("text").get<std::string>());
    if (o.contains("no_certificate"))
      put_short(out, "no proof", "of that: " + o.at("no_certificate").get<std::string>());
  }
  const Json failed = result.value("failed", Json::array());
  if (style.solutions && result.contains("no_solutions") &&
      !is_among(result.at("no_solutions"), failed))
    put_short(out, "solutions", "not printed: " + result.at("no_solutions").get<std::string>());
  out << reading_text(result);
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
      put_short(out, "proof", "written to " + path + "; check it with: kovacic verify " + path);
    }
  return out.str();
}

Json reading_json(const AskedEquation& question) {
  Json reading = Json::object();
  if (!question.read_as.empty()) reading["read_as"] = question.read_as;
  if (!question.notes.empty()) reading["notes"] = sentences(question.notes);
  return reading;
}

std::string reading_text(const Json& reading) {
  std::ostringstream out;
  for (const auto& [key, label] : {std::pair{"read_as", "read as"}, std::pair{"notes", "note"}})
    for (const Json& words : reading.value(key, Json::array()))
      if (words != reading.value("equation", Json())) // which is printed above
        put(out, label, words.get<std::string>());
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
