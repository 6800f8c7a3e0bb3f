#pragma once
// The function field of a phase curve over K = Q(parameters)(z), z = phi(x), with d/dz.
//
// R = K[x]/(curve, den(phi) z - num(phi)), saturated by den(phi): of dimension 0 over K, because z
// is not constant on the curve.  The field gives x_i' in R, z' = X(phi), and d/dz = (1/z') d/dt.  R
// is a finite extension of K (a field if the curve is irreducible), which is the hypothesis of the
// theorem that the identity component of the differential Galois group does not change when the
// equation is written in z (docs/theory/mechanics.md (6); [MoralesRamis2001] I, 2.2; [AcostaBlazquez2008]).

#include "exact/finite_algebra.hpp"
#include "manifold/invariant_manifold.hpp"

#include <variant>

namespace kov {

/// Why a change of variable cannot be used.
struct ChangeFailure {
  std::string message;
  /// If r lies in K(z, w), w^2 of degree at most 2 in z with a point: a change that parametrizes
  /// this extension, as a function on the phase space.
  std::optional<MFraction> better{};
};

class FunctionField {
public:
  using Element = FiniteAlgebra::Element;

  /// `divisors`: functions that the reduction divided by; each must be a unit, or the components of
  /// the curve on which it vanishes are left out.
  [[nodiscard]] static std::variant<FunctionField, ChangeFailure>
  make(const VectorField& v, const InvariantManifold& m, std::size_t z, const MFraction& phi,
       const std::vector<MPoly>& divisors, const Budget& budget = {}, std::size_t max_degree = 200);

  [[nodiscard]] const FiniteAlgebra& algebra() const noexcept { return algebra_; }
  /// [R : K], not counting algebraic constants.
  [[nodiscard]] std::size_t degree() const;

  /// A function on the curve; unset where its denominator is not a unit.
  [[nodiscard]] std::optional<Element> evaluate(const MFraction& f) const {
    return algebra_.evaluate(f);
  }
  [[nodiscard]] const Element& z_dot() const noexcept { return z_dot_; }
  [[nodiscard]] const Element& z_ddot() const noexcept { return z_ddot_; }
  [[nodiscard]] const Element& inverse_z_dot() const noexcept { return inverse_z_dot_; }
  [[nodiscard]] Element derivative(const Element& a) const; ///< d/dz
  /// The element as a function of z, the parameters and the algebraic constants, if it is one.
  [[nodiscard]] std::optional<MFraction> in_z(const Element& a) const;
  /// For messages: the element in the variables of the system and z.
  [[nodiscard]] MFraction lift(const Element& a) const { return algebra_.lift(a); }
  /// Polynomials in the parameters and z that are not zero in K and were divided by.
  [[nodiscard]] const std::vector<MPoly>& inverted() const { return algebra_.ideal().inverted(); }
  /// Functions on the curve that are units here: components on which one vanishes are lost.
  [[nodiscard]] const std::vector<MPoly>& divided_by() const noexcept { return divided_by_; }

private:
  FunctionField(FiniteAlgebra algebra, std::size_t z) : algebra_(std::move(algebra)), z_(z) {}
  [[nodiscard]] std::optional<ChangeFailure> find_derivatives(const VectorField& v,
                                                              const MFraction& phi);

  FiniteAlgebra algebra_;
  std::size_t z_;
  std::vector<MPoly> divided_by_;
  std::vector<bool> constant_basis_;      ///< basis monomials in algebraic constants only
  std::vector<Element> basis_derivative_; ///< d/dz of the basis
  Element z_dot_, z_ddot_, inverse_z_dot_;
};

} // namespace kov
