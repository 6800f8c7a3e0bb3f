#include "pullback/special_solution.hpp"

#include "exact/error.hpp"
#include "exact/factor.hpp"
#include "pullback/gauge.hpp"
#include "pullback/local.hpp"
#include "pullback/standard.hpp"

#include <vector>

namespace kov {
namespace {

using namespace pullback;

constexpr long largest_degree = 200; ///< of num(r) and den(r)

// p = k^2 h up to a constant, h squarefree.
std::pair<Poly, Poly> square_and_rest(const Poly& p) {
  Poly k(1), h(1);
  for (const Factor& factor : squarefree_factors(p)) {
    k *= pow(factor.base, static_cast<unsigned long>(factor.exponent / 2));
    if (factor.exponent % 2 == 1) h *= factor.base;
  }
  return {k, h};
}

// U = u(f)/sqrt(f'), U' = (f' u'(f) - f''/(2 f') u(f))/sqrt(f'); 1/f' = num den/num^2 of f'.
SpecialSolution written(const Candidate& c, const Gauge& gauge) {
  const RationalFunction slope = derivative(c.f);
  const auto [k, h] = square_and_rest(gauge.g * slope.num() * slope.den());
  const RationalFunction outer(k, slope.num());
  const RationalFunction half(Rational(1, 2));
  SpecialSolution y{c.family, c.standard, c.f, h, {}, {}};
  y.a = outer * (gauge.a - gauge.b * derivative(slope) * half / slope);
  y.b = outer * gauge.b * slope;
  // one constant is free
  const Poly& scale_of = is_zero(y.b) ? y.a.num() : y.b.num();
  const RationalFunction unit(Poly(inverse(lead(scale_of))));
  y.a = y.a * unit;
  y.b = y.b * unit;
  return y;
}

// x may be scaled: c x with c a root in K makes the standard equation simpler.
void normalise(SpecialSolution& y) {
  if (y.family != Classical::airy) return;
  const NfElem a = y.standard.num().coeff(1);
  const auto roots = roots_of(Poly(a), 3, Poly::z());
  if (roots.empty()) return;
  y.f = y.f * RationalFunction(roots.front());
  y.b = y.b * RationalFunction(roots.front());
  y.standard = RationalFunction(Poly::z());
}

} // namespace

bool satisfies(const SpecialSolution& y, const RationalFunction& r) {
  const RationalFunction half(Rational(1, 2));
  const RationalFunction root = derivative(RationalFunction(y.h)) / RationalFunction(y.h) * half;
  const RationalFunction slope = derivative(y.f);
  const RationalFunction behind = compose(y.standard, y.f) * slope;
  RationalFunction a = y.a, b = y.b;
  for (int i = 0; i < 2; ++i) {
    const RationalFunction next = derivative(a) + root * a + behind * b;
    b = derivative(b) + root * b + slope * a;
    a = next;
  }
  return (!is_zero(y.a) || !is_zero(y.b)) && a == r * y.a && b == r * y.b;
}

std::optional<SpecialSolution> special_solution(const Singularities& s, const Budget& budget) {
  if (degree(s.r.num()) > largest_degree || degree(s.r.den()) > largest_degree) return std::nullopt;
  std::optional<SpecialSolution> found;
  const Try tell = [&](const Candidate& c) {
    budget.check();
    const RationalFunction there = pulled_back(c.standard, c.f);
    if (is_zero(there)) return false; // y'' = 0 behind no map has the group SL(2)
    const auto gauge = find_gauge(s, singularities(there, budget), budget);
    if (!gauge) return false;
    found = written(c, *gauge);
    normalise(*found);
    KOV_ENSURE(satisfies(*found, s.r));
    return true;
  };
  if (try_airy(s, tell, budget) || try_whittaker(s, tell, budget) ||
      try_bessel_of_root(s, tell, budget) || try_riemann(s, tell, budget))
    return found;
  return std::nullopt;
}

} // namespace kov
