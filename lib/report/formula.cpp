#include "report/formula.hpp"

#include "exact/joined.hpp"
#include "symbol/expression.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <regex>
#include <sstream>
#include <string_view>
#include <vector>

namespace kov::report {
namespace {

using Kind = Expression::Kind;

// How tightly the outermost operation binds: sums 1, products 2, powers 3, atoms 4.
int binding(const Expression& e) {
  switch (e.kind()) {
  case Kind::equation:
    return 0;
  case Kind::sum:
  case Kind::negate:
    return 1;
  case Kind::product:
  case Kind::quotient:
    return 2;
  case Kind::power:
    return 3;
  default:
    return 4;
  }
}

const std::map<std::string, std::pair<std::string, std::string>>& greek() {
  static const std::map<std::string, std::pair<std::string, std::string>> letters{
      {"alpha", {"\\alpha", "&alpha;"}},
      {"beta", {"\\beta", "&beta;"}},
      {"gamma", {"\\gamma", "&gamma;"}},
      {"delta", {"\\delta", "&delta;"}},
      {"epsilon", {"\\varepsilon", "&epsilon;"}},
      {"zeta", {"\\zeta", "&zeta;"}},
      {"eta", {"\\eta", "&eta;"}},
      {"theta", {"\\theta", "&theta;"}},
      {"kappa", {"\\kappa", "&kappa;"}},
      {"lambda", {"\\lambda", "&lambda;"}},
      {"mu", {"\\mu", "&mu;"}},
      {"nu", {"\\nu", "&nu;"}},
      {"xi", {"\\xi", "&xi;"}},
      {"pi", {"\\pi", "&pi;"}},
      {"rho", {"\\rho", "&rho;"}},
      {"sigma", {"\\sigma", "&sigma;"}},
      {"tau", {"\\tau", "&tau;"}},
      {"phi", {"\\varphi", "&phi;"}},
      {"chi", {"\\chi", "&chi;"}},
      {"psi", {"\\psi", "&psi;"}},
      {"omega", {"\\omega", "&omega;"}},
      {"Gamma", {"\\Gamma", "&Gamma;"}},
      {"Delta", {"\\Delta", "&Delta;"}},
      {"Theta", {"\\Theta", "&Theta;"}},
      {"Lambda", {"\\Lambda", "&Lambda;"}},
      {"Sigma", {"\\Sigma", "&Sigma;"}},
      {"Phi", {"\\Phi", "&Phi;"}},
      {"Psi", {"\\Psi", "&Psi;"}},
      {"Omega", {"\\Omega", "&Omega;"}}};
  return letters;
}

// The sign in front, and what it stands before: that of (-r)*sqrt(n), -a/b, -(a*b).
SignedTerm with_its_sign(const Expression& e) {
  if (e.kind() == Kind::negate) {
    SignedTerm term = with_its_sign(e.operand(0));
    return {!term.minus, term.term};
  }
  if (e.kind() != Kind::product && e.kind() != Kind::quotient) return {false, e};
  SignedTerm whole{false, e};
  std::vector<Expression> factors;
  for (const Expression& x : e.operands()) {
    const SignedTerm factor = with_its_sign(x);
    whole.minus ^= factor.minus;
    factors.push_back(factor.term);
  }
  return {whole.minus, Expression::made(e.kind(), std::move(factors))};
}

// The terms of a sum, also of sums in it.
void add_terms(const Expression& sum, std::vector<SignedTerm>& all) {
  for (const Expression& x : sum.operands()) {
    const SignedTerm t = with_its_sign(x);
    if (!t.minus && t.term.kind() == Kind::sum)
      add_terms(t.term, all);
    else
      all.push_back(t);
  }
}

class Writer {
public:
  /// flat: LaTeX that may break between lines, without fractions and growing parentheses.
  Writer(Markup m, bool flat, Instead instead = {})
      : tex_(m == Markup::tex), flat_(tex_ && flat), instead_(std::move(instead)) {}
  [[nodiscard]] std::string write(const Expression& e) const;
  [[nodiscard]] std::string name(const std::string& n) const;

private:
  [[nodiscard]] std::string sign(const std::string& s, bool in_front = false) const {
    const std::string space = in_front ? "" : " ";
    return tex_ ? space + s + space : "<mo>" + (s == "-" ? "&minus;" : s) + "</mo>";
  }
  [[nodiscard]] std::string row(const std::string& s) const {
    return tex_ ? s : "<mrow>" + s + "</mrow>";
  }
  [[nodiscard]] std::string inside(const Expression& e, int least) const {
    const std::string s = write(e);
    return binding(e) >= least ? s : row(enclosed(s, !flat_));
  }
  [[nodiscard]] std::string enclosed(const std::string& s, bool grows) const {
    if (!tex_) return row("<mo>(</mo>" + s + "<mo>)</mo>");
    return grows ? "\\left(" + s + "\\right)" : "(" + s + ")";
  }
  [[nodiscard]] std::string sum(const Expression& e) const;
  [[nodiscard]] std::string product(const Expression& e) const;
  [[nodiscard]] std::string letter(const std::string& stem) const;
  [[nodiscard]] std::string below(const std::string& base, const std::string& index) const;
  [[nodiscard]] std::string call(const Expression& e, long primes = 0) const;
  [[nodiscard]] std::string primed(const std::string& s, long primes) const;
  [[nodiscard]] std::string power(const Expression& e) const;

  bool tex_, flat_;
  Instead instead_;
};

// theta, x, or the name in roman letters
std::string Writer::letter(const std::string& stem) const {
  if (const auto it = greek().find(stem); it != greek().end())
    return tex_ ? it->second.first + " " : "<mi>" + it->second.second + "</mi>";
  if (!tex_) return "<mi>" + stem + "</mi>";
  if (stem.size() == 1) return stem;
  std::string escaped;
  for (const char c : stem)
    escaped += c == '_' ? std::string("\\_") : std::string(1, c);
  return "\\mathrm{" + escaped + "}";
}

std::string Writer::below(const std::string& base, const std::string& index) const {
  return tex_ ? base + "_{" + index + "}" : "<msub>" + base + index + "</msub>";
}

// x_dot is x with a dot; px, p_theta and a_1 have an index, and so has q1.
std::string Writer::name(const std::string& n) const {
  const auto is_letter = [](const std::string& x) { return x.size() == 1 || greek().contains(x); };
  if (n.size() > 4 && n.ends_with("_dot")) {
    const std::string base = name(n.substr(0, n.size() - 4));
    return tex_ ? "\\dot{" + base + "}" : "<mover>" + base + "<mo>&#x2d9;</mo></mover>";
  }
  std::size_t end = n.size();
  while (end > 0 && std::isdigit(static_cast<unsigned char>(n[end - 1])) != 0)
    --end;
  std::string stem = n.substr(0, end);
  const std::string digits = n.substr(end);
  const std::string index = digits.empty() || tex_ ? digits : "<mn>" + digits + "</mn>";
  if (stem.size() > 1 && stem.back() == '_' && !index.empty()) stem.pop_back();
  const auto low = stem.find('_');
  const bool momentum = stem.size() > 1 && stem[0] == 'p' && !greek().contains(stem);
  const std::string head = low != std::string::npos ? stem.substr(0, low)
                           : momentum               ? "p"
                                                    : "",
                    tail =
                        low != std::string::npos ? stem.substr(low + 1) : stem.substr(head.size());
  if (!head.empty() && is_letter(head) && is_letter(tail))
    return below(letter(head), index.empty() ? letter(tail) : below(letter(tail), index));
  return index.empty() ? letter(stem) : below(letter(stem), index);
}

std::string Writer::sum(const Expression& e) const {
  std::string text;
  std::vector<SignedTerm> terms;
  add_terms(e, terms);
  for (const SignedTerm& t : terms) {
    if (!text.empty() || t.minus) text += sign(t.minus ? "-" : "+", text.empty());
    text += inside(t.term, t.minus ? 2 : 1);
  }
  return row(text);
}

std::string Writer::product(const Expression& e) const {
  std::string text;
  for (const Expression& x : e.operands()) {
    if (!text.empty())
      text += x.kind() == Kind::number ? (tex_ ? "\\cdot " : "<mo>&sdot;</mo>")
                                       : (tex_ ? "\\, " : "<mspace width=\"0.12em\"/>");
    text += inside(x, 2);
  }
  return row(text);
}

// The index of a name stands below its exponent.
std::string Writer::power(const Expression& e) const {
  const std::string base = inside(e.operand(0), 4), exponent = write(e.operand(1));
  constexpr std::string_view open = "<msub>", close = "</msub>";
  if (tex_) return base + "^{" + exponent + "}";
  if (e.operand(0).kind() == Kind::name && base.starts_with(open))
    return "<msubsup>" + base.substr(open.size(), base.size() - open.size() - close.size()) +
           row(exponent) + "</msubsup>";
  return "<msup>" + row(base) + row(exponent) + "</msup>";
}

std::string Writer::primed(const std::string& s, long primes) const {
  if (primes == 0) return s;
  if (tex_) return s + std::string(static_cast<std::size_t>(primes), '\'');
  std::string all;
  for (long i = 0; i < primes; ++i)
    all += "&prime;";
  return "<msup>" + row(s) + "<mo>" + all + "</mo></msup>";
}

std::string Writer::call(const Expression& e, long primes) const {
  static const std::regex known("exp|log|sin|cos|tan|sinh|cosh|tanh");
  if (e.name() == "sqrt" && e.operands().size() == 1)
    return tex_ ? "\\sqrt{" + write(e.operand(0)) + "}"
                : "<msqrt>" + write(e.operand(0)) + "</msqrt>";
  const bool grows = !flat_ && std::ranges::any_of(e.operands(), [](const Expression& x) {
    return binding(x) < 4;
  });
  const std::string arguments = joined(
      e.operands(), [&](const Expression& x) { return write(x); }, tex_ ? ", " : "<mo>,</mo>");
  const std::string f =
      tex_ && std::regex_match(e.name(), known) ? "\\" + e.name() : name(e.name());
  return row(primed(f, primes) + enclosed(arguments, grows));
}

std::string Writer::write(const Expression& given) const {
  if (instead_)
    if (auto text = instead_(given)) return *std::move(text);
  const SignedTerm whole = with_its_sign(given);
  const Expression& e = whole.term;
  if (whole.minus) return row(sign("-", true) + inside(e, 2));
  switch (e.kind()) {
  case Kind::number:
    return tex_ ? to_string(e.number()) : "<mn>" + to_string(e.number()) + "</mn>";
  case Kind::decimal:
    return tex_ ? e.name() : "<mn>" + e.name() + "</mn>";
  case Kind::name:
    return name(e.name());
  case Kind::sum:
    return sum(e);
  case Kind::negate: // it has no sign
    return "";
  case Kind::product:
    return product(e);
  case Kind::quotient:
    if (flat_) return inside(e.operand(0), 2) + "/" + inside(e.operand(1), 3);
    return tex_ ? "\\frac{" + write(e.operand(0)) + "}{" + write(e.operand(1)) + "}"
                : "<mfrac>" + row(write(e.operand(0))) + row(write(e.operand(1))) + "</mfrac>";
  case Kind::power:
    return power(e);
  case Kind::call:
    return call(e);
  case Kind::derivative: {
    const Expression& of = e.operand(0);
    return of.kind() == Kind::call ? call(of, e.order()) : primed(inside(of, 4), e.order());
  }
  case Kind::equation:
    return row(write(e.operand(0)) + sign("=") + write(e.operand(1)));
  }
  return "";
}

// "a = 0, {x, y} = 1" at ", " outside of brackets; empty pieces do not occur.
std::vector<std::string> pieces(const std::string& s) {
  std::vector<std::string> all(1);
  long open = 0;
  for (std::size_t i = 0; i < s.size(); ++i)
    if (open += s[i] == '{' ? 1 : s[i] == '}' ? -1 : 0; open == 0 && s.compare(i, 2, ", ") == 0) {
      all.emplace_back();
      ++i;
    } else {
      all.back() += s[i];
    }
  return all;
}

constexpr std::size_t fits_in_fractions = 70;

// Z as the integers, in a sentence only: elsewhere it is a letter of the reader.  C is that of SL(2, C).
Instead number_sets(Markup m) {
  return [m](const Expression& e) -> std::optional<std::string> {
    const auto is = [](const Expression& x, const char* name) {
      return x.kind() == Kind::name && x.name() == name;
    };
    if (is(e, "Z")) return m == Markup::tex ? "\\mathbb{Z}" : "<mi>&#8484;</mi>";
    if (e.kind() == Kind::call && e.name() == "SL" && is(e.operands().back(), "C"))
      return m == Markup::tex
                 ? "\\mathrm{SL}(2, \\mathbb{C})"
                 : "<mi>SL</mi><mo>(</mo><mn>2</mn><mo>,</mo><mi>&#8450;</mi><mo>)</mo>";
    return std::nullopt;
  };
}

std::string one_formula(const std::string& source, Markup m,
                        std::size_t longest = fits_in_fractions, bool has_sets = false) {
  static const std::vector<std::pair<std::string, std::pair<std::string, std::string>>> relations{
      {" != ", {" \\neq ", "<mo>&ne;</mo>"}}, {" <= ", {" \\leq ", "<mo>&le;</mo>"}},
      {" >= ", {" \\geq ", "<mo>&ge;</mo>"}}, {" < ", {" < ", "<mo>&lt;</mo>"}},
      {" > ", {" > ", "<mo>&gt;</mo>"}},      {" = ", {" = ", "<mo>=</mo>"}},
      {" -> ", {" \\to ", "<mo>&rarr;</mo>"}}};
  const Writer writer(m, source.size() > longest, has_sets ? number_sets(m) : Instead());
  const auto parsed = [&](const std::string& s) {
    return writer.write(parse_expression(s, "formula", true));
  };
  if (const auto [comma, close] = std::pair{source.find(", "), source.find("} = ")};
      source.starts_with('{') && comma < close && close != std::string::npos) {
    const std::string first = parsed(source.substr(1, comma - 1));
    const std::string second = parsed(source.substr(comma + 2, close - comma - 2));
    const std::string value = parsed(source.substr(close + 4));
    return m == Markup::tex ? "\\{" + first + ", " + second + "\\} = " + value
                            : "<mrow><mo>{</mo>" + first + "<mo>,</mo>" + second +
                                  "<mo>}</mo><mo>=</mo>" + value + "</mrow>";
  }
  const auto& first = std::ranges::min(
      relations, {}, [&](const auto& relation) { return source.find(relation.first); });
  const auto at = source.find(first.first);
  if (at == std::string::npos) return parsed(source);
  return parsed(source.substr(0, at)) +
         (m == Markup::tex ? first.second.first : first.second.second) +
         one_formula(source.substr(at + first.first.size()), m, longest, has_sets);
}

} // namespace

namespace {

std::string escaped(const std::string& source, Markup m) {
  static const std::map<char, std::string> html{
      {'<', "&lt;"}, {'>', "&gt;"}, {'&', "&amp;"}, {'"', "&quot;"}, {'*', "&#8201;"}};
  static const std::map<char, std::string> tex{{'\\', "\\textbackslash{}"},
                                               {'{', "\\{"},
                                               {'}', "\\}"},
                                               {'$', "\\$"},
                                               {'&', "\\&"},
                                               {'#', "\\#"},
                                               {'%', "\\%"},
                                               {'_', "\\_"},
                                               {'^', "\\^{}"},
                                               {'~', "\\~{}"},
                                               {'<', "$<$"},
                                               {'>', "$>$"},
                                               {'|', "$|$"},
                                               {'"', "''"},
                                               {'*', "$\\cdot$"}};
  const auto& table = m == Markup::tex ? tex : html;
  std::string out;
  for (const char c : source) {
    const auto it = table.find(c);
    out += it == table.end() ? std::string(1, c) : it->second;
  }
  if (m == Markup::tex && source.starts_with('"')) out.replace(0, 2, "``");
  return out;
}

// "<=", "+-", ... as they are printed.
std::string relation(const std::string& s, Markup m) {
  static const std::map<std::string, std::pair<std::string, std::string>> signs{
      {"<=", {"$\\leq$", "&le;"}},    {">=", {"$\\geq$", "&ge;"}},   {"!=", {"$\\neq$", "&ne;"}},
      {"+-", {"$\\pm$", "&plusmn;"}}, {"-+", {"$\\mp$", "&#8723;"}}, {"->", {"$\\to$", "&rarr;"}}};
  return m == Markup::tex ? signs.at(s).first : signs.at(s).second;
}

std::string script(const std::string& inner, bool above, Markup m) {
  if (m == Markup::tex) return (above ? "\\textsuperscript{" : "\\textsubscript{") + inner + "}";
  return above ? "<sup>" + inner + "</sup>" : "<sub>" + inner + "</sub>";
}

} // namespace

namespace {

std::string in_math(const std::string& formula, Markup m) {
  if (m == Markup::html) return "<math displaystyle=\"true\">" + formula + "</math>";
  const bool tall = formula.find("\\frac") != std::string::npos;
  return (tall ? "$\\displaystyle " : "$") + formula + "$";
}

} // namespace

namespace {

// "alpha|beta|...", for a regular expression
std::string greek_names() {
  return joined(
      std::views::keys(greek()), [](const std::string& name) { return name; }, "|");
}

} // namespace

namespace {

// Words that are no formula: Greek names, indices, powers and relations in them are set as such; Z3 is a program.
std::string words(const std::string& source, Markup m) {
  static const std::regex piece(
      R"(\b([A-Z]|[A-Z]\d|(?:)" + greek_names() + R"()\d?)'(?![A-Za-z])|\b()" + greek_names() +
      R"()(\d?)(?![A-Za-z])|\b(?!Z3\b)([A-Z](?=\d)|G(?=[ma]\b))(\d|[ma])\b|\^(\([^()]*\)|[A-Za-z0-9]+))"
      R"(|_(ijk|[a-z+-]|\d+)(?![A-Za-z])|(<=|>=|!=|\+-|-\+|->)|\binfinity\b)");
  enum : std::uint8_t { derived = 1, letter, index, capital, digit, power, below, sign };
  std::string out;
  std::size_t last = 0;
  for (std::sregex_iterator it(source.begin(), source.end(), piece), end; it != end; ++it) {
    const std::smatch& x = *it;
    out += escaped(source.substr(last, static_cast<std::size_t>(x.position()) - last), m);
    last = static_cast<std::size_t>(x.position() + x.length());
    if (x[derived].matched) {
      out += words(x[derived].str(), m) + (m == Markup::tex ? "$'$" : "&prime;");
    } else if (x[letter].matched) {
      const auto& written = greek().at(x[letter].str());
      out += m == Markup::tex ? "$" + written.first + "$" : written.second;
      if (x[index].length() > 0) out += script(x[index].str(), false, m);
    } else if (x[capital].matched) {
      out += x[capital].str() + script(x[digit].str(), false, m);
    } else if (x[power].matched) {
      std::string exponent = x[power].str();
      if (exponent.front() == '(') exponent = exponent.substr(1, exponent.size() - 2);
      out += script(words(exponent, m), true, m);
    } else if (x[below].matched) {
      out += script(escaped(x[below].str(), m), false, m);
    } else {
      out += x[sign].matched    ? relation(x[sign].str(), m)
             : m == Markup::tex ? "$\\infty$"
                                : "&infin;";
    }
  }
  return out + escaped(source.substr(last), m);
}

constexpr std::string_view signs = "+-*/^=<>!(){},_'\" ", marks = ".,;:\"";

// May this word of a sentence be a part of a formula?  English words have two letters or more: mu, px and sqrt are none.
bool may_be_mathematics(const std::string& word) {
  static const std::regex name("[A-Za-z]|[pv][q-z]|SL|sqrt|sinh?|cosh?|tanh?|exp|log|" +
                               greek_names());
  std::string letters;
  for (const char c : word + " ") {
    if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
      letters += c;
      continue;
    }
    if (!letters.empty() && !std::regex_match(letters, name)) return false;
    letters.clear();
    if (std::isdigit(static_cast<unsigned char>(c)) == 0 && signs.find(c) == signs.npos)
      return false;
  }
  return word != "Z3";
}

// Is it a formula for a reader: a relation, an operation, an index, a letter?  "2", "I", "a" as an article stay in the sentence.
bool is_told_as_formula(const std::string& text, bool listed) {
  static const std::regex some("[-+*/^=<>_']|[A-Za-z][0-9]|sqrt|SL|[pv][q-z]|^[b-zB-HJ-Z]$|" +
                               greek_names());
  return std::regex_search(text, some) || (listed && (text == "a" || text == "A"));
}

/// A formula in a sentence, and the marks around it.
struct Piece {
  std::string before, markup, after;
};
std::optional<Piece> formula_piece(std::string text, Markup m, bool has_sets) {
  Piece piece;
  const auto depth = [&] { return std::ranges::count(text, '(') - std::ranges::count(text, ')'); };
  while (!text.empty() &&
         (marks.find(text.back()) != marks.npos || (text.back() == ')' && depth() < 0))) {
    piece.after.insert(0, 1, text.back());
    text.pop_back();
  }
  while (text.starts_with('"') || (text.starts_with('(') && depth() > 0)) {
    piece.before += text.front();
    text.erase(0, 1);
  }
  if (text.starts_with('(') && text.find(')') + 1 == text.size()) { // (m = n)
    piece.before += '(';
    piece.after.insert(0, 1, ')');
    text = text.substr(1, text.size() - 2);
  }
  if (!is_told_as_formula(text, piece.after.starts_with(','))) return std::nullopt;
  try {
    const std::string math =
        one_formula(text, m, 0, has_sets || text.find("SL(2, C)") != text.npos);
    piece.markup = m == Markup::tex ? "$" + math + "$" : "<math>" + math + "</math>";
  } catch (const InputError&) {
    return std::nullopt;
  }
  return piece;
}

} // namespace

std::string prose(const std::string& source, Markup m) {
  if (m == Markup::text) return source;
  std::vector<std::string> all;
  std::istringstream in(source);
  for (std::string word; std::getline(in, word, ' ');)
    if (!all.empty() && (all.back().ends_with("SL(2,") ||
                         std::ranges::count(all.back(), '{') > std::ranges::count(all.back(), '}')))
      all.back() += ' ' + word;
    else
      all.push_back(word);
  std::string out;
  bool has_sets = false; // n is in 1/2 + Z, 3*Z or 1 + 4*Z
  for (std::size_t i = 0; i < all.size();) {
    constexpr std::size_t longest = 400;
    std::size_t end = i;
    while (end < all.size() && end < i + longest && !all[end].empty() &&
           may_be_mathematics(all[end].substr(0, all[end].find_last_not_of(marks) + 1)))
      if (marks.find(all[end++].back()) != marks.npos) break;
    std::optional<Piece> piece;
    for (; end > i && !piece; --end) {
      std::string text = all[i];
      for (std::size_t k = i + 1; k < end; ++k)
        text += ' ' + all[k];
      piece = formula_piece(text, m, has_sets);
      if (piece) break;
    }
    out += (i == 0 ? "" : " ") +
           (piece ? escaped(piece->before, m) + piece->markup + escaped(piece->after, m)
                  : words(all[i], m));
    has_sets = all[i] == "in" || (has_sets && (piece || all[i] == "or" || all[i] == "and"));
    i = std::max(end, i + 1);
  }
  return out;
}

std::string tex_name(const std::string& name) { return Writer(Markup::tex, false).name(name); }

std::string in_markup(const Expression& e, Markup m, const Instead& instead) {
  return Writer(m, false, instead).write(e);
}

std::string verbatim(const std::string& source, Markup m) {
  std::string out;
  for (const char c : source)
    out += c == '*' ? std::string(1, c) : escaped(std::string(1, c), m);
  return m == Markup::text ? source : out;
}

namespace {

// "yes", "infinity": a word, no name.
bool is_word(const std::string& s) {
  for (const char c : s)
    if (std::isalpha(static_cast<unsigned char>(c)) == 0) return false;
  return s.size() > 1 && !greek().contains(s);
}

} // namespace

std::string formula(const std::string& source, Markup m) {
  if (m == Markup::text) return source;
  try {
    return joined(pieces(source), [m](const std::string& piece) {
      return is_word(piece) ? words(piece, m) : in_math(one_formula(piece, m), m);
    });
  } catch (const InputError&) {
    return prose(source, m);
  }
}

std::string label(const std::string& source, Markup m) {
  if (m == Markup::tex) {
    try {
      return in_math(one_formula(source, m, 0), m);
    } catch (const InputError&) { // words
      return prose(source, m);
    }
  }
  static const std::regex root("sqrt\\(");
  const std::string plain = std::regex_replace(source, root, "\u221a(");
  return m == Markup::html ? escaped(plain, m) : plain;
}

std::string heading(const std::string& source, Markup m) {
  static const std::regex name("([A-Za-z]|" + greek_names() + ")\\d*'?");
  return std::regex_match(source, name) ? formula(source, m) : prose(source, m);
}

std::string shortened(const std::string& source, std::size_t length) {
  if (length == 0 || source.size() <= length) return source;
  return source.substr(0, length) + " ... (" + std::to_string(source.size()) + " characters)";
}

} // namespace kov::report
