#pragma once
// Polynomials in names to which roots and inverses are adjoined: theorem_certificates.md 3.

#include "certify/system/functions.hpp"

#include <array>

namespace kov::certify {

/// u = 1/inverse of, or a root of `square`.
struct AdjoinedName {
  std::size_t variable = 0;
  std::optional<PhaseFunction> square;
  MPoly inverse_of;
};

/// even and odd of f = even + odd r, r^2 = the square, each times the same number.
[[nodiscard]] std::array<MPoly, 2> halves(const MPoly& f, std::size_t r,
                                          const PhaseFunction& square, Arithmetic& a);

class Tower {
public:
  explicit Tower(const Functions& f) : f_(f) {}

  void adjoin(AdjoinedName name) { steps_.push_back(std::move(name)); }
  [[nodiscard]] bool has_roots() const;
  [[nodiscard]] const std::vector<AdjoinedName>& steps() const { return steps_; }
  /// Is f cleared to 0?
  [[nodiscard]] bool clears(const PhaseFunction& f) const { return clears(f.p, steps_.size()); }
  /// f times all that its inverses need, if there are no roots.
  [[nodiscard]] MPoly cleared(MPoly f) const;

private:
  [[nodiscard]] bool clears(MPoly f, std::size_t steps) const;

  Functions f_;
  std::vector<AdjoinedName> steps_;
};

} // namespace kov::certify
