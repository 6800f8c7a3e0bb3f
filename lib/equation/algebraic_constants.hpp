#pragma once
// Constants outside Q beside parameters: I, square roots of integers, the root of a polynomial.
// They become parameters with an assumed equation, which lib/strata keeps as a relation: I with
// I^2 = -1, and sqrt(p) for each prime p in a square root, so that they are independent
// (sqrt(-12) is 2*I*sqrt(3)).  So do square roots of functions of the parameters: sqrt(N - 1), with
// N = sqrt(N - 1)^2 + 1.
//
// The result holds for every choice of the roots (I and -I, both square roots, all roots of the
// polynomial): a little more than was asked.  The root of what is assumed to be positive is positive.

#include "equation/read_equation.hpp"
#include "parameters/conditions.hpp"
#include "system/formula.hpp"

namespace kov {

class AlgebraicConstants {
public:
  /// The constants in the formulas.  Unset: root(...); a square root of something that is neither an
  /// integer nor a function of the parameters, or with a prime factor above 10^6; the root of a
  /// polynomial beside other constants.
  /// Given   EquationText text;
  /// Given   text.r = parse_expression("sqrt(-12)*z + a", "r"), text.parameters = {"a"};
  /// Example AlgebraicConstants::in(text)->names().size()  // -> 2
  [[nodiscard]] static std::optional<AlgebraicConstants> in(const EquationText& text);

  [[nodiscard]] std::vector<std::string> names() const; ///< as variables of the ring
  /// The meaning of sqrt(n) in a formula.
  [[nodiscard]] std::vector<FunctionMeaning> functions(const Ring& ring) const;
  /// I^2 + 1 = 0, ...
  void assume(Assumptions& all, const Scope& scope) const;
  /// The root of what is positive by these assumptions is meant to be the positive one.
  void assume_signs(Assumptions& all, const Scope& scope) const;
  /// The same value with the powers that the equations allow to lower.  Throws DomainError when the
  /// denominator is 0.
  [[nodiscard]] MFraction reduced(const MFraction& f, const Scope& scope) const;

private:
  /// sqrt(n) = factor * (I if imaginary) * the roots of these primes
  struct SquareRoot {
    Integer n, factor{1};
    bool imaginary = false;
    std::vector<Integer> primes;
  };
  struct ParameterRoot {
    Expression argument;
    std::string name; ///< sqrt(...), of the ring
  };
  bool collect(const Expression& e, const EquationText& text);
  bool collect_root(const Expression& argument, const EquationText& text);
  static std::optional<SquareRoot> square_root(const Integer& n);
  [[nodiscard]] std::vector<Integer> primes() const;
  [[nodiscard]] std::vector<std::pair<std::size_t, MPoly>> equations(const Scope& scope) const;

  bool i_ = false;
  std::vector<SquareRoot> square_roots_;
  std::vector<ParameterRoot> parameter_roots_;
  std::optional<Expression> minpoly_;
};

} // namespace kov
