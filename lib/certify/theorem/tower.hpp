#pragma once
// Polynomials in names to which roots and inverses are adjoined: theorem_certificates.md 3.

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

/// u = 1/inverse of, or a root of `square`.
struct AdjoinedName {
  std::size_t variable = 0;
  std::optional<PhaseFunction> square;
  MPoly inverse_of;
};

class Tower {
public:
  explicit Tower(const Functions& f) : f_(f) {}

  void adjoin(AdjoinedName name) { steps_.push_back(std::move(name)); }
  [[nodiscard]] bool has_roots() const;
  [[nodiscard]] const std::vector<AdjoinedName>& steps() const { return steps_; }
  /// Is f cleared to 0?
  [[nodiscard]] bool clears(const PhaseFunction& f) const { return clears(f.p, steps_.size()); }

private:
  [[nodiscard]] bool clears(MPoly f, std::size_t steps) const;
  /// sum c[j] square^(j/2) over j = first, first + 2, ..., times a number
  [[nodiscard]] MPoly half(const Coefficients& c, std::size_t first,
                           const PhaseFunction& square) const;
  [[nodiscard]] MPoly without_inverse(const MPoly& f, const AdjoinedName& u) const;

  Functions f_;
  std::vector<AdjoinedName> steps_;
};

} // namespace kov::certify
