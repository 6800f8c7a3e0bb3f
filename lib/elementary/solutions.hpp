#pragma once
// The answer to a linear equation of the second order with a right side and initial values, and to a Riccati equation.
// whole.hpp puts each of them into the given equation.

#include "elementary/homogeneous.hpp"
#include "elementary/read.hpp"

#include <optional>
#include <string>
#include <vector>

namespace kov::elementary {

/// One solution of the whole equation: by undetermined coefficients where the coefficients are rational, else by
/// variation of constants, which may leave integrals.  basis: of the homogeneous equation, where it is known.
/// Given   const auto letters = std::make_shared<Letters>("x", std::vector<std::string>{"s"});
/// Given   const auto particular = [&](const char* s) {
///             const LinearEquation e = linear_equation(parse_expression(s, "e", true), "y", letters); return
///             text(*particular_solution(e, homogeneous_basis(e))); };
/// Example particular("y'' - s*y = -1")  // -> 1/s
/// Example particular("x^2*y'' - 3*x*y' + 4*y = x^2*log(x)")  // -> x^2*log(x)^3/6
[[nodiscard]] std::optional<Element> particular_solution(const LinearEquation& equation,
                                                         const std::optional<Basis>& basis);
/// Polynomials in the parameters: where one of them is 0 the two solutions may be dependent.
[[nodiscard]] std::vector<std::string> dependent_where(const Basis& basis);
/// characteristic_basis, where the coefficients are rational functions; 1 and an integral for y'' + p y' = 0, where they
/// are not.
[[nodiscard]] std::optional<Basis> homogeneous_basis(const LinearEquation& equation);

/// y^(order)(point) = value
struct InitialValue {
  Element point;
  long order = 0;
  Element value;
};
/// "y'(0) = 1".  Throws NotElementary for other conditions.
[[nodiscard]] InitialValue initial_value(const Expression& condition, const std::string& unknown,
                                         const LettersPtr& letters);

/// The function c1 y1 + c2 y2 + particular with these values, or why there is none.
struct WithValues {
  std::optional<Element> y{};
  std::string missing{};
  std::optional<Element> start{}; ///< of each integral in y
};
/// Given   const LinearEquation oscillator = linear_equation(parse_expression("y'' + 4*y = 0", "e", true), "y", letters);
/// Given   const auto at_0 = [&](const char* s) { return initial_value(parse_expression(s, "c", true), "y", letters); };
/// Example text(*with_values(*homogeneous_basis(oscillator), Element(letters), {at_0("y(0) = 1"), at_0("y'(0) = 0")}).y)
///         // -> cos(2*x)
[[nodiscard]] WithValues with_values(const Basis& basis, const Element& particular,
                                     const std::vector<InitialValue>& values);

/// exp(-int c0/c1) and one solution of the whole equation, of the first order; both may leave integrals.
struct FirstOrderSolutions {
  Element homogeneous, particular;
};
/// Given   const auto first = [&](const char* s) {
///             return first_order_solutions(linear_equation(parse_expression(s, "e", true), "y", letters)); };
/// Example text(first("y' = x*y").homogeneous)  // -> exp(x^2/2)
/// Example text(first("x*y' = y + x^2").particular)  // -> x^2
/// Throws  NotElementary
[[nodiscard]] FirstOrderSolutions first_order_solutions(const LinearEquation& equation);
/// homogeneous c + particular with one value.
[[nodiscard]] WithValues with_value(const FirstOrderSolutions& solutions,
                                    const InitialValue& value);

/// y' = a y^2 + b y + c by the equation for u, y = -u'/(a u).
struct RiccatiSolutions {
  std::vector<Element> special; ///< rational or algebraic
  Element general;              ///< with the letter of the constant
};
/// a; basis: of the equation for u; constant: a letter of the ring.  Throws NotElementary.
[[nodiscard]] RiccatiSolutions riccati_solutions(const Element& a, const Basis& basis,
                                                 const std::string& constant);
/// The solution with one value.
[[nodiscard]] WithValues riccati_with_value(const Element& a, const Basis& basis,
                                            const InitialValue& value);

} // namespace kov::elementary
