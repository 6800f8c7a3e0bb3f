#pragma once
// L = K(I), I' = u in K = C(z), u no derivative in K: I is transcendental, and the primitive of an
// element of K[I] that lies in L lies in K[I].
//
// Source  docs/theory/quadratures.md (1); Bronstein, Symbolic Integration I, 5.3 and 5.8

#include "exact/budget.hpp"
#include "exact/rational_function.hpp"

#include <optional>
#include <vector>

namespace kov {

/// f = derivative of `rational` + `poles`, the latter proper with simple poles (Hermite).
struct HermiteParts {
  RationalFunction rational, poles;
};
/// Example hermite_parts(RationalFunction(z + 1, z*z)).rational  // -> -1/z
/// Example hermite_parts(RationalFunction(z + 1, z*z)).poles  // -> 1/z
[[nodiscard]] HermiteParts hermite_parts(const RationalFunction& f, const Budget& budget = {});

class PrimitiveExtension {
public:
  /// sum f_j I^j, ascending, the last one not 0; empty: 0.
  using Element = std::vector<RationalFunction>;

  /// Unset: u is a derivative in K.
  /// Given   const auto log = *PrimitiveExtension::make(RationalFunction(1, z));
  /// Example PrimitiveExtension::make(z).has_value()  // -> no
  [[nodiscard]] static std::optional<PrimitiveExtension> make(const RationalFunction& u,
                                                              const Budget& budget = {});
  /// K itself: there is no I yet.
  /// Example PrimitiveExtension::none().primitive({RationalFunction(1, z)}).has_value()  // -> no
  [[nodiscard]] static PrimitiveExtension none() { return {RationalFunction(0), {}}; }
  [[nodiscard]] bool is_none() const noexcept { return is_zero(u_); }
  [[nodiscard]] const RationalFunction& u() const noexcept { return u_; }

  /// Example log.derivative({0, 1})  // -> {1/z}
  [[nodiscard]] Element derivative(const Element& f) const; ///< d/dz
  /// g with g' = f, without a constant; unset: there is none in L, and at `level` that is seen.
  /// Example log.primitive({0, RationalFunction(1, z)})->size()  // -> 3
  /// Example log.primitive({0, RationalFunction(1, z - 1)}).has_value()  // -> no
  [[nodiscard]] std::optional<Element> primitive(const Element& f, const Budget& budget = {},
                                                 std::size_t* level = nullptr) const;

private:
  PrimitiveExtension(RationalFunction u, HermiteParts parts)
      : u_(std::move(u)), parts_(std::move(parts)) {}
  RationalFunction u_;
  HermiteParts parts_;
};

/// d/dI, the Lie algebra of the group of L over K.
[[nodiscard]] PrimitiveExtension::Element by_the_primitive(const PrimitiveExtension::Element& f);
[[nodiscard]] PrimitiveExtension::Element operator+(const PrimitiveExtension::Element& a,
                                                    const PrimitiveExtension::Element& b);
[[nodiscard]] PrimitiveExtension::Element operator*(const PrimitiveExtension::Element& a,
                                                    const PrimitiveExtension::Element& b);
[[nodiscard]] PrimitiveExtension::Element operator*(const RationalFunction& c,
                                                    PrimitiveExtension::Element f);

} // namespace kov
