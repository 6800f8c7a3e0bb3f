#include "answer/notation.hpp"

#include "symbol/formula.hpp"
#include "symbol/written.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace kov::answer {
namespace {

using Kind = Expression::Kind;

struct Function {
  const char *name, *letter;
  std::size_t indices; ///< arguments below and above the letter
};
constexpr std::array<Function, 14> functions{{{"besselj", "J", 1},
                                              {"bessely", "Y", 1},
                                              {"besseli", "I", 1},
                                              {"besselk", "K", 1},
                                              {"airyai", "Ai", 0},
                                              {"airybi", "Bi", 0},
                                              {"airyaiprime", "Ai'", 0},
                                              {"airybiprime", "Bi'", 0},
                                              {"pcfd", "D", 1},
                                              {"legenp", "P", 2},
                                              {"legenq", "Q", 2},
                                              {"hyp1f1", "M", 0},
                                              {"hyperu", "U", 0},
                                              {"hyp2f1", "2F1", 0}}};

const Function* special(const Expression& e) {
  if (e.kind() != Kind::call) return nullptr;
  const auto* found =
      std::ranges::find_if(functions, [&](const Function& f) { return e.name() == f.name; });
  return found == functions.end() ? nullptr : found;
}

std::string index(const Expression& e) {
  const std::string text = for_people(e);
  const bool atom = e.kind() == Kind::name || e.kind() == Kind::number;
  return atom ? text : "(" + text + ")";
}

std::optional<std::string> book_text(const Expression& e) {
  const auto f = in_books(e);
  if (!f) return std::nullopt;
  std::string text = f->letter;
  if (f->below) text += "_" + index(*f->below);
  if (f->above) text += "^" + index(*f->above);
  for (std::size_t i = 0; i < f->arguments.size(); ++i)
    text += (i == 0                                    ? "("
             : i < f->parameters || f->parameters == 0 ? ", "
                                                       : "; ") +
            for_people(f->arguments[i]);
  return text + ")";
}

} // namespace

std::optional<InBooks> in_books(const Expression& e) {
  const Function* f = special(e);
  if (f == nullptr) return std::nullopt;
  InBooks out{f->letter, {}, {}, e.operands(), 0};
  const auto taken = [&] {
    const Expression first = out.arguments.front();
    out.arguments.erase(out.arguments.begin());
    return first;
  };
  if (f->indices > 0) out.below = taken();
  if (f->indices > 1)
    if (const Expression m = taken(); !trees::is_number(m, 0)) out.above = m;
  if (e.name() == "hyp2f1") out.parameters = 2;
  return out;
}

std::string for_people(const Expression& y) { return written(y, book_text); }

std::string for_programs(const Expression& y) {
  std::string text;
  for (const char c : written(y))
    text += c == '^' ? std::string("**") : std::string(1, c);
  return text;
}

std::vector<std::string> for_programs(const Solutions& all) {
  std::vector<std::string> texts;
  for (const Expression& y : all.y)
    texts.push_back(for_programs(y));
  return texts;
}

bool is_special(const Expression& y) {
  return special(y) != nullptr || std::ranges::any_of(y.operands(), is_special);
}

std::string meaning_of_functions(const Solutions& all) {
  const auto stands = [&](const char* function) {
    return std::ranges::any_of(all.y,
                               [&](const Expression& y) { return mentions_name(y, function); });
  };
  if (stands("hyperu")) return "M and U are Kummer's functions";
  if (stands("hyp1f1")) return "M is Kummer's function 1F1";
  if (stands("pcfd")) return "D is the parabolic cylinder function";
  if (stands("legenp")) return "P and Q are Legendre's functions";
  return {};
}

} // namespace kov::answer
