#pragma once
// R = K(z)[w_1, ..., w_k]/(w_i^(d_i) - v_i) with its derivation D: system_certificates.md C1, C2.
// R is free over K(z), so that an element is 0 exactly if its reduced numerator is.

#include "certify/system/functions.hpp"

#include <algorithm>
#include <set>

namespace kov::certify {

class CurveAlgebra : public Algebra<CurveAlgebra, CurveFunction> {
public:
  /// C1; refuses denominators and a tower that are not of its form.
  CurveAlgebra(const PhaseCurve& c, Arithmetic& a) : Algebra(c.ring, a), c_(c), a_(a) {
    for (const MPoly& d : c.denominators)
      need(!is_zero(d) && depends_on_z_only(d), "C1: a denominator is 0 or no function of z");
    for (std::size_t i = 0; i < c.tower.size(); ++i) {
      const auto& [degree, value, derivative] = c.tower[i];
      need(degree >= 2, "C1: a degree of the tower is below 2");
      for (std::size_t k = 0; k < c.variable(i); ++k)
        need(!uses(value.p, k), "C1: a value of the tower uses a later name");
      need(kov::degree(value.p, c.variable(i)) < static_cast<long>(degree),
           "C1: a value of the tower is not reduced");
    }
  }
  void need_derivation() const { ///< C2
    for (std::size_t i = 0; i < c_.tower.size(); ++i) {
      const TowerStep& step = c_.tower[i];
      const MPoly power = a_.power(MPoly::variable(c_.ring, c_.variable(i)), step.degree - 1);
      const CurveFunction factor{scaled(power, Integer(static_cast<long>(step.degree))), {1}};
      need(equal(times(factor, step.derivative), derivative(step.value)),
           "C2: the derivation does not respect the tower");
    }
  }

  /// The element in its canonical basis, shortened by what is easily seen.
  [[nodiscard]] CurveFunction reduced(CurveFunction f) const {
    for (std::size_t i = c_.tower.size(); i-- > 0;)
      while (is_high(f.p, i))
        f = lowered(f, i);
    return shortened(std::move(f));
  }
  [[nodiscard]] CurveFunction plus(const CurveFunction& f, const CurveFunction& g) const {
    if (is_zero(f.p)) return reduced(g);
    if (is_zero(g.p)) return reduced(f);
    const Integer n = a_.common_multiple(f.n, g.n);
    const Exponents e = combined(f.over, g.over, [](auto a, auto b) { return std::max(a, b); });
    const auto raised = [&](const CurveFunction& x) {
      return a_.times(a_.scaled(x.p, exact_div(n, x.n)),
                      denominator(combined(e, x.over, std::minus())));
    };
    return reduced({a_.plus(raised(f), raised(g)), n, e});
  }
  [[nodiscard]] CurveFunction times(const CurveFunction& f, const CurveFunction& g) const {
    if (is_zero(f.p) || is_zero(g.p)) return zero();
    return reduced({a_.times(f.p, g.p), a_.times(f.n, g.n), sum(f.over, g.over)});
  }
  [[nodiscard]] CurveFunction derivative(const CurveFunction& f) const { ///< D f
    const auto charged = [&](const MPoly& p, std::size_t i) {
      a_.charge(static_cast<double>(p.length()));
      return kov::derivative(p, i);
    };
    CurveFunction d = reduced({charged(f.p, c_.z()), f.n, f.over});
    for (std::size_t i = 0; i < c_.tower.size(); ++i)
      if (const std::size_t w = c_.variable(i); uses(f.p, w))
        d = plus(d, times({charged(f.p, w), f.n, f.over}, c_.tower[i].derivative));
    for (std::size_t k = 0; k < f.over.size(); ++k) { // (1/d^e)' = -e d'/d^(e + 1)
      if (f.over[k] == 0 || !uses(c_.denominators[k], c_.z())) continue;
      Exponents once(k + 1, 0);
      once[k] = 1;
      const MPoly e =
          scaled(charged(c_.denominators[k], c_.z()), -Integer(static_cast<long>(f.over[k])));
      d = plus(d, times(f, {e, {1}, once}));
    }
    return d;
  }
  [[nodiscard]] bool equal(const CurveFunction& f, const CurveFunction& g) const {
    return is_zero(minus(f, g).p);
  }

  /// The determinant of the multiplication by f, times denominators and a number, in z and the parameters: f
  /// has an inverse in R unless it is 0.
  [[nodiscard]] MPoly norm(const CurveFunction& f) const {
    if (depends_on_z_only(f.p)) return f.p;
    CurveRow basis{one()};
    for (std::size_t i = 0; i < c_.tower.size(); ++i) { // the first step changes fastest
      const std::size_t below = basis.size();
      for (std::size_t k = 0; k < (c_.tower[i].degree - 1) * below; ++k)
        basis.push_back(times(basis[k], variable(c_.variable(i))));
    }
    std::vector<std::vector<MPoly>> rows;
    for (const CurveFunction& w : basis)
      by_tower(times(f, w).p, c_.tower.size(), rows.emplace_back());
    return Elimination(a_).determinant(std::move(rows));
  }
  /// Is the norm not 0 for all z wherever no denominator is, and none of these?
  [[nodiscard]] bool is_unit(MPoly norm, const std::vector<MPoly>& where) const {
    for (const auto* all : {&c_.denominators, &where})
      for (const MPoly& given : *all) {
        if (is_zero(norm) || is_constant(given)) continue;
        const MPoly d = primitive(given);
        while (auto q = a_.quotient(norm, d))
          norm = *std::move(q);
      }
    const Coefficients c = coefficients(norm, c_.z());
    return std::ranges::any_of(c, [](const MPoly& x) { return !is_zero(x) && is_constant(x); });
  }
  /// Work that is not seen in polynomials: see Arithmetic.
  void charge(double products) const { a_.charge(products); }

private:
  using Exponents = std::vector<unsigned long>;

  // Exponent by exponent; those left out are 0.
  template <class Operation>
  static Exponents combined(const Exponents& a, const Exponents& b, Operation operation) {
    Exponents e(std::max(a.size(), b.size()));
    for (std::size_t k = 0; k < e.size(); ++k)
      e[k] = operation(k < a.size() ? a[k] : 0, k < b.size() ? b[k] : 0);
    return e;
  }
  static Exponents sum(const Exponents& a, const Exponents& b) {
    return combined(a, b, std::plus());
  }
  [[nodiscard]] MPoly denominator(const Exponents& e) const {
    MPoly d(c_.ring, Integer(1));
    for (std::size_t k = 0; k < e.size(); ++k)
      if (e[k] > 0) d = a_.times(d, a_.power(c_.denominators[k], e[k]));
    return d;
  }
  [[nodiscard]] bool depends_on_z_only(const MPoly& f) const {
    const auto used = used_variables(f);
    return std::ranges::none_of(used, [&](std::size_t i) { return i < c_.z(); });
  }
  [[nodiscard]] bool is_high(const MPoly& f, std::size_t step) const {
    return degree(f, c_.variable(step)) >= static_cast<long>(c_.tower[step].degree);
  }

  [[nodiscard]] CurveFunction shortened(CurveFunction f) const {
    if (is_zero(f.p)) return zero();
    const MPoly core = primitive(f.p);
    const Integer content = exact_div(f.p.coefficient(0), core.coefficient(0));
    const Integer g = gcd(content, f.n);
    f = {scaled(core, exact_div(content, g)), exact_div(f.n, g), std::move(f.over)};
    for (std::size_t k = 0; k < f.over.size(); ++k)
      while (f.over[k] > 0) {
        auto q = a_.quotient(f.p, c_.denominators[k]);
        if (!q) break;
        f.p = *std::move(q);
        --f.over[k];
      }
    return f;
  }
  // f = sum of w^(qd) f_q, f_q of degree < d in w: Horner's scheme for v^q in the place of w^(qd).  Where
  // v has w in it the product is of degree < 2d, and one step makes the degree less.
  [[nodiscard]] CurveFunction lowered(const CurveFunction& f, std::size_t i) const {
    const CurveFunction& v = c_.tower[i].value;
    const std::size_t d = c_.tower[i].degree;
    const MPoly w = MPoly::variable(c_.ring, c_.variable(i));
    const Coefficients c = coefficients(f.p, c_.variable(i));
    const auto part = [&](std::size_t q) {
      MPoly all(c_.ring);
      for (std::size_t k = std::min(c.size(), (q + 1) * d); k-- > q * d;)
        all = a_.plus(a_.times(all, w), c[k]);
      return all;
    };
    std::size_t q = (c.size() - 1) / d;
    CurveFunction low{part(q), {1}};
    while (q-- > 0) {
      low = {a_.times(low.p, v.p), a_.times(low.n, v.n), sum(low.over, v.over)};
      while (is_high(low.p, i))
        low = lowered(low, i);
      low.p = a_.plus(low.p, a_.times(part(q), a_.scaled(denominator(low.over), low.n)));
    }
    return {low.p, a_.times(low.n, f.n), sum(low.over, f.over)};
  }
  // The coefficients of f, reduced, by the monomials of the first steps of the tower.
  void by_tower(const MPoly& f, std::size_t steps, std::vector<MPoly>& row) const {
    if (steps == 0) return row.push_back(f);
    Coefficients c = coefficients(f, c_.variable(steps - 1));
    c.resize(c_.tower[steps - 1].degree, MPoly(c_.ring));
    for (const MPoly& part : c)
      by_tower(part, steps - 1, row);
  }

  const PhaseCurve& c_;
  Arithmetic& a_;
};

} // namespace kov::certify
