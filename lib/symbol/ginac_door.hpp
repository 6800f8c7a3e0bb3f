#pragma once
// The door to GiNaC, for proof scripts that hold their formulas as GiNaC expressions and for second
// opinions (read_back.hpp).  The pipeline itself works on exact FLINT values; GiNaC's printing order, its is_zero
// and its floating point never decide anything.

#include "symbol/expression.hpp"

#include <ginac/ginac.h>
#include <map>
#include <string>

namespace kov {

/// The meaning of names in formulas: one GiNaC symbol for each (two symbols of the same name would be different
/// variables), or a formula.
class SymbolTable {
public:
  SymbolTable() = default;
  /// values: a name is read as this formula, and so is f(x) for a function f of this name.
  /// variable: by which a prime differentiates.
  explicit SymbolTable(std::map<std::string, Expression> values, std::string variable)
      : values_(std::move(values)), variable_(std::move(variable)) {}

  [[nodiscard]] const GiNaC::symbol& operator[](const std::string& name) {
    return symbols_.try_emplace(name, name).first->second;
  }
  /// The roots root(p, approx) that stand in what was read, by the name of their symbol.
  [[nodiscard]] const std::map<std::string, Expression>& roots() const { return roots_; }

private:
  friend class GinacReader;
  std::map<std::string, Expression> values_, roots_;
  std::string variable_;
  std::map<std::string, GiNaC::symbol> symbols_;
  std::map<std::string, GiNaC::ex> read_; // the values
  GiNaC::exmap slopes_;
};

/// The tree of a formula as a GiNaC expression, with the functions of known_functions.hpp; of an equation left - right.
/// I and pi are GiNaC's; int(f, x) is one function wherever the same f stands, and its derivative is f.
/// Errors  InputError for what has no meaning there: decimals, other functions
[[nodiscard]] GiNaC::ex to_ginac(const Expression& formula, SymbolTable& symbols);

/// A function that GiNaC does not have: its name, a symbol, and its arguments (of four, those that it has: the last one
/// is the variable); of the integrals their number.
DECLARE_FUNCTION_5P(called)

/// The text of a GiNaC expression in our grammar, fully parenthesized; parse_expression reads it
/// back.
/// Errors  InvalidArgument for inexact numbers and for functions other than sqrt, sin, cos, exp
/// Given   SymbolTable symbols;
/// Given   const GiNaC::ex f = to_ginac(parse_expression("x^3 + a", "f"), symbols);
/// Example to_formula(f.diff(symbols["x"]))  // -> ((x^(2))*(3))
[[nodiscard]] std::string to_formula(const GiNaC::ex& expression);

} // namespace kov
