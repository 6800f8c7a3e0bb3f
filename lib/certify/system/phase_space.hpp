#pragma once
// Polynomials in the phase names with their partial derivatives: system_certificates.md 3.

#include "certify/system/functions.hpp"

#include <functional>

namespace kov::certify {

class PhaseSpace {
public:
  PhaseSpace(const PhaseSystem& s, Arithmetic& a) : s_(s), a_(a), in_(s.ring, a) {}

  /// S1; refuses symbols of other kinds than the rule allows.
  void need_symbols() const;
  /// S2: the field, after the bracket is known to be one of Poisson.
  [[nodiscard]] std::vector<PhaseFunction> field() const;
  /// {x_i, x_j}
  [[nodiscard]] PhaseFunction bracket(std::size_t i, std::size_t j) const;
  /// S3, with what is stated for the relations; refuses `f` with this reason.
  void need_cleared(const PhaseFunction& f, const std::vector<PhaseFunction>& cofactors,
                    const char* why) const;
  /// S4; x: field().
  void need_claim(const ClaimedFunction& c, const std::vector<PhaseFunction>& x) const;

  [[nodiscard]] PhaseFunction partial(const PhaseFunction& f, std::size_t j) const; ///< d_j f
  /// sum of a_j b_j
  [[nodiscard]] PhaseFunction product(const std::vector<PhaseFunction>& a,
                                      const std::vector<PhaseFunction>& b) const {
    return in_.product(a, b);
  }
  /// By variable: those of `over`, and the functions that relations make algebraic over them, one after
  /// the other, by a leading coefficient that is a unit.
  [[nodiscard]] std::vector<bool> algebraic(std::vector<bool> over,
                                            const std::function<bool(const MPoly&)>& is_unit) const;
  /// The coordinates on which function s depends, by variable: those in its gradient, and in those of the
  /// functions there.
  [[nodiscard]] std::vector<bool> arguments(std::size_t s) const;
  /// The entry of the gradient of function s for x_j; null: 0.
  [[nodiscard]] const PhaseFunction* gradient(std::size_t s, std::size_t j) const;

private:
  [[nodiscard]] bool uses_inverses(const MPoly& f) const;
  [[nodiscard]] MPoly cleared(MPoly f) const;
  void need_jacobi() const;
  void need_closed(std::size_t s) const;
  /// sum_l {x_i, x_l} d_l f
  [[nodiscard]] PhaseFunction flow(std::size_t i, const PhaseFunction& f) const;

  const PhaseSystem& s_;
  Arithmetic& a_;
  Functions in_;
};

} // namespace kov::certify
