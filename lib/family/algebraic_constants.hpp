#pragma once
// Constants outside Q beside parameters: I, sqrt(2), the root of a polynomial.  Each is one more
// parameter with an assumed equation, which lib/strata keeps as a relation.
//
// What is found holds for every choice of the roots (I and -I, both square roots, all roots of the
// polynomial): a little more than was asked.

#include "equation/read_equation.hpp"
#include "strata/conditions.hpp"
#include "system/formula.hpp"

namespace kov {

class AlgebraicConstants {
public:
  /// The constants in the formulas.  Unset: some root(...) or a square root of something that is
  /// not an integer, or that is a square.
  [[nodiscard]] static std::optional<AlgebraicConstants> in(const EquationText& text);

  [[nodiscard]] std::vector<std::string> names() const; ///< as variables of the ring
  /// What sqrt(n) means in a formula.
  [[nodiscard]] std::vector<FunctionMeaning> functions(const Ring& ring) const;
  /// I^2 + 1 = 0, ...
  void assume(strata::Assumptions& all, const Scope& scope) const;

private:
  bool collect(const Expression& e);
  bool i_ = false;
  std::vector<Integer> square_roots_; ///< of these integers
  std::optional<Expression> minpoly_;
};

} // namespace kov
