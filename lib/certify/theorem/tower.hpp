#pragma once
// Polynomials in names to which roots and inverses are adjoined: theorem_certificates.md 3.

#include "certify/system/functions.hpp"

#include <algorithm>
#include <array>

namespace kov::certify {

/// u = 1/inverse of, or a root of `square`.
struct AdjoinedName {
  std::size_t variable = 0;
  std::optional<PhaseFunction> square;
  MPoly inverse_of;
};

/// even and odd of f = even + odd r, r^2 = the square, each times the same number.
[[nodiscard]] inline std::array<MPoly, 2> halves(const MPoly& f, std::size_t r,
                                                 const PhaseFunction& square, Arithmetic& a) {
  std::array<MPoly, 2> sum{MPoly(f.ring()), MPoly(f.ring())};
  Integer lift(1);
  Coefficients c = coefficients(f, r);
  c.resize(c.size() + c.size() % 2, MPoly(f.ring()));
  for (std::size_t j = c.size(); j-- > 0;) {
    sum[j % 2] = a.plus(a.times(sum[j % 2], square.p), a.scaled(c[j], lift));
    if (j % 2 == 0) lift = a.times(lift, square.n);
  }
  return sum;
}

class Tower {
public:
  explicit Tower(Arithmetic& a) : a_(a) {}

  void adjoin(AdjoinedName name) { steps_.push_back(std::move(name)); }
  [[nodiscard]] bool has_roots() const {
    return std::ranges::any_of(steps_, [](const AdjoinedName& x) { return x.square.has_value(); });
  }
  [[nodiscard]] const std::vector<AdjoinedName>& steps() const { return steps_; }
  /// Is f cleared to 0?
  [[nodiscard]] bool clears(const PhaseFunction& f) const { return clears(f.p, steps_.size()); }
  /// f times all that its inverses need, if there are no roots.
  [[nodiscard]] MPoly cleared(MPoly f) const {
    for (auto u = steps_.rbegin(); u != steps_.rend(); ++u)
      f = without_inverse(f, u->variable, u->inverse_of, a_);
    return f;
  }

private:
  [[nodiscard]] bool clears(MPoly f, std::size_t steps) const {
    while (!is_zero(f) && steps > 0) {
      const AdjoinedName& x = steps_[--steps];
      if (!uses(f, x.variable)) continue;
      if (!x.square) {
        f = without_inverse(f, x.variable, x.inverse_of, a_);
        continue;
      }
      const auto [even, odd] = halves(f, x.variable, *x.square, a_);
      return clears(even, steps) && clears(odd, steps);
    }
    return is_zero(f);
  }

  Arithmetic& a_;
  std::vector<AdjoinedName> steps_;
};

} // namespace kov::certify
