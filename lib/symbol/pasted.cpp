#include "symbol/pasted.hpp"

#include "exact/lists.hpp"
#include "exact/tried.hpp"
#include "symbol/one_name.hpp"
#include "symbol/pasted_characters.hpp"
#include "symbol/pasted_passes.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace kov {

bool PastedNames::has(std::string_view name) const {
  return name == variable || is_among(name, declared);
}

void Pasting::note(ReadingNote n) { add_once(notes, std::move(n)); }

void Pasting::stop_at_errors() const {
  if (errors.empty()) return;
  const InputError& first = errors.front();
  std::string hint = first.hint();
  for (std::size_t i = 1; i < errors.size(); ++i) {
    const InputError& e = errors[i];
    hint += (hint.empty() ? "" : "; ") + std::string("also at column ") +
            std::to_string(e.column()) + ": " + e.message() +
            (e.hint().empty() || e.hint() == first.hint() ? "" : ": " + e.hint());
  }
  throw InputError(first.file(), first.line(), first.column(), first.length(), first.message(),
                   hint, first.source_line());
}

std::size_t closing_of(const std::vector<Token>& tokens, std::size_t open) {
  long depth = 0;
  for (std::size_t i = open; i < tokens.size(); ++i) {
    depth += opens(tokens[i]) - closes(tokens[i]);
    if (depth == 0) return i;
  }
  return tokens.size() - 1;
}

namespace {

using List = std::vector<Token>;

constexpr std::size_t longest = std::size_t{1} << 20; // bytes; more is nothing that a person pastes

// The words of the text, with places in it as it was written.
List words(const PlainCharacters& plain, const OriginPtr& origin) {
  Tokens cut(plain.text, origin);
  cut.foreign_signs = cut.pasted_signs = true;
  cut.decimals_allowed = 1;
  List all;
  std::size_t end = 0;
  for (;;) {
    Token t = cut.next();
    const std::size_t begin = t.span.offset;
    t.after_blank = begin > end;
    end = begin + t.span.length;
    t.span = make_span(plain.from[begin], std::max(plain.from[end], plain.from[begin]));
    all.push_back(t);
    if (t.kind == TokenKind::end) return all;
  }
}

bool is_solver(const Token& t) {
  static constexpr std::array<std::string_view, 7> solvers{
      "dsolve", "DSolve", "desolve", "ode2", "contrib_ode", "kovacicsols", "DSolveValue"};
  return t.kind == TokenKind::name && is_among(t.text, solvers);
}

/// One question as tokens: the equation, and what stands beside it.
struct QuestionTokens {
  std::vector<List> formulas; // without end
  std::vector<List> ignored;  // options of a solver that restrict the solutions
  std::string variable;       // of a list of coefficients
};

class Cutting {
public:
  Cutting(List all, Pasting& p) : all_(std::move(all)), p_(p) {
    end_ = all_.back();
    all_.pop_back();
  }

  QuestionTokens operator()() {
    while (!all_.empty() && (all_.back().is(";") || all_.back().is("$") || all_.back().is(".")))
      all_.pop_back();
    drop_assignment();
    if (!take_solver())
      for (const List& piece : split(all_, ",;"))
        take(piece);
    for (List& piece : result_.formulas)
      piece.push_back(end_);
    return std::move(result_);
  }

private:
  [[nodiscard]] const Token& token(std::size_t i) const { return i < all_.size() ? all_[i] : end_; }

  // ode := ..., ode: ..., ode = Eq(...)
  void drop_assignment() {
    if (token(0).kind != TokenKind::name) return;
    std::size_t begin = 0;
    if (token(1).is(":")) begin = token(2).is("=") ? 3 : 2;
    const bool call = token(2).kind == TokenKind::name && token(3).is("(");
    if (token(1).is("=") && call && (is_solver(token(2)) || token(2).text == "Eq")) begin = 2;
    if (begin == 0) return;
    all_.erase(all_.begin(), all_.begin() + static_cast<std::ptrdiff_t>(begin));
  }

  static std::vector<List> split(const List& all, std::string_view at) {
    std::vector<List> parts(1);
    long depth = 0;
    for (const Token& t : all) {
      depth += opens(t) - closes(t);
      const bool here =
          depth == 0 && t.kind == TokenKind::sign && at.find(t.text) != std::string_view::npos;
      if (here)
        parts.emplace_back();
      else
        parts.back().push_back(t);
    }
    std::erase_if(parts, [](const List& part) { return part.empty(); });
    return parts;
  }

  // {a, b}: both
  void take(const List& piece) {
    const bool set = piece.front().is("{") && closing_of(piece, 0) + 1 == piece.size();
    if (!set) return result_.formulas.push_back(piece);
    for (const List& part : split({piece.begin() + 1, piece.end() - 1}, ","))
      take(part);
  }

  bool take_solver() {
    const bool in_package = token(1).is("[") && is_solver(token(2)) && token(3).is("]");
    const std::size_t open = in_package ? 4 : 1;
    if (!in_package && !is_solver(token(0))) return false;
    if (!opens(token(open)) || closing_of(all_, open) + 1 != all_.size()) return false;
    const auto begin = all_.begin() + static_cast<std::ptrdiff_t>(open) + 1;
    const std::vector<List> arguments = split({begin, all_.end() - 1}, ",");
    for (std::size_t i = 0; i < arguments.size(); ++i)
      if (i == 0)
        take_first(arguments[0]);
      else
        take_option(arguments[i]);
    return !result_.formulas.empty();
  }

  // [equation, y(0) = 1], but a list of coefficients is one formula
  void take_first(const List& piece) {
    const bool list = piece.front().is("[") && closing_of(piece, 0) + 1 == piece.size();
    const bool equations = std::ranges::any_of(
        piece, [](const Token& t) { return t.is("=") || t.is("'") || is_named(t, "diff"); });
    if (!list || !equations) return take(piece);
    for (const List& part : split({piece.begin() + 1, piece.end() - 1}, ","))
      take(part);
  }

  // y(x), x, option = ...: nothing that restricts the solutions
  void take_option(const List& piece) {
    if (piece.size() == 1 && piece[0].kind == TokenKind::name) result_.variable = piece[0].text;
    const bool named = piece.size() > 1 && piece[1].is("=") && !is_named(piece[0], "ics");
    const bool numbers = std::ranges::any_of(piece, [](const Token& t) {
      return t.kind == TokenKind::number || t.kind == TokenKind::decimal || t.is(":");
    });
    if (!named && numbers) result_.ignored.push_back(piece);
  }

  List all_;
  Pasting& p_;
  Token end_;
  QuestionTokens result_;
};

// [a, b, c]: a y + b y' + c y'', as DEtools has it.
bool is_list(const List& piece) {
  return piece.front().is("[") && closing_of(piece, 0) + 2 == piece.size();
}

List equation_of_list(const List& list, const std::string& variable, Pasting& p) {
  const bool taken = p.names.has("y") ||
                     std::ranges::any_of(list, [](const Token& t) { return is_named(t, "y"); });
  const std::string_view y = taken ? "u" : "y";
  List out;
  long order = 0, depth = 0;
  const auto put = [&](const Token& at, TokenKind kind, std::string_view s) {
    out.push_back(made(at, kind, s));
    out.back().after_blank = false;
  };
  const auto end_term = [&](const Token& at) {
    put(at, TokenKind::sign, ")");
    put(at, TokenKind::sign, "*");
    put(at, TokenKind::name, y);
    for (long i = 0; i < order; ++i)
      put(at, TokenKind::sign, "'");
    if (!variable.empty()) {
      put(at, TokenKind::sign, "(");
      put(at, TokenKind::name, p.kept(variable));
      put(at, TokenKind::sign, ")");
    }
    ++order;
  };
  put(list[0], TokenKind::sign, "(");
  for (std::size_t i = 1; i + 2 < list.size(); ++i) {
    depth += opens(list[i]) - closes(list[i]);
    if (depth == 0 && list[i].is(",")) {
      end_term(list[i]);
      put(list[i], TokenKind::sign, "+");
      put(list[i], TokenKind::sign, "(");
    } else {
      out.push_back(list[i]);
    }
  }
  end_term(list[list.size() - 2]);
  out.push_back(list.back());
  p.note({ReadingNote::What::coefficients, {std::string(y)}});
  return out;
}

// y(x) between these places, where x is the variable or any name.
void find_calls(const List& tokens, std::size_t from, std::size_t to, std::string_view variable,
                Pasting& p) {
  for (std::size_t i = from; i + 3 < to; ++i) {
    const bool call = tokens[i].kind == TokenKind::name && opens(tokens[i + 1]) &&
                      tokens[i + 2].kind == TokenKind::name && closes(tokens[i + 3]);
    if (call && !is_function_word(tokens[i].text) &&
        (variable.empty() || tokens[i + 2].text == variable))
      p.unknowns.emplace(tokens[i].text);
  }
}

// Finds all that is differentiated: y'', diff(y, x), and y(x) in (x y(x))'' and diff(x y(x), x).
void find_unknowns(const List& tokens, Pasting& p) {
  if (!p.names.unknown.empty()) p.unknowns.emplace(p.names.unknown);
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    if (closes(tokens[i]) && tokens[i + 1].is("'")) {
      find_calls(tokens, opening_of(tokens, i) + 1, i + 1, "", p);
    }
    if (tokens[i].kind != TokenKind::name) continue;
    if (tokens[i + 1].is("'")) p.unknowns.emplace(tokens[i].text);
    if (tokens[i].text != "diff" || i + 2 >= tokens.size()) continue;
    const Token& first = tokens[i + 2];
    if (first.kind == TokenKind::name && i + 3 < tokens.size() && tokens[i + 3].is(","))
      p.unknowns.emplace(first.text);
    std::size_t comma = i + 2;
    for (long depth = 0; comma + 1 < tokens.size(); ++comma) {
      depth += opens(tokens[comma]) - closes(tokens[comma]);
      if (depth <= 0 && tokens[comma].is(",")) break;
    }
    if (tokens[std::min(comma + 1, tokens.size() - 1)].kind == TokenKind::name)
      find_calls(tokens, i + 2, comma, tokens[comma + 1].text, p);
  }
}

// xy' beside y is x*y': two or three letters, the last of which is the unknown.
List with_letters_apart(const List& tokens, Pasting& p) {
  List out;
  for (const Token& t : tokens) {
    const std::string_view word = t.text, y = word.substr(word.empty() ? 0 : word.size() - 1);
    const bool is_name = t.kind == TokenKind::name && (word.size() == 2 || word.size() == 3) &&
                         std::ranges::all_of(word, [](char c) { return std::isalpha(c) != 0; });
    const bool is_known = !is_name || is_function_word(word) ||
                          is_function_word(word.substr(0, 2)) || is_one_name(word) ||
                          p.names.has(word) || word == p.names.unknown ||
                          word == p.names.variable || word[0] == 'd' || word[0] == 'D';
    const bool is_alone =
        p.unknowns.contains(y) ||
        (p.unknowns.contains(word) && std::ranges::any_of(tokens, [&](const Token& other) {
           return other.kind == TokenKind::name && other.text == y;
         }));
    if (is_known || !is_alone) {
      out.push_back(t);
      continue;
    }
    for (std::size_t i = 0; i < word.size(); ++i) {
      if (i > 0) out.push_back({.kind = TokenKind::sign, .span = t.span, .text = "*"});
      out.push_back({.kind = TokenKind::name, .span = t.span, .text = word.substr(i, 1)});
    }
  }
  return out;
}

struct Read {
  Expression formula;
  std::string text;
};

class PastedReading {
public:
  PastedReading(const std::string& text, const std::string& name, const PastedNames& names)
      : origin_(origin_of_text(name, text)), p_{.text = origin_->text,
                                                .origin = origin_,
                                                .names = names} {
    if (text.size() > longest)
      throw InputError(*origin_, Span{0, 1},
                       "a text of " + std::to_string(text.size()) + " bytes is too long here",
                       "write it into a file");
    plain_ = plain_characters(p_.text, origin_, p_.errors);
    p_.stop_at_errors();
    p_.by_time = plain_.dotted;
    words_ = words(plain_, origin_);
    if (const auto wrong = wrong_bracket(words_, origin_)) p_.errors.push_back(*wrong);
    p_.stop_at_errors();
    words_ = without_latex(std::move(words_), p_);
    p_.stop_at_errors();
  }

  Pasted formula() {
    refuse_pasted_signs(words_);
    List tokens = plain(words_);
    p_.stop_at_errors();
    return finished(parsed(std::move(tokens), false), {});
  }

  Pasted equation() {
    List tokens = without_quotients_of_d(std::move(words_), p_);
    QuestionTokens pieces = Cutting(std::move(tokens), p_)();
    if (pieces.formulas.empty()) throw at_end("a formula is missing");
    for (List& piece : pieces.formulas) {
      if (is_list(piece)) piece = equation_of_list(piece, pieces.variable, p_);
      translations_.push_back(translated(std::move(piece), p_.text, origin_));
      find_unknowns(translations_.back().tokens, p_);
    }
    for (TokenList& t : translations_)
      t.tokens = with_letters_apart(t.tokens, p_);
    p_.unknowns.clear();
    for (const TokenList& t : translations_)
      find_unknowns(t.tokens, p_);
    std::vector<List> plain_pieces;
    for (const TokenList& t : translations_) {
      refuse_pasted_signs(t.tokens);
      plain_pieces.push_back(plain(t.tokens));
    }
    if (!p_.errors.empty()) put_word_first();
    p_.stop_at_errors();
    Read first = parsed(std::move(plain_pieces.front()), true);
    std::vector<Expression> conditions;
    for (std::size_t i = 1; i < plain_pieces.size(); ++i)
      conditions.push_back(condition(parsed(std::move(plain_pieces[i]), true), first));
    for (const List& ignored : pieces.ignored)
      p_.note({ReadingNote::What::not_used, {text_of(ignored)}});
    return finished(std::move(first), std::move(conditions));
  }

private:
  [[nodiscard]] InputError at_end(const std::string& message) const {
    return {*origin_, make_span(0, 1), message};
  }

  // In xy''(x) = y(x) the word is the mistake, not the call.
  void put_word_first() {
    for (const TokenList& t : translations_)
      for (std::size_t i = 0; i + 1 < t.tokens.size(); ++i) {
        const Token& word = t.tokens[i];
        const bool differentiated =
            word.kind == TokenKind::name && p_.unknowns.contains(word.text) &&
            (t.tokens[i + 1].is("'") || (i > 1 && is_named(t.tokens[i - 2], "diff")));
        if (!differentiated || is_one_name(word.text) || p_.names.has(word.text) ||
            word.text == p_.names.unknown)
          continue;
        const std::string name(word.text);
        p_.errors.clear();
        p_.errors.emplace_back(*origin_, word.span, name + " is read as one name",
                               "write " + as_product(name) + " for " + name +
                                   "; if it is one name: --unknown " + name);
        return;
      }
  }

  List plain(const List& tokens) { return with_products(with_plain_functions(tokens, p_), p_); }

  Read parsed(List tokens, bool equation) {
    std::string text = text_of(tokens);
    Expression e =
        parse_tokens(Tokens(p_.text, origin_, std::move(tokens)), ParseLimits{}, equation);
    return {std::move(e), std::move(text)};
  }

  void refuse_pasted_signs(const List& tokens) {
    for (const Token& t : tokens)
      if (t.kind == TokenKind::sign &&
          std::string_view(":&~@$%.;").find(t.text) != std::string_view::npos)
        p_.refuse(t.span, "unexpected " + quoted(t.text));
      else if (t.is("[") || t.is("]") || t.is("{") || t.is("}"))
        p_.refuse(t.span, "unexpected character " + quoted(t.text), "use parentheses ( )");
  }

  // y(0) = 1, y'(0) = a: the unknown at a point.
  [[nodiscard]] Expression condition(const Read& piece, const Read& equation) const {
    const Expression& e = piece.formula;
    const auto refuse = [&] {
      return e.error("this is neither an equation for the unknown function nor a value of it",
                     "one equation is expected, and values like y(0) = 1 behind commas");
    };
    if (e.kind() != Expression::Kind::equation) throw refuse();
    Expression left = e.operand(0);
    if (left.kind() == Expression::Kind::name && !p_.unknowns.contains(left.name()))
      throw e.error("no value of the unknown function",
                    "a value of a parameter: --set " + left.name() + "=...");
    if (left.kind() == Expression::Kind::derivative) left = left.operand(0);
    if (left.kind() != Expression::Kind::call || !p_.unknowns.contains(left.name()) ||
        left.operands().size() != 1)
      throw refuse();
    const std::string call = left.name() + "(" + std::string(left.operand(0).text()) + ")";
    if (equation.text.find(call) != std::string::npos) throw refuse();
    return e;
  }

  Pasted finished(Read first, std::vector<Expression> conditions) {
    return {.formula = std::move(first.formula),
            .as_written = conditions.empty() && p_.notes.empty() && is_strict(first.text),
            .notes = std::move(p_.notes),
            .conditions = std::move(conditions),
            .by_time = p_.by_time};
  }

  // Would the strict reader see the same?
  [[nodiscard]] bool is_strict(const std::string& understood) const {
    return tried<InputError>(
        [&] { return text_of(translated(p_.text, origin_).tokens) == understood; });
  }

  OriginPtr origin_;
  Pasting p_;
  PlainCharacters plain_;
  List words_;
  std::vector<TokenList> translations_;
};

} // namespace

std::string plain_text(const std::string& text) {
  std::string plain;
  for (std::size_t at = 0; at < text.size();) { // formulas have none of <, > and !
    const std::size_t end = std::min(text.find_first_of("<>!", at), text.size());
    const std::string formula = text.substr(at, end - at);
    std::vector<InputError> errors;
    plain += plain_characters(formula, origin_of_text("", formula), errors).text;
    if (!errors.empty()) return text;
    if (end < text.size()) plain += text[end];
    at = end + 1;
  }
  return plain.substr(0, plain.find_last_not_of(' ') + 1);
}

Pasted pasted_formula(std::string text, const std::string& name, const PastedNames& names) {
  return PastedReading(text, name, names).formula();
}

Pasted pasted_equation(std::string text, const std::string& name, const PastedNames& names) {
  return PastedReading(text, name, names).equation();
}

} // namespace kov
