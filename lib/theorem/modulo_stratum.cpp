#include "theorem/modulo_stratum.hpp"

#include "certify/equation/facts.hpp"
#include "certify/theorem/computed.hpp"

namespace kov {

ModuloStratum::ModuloStratum(Ring ring, std::size_t w, const std::vector<Condition>& given)
    : ring_(std::move(ring)), w_(w) {
  for (const Condition& c : given)
    if (c.sign == Sign::zero && !is_zero(c.p) && !is_constant(c.p)) equations_.push_back(c.p);
}

MPoly ModuloStratum::lead(const MPoly& f) const { return coefficients(f, w_).back(); }

MPoly ModuloStratum::power_of_w(std::size_t e) const { return pow(MPoly::variable(ring_, w_), e); }

// Multiples of the coefficients by what may be 0 are no proof; this is a search.
bool ModuloStratum::vanishes(const MPoly& f) const {
  certify::Arithmetic a;
  for (MPoly c : coefficients(f, w_)) {
    for (std::size_t v = ring_->size(); v-- > 0 && !is_zero(c);)
      for (const MPoly& g : equations_) {
        if (used_variables(g).back() != v || is_zero(c)) continue;
        const auto rest =
            certify::Elimination(a).pseudo_remainder(coefficients(c, v), coefficients(g, v));
        MPoly sum(ring_);
        for (std::size_t k = 0; k < rest.size(); ++k)
          sum = sum + rest[k] * pow(MPoly::variable(ring_, v), k);
        c = sum;
      }
    if (!is_zero(c)) return false;
  }
  return true;
}

MPoly ModuloStratum::content(const MPoly& f) const {
  MPoly all(ring_);
  for (const MPoly& c : coefficients(f, w_))
    if (!is_zero(c)) all = is_zero(all) ? c : gcd(all, c);
  return all;
}

MPoly ModuloStratum::primitive(const MPoly& f) const {
  return is_zero(f) ? f : exact_div(f, content(f));
}

MPoly ModuloStratum::stripped(const MPoly& f) const {
  certify::Arithmetic a;
  MPoly rest = certify::modulo_equations(f, equations_, a);
  while (!is_zero(rest) && vanishes(lead(rest)))
    rest = rest - lead(rest) * power_of_w(coefficients(rest, w_).size() - 1);
  return primitive(rest);
}

MPoly ModuloStratum::common(MPoly f, MPoly g) const {
  f = stripped(f);
  g = stripped(g);
  if (!is_zero(f) && !is_zero(g) && degree(f, w_) < degree(g, w_)) std::swap(f, g);
  while (!is_zero(g)) {
    if (degree(g, w_) < 1) return {ring_, Integer(1)};
    const auto [q, s] = divided(f, g);
    f = std::exchange(g, stripped(s * f - q * g));
  }
  return f;
}

std::pair<MPoly, MPoly> ModuloStratum::divided(const MPoly& f, const MPoly& d) const {
  MPoly rest = f, q(ring_), s(ring_, Integer(1));
  const MPoly top = lead(d);
  const long n = degree(d, w_);
  while (!is_zero(rest) && degree(rest, w_) >= n) {
    const MPoly term = lead(rest) * power_of_w(static_cast<std::size_t>(degree(rest, w_) - n));
    rest = top * rest - term * d;
    q = top * q + term;
    s = top * s;
  }
  return {q, s};
}

ModuloStratum::DivisorPower ModuloStratum::order(MPoly f, const MPoly& d) const {
  DivisorPower p{f, MPoly(ring_, Integer(1)), 0};
  while (degree(p.rest, w_) >= degree(d, w_)) {
    auto [q, s] = divided(p.rest, d);
    if (is_zero(q) || !vanishes(s * p.rest - q * d)) break;
    p.rest = std::move(q);
    p.scale = p.scale * s;
    ++p.order;
  }
  return p;
}

} // namespace kov
