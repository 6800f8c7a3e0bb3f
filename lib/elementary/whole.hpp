#pragma once
// The answer to an equation as it was asked: with its right side, its initial values, or one of the first order in its
// own unknown.

#include "elementary/solutions.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace kov::elementary {

/// An equation as it was asked, where that is more than a linear homogeneous equation of the second order.
struct WholeEquation {
  Expression ode;
  std::string unknown, variable;
  std::vector<Expression> conditions{}; ///< y(0) = 1
  /// y' = a y^2 + ... by the linear equation for u, y = -u'/(a u)
  struct Riccati {
    Expression a, linear;
    std::string unknown; ///< u
  };
  std::optional<Riccati> riccati{};
  /// y = v^exponent, v' + p v = q
  struct Bernoulli {
    Expression linear;
    std::string unknown; ///< v
    Rational exponent;
  };
  std::optional<Bernoulli> bernoulli{};
};

/// In our own notation, each read back and compared with `ode` at points.
struct WholeAnswer {
  std::vector<std::string> special;      ///< Riccati: rational and algebraic solutions
  std::optional<std::string> particular; ///< one solution of the whole equation
  std::optional<std::string> general;    ///< with c1 and c2, or c
  std::optional<std::string> with_values;
  std::string integrals;              ///< where those in the solution with the values start
  std::string no_values;              ///< why the initial values have none
  std::vector<std::string> nonzero{}; ///< of the parameters: these formulas need it
  std::vector<std::string> failed{};  ///< what was withdrawn: an error of ours
};

/// `known`: two solutions of the linear homogeneous equation (for u), where somebody has them; asked only where the
/// characteristic equation does not give them.
/// Given   const auto none = [](const elementary::LettersPtr&) { return std::optional<elementary::Basis>(); };
/// Given   const auto ode = [](const char* s) { return parse_expression(s, "e", true); };
/// Example *whole_answer({ode("y'' + y = tan(x)"), "y", "x"}, none).particular
///         // -> cos(x)*log((1 - sin(x))/(sin(x) + 1))/2
/// Example *whole_answer({ode("y'' + 4*y = 0"), "y", "x", {ode("y(0) = 1"), ode("y'(0) = 0")}}, none).with_values
///         // -> cos(2*x)
/// Example *whole_answer({ode("y' + 2*y = x"), "y", "x"}, none).general  // -> c*exp(-2*x) + (2*x - 1)/4
[[nodiscard]] WholeAnswer
whole_answer(const WholeEquation& equation,
             const std::function<std::optional<Basis>(const LettersPtr&)>& known);

} // namespace kov::elementary
