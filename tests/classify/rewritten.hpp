#pragma once
// One question in many words: the same assumptions in other inequalities, other letters, another order of
// the axes, with and without what the program knows by itself.

#include "support/random.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace kov::test {

/// What is assumed of three numbers P, Q, R (or of two), in lists that say the same.
struct Order {
  std::vector<std::vector<std::string>> said;
};

inline const Order& decreasing() { // P > Q > R > 0
  static const Order all{{{"P > 0", "Q > 0", "R > 0", "P > Q", "Q > R"},
                          {"R > 0", "Q > R", "P > Q"},
                          {"0 < R", "R < Q", "Q < P"},
                          {"P - Q > 0", "2*Q > 2*R", "-R < 0"},
                          {"Q > R", "R > 0", "P > R", "P > Q", "P + Q > 0"},
                          {"R > 0", "P > Q", "Q >= R", "Q != R"},
                          {"R >= 0", "R != 0", "P - R > Q - R", "Q > R"},
                          {"3*R > 0", "P/2 > Q/2", "R - Q < 0"}}};
  return all;
}
inline const Order& triangle() { // of different numbers, strictly
  static const Order all{
      {{"P > 0", "Q > 0", "R > 0", "P + Q > R", "Q + R > P", "R + P > Q", "P != Q", "Q != R",
        "P != R"},
       {"P + Q > R", "Q + R > P", "R + P > Q", "P != Q", "Q != R", "P != R"},
       {"P > R - Q", "Q > P - R", "R > Q - P", "P - Q != 0", "R != Q", "R != P"},
       {"2*P + 2*Q > 2*R", "P - Q < R", "Q - P < R", "Q != P", "Q != R", "P != R"},
       {"R < P + Q", "P < Q + R", "Q < R + P", "P + Q + R > 0", "P != Q", "Q != R", "P != R"},
       {"P + Q - R > 0", "Q + R - P > 0", "R + P - Q > 0", "(P - Q)^2 > 0", "Q != R", "P != R"}}};
  return all;
}
inline const Order& not_increasing() { // P >= Q >= R > 0
  static const Order all{{{"P > 0", "Q > 0", "R > 0", "P >= Q", "Q >= R"},
                          {"R > 0", "Q >= R", "P >= Q"},
                          {"0 < R", "R <= Q", "Q <= P"},
                          {"P - Q >= 0", "2*Q - 2*R >= 0", "R/2 > 0"},
                          {"P >= R", "P >= Q", "Q >= R", "R > 0"}}};
  return all;
}
inline const Order& apart() { // Q > 0, P > Q + 1
  static const Order all{{{"P > 0", "Q > 0", "P > Q + 1"},
                          {"Q > 0", "P > Q + 1"},
                          {"0 < 3*Q", "P - Q - 1 > 0"},
                          {"Q >= 0", "Q != 0", "1 < P - Q"},
                          {"P - 1 > Q", "Q > 0", "P > 1"}}};
  return all;
}

/// A system in the letters P, Q, R, X, Z, with M and G or x, y, u, v for its coordinates.
struct Question {
  bool top = true; ///< on e(3)*
  std::string hamiltonian;
  const Order& order;
  std::vector<std::string> besides = {}; ///< assumed of other letters
};

inline const std::vector<Question>& questions() {
  static const std::string body = "M1^2/(2*P) + M2^2/(2*Q) + M3^2/(2*R) + ";
  static const std::vector<Question> all{
      {true, body + "X*G1 + Z*G3", decreasing(), {"X > 0", "Z real"}},
      {true, body + "X*G1 + Z*G3", triangle(), {"X > 0", "Z real"}},
      {true, body + "X*G2 + Z*G3", decreasing(), {"X < 0", "Z real"}},
      {true, body + "X*(G1 + G2 - G3)", decreasing(), {"X > 0"}},
      {true, body + "X*(G1 + 2*G2 + G3)", triangle(), {"X != 0", "X real"}},
      {false, "(u^2 + v^2)/2 + P*x^2 + Q*y^2 + x^2*y + R*y^3/3", decreasing()},
      {false, "(u^2 + v^2)/2 + P*x^4 + 6*x^2*y^2 + Q*y^4", apart()},
      {false, "(u^2 + v^2)/2 + P*x^2 + Q*y^2 + x^2*y^2", apart()},
      {false, "(P*u^2 + Q*v^2)/2 + x^4 + R*x^2*y^2", not_increasing()},
      {false, "(u^2 + v^2)/2 + P*x^4 + Q*x^2*y^2 + R*y^4", triangle()}};
  return all;
}

/// How it is asked.
struct Writing {
  std::size_t order = 0;         ///< which list of inequalities
  std::size_t first = 0;         ///< which of them stands first
  std::string letters = "PQRXZ"; ///< in the place of these
  std::size_t turn = 0;          ///< of the axes of a top: 0, 1 or 2
  bool blocks = false;           ///< Casimir functions and H are declared
  std::string opposite = {};     ///< these of PQRXZ stand for the opposites of what they were
};

inline std::vector<Writing> writings(const Question& q) {
  static const std::array<const char*, 4> letters{"PQRXZ", "ABCxz", "kacdb", "CABmn"};
  std::vector<Writing> all;
  for (std::size_t k = 0; k < std::max<std::size_t>(q.order.said.size(), 7); ++k)
    all.push_back({k % q.order.said.size(), k / 2,
                   q.top ? letters[k % 4] : letters[k % 3 == 2 ? 0 : 3], q.top ? k % 3 : 0,
                   q.top && k % 2 == 1});
  for (const char* opposite : {"P", "QX", "PQR"})
    all.push_back({.opposite = opposite});
  return all;
}

namespace detail {

inline std::string replaced(const std::string& text, const std::string& from, const std::string& to,
                            const std::string& opposite) {
  std::string result;
  for (const char c : text) {
    const std::size_t at = from.find(c);
    const std::string name(1, at == std::string::npos ? c : to[at]);
    result += opposite.find(c) == std::string::npos ? name : "(-" + name + ")";
  }
  return result;
}
// M1 -> M2 -> M3 -> M1, and G: a rotation.
inline std::string turned(std::string text, std::size_t by) {
  for (std::size_t i = 1; i < text.size(); ++i)
    if ((text[i - 1] == 'M' || text[i - 1] == 'G') && text[i] >= '1' && text[i] <= '3')
      text[i] = static_cast<char>('1' + (text[i] - '1' + static_cast<int>(by)) % 3);
  return text;
}

} // namespace detail

/// The file.
inline std::string text_of(const Question& q, const Writing& w) {
  const auto named = [&](const std::string& text) {
    return detail::replaced(text, "PQRXZ", w.letters, w.opposite);
  };
  const auto letter = [&](char name) {
    return std::string(1, w.letters[std::string("PQRXZ").find(name)]);
  };
  std::string parameters, conditions, words;
  auto said = q.order.said.at(w.order);
  std::rotate(said.begin(), said.begin() + static_cast<long>(w.first % said.size()), said.end());
  for (const std::string& one : q.besides) {
    if (one.ends_with(" real"))
      words += letter(one.front()) + " = 'real'\n";
    else
      said.push_back(one);
  }
  std::string used = q.hamiltonian;
  for (const std::string& one : said) {
    conditions += (conditions.empty() ? "'" : ", '") + named(one) + "'";
    used += one;
  }
  for (const char name : std::string("PQRXZ"))
    if (used.find(name) != std::string::npos)
      parameters += (parameters.empty() ? "'" : ", '") + letter(name) + "'";
  std::string text = "[system]\nkind = '" + std::string(q.top ? "euler-poisson" : "hamiltonian") +
                     "'\ncoordinates = ";
  text += q.top ? "['M1', 'M2', 'M3', 'G1', 'G2', 'G3']\n" : "['x', 'y']\nmomenta = ['u', 'v']\n";
  text += "parameters = [" + parameters + "]\nhamiltonian = '" +
          detail::turned(named(q.hamiltonian), w.turn) + "'\n[assume]\n" + words +
          "conditions = [" + conditions + "]\n";
  if (w.blocks)
    text += "[[casimir]]\nname = 'F1'\nvalue = 'G1^2 + G2^2 + G3^2'\n[[casimir]]\nname = 'F2'\n"
            "value = 'M1*G1 + M2*G2 + M3*G3'\n[[integral]]\nname = 'H'\n";
  return text;
}

} // namespace kov::test
