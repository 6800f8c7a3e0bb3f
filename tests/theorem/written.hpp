#pragma once
// Small theorem files, and theorems that a classification has written.

#include "classify/classify.hpp"
#include "support/own_folder.hpp"
#include "theorem/goals.hpp"
#include "theorem/prove.hpp"

#include <fstream>
#include <string>
#include <vector>

namespace kov::test {

inline void write(const std::string& name, const std::string& text) {
  std::ofstream(test::own_folder() + name) << text;
}
inline Theorem theorem(const std::string& text) {
  return read_theorem(parse_document("format = \"theorem/1\"\ntitle = \"T\"\n" + text,
                                     test::own_folder() + "laws.toml"));
}
inline const NodeResult& root(const TheoremResult& r) { return r.nodes.front(); }

inline std::string planar(const std::string& hamiltonian, const std::string& more) {
  return "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
         "parameters = ['a', 'h']\nhamiltonian = '" +
         hamiltonian + "'\n" + more;
}
inline const std::string even = "(u^2 + v^2 + x^2 + y^2)/2 + a*x^2*y^2";
inline const std::string axis =
    "[[manifold]]\nname = 'N'\nequations = ['x = 0', 'u = 0']\nlevel = ['H = h']\n";

inline std::string quoted(const std::vector<std::string>& all) {
  std::string text;
  for (const std::string& one : all)
    text += (text.empty() ? "\"" : ", \"") + one + "\"";
  return "[" + text + "]";
}

inline TheoremResult proved_again(const Theorem& t) {
  ProveOptions options;
  options.found = true;
  return prove(t, options);
}

struct Found {
  System s;
  SystemClassification c;
  std::string name;
  std::string text; ///< of the theorem's file

  explicit Found(const std::string& system, std::string file = "found.toml", double work = 2e9)
      : name(std::move(file)) {
    write(name, system);
    s = read_system(test::own_folder() + name);
    ClassifyOptions options;
    options.check.decide.budget.give(work);
    options.check.decide.ask_the_judge = true;
    c = classify_system(s, options);
    text = theorem_file(theorem(), name, {});
  }
  /// With what the search has kept for its steps.
  [[nodiscard]] Theorem theorem() const {
    Theorem t = goals(s, c, name);
    t.file = test::own_folder() + "what was found.toml";
    return t;
  }
  [[nodiscard]] Theorem read() const {
    return read_theorem(parse_document(text, test::own_folder() + "what was found.toml"));
  }
};

} // namespace kov::test
