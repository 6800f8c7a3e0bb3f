#pragma once
// Formulas of ours in the notation of another program, and the names in them.

#include <map>
#include <optional>
#include <set>
#include <string>

namespace kov::cli {

enum class Program : std::uint8_t { sympy, maxima, maple, mathematica, sage };

/// What --format names; nothing for text, json and tex.
[[nodiscard]] std::optional<Program> program_of(const std::string& format);

/// The names of a script: those of the question, which keep their letters unless the program has
/// them for itself, and those that the script brings in, which are others.
class ProgramNames {
public:
  /// question: every name in its formulas
  ProgramNames(Program program, const std::set<std::string>& question);

  /// A name of the question: lambda -> lambda_ in Python, E -> E0 in Mathematica.
  [[nodiscard]] std::string operator()(const std::string& name) const;
  /// A name of the script's own: r -> r_ where the question has an r.
  [[nodiscard]] std::string own(const std::string& name) const;

private:
  Program program_;
  std::map<std::string, std::string> names_;
  std::set<std::string> used_;
};

/// A formula of ours in the program's notation; `variable` is what its integrals are over.
/// Errors  InputError for what is not a formula of ours
[[nodiscard]] std::string program_formula(const std::string& formula, const std::string& variable,
                                          Program program, const ProgramNames& names);

/// "**" or "^"
[[nodiscard]] const char* power_sign(Program program);

} // namespace kov::cli
