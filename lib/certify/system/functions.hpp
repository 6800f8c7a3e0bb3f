#pragma once
// Sums and products of functions, counted, and polynomials over numbers: theorem_certificates.md 3,
// system_certificates.md 3.

#include "certify/equation/facts.hpp"
#include "certify/system/check.hpp"
#include "proof/algebra/arithmetic.hpp"

namespace kov::certify {

/// An algebra Own of functions F, a polynomial over a number each, as far as it is known by `plus` and `times`.
template <class Own, class F> class Algebra {
public:
  using Row = std::vector<F>;
  using Values = std::vector<std::optional<F>>; ///< by variable

  Algebra(Ring ring, Arithmetic& a) : ring_(std::move(ring)), a_(a) {}

  [[nodiscard]] const Ring& ring() const { return ring_; }
  [[nodiscard]] Arithmetic& arithmetic() const { return a_; }
  [[nodiscard]] F zero() const { return {MPoly(ring_), {1}}; }
  [[nodiscard]] F one() const { return integer(1); }
  [[nodiscard]] F integer(const Integer& n) const { return {MPoly(ring_, n), {1}}; }
  [[nodiscard]] F variable(std::size_t i) const { return {MPoly::variable(ring_, i), {1}}; }
  /// By variable: itself.
  [[nodiscard]] Values variables() const {
    Values all;
    for (std::size_t i = 0; i < ring_->size(); ++i)
      all.emplace_back(variable(i));
    return all;
  }

  [[nodiscard]] static F over(F f, const Integer& n) { return f.n = f.n * n, f; }
  [[nodiscard]] static F negative(F f) { return f.p = -f.p, f; }
  [[nodiscard]] F minus(const F& f, const F& g) const { return own().plus(f, negative(g)); }
  [[nodiscard]] F power(const F& f, unsigned long e) const {
    F r = one();
    for (; e > 0; --e)
      r = own().times(r, f);
    return r;
  }
  /// sum of a_j b_j
  [[nodiscard]] F dot(const Row& a, const Row& b) const {
    F sum = zero();
    for (std::size_t i = 0; i < a.size(); ++i)
      if (!is_zero(a[i].p) && !is_zero(b[i].p)) sum = own().plus(sum, own().times(a[i], b[i]));
    return sum;
  }
  /// A polynomial whose variables have these values; refuses a variable without one.
  [[nodiscard]] F evaluate(const MPoly& f, const Values& at) const {
    return is_zero(f) ? zero() : evaluate(f, used_variables(f), at);
  }

private:
  [[nodiscard]] const Own& own() const { return static_cast<const Own&>(*this); }
  // By powers of one variable after the other; at the end f is a number.
  [[nodiscard]] F evaluate(const MPoly& f, std::vector<std::size_t> order, const Values& at) const {
    if (order.empty()) return integer(f.coefficient(0));
    const std::size_t x = order.back();
    order.pop_back();
    need(x < at.size() && at[x].has_value(), "a name without a value is used");
    const auto all = coefficients(f, x);
    F sum = is_zero(all[0]) ? zero() : evaluate(all[0], order, at), power = *at[x];
    for (std::size_t k = 1; k < all.size(); ++k) {
      if (k > 1) power = own().times(power, *at[x]);
      if (!is_zero(all[k])) sum = own().plus(sum, own().times(evaluate(all[k], order, at), power));
    }
    return sum;
  }

  Ring ring_;
  Arithmetic& a_;
};

/// Polynomials over numbers, never reduced.
class Functions : public Algebra<Functions, PhaseFunction> {
public:
  using Algebra::Algebra;

  [[nodiscard]] PhaseFunction times(const PhaseFunction& a, const PhaseFunction& b) const {
    if (is_zero(a.p) || is_zero(b.p)) return zero();
    return {arithmetic().times(a.p, b.p), arithmetic().times(a.n, b.n)};
  }
  [[nodiscard]] PhaseFunction plus(const PhaseFunction& a, const PhaseFunction& b) const {
    if (is_zero(a.p)) return b;
    if (is_zero(b.p)) return a;
    const Integer n = arithmetic().common_multiple(a.n, b.n);
    const auto raised = [&](const PhaseFunction& f) {
      return arithmetic().scaled(f.p, exact_div(n, f.n));
    };
    return {arithmetic().plus(raised(a), raised(b)), n};
  }
  /// f with images of its variables.
  [[nodiscard]] PhaseFunction composed(const PhaseFunction& f, const Values& images) const {
    PhaseFunction g = evaluate(f.p, images);
    if (!is_zero(f.p)) g.n = arithmetic().times(g.n, f.n);
    return g;
  }
};

/// f h^D, D the degree in u = 1/h, as a polynomial without u.
[[nodiscard]] inline MPoly without_inverse(const MPoly& f, std::size_t u, const MPoly& h,
                                           Arithmetic& a) {
  MPoly sum(f.ring());
  for (const MPoly& c : coefficients(f, u)) // ((c_0 h + c_1) h + c_2) ...
    sum = a.plus(a.times(sum, h), c);
  return sum;
}

} // namespace kov::certify
