#include "quadratures/primitive_extension.hpp"

#include "exact/error.hpp"
#include "exact/factor.hpp"
#include "galois/hyperexponential_integral.hpp"

#include <algorithm>

namespace kov {

using Element = PrimitiveExtension::Element;

HermiteParts hermite_parts(const RationalFunction& f, const Budget& budget) {
  std::vector<Poly> places; // irreducible: a part of a place could lose its multiplicity first
  for (const Factor& q : irreducible_factors(f.den(), budget))
    if (degree(q.base) > 0) places.push_back(q.base);
  const auto integral = reduced_integral(f, RationalFunction(0), places, budget);
  KOV_ENSURE(degree(integral.b.num()) < degree(integral.b.den()) &&
             is_squarefree(integral.b.den()));
  return {integral.w, integral.b};
}

namespace {

Element trimmed(Element f) {
  while (!f.empty() && is_zero(f.back()))
    f.pop_back();
  return f;
}

// c with a = c b; unset: there is none.
std::optional<RationalFunction> constant_ratio(const RationalFunction& a,
                                               const RationalFunction& b) {
  if (is_zero(a)) return RationalFunction(0);
  if (is_zero(b)) return std::nullopt;
  const RationalFunction c = a / b;
  if (degree(c.num()) > 0 || degree(c.den()) > 0) return std::nullopt;
  return c;
}

} // namespace

std::optional<PrimitiveExtension> PrimitiveExtension::make(const RationalFunction& u,
                                                           const Budget& budget) {
  HermiteParts parts = hermite_parts(u, budget);
  if (is_zero(parts.poles)) return std::nullopt;
  return PrimitiveExtension(u, std::move(parts));
}

Element PrimitiveExtension::derivative(const Element& f) const {
  Element d;
  for (std::size_t j = 0; j < f.size(); ++j) {
    d.push_back(kov::derivative(f[j]));
    if (j + 1 < f.size())
      d.back() += RationalFunction(Rational(static_cast<long>(j + 1))) * f[j + 1] * u_;
  }
  return trimmed(std::move(d));
}

// g_j' = f_j - (j + 1) g_(j+1) u from the top.  The constant in g_(j+1) is the only one that is free
// at level j: it has to take the simple poles away.
std::optional<Element> PrimitiveExtension::primitive(const Element& f, const Budget& budget,
                                                     std::size_t* level) const {
  Element g(f.size() + 1, RationalFunction(0));
  for (std::size_t j = f.size(); j-- > 0;) {
    const RationalFunction times(Rational(static_cast<long>(j + 1)));
    const HermiteParts rest = hermite_parts(f[j] - times * g[j + 1] * u_, budget);
    const auto c = constant_ratio(rest.poles, times * parts_.poles);
    if (!c) {
      if (level) *level = j;
      return std::nullopt;
    }
    g[j + 1] += *c;
    g[j] = rest.rational - times * *c * parts_.rational;
  }
  g = trimmed(std::move(g));
  KOV_ENSURE(derivative(g) == trimmed(f));
  return g;
}

Element by_the_primitive(const Element& f) {
  Element d;
  for (std::size_t j = 1; j < f.size(); ++j)
    d.push_back(RationalFunction(Rational(static_cast<long>(j))) * f[j]);
  return trimmed(std::move(d));
}

Element operator+(const Element& a, const Element& b) {
  Element sum(std::max(a.size(), b.size()), RationalFunction(0));
  for (std::size_t j = 0; j < a.size(); ++j)
    sum[j] += a[j];
  for (std::size_t j = 0; j < b.size(); ++j)
    sum[j] += b[j];
  return trimmed(std::move(sum));
}

Element operator*(const Element& a, const Element& b) {
  if (a.empty() || b.empty()) return {};
  Element product(a.size() + b.size() - 1, RationalFunction(0));
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      product[i + j] += a[i] * b[j];
  return trimmed(std::move(product));
}

Element operator*(const RationalFunction& c, Element f) {
  for (RationalFunction& x : f)
    x = c * x;
  return trimmed(std::move(f));
}

} // namespace kov
