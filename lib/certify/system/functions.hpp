#pragma once
// Polynomials over numbers: theorem_certificates.md 3, system_certificates.md 3.

#include "certify/system/certificate.hpp"
#include "proof/algebra/arithmetic.hpp"

namespace kov::certify {

/// Sums and products of polynomials over numbers, counted.
class Functions {
public:
  Functions(Ring ring, Arithmetic& a) : ring_(std::move(ring)), a_(a) {}

  [[nodiscard]] const Ring& ring() const { return ring_; }
  [[nodiscard]] Arithmetic& arithmetic() const { return a_; }
  [[nodiscard]] PhaseFunction zero() const { return {MPoly(ring_), Integer(1)}; }
  [[nodiscard]] PhaseFunction one() const { return {MPoly(ring_, Integer(1)), Integer(1)}; }
  [[nodiscard]] PhaseFunction variable(std::size_t i) const {
    return {MPoly::variable(ring_, i), Integer(1)};
  }
  [[nodiscard]] PhaseFunction times(const PhaseFunction& a, const PhaseFunction& b) const;
  [[nodiscard]] PhaseFunction plus(const PhaseFunction& a, const PhaseFunction& b) const;
  /// sum of a_j b_j
  [[nodiscard]] PhaseFunction product(const std::vector<PhaseFunction>& a,
                                      const std::vector<PhaseFunction>& b) const;
  [[nodiscard]] PhaseFunction minus(const PhaseFunction& a, const PhaseFunction& b) const;
  /// f with images of its variables, by their index; refuses a variable without one.
  [[nodiscard]] PhaseFunction
  composed(const PhaseFunction& f, const std::vector<std::optional<PhaseFunction>>& images) const;

private:
  [[nodiscard]] PhaseFunction put(const MPoly& f, std::vector<std::size_t> order,
                                  const std::vector<std::optional<PhaseFunction>>& images) const;

  Ring ring_;
  Arithmetic& a_;
};

/// f h^D, D the degree in u = 1/h, as a polynomial without u.
[[nodiscard]] MPoly without_inverse(const MPoly& f, std::size_t u, const MPoly& h, Arithmetic& a);

} // namespace kov::certify
