#pragma once
// Letters that what we print brings in itself (n in "nu = n + 1/2", F in "F'' = x F", p in "p an
// integer"): the one place that keeps them apart from the names that the question uses.

#include "exact/multivariate.hpp"

#include <map>
#include <set>
#include <string>

namespace kov {

/// Every letter of ours has one name beside a question: itself, or one that the question leaves
/// free (n -> n_1; the variables x and t of standard equations: another of x, t, s).
/// Given   const FreshLetters beside_n({"n", "x"});
/// Example beside_n("n")  // -> n_1
/// Example beside_n("x")  // -> t
/// Example beside_n("m")  // -> m
class FreshLetters {
public:
  /// Beside a question that uses these names.
  explicit FreshLetters(const std::set<std::string>& taken = {});
  /// Beside formulas over this ring.
  explicit FreshLetters(const Ring& ring);

  [[nodiscard]] std::string operator()(const std::string& letter) const;
  /// A text of ours, without names of the question: each letter under its name.
  /// Example beside_n.in("y'' = (n^2 + x) y, a number n")  // -> y'' = (n_1^2 + t) y, a number n_1
  [[nodiscard]] std::string in(const std::string& text) const;
  /// The same for a text in which `mark` stands for the variable of the question.
  [[nodiscard]] std::string in(const std::string& text, const std::string& variable) const;
  static constexpr const char* mark = "\x01"; // a sign that no name has
  /// The letter means the same in the question: it keeps its name.
  void keep(const std::string& letter);

private:
  std::map<std::string, std::string> names_; // of the letters that have another one
};

/// The text with whole names replaced.
/// Example renamed("n + nu", {{"n", "n_1"}})  // -> n_1 + nu
[[nodiscard]] std::string renamed(const std::string& text,
                                  const std::map<std::string, std::string>& names);

/// Every name that stands in the text of a formula, also those of functions.
/// Example names_in_text("n_1*sqrt(z)")  // -> {n_1, sqrt, z}
[[nodiscard]] std::set<std::string> names_in_text(const std::string& formula);

} // namespace kov
