#include "pasted_question.hpp"

#include "equation/function_change.hpp"
#include "render.hpp"
#include "symbol/pasted.hpp"
#include "symbol/written.hpp"

#include <algorithm>
#include <sstream>

namespace kov::cli {
namespace {

class QuestionOptions {
public:
  QuestionOptions(const FormulaOptions& options, EquationText given) : options_(options) {
    question_.text = std::move(given);
    question_.text.minpoly = formula("--minpoly", "", options.minpoly);
    names_ = {declared_names(question_.text), question_.text.variable, question_.text.unknown};
  }

  PastedQuestion operator()() {
    if (options_.ode) take(understood(*options_.ode, "-e", question_.text));
    question_.text.r = formula("-r", "r", options_.r);
    if (!options_.ode || options_.p) // both are refused later
      question_.text.p = options_.p ? formula("--p", "p", options_.p) : question_.text.p;
    if (!options_.ode || options_.q)
      question_.text.q = options_.q ? formula("--q", "q", options_.q) : question_.text.q;
    refuse_words(question_.text);
    functions();
    return std::move(question_);
  }

private:
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
    Understood u = understood(ode, t.r ? "-r" : "--p, --q", given);
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

  const FormulaOptions& options_;
  PastedQuestion question_;
  PastedNames names_;
};

} // namespace

PastedQuestion read_options(const FormulaOptions& options, EquationText given) {
  return QuestionOptions(options, std::move(given))();
}

Json reading_json(const PastedQuestion& question) {
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

} // namespace kov::cli
