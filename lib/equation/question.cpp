#include "equation/question.hpp"

#include "equation/assumptions.hpp"
#include "equation/function_change.hpp"
#include "equation/parametric_equation.hpp"
#include "exact/lists.hpp"
#include "symbol/pasted.hpp"
#include "symbol/written.hpp"

#include <algorithm>
#include <utility>

namespace kov {
namespace {

class QuestionOptions {
public:
  QuestionOptions(const EquationTexts& options, EquationText given, Door door)
      : options_(options), door_(door) {
    question_.text = std::move(given);
    question_.text.minpoly = formula(name("--minpoly", "minpoly"), "", options.minpoly);
    for (std::string& one : question_.text.parameters)
      one = plain_text(one);
    for (std::string* one : {&question_.text.variable, &question_.text.unknown})
      *one = plain_text(*one);
    names_ = {declared_names(question_.text), question_.text.variable, question_.text.unknown};
  }

  AskedEquation operator()() {
    if (options_.ode) take(understood(*options_.ode, name("-e", "ode"), question_.text));
    question_.text.r = formula(name("-r", "r"), "r", options_.r);
    if (!options_.ode || options_.p) // both are refused later
      question_.text.p = options_.p ? formula(name("--p", "p"), "p", options_.p) : question_.text.p;
    if (!options_.ode || options_.q)
      question_.text.q = options_.q ? formula(name("--q", "q"), "q", options_.q) : question_.text.q;
    refuse_words(question_.text);
    functions();
    return std::move(question_);
  }

private:
  [[nodiscard]] std::string name(const char* option, const char* key) const {
    return door_ == Door::options ? option : key;
  }
  std::optional<Expression> formula(const std::string& option, const std::string& letter,
                                    const std::optional<std::string>& text) {
    if (!text) return std::nullopt;
    Pasted pasted = pasted_formula(*text, option, names_);
    if (!pasted.as_written)
      question_.read_as.push_back((letter.empty() ? "" : letter + " = ") + pasted.text());
    told(pasted.notes);
    return std::move(pasted.formula);
  }

  void told(const std::vector<ReadingNote>& notes) {
    question_.notes.insert(question_.notes.end(), notes.begin(), notes.end());
  }

  void take(Understood u) {
    question_.text = std::move(u.text);
    question_.given = std::move(u.given);
    if (!u.read_as.empty()) question_.read_as.push_back(u.read_as);
    told(u.notes);
    question_.right_side = std::move(u.right_side);
    question_.whole = std::move(u.whole);
  }

  // Coefficients in sin(x), exp(x), ...: the whole equation in another variable.
  void functions() {
    EquationText& t = question_.text;
    const bool here = !options_.ode && ((t.r && !t.p && !t.q) || (!t.r && t.p && t.q));
    if (!here || !(calls_function(t.r) || calls_function(t.p) || calls_function(t.q))) return;
    const std::string y = fresh_unknown();
    const std::string ode =
        t.r ? y + "'' = (" + written(*t.r) + ")*" + y
            : y + "'' + (" + written(*t.p) + ")*" + y + "' + (" + written(*t.q) + ")*" + y + " = 0";
    EquationText given = t;
    given.r = given.p = given.q = std::nullopt;
    Understood u = understood(ode, t.r ? name("-r", "r") : name("--p, --q", "p, q"), given);
    if (!u.text.p && calls_function(u.text.ode)) return; // roots of constants: as they are
    u.read_as = ode;
    take(std::move(u));
  }
  static bool calls_function(const std::optional<Expression>& e) {
    if (!e) return false;
    const auto names = names_in(*e);
    return std::ranges::any_of(names,
                               [&](const std::string& x) { return has_functions_of(*e, x); });
  }
  [[nodiscard]] std::string fresh_unknown() const {
    for (const char* letter : {"y", "u", "w", "f"}) {
      const auto uses = [&](const std::optional<Expression>& e) {
        return e && mentions_name(*e, letter);
      };
      if (!uses(question_.text.r) && !uses(question_.text.p) && !uses(question_.text.q))
        return letter;
    }
    return "y_";
  }

  const EquationTexts& options_;
  Door door_;
  AskedEquation question_;
  PastedNames names_;
};

} // namespace

namespace {

// If the variable was named, the other names are parameters.
void take_parameters(AskedEquation& asked) {
  const std::vector<std::string> before = asked.text.parameters;
  take_all_parameters(asked.text);
  std::vector<std::string> taken;
  for (const std::string& name : asked.text.parameters)
    if (!is_among(name, before)) taken.push_back(name);
  if (asked.whole) { // letters of a right side and of values
    const std::vector<std::string> known = declared_names(asked.text);
    std::vector<Expression> all = asked.whole->conditions;
    all.push_back(asked.whole->ode);
    for (const Expression& e : all)
      for (const std::string& name : names_in(e))
        if (name != "I" && name != asked.whole->unknown && name != asked.whole->variable &&
            !is_among(name, known))
          add_once(taken, name);
  }
  if (taken.empty()) return;
  auto note = std::ranges::find(asked.notes, ReadingNote::What::names, &ReadingNote::what);
  if (note == asked.notes.end())
    note = asked.notes.insert(note, {ReadingNote::What::names, {"", asked.text.variable}});
  note->of.insert(note->of.end(), taken.begin(), taken.end());
}

} // namespace

AskedEquation asked_equation(const EquationTexts& texts, EquationText given, Door door) {
  AskedEquation asked = QuestionOptions(texts, std::move(given), door)();
  const auto assume = std::exchange(asked.text.assume, {});
  add_assumptions(asked.text, assume);
  const bool is_equation = asked.text.ode || asked.text.change;
  if (!asked.text.variable.empty() && is_equation && !asked.text.minpoly) take_parameters(asked);
  return asked;
}

std::vector<AssumedText> assumed_texts(const std::vector<std::string>& sentences,
                                       const std::string& origin) {
  std::vector<AssumedText> all;
  for (const std::string& text : sentences)
    all.push_back({plain_text(text), origin_of_text(origin, plain_text(text)), ""});
  return all;
}

void add_assumptions(EquationText& text, const std::vector<AssumedText>& sentences) {
  const auto names = settable_names(text);
  const std::string variable = text.variable.empty() ? "z" : text.variable;
  for (const AssumedText& sentence : sentences) {
    text.assume.push_back(sentence);
    for (const std::string& name : names_in_assumption(sentence))
      if (name != variable && std::ranges::binary_search(names, name))
        text.parameters.push_back(name);
  }
}

} // namespace kov
