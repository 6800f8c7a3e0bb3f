#include "certify/system/curve_algebra.hpp"

#include "certify/equation/facts.hpp"

#include <algorithm>

namespace kov::certify {

namespace {

using Exponents = std::vector<unsigned long>;

unsigned long at(const Exponents& e, std::size_t k) { return k < e.size() ? e[k] : 0; }

Exponents sum(const Exponents& a, const Exponents& b) {
  Exponents e(std::max(a.size(), b.size()));
  for (std::size_t k = 0; k < e.size(); ++k)
    e[k] = at(a, k) + at(b, k);
  return e;
}

Exponents largest(const Exponents& a, const Exponents& b) {
  Exponents e(std::max(a.size(), b.size()));
  for (std::size_t k = 0; k < e.size(); ++k)
    e[k] = std::max(at(a, k), at(b, k));
  return e;
}

Exponents difference(Exponents a, const Exponents& b) {
  for (std::size_t k = 0; k < a.size(); ++k)
    a[k] -= at(b, k);
  return a;
}

} // namespace

std::set<std::string> names_in(const PhaseCurve& c, const CurveFunction& f) {
  std::set<std::string> names;
  std::vector<const CurveFunction*> left{&f};
  while (!left.empty()) {
    const CurveFunction& x = *left.back();
    left.pop_back();
    std::vector<std::size_t> used = used_variables(x.p);
    for (std::size_t k = 0; k < x.over.size(); ++k)
      if (x.over[k] > 0)
        for (const std::size_t i : used_variables(c.denominators[k]))
          used.push_back(i);
    for (const std::size_t i : used)
      if (names.insert(c.ring->name(i)).second && i < c.z())
        left.push_back(&c.tower[c.z() - 1 - i].value);
  }
  return names;
}

CurveAlgebra::CurveAlgebra(const PhaseCurve& c, Arithmetic& a) : c_(c), a_(a) {
  for (const MPoly& d : c.denominators)
    need(!is_zero(d) && depends_on_z_only(d), "C1: a denominator is 0 or no function of z");
  for (std::size_t i = 0; i < c.tower.size(); ++i) {
    need(c.tower[i].degree >= 2, "C1: a degree of the tower is below 2");
    for (std::size_t k = 0; k < c.variable(i); ++k)
      need(!uses(c.tower[i].value.p, k), "C1: a value of the tower uses a later name");
    need(degree(c.tower[i].value.p, c.variable(i)) < static_cast<long>(c.tower[i].degree),
         "C1: a value of the tower is not reduced");
  }
}

bool CurveAlgebra::depends_on_z_only(const MPoly& f) const {
  for (std::size_t i = 0; i < c_.z(); ++i)
    if (uses(f, i)) return false;
  return true;
}

MPoly CurveAlgebra::denominator(const Exponents& e) const {
  MPoly d(c_.ring, Integer(1));
  for (std::size_t k = 0; k < e.size(); ++k)
    if (e[k] > 0) d = a_.times(d, a_.power(c_.denominators[k], e[k]));
  return d;
}

CurveFunction CurveAlgebra::shortened(CurveFunction f) const {
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

CurveFunction CurveAlgebra::reduced(CurveFunction f) const {
  for (std::size_t i = c_.tower.size(); i-- > 0;)
    while (degree(f.p, c_.variable(i)) >= static_cast<long>(c_.tower[i].degree))
      f = lowered(f, i);
  return shortened(std::move(f));
}

// f = sum of w^(qd) f_q, f_q of degree < d in w: Horner's scheme for v^q in the place of w^(qd).  Where
// v has w in it the product is of degree < 2d, and one step makes the degree less.
CurveFunction CurveAlgebra::lowered(const CurveFunction& f, std::size_t i) const {
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
  CurveFunction low{part(q), Integer(1), {}};
  while (q-- > 0) {
    low = {a_.times(low.p, v.p), a_.times(low.n, v.n), sum(low.over, v.over)};
    while (degree(low.p, c_.variable(i)) >= static_cast<long>(d))
      low = lowered(low, i);
    low.p = a_.plus(low.p, a_.times(part(q), a_.scaled(denominator(low.over), low.n)));
  }
  return {low.p, a_.times(low.n, f.n), sum(low.over, f.over)};
}

CurveFunction CurveAlgebra::plus(const CurveFunction& f, const CurveFunction& g) const {
  const Integer n = a_.common_multiple(f.n, g.n);
  const Exponents e = largest(f.over, g.over);
  const auto raised = [&](const CurveFunction& x) {
    return a_.times(a_.scaled(x.p, exact_div(n, x.n)), denominator(difference(e, x.over)));
  };
  return reduced({a_.plus(raised(f), raised(g)), n, e});
}

CurveFunction CurveAlgebra::minus(const CurveFunction& f, const CurveFunction& g) const {
  return plus(f, {-g.p, g.n, g.over});
}

CurveFunction CurveAlgebra::times(const CurveFunction& f, const CurveFunction& g) const {
  if (is_zero(f.p) || is_zero(g.p)) return zero();
  return reduced({a_.times(f.p, g.p), a_.times(f.n, g.n), sum(f.over, g.over)});
}

CurveFunction CurveAlgebra::power(const CurveFunction& f, unsigned long e) const {
  CurveFunction r = integer(1);
  for (; e > 0; --e)
    r = times(r, f);
  return r;
}

// The coefficients of f, reduced, by the monomials of the first steps of the tower.
void CurveAlgebra::by_tower(const MPoly& f, std::size_t steps, std::vector<MPoly>& row) const {
  if (steps == 0) {
    row.push_back(f);
    return;
  }
  Coefficients c = coefficients(f, c_.variable(steps - 1));
  c.resize(c_.tower[steps - 1].degree, MPoly(c_.ring));
  for (const MPoly& part : c)
    by_tower(part, steps - 1, row);
}

MPoly CurveAlgebra::norm(const CurveFunction& f) const {
  if (depends_on_z_only(f.p)) return f.p;
  std::vector<CurveFunction> basis{integer(1)};
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

bool CurveAlgebra::is_unit(MPoly norm, const std::vector<MPoly>& where) const {
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

CurveFunction CurveAlgebra::derivative(const CurveFunction& f) const {
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
    d = plus(d, times(f, {e, Integer(1), once}));
  }
  return d;
}

void CurveAlgebra::need_derivation() {
  for (std::size_t i = 0; i < c_.tower.size(); ++i) {
    const TowerStep& step = c_.tower[i];
    const auto power = a_.power(MPoly::variable(c_.ring, c_.variable(i)), step.degree - 1);
    const CurveFunction factor{
        scaled(power, Integer(static_cast<long>(step.degree))), Integer(1), {}};
    need(equal(times(factor, step.derivative), derivative(step.value)),
         "C2: the derivation does not respect the tower");
  }
}

CurveFunction CurveAlgebra::evaluate(const MPoly& f,
                                     const std::vector<std::optional<CurveFunction>>& at) const {
  std::vector<std::vector<CurveFunction>> powers(at.size());
  const auto power = [&](std::size_t i, unsigned long e) -> const CurveFunction& {
    need(at[i].has_value(), "a name without a value is used on the curve");
    auto& all = powers[i];
    if (all.empty()) all.push_back(integer(1));
    while (all.size() <= e)
      all.push_back(times(all.back(), *at[i]));
    return all[e];
  };
  CurveFunction total = zero();
  for (long k = 0; k < f.length(); ++k) {
    CurveFunction term{MPoly(c_.ring, f.coefficient(k)), Integer(1), {}};
    const auto e = f.exponents(k);
    for (std::size_t i = 0; i < e.size(); ++i)
      if (e[i] > 0) {
        const CurveFunction& factor = power(i, e[i]);
        if (!is_zero(term.p)) term = times(term, factor);
      }
    if (!is_zero(term.p)) total = plus(total, term);
  }
  return total;
}

} // namespace kov::certify
