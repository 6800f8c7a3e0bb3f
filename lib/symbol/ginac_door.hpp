#pragma once
// The door to GiNaC, for proof scripts that hold their formulas as GiNaC expressions and for second
// opinions.  The pipeline itself works on exact FLINT values; GiNaC's printing order, its is_zero
// and its floating point never decide anything.

#include "symbol/expression.hpp"

#include <ginac/ginac.h>
#include <map>
#include <string>

namespace kov {

/// One GiNaC symbol for each name: two symbols of the same name would be different variables.
class SymbolTable {
public:
  [[nodiscard]] const GiNaC::symbol& operator[](const std::string& name) {
    return symbols_.try_emplace(name, name).first->second;
  }

private:
  std::map<std::string, GiNaC::symbol> symbols_;
};

/// The tree of a formula as a GiNaC expression.  I is GiNaC's I; sqrt, sin, cos, exp are GiNaC's.
/// Errors  InputError for what has no meaning there: primes, equations, decimals, other functions
[[nodiscard]] GiNaC::ex to_ginac(const Expression& formula, SymbolTable& symbols);

/// The text of a GiNaC expression in our grammar, fully parenthesized; parse_expression reads it
/// back.
/// Errors  InvalidArgument for inexact numbers and for functions other than sqrt, sin, cos, exp
/// Given   SymbolTable symbols;
/// Given   const GiNaC::ex f = to_ginac(parse_expression("x^3 + a", "f"), symbols);
/// Example to_formula(f.diff(symbols["x"]))  // -> ((x^(2))*(3))
[[nodiscard]] std::string to_formula(const GiNaC::ex& expression);

} // namespace kov
