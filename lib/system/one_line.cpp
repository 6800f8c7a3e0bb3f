#include "system/one_line.hpp"

#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "symbol/author_words.hpp"
#include "symbol/document.hpp"
#include "symbol/expression.hpp"
#include "symbol/one_name.hpp"
#include "symbol/pasted.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>
#include <sstream>

namespace kov {
namespace {

using Names = std::vector<std::string>;

bool is_number(const std::string& s) {
  return !s.empty() && std::ranges::all_of(s, [](unsigned char c) { return std::isdigit(c) != 0; });
}
bool is_part_of_a_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// x' and x'(t) are the velocity x_dot: a file knows no primes.
std::string without_primes(const std::string& formula) {
  std::string text;
  for (const char c : formula)
    if (c == '\'' && !text.empty() && is_part_of_a_name(text.back()))
      text += "_dot";
    else
      text += c;
  return text;
}

// Letters that people call coordinates: they may be cyclic.
const Names usual = {"x", "y", "z", "q", "r", "theta", "phi", "psi", "rho", "s", "u"};
// Coordinates that go with actions I1, J, and with angular momenta L, M where there is no p.
const Names angles = {"theta", "th", "phi", "varphi", "psi"};

class Guess {
public:
  Guess(Names names, Mechanics kind) : names_(std::move(names)), kind_(kind) {}

  // The coordinate of a momentum or velocity; nothing: it is none.
  [[nodiscard]] std::optional<std::string> coordinate_of(const std::string& rate) const {
    if (kind_ != Mechanics::hamiltonian) return of_velocity(rate);
    const auto c = of_momentum(rate);
    return c ? c : of_action(rate);
  }

  // The letter that goes with this coordinate; nothing: none is called so.
  [[nodiscard]] std::optional<std::string> rate_of(const std::string& coordinate) const {
    for (const std::string& name : names_)
      if (coordinate_of(name) == coordinate) return name;
    return std::nullopt;
  }

private:
  [[nodiscard]] std::optional<std::string> of_momentum(const std::string& rate) const {
    if (rate[0] != 'p' && rate[0] != 'P') return std::nullopt;
    std::string rest = rate.substr(1);
    if (rest.starts_with("_")) rest.erase(0, 1);
    if (rest.empty()) return of_the_only_one();
    if (is_number(rest)) return numbered(rest);
    return known_or_usual(rest);
  }

  [[nodiscard]] std::optional<std::string> of_action(const std::string& rate) const {
    const bool has_momenta = std::ranges::any_of(
        names_, [&](const std::string& n) { return of_momentum(n).has_value(); });
    const std::string letters = has_momenta ? "IJ" : "IJLM";
    if (letters.find(rate[0]) == std::string::npos) return std::nullopt;
    const std::string rest = rate.substr(rate.starts_with(rate.substr(0, 1) + "_") ? 2 : 1);
    std::optional<std::string> found;
    for (const std::string& angle : angles) {
      const std::string c = rest.empty() || is_number(rest) ? angle + rest : angle;
      const bool is_meant = is_among(c, names_) && (rest.empty() || is_number(rest) || rest == c);
      const bool has_momentum =
          std::ranges::any_of(names_, [&](const std::string& n) { return of_momentum(n) == c; });
      if (!is_meant || has_momentum) continue;
      if (found) return std::nullopt; // of two
      found = c;
    }
    return found;
  }

  [[nodiscard]] std::optional<std::string> of_velocity(const std::string& rate) const {
    for (const std::string end : {"_dot", "dot"})
      if (rate.size() > end.size() && rate.ends_with(end))
        return rate.substr(0, rate.size() - end.size());
    if (rate.size() > 1 && rate[0] == 'v') {
      const std::string rest = rate.substr(rate[1] == '_' ? 2 : 1);
      if (is_number(rest)) return numbered(rest);
      if (!rest.empty()) return known_or_usual(rest);
    }
    return std::nullopt;
  }

  [[nodiscard]] std::optional<std::string> known_or_usual(const std::string& name) const {
    if (is_among(name, names_) || is_among(name, usual)) return name;
    return std::nullopt;
  }

  // p: q, x, or another usual letter that occurs.
  [[nodiscard]] std::optional<std::string> of_the_only_one() const {
    if (is_among("q", names_)) return "q";
    for (const std::string& name : usual)
      if (is_among(name, names_)) return name;
    return "q";
  }

  // p1: q1 or x1, as others are called; else x, y, z in this order.
  [[nodiscard]] std::optional<std::string> numbered(const std::string& number) const {
    const Names stems = {"q", "x", "q_", "x_", "theta", "phi", "r", "th", "y"};
    for (const std::string& stem : stems)
      if (is_among(stem + number, names_)) return stem + number;
    for (const std::string& stem : stems)
      if (std::ranges::any_of(names_, [&](const std::string& n) {
            return n.starts_with(stem) && is_number(n.substr(stem.size()));
          }))
        return stem + number;
    const std::array<std::string, 3> letters = {"x", "y", "z"};
    const std::size_t i = number.size() == 1 ? static_cast<std::size_t>(number[0] - '1') : 3;
    if (i < letters.size() && is_among(letters[i], names_)) return letters[i];
    return std::nullopt;
  }

  Names names_;
  Mechanics kind_;
};

std::string rate_word(Mechanics kind) {
  return kind == Mechanics::hamiltonian ? "momentum" : "velocity";
}

std::string quoted(const Names& all) {
  return "[" + joined(all, [](const std::string& one) { return "\"" + one + "\""; }) + "]";
}

// Compares in the order x, y, z or q1, q2, q10 in which a person lists them.
bool comes_before(const std::string& a, const std::string& b) {
  const auto stem = [](const std::string& s) {
    return s.substr(0, s.find_last_not_of("0123456789") + 1);
  };
  if (stem(a) != stem(b)) return a < b;
  return a.size() != b.size() ? a.size() < b.size() : a < b;
}

void guess_coordinates(const Expression& e, const Guess& guess, const Names& names, Mechanics kind,
                       Letters& letters) {
  for (const std::string& name : names)
    if (const auto c = guess.coordinate_of(name); c && !is_among(name, letters.parameters) &&
                                                  !is_among(*c, letters.coordinates) && *c != name)
      letters.coordinates.push_back(*c);
  std::ranges::sort(letters.coordinates, comes_before);
  if (letters.coordinates.empty())
    throw e.error("no letter of it looks like a " + rate_word(kind),
                  kind == Mechanics::hamiltonian
                      ? "call the momenta p1, p2, ... or px, py, ..., or name the coordinates: "
                        "--coordinates x,y"
                      : "call the velocities xdot, ydot, ... or x', y', ..., or name the "
                        "coordinates: --coordinates x,y");
}

// xy, kx, x2y and y3 are not parameters beside x and y, nor cosq: products and powers, whose signs are missing.
void refuse_run_together(const Expression& e, const std::string& name, const Names& names,
                         const Letters& letters) {
  Names known = letters.coordinates;
  if (!std::ranges::any_of(known, [&](const std::string& c) { return is_among(c, names); }))
    known.insert(known.end(), usual.begin(), usual.end()); // a coordinate that occurs nowhere
  known.insert(known.end(), letters.rates.begin(), letters.rates.end());
  if (is_one_name(name) && !is_among(name.substr(0, name.find_first_of("_0123456789")), known))
    return; // k, mu, omega_c
  std::string rest = name, product = as_product(name);
  const auto known_length = [&](const std::string& word) {
    std::size_t n = 0;
    for (const std::string& letter : known)
      if (word.starts_with(letter)) n = std::max(n, letter.size());
    return n;
  };
  if (product.find('(') == std::string::npos) {
    product.clear();
    while (!rest.empty()) {
      const bool is_factor = product.empty() && known_length(rest.substr(1)) > 0; // k in kx
      const std::size_t n = std::max<std::size_t>(known_length(rest), is_factor ? 1 : 0);
      if (n == 0) return;
      product += (product.empty() ? "" : "*") + rest.substr(0, n);
      rest.erase(0, n);
      const std::size_t digits = std::min(rest.find_first_not_of("0123456789"), rest.size());
      if (digits > 0 && digits == rest.size() && rest[0] < '2') return; // x0, y1
      if (digits > 0) product += "^" + rest.substr(0, digits);
      rest.erase(0, digits);
    }
  }
  throw e.error("is " + name + " one name, or " + product + "?",
                "write " + product + "; one name: --parameters " + name + ",...");
}

// r beside x and y is hardly a parameter.
void refuse_radius(const Expression& e, const std::string& name, const Letters& letters) {
  if (name != "r" || !is_among("x", letters.coordinates) || !is_among("y", letters.coordinates))
    return;
  const std::string radius =
      is_among("z", letters.coordinates) ? "sqrt(x^2 + y^2 + z^2)" : "sqrt(x^2 + y^2)";
  throw e.error("r is " + radius + ", or a parameter: which?",
                "write " + radius + "; a parameter: --parameters r,...");
}

void settle_parameters(const Expression& e, const Names& names, Letters& letters) {
  const bool given = !letters.parameters.empty();
  for (const std::string& name : names) {
    if (is_among(name, letters.coordinates) || is_among(name, letters.rates) ||
        is_among(name, letters.parameters))
      continue;
    if (given)
      throw e.error(name + " is not a coordinate, and not among the parameters " +
                    joined(letters.parameters));
    if (name == "t")
      throw e.error("t is the time or a parameter: which?",
                    "a parameter: --parameters t,...; the time: make it a coordinate, with the "
                    "energy as its momentum (H + p_t, --coordinates t,...)");
    refuse_radius(e, name, letters);
    refuse_run_together(e, name, names, letters);
    letters.parameters.push_back(name);
  }
}

} // namespace

Letters letters_of(const std::string& formula, Mechanics kind, const Letters& given,
                   const std::string& name) {
  const Expression e = parse_expression(without_primes(formula), name);
  const Names names = names_in(e);
  const Guess guess(names, kind);
  Letters letters = given;
  if (letters.coordinates.empty()) guess_coordinates(e, guess, names, kind, letters);
  if (letters.rates.empty())
    for (const std::string& c : letters.coordinates) {
      const auto rate = guess.rate_of(c);
      if (!rate)
        throw e.error("which letter is the " + rate_word(kind) + " of " + c + "?",
                      kind == Mechanics::hamiltonian
                          ? "name them in the order of the coordinates: --momenta u,v,..."
                          : "name them in the order of the coordinates: --velocities u,v,...");
      letters.rates.push_back(*rate);
    }
  if (letters.rates.size() != letters.coordinates.size())
    throw e.error("each coordinate needs one " + rate_word(kind) + ", in the same order");
  for (const std::string& rate : letters.rates)
    if (is_among(rate, letters.coordinates) || is_among(rate, letters.parameters))
      throw e.error(rate + " is the " + rate_word(kind) + " of a coordinate and something else");
  settle_parameters(e, names, letters);
  return letters;
}

std::string in_words(const Letters& letters, Mechanics kind) {
  return "coordinates " + joined(letters.coordinates) +
         (kind == Mechanics::hamiltonian ? "; momenta " : "; velocities ") + joined(letters.rates) +
         (letters.parameters.empty() ? "; no parameters"
                                     : "; parameters " + joined(letters.parameters));
}

std::string system_text(const std::string& formula, Mechanics kind, const Letters& letters) {
  const bool hamiltonian = kind == Mechanics::hamiltonian;
  std::string text = without_primes(formula);
  std::string escaped;
  for (const char c : text)
    escaped += c == '"' || c == '\\' ? std::string("\\") + c : c == '\n' ? " " : std::string(1, c);
  return "format = \"equation/1\"\n\n[system]\nkind        = \"" +
         std::string(hamiltonian ? "hamiltonian" : "lagrangian") +
         "\"\ncoordinates = " + quoted(letters.coordinates) +
         (hamiltonian ? "\nmomenta     = " : "\nvelocities  = ") + quoted(letters.rates) +
         (letters.parameters.empty() ? "" : "\nparameters  = " + quoted(letters.parameters)) +
         (hamiltonian ? "\nhamiltonian = \"" : "\nlagrangian  = \"") + escaped + "\"\n";
}

namespace {

// "p^2/2 + q^4/4" of "H = p^2/2 + q^4/4"
std::string without_name(const std::string& text, const std::string& name) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) return text;
  std::string left = text.substr(0, equals);
  std::erase_if(left, [](char c) { return c == ' ' || c == '\t'; });
  const bool is_named = left == name || (left.starts_with(name + "(") && left.ends_with(")"));
  return is_named ? text.substr(equals + 1) : text;
}

} // namespace

OneLine read_one_line(const std::string& given, Mechanics kind, const Letters& letters,
                      const std::string& name) {
  Names declared = letters.parameters;
  for (const Names* list : {&letters.coordinates, &letters.rates})
    declared.insert(declared.end(), list->begin(), list->end());
  const char* const own = kind == Mechanics::hamiltonian ? "H" : "L";
  Pasted pasted = pasted_formula(without_name(given, own), name, {declared, ""});
  OneLine line{pasted.text(), "", {}, pasted.as_written, std::move(pasted.notes)};
  line.letters = letters_of(line.formula, kind, letters, name);
  line.text = system_text(line.formula, kind, line.letters);
  return line;
}

std::string assume_table(const std::vector<std::string>& sentences) {
  static const std::map<std::string, std::string> signs{
      {"positive", " > 0"}, {"negative", " < 0"}, {"nonnegative", " >= 0"}, {"nonzero", " != 0"}};
  static const Names domains{"real", "rational", "integer"};
  std::string words;
  Names conditions;
  Names all; // "a > 0, b > 0" as two
  for (const std::string& some : sentences) {
    std::istringstream in(some);
    for (std::string one; std::getline(in, one, ',');)
      all.push_back(one);
  }
  for (const std::string& sentence : all) {
    std::istringstream in(sentence);
    Names parts;
    for (std::string word; in >> word;)
      if (parts.empty() || (word != "is" && word != "an" && word != "a")) parts.push_back(word);
    const bool is_word = parts.size() == 2 && is_identifier(parts[0]);
    const auto sign = is_word ? signs.find(parts[1]) : signs.end();
    if (is_word && is_among(parts[1], domains))
      words += parts[0] + " = \"" + parts[1] + "\"\n";
    else
      conditions.push_back(sign == signs.end() ? sentence : parts[0] + sign->second);
  }
  return "[assume]\n" + words +
         (conditions.empty() ? "" : "conditions = " + quoted(conditions) + "\n");
}

std::string with_scene(const std::string& system, const SceneWishes& wishes) {
  const Entry document = parse_document(system, "-H");
  const Entry& table = document.at("system");
  const auto list = [&](const char* key) {
    return table.find(key) != nullptr ? table.at(key).strings() : Names();
  };
  const Names coordinates = list("coordinates");
  Names momenta = list("momenta");
  if (momenta.empty() && table.at("kind").string() == "lagrangian")
    for (const std::string& c : coordinates)
      momenta.push_back("p_" + c);
  if (momenta.size() != coordinates.size())
    throw table.error("this system has no scene", "kovacic new scene shows a [[scene]] table");
  if (coordinates.size() < 2)
    throw table.error("a section needs two degrees of freedom; with one, the orbits are the curves "
                      "H = constant");
  std::string set;
  for (const std::string& name : list("parameters")) {
    const auto value =
        std::ranges::find(wishes.values, name, &std::pair<std::string, std::string>::first);
    set += (set.empty() ? "" : ", ") + name + " = \"" +
           (value == wishes.values.end() ? "1" : value->second) + "\"";
  }
  std::string text = system + "\n[[scene]]\n";
  if (!wishes.name.empty()) text += "name      = \"" + wishes.name + "\"\n";
  if (!set.empty()) text += "set       = { " + set + " }\n";
  text += "section   = \"" + coordinates[0] +
          "\"                 # seen where this is 0 and grows\n" +
          "plot      = " + quoted({coordinates[1], momenta[1]}) + "\n";
  if (coordinates.size() == 2) {
    text += "levels    = { H = \"" + wishes.energy + "\" }\n" +
            "grid      = [8, 8]                # over the level; range = [[a, b], [c, d]]: there\n";
  } else { // starts on no level
    text += "states    = [";
    for (int i = 1; i <= 8; ++i) {
      text += i == 1 ? "[" : ", [";
      for (std::size_t j = 0; j < 2 * coordinates.size(); ++j)
        text += (j == 0 ? "" : ", ") + std::string("\"") + std::to_string(i + static_cast<int>(j)) +
                "/20\"";
      text += "]";
    }
    text += "]    # " + joined(coordinates) + ", " + joined(momenta) + "\n";
  }
  return text + "crossings = 300                   # of each orbit\n";
}

} // namespace kov
