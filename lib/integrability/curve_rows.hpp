#pragma once
// Rows of functions on a phase curve, and how the variational equation moves them.

#include "algebraize/function_field.hpp"

namespace kov {

/// Linear algebra along a phase curve, in its function field.
class CurveRows {
public:
  using Element = FunctionField::Element;
  using Row = std::vector<Element>;

  /// Errors  DomainError: something in the field's derivatives has no value on the curve
  CurveRows(const VectorField& v, const FunctionField& f);

  [[nodiscard]] Row gradient(const MFraction& f) const;
  [[nodiscard]] Row nabla(const Row& a) const; ///< D a + T a J
  [[nodiscard]] Element value(const MFraction& f) const;
  [[nodiscard]] Element times(const Element& a, const Element& b) const {
    return f_.algebra().multiply(a, b);
  }
  /// a x for the bracket matrix, or a where there is none.
  [[nodiscard]] Row through_bracket(const Row& a) const;
  /// c with sum c_i rows_i = target; unset if there are none, or a pivot is a zero divisor.
  [[nodiscard]] std::optional<Row> combination(const std::vector<Row>& rows,
                                               const Row& target) const;
  /// x with rows x = right; free unknowns are 0.
  [[nodiscard]] std::optional<Row> solve(std::vector<Row> rows, Row right) const;
  [[nodiscard]] Element constant(long c) const;

private:
  const VectorField& v_;
  const FunctionField& f_;
  std::vector<Row> jacobian_;
  std::vector<Row> bracket_;
};

} // namespace kov
