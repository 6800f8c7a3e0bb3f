#pragma once
// Formulas put together from smaller ones, in the form in which a person would write them: like terms and like powers
// stand once, exp(a) exp(b) is exp(a + b), numbers are reduced.
//
//   sum       c1 T1 + c2 T2 + ...      rational c_i, different T_i
//   product   c B1^e1 B2^e2 ...        different B_i; what has a negative exponent stands below the line
//
// Nothing is expanded, and nothing is decided: two formulas may be equal and look different.

#include "exact/multivariate.hpp"
#include "symbol/expression.hpp"

#include <functional>
#include <map>
#include <optional>

namespace kov::trees {

[[nodiscard]] Expression number(const Rational& c);
[[nodiscard]] Expression name(std::string letter);
[[nodiscard]] Expression call(std::string function, std::vector<Expression> arguments);

/// Given   using namespace trees;
/// Given   const Expression x = name("x");
/// Example written(sum({x, number(2), x}))  // -> 2*x + 2
[[nodiscard]] Expression sum(const std::vector<Expression>& terms);
/// Example written(product({x, power(x, number(Rational(-1, 2)))}))  // -> sqrt(x)
[[nodiscard]] Expression product(const std::vector<Expression>& factors);
/// Branches: exp(a)^b is exp(a b), and (a^b)^c is a^(b c), the same up to a constant factor on each part of the plane.
/// Example written(power(power(x, number(2)), number(Rational(1, 2))))  // -> x
[[nodiscard]] Expression power(const Expression& base, const Expression& exponent);
[[nodiscard]] Expression negative(const Expression& e);
[[nodiscard]] Expression quotient(const Expression& above, const Expression& below);

[[nodiscard]] bool is_number(const Expression& e, const Rational& c);

/// Given   const Ring ring = make_ring({"a", "x"});
/// Given   const MFraction a = MFraction::variable(ring, 0), y = MFraction::variable(ring, 1);
/// Example written(from((a + y) / (Rational(2) * a)))  // -> (a + x)/(2*a)
[[nodiscard]] Expression from(const MFraction& f);
[[nodiscard]] Expression from(const MPoly& f);

/// The tree put together again by the functions above, with other trees for names.
/// Example written(rebuilt(parse_expression("x*(1/x)^(1/2)", "f")))  // -> sqrt(x)
[[nodiscard]] Expression rebuilt(const Expression& e,
                                 const std::map<std::string, Expression>& values = {});

/// e = modulus (real + I imaginary) exp(I angle), of factors exp(a + I b), c^(a + I b), at most one sum with I, and
/// others without I.
struct Phase {
  Expression modulus, real, imaginary, angle;
};
/// Unset where I stands elsewhere, or not at all.
/// Example written(phase_of(rebuilt(parse_expression("x*exp(x + 2*I*x)", "f")))->angle)  // -> 2*x
[[nodiscard]] std::optional<Phase> phase_of(const Expression& e);

/// A short text first.
[[nodiscard]] std::size_t length_of(const Expression& e);

} // namespace kov::trees
