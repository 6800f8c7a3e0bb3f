#pragma once
// The function field R of a phase curve as a tower K(z)[w_1, ..., w_k]/(w_i^d_i - v_i), whose
// generators w_i are coordinates and functions: the form in which certificates have it
// (docs/theory/system_certificates.md, C1).

#include "algebraize/function_field.hpp"

#include <optional>

namespace kov {

class Tower {
public:
  struct Step {
    std::size_t variable = 0; ///< of the ring
    std::size_t degree = 2;
  };
  using Exponents = std::vector<unsigned long>; ///< by step

  /// Unset where R is not free over K(z)[w_1, ..., w_i] for some i: several components, of different
  /// degrees.   Cost  linear systems of the size of R   Errors  OutOfBudget
  [[nodiscard]] static std::optional<Tower> make(const FunctionField& f);

  [[nodiscard]] const std::vector<Step>& steps() const noexcept { return steps_; }
  /// The monomials of the basis; their exponents are below the degrees.
  [[nodiscard]] const std::vector<Exponents>& monomials() const noexcept { return monomials_; }
  /// Coordinates of an element in that basis.
  [[nodiscard]] std::vector<MFraction> coordinates(const FunctionField::Element& a) const;

private:
  using Element = FunctionField::Element;
  bool adjoin(const FiniteAlgebra& r, std::size_t variable);
  bool change_basis(const FiniteAlgebra& r);

  std::vector<Step> steps_;
  std::vector<Exponents> monomials_;
  std::vector<Element> basis_;
  std::vector<std::vector<MFraction>> columns_; ///< the basis of R in this one
};

} // namespace kov
