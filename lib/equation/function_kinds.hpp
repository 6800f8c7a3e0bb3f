#pragma once
// The functions of one variable that the coefficients of a typed equation may have.

#include "exact/multivariate.hpp"
#include "symbol/expression.hpp"

#include <string>

namespace kov {

enum class FunctionFamily : std::uint8_t { circular, hyperbolic, root };

/// sin(2*x), exp(-x), sqrt(x), x^(3/2)
struct CoefficientFunction {
  Expression e;
  FunctionFamily family = FunctionFamily::root;
  std::string name{};   ///< sin, ...; "" for a root
  Rational multiple{1}; ///< of the common argument; of a root: its exponent
};

/// Is e itself such a function?
[[nodiscard]] bool is_function_of(const Expression& e, const std::string& x);
/// Requires is_function_of.   Errors  InputError: more than one argument
/// Example function_of(parse_expression("sech(x)", "-e")).name  // -> sech
[[nodiscard]] CoefficientFunction function_of(const Expression& e);
/// From the cosine and the sine of its argument, or the hyperbolic ones; exp is what stands for the cosine.
/// Errors  InputError: it has no value there
[[nodiscard]] MFraction value_of(const CoefficientFunction& f, const MFraction& cos,
                                 const MFraction& sin);

} // namespace kov
