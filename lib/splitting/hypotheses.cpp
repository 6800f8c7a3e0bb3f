#include "splitting/hypotheses.hpp"

#include "splitting/cone.hpp"

namespace kov {
namespace {

// H0 in the chart.
MFraction unperturbed(const OrbitSpace& o) {
  const Triple& m = o.chart.momentum;
  return Rational(Integer(1), Integer(2)) *
         (o.a * m[0] * m[0] + o.b * m[1] * m[1] + o.c * m[2] * m[2]);
}

// At L = 0, sin l = 0: p = G and cos l = +-1.
MFraction at_saddle(const AndoyerChart& c, const MFraction& f) {
  const Ring& r = c.ring;
  return substitute(f, {{r->index("L"), MFraction(r)},
                        {r->index("sin_l"), MFraction(r)},
                        {r->index("cos_l"), MFraction(r, Rational(1))},
                        {r->index("p"), c.variable("G")}});
}

bool saddles_are_hyperbolic(const OrbitSpace& o) {
  const AndoyerChart& c = o.chart;
  const MFraction h0 = unperturbed(o);
  const std::size_t l = 0, big_l = 3; // positions among the coordinates
  const auto d = [&](const MFraction& f, std::size_t j) { return partial(c.phase, f, j); };
  const MFraction ll = at_saddle(c, d(d(h0, l), l)), pp = at_saddle(c, d(d(h0, big_l), big_l)),
                  lp = at_saddle(c, d(d(h0, l), big_l));
  const bool equilibrium = is_zero(at_saddle(c, d(h0, l))) && is_zero(at_saddle(c, d(h0, big_l)));
  return equilibrium && o.field.is_zero(lp * lp - ll * pp - o.lambda * o.lambda);
}

// dH0/dG - a G = (b - a) G cos^2 l.
bool frequency_is_positive(const OrbitSpace& o) {
  const AndoyerChart& c = o.chart;
  const MFraction rate = partial(c.phase, unperturbed(o), 4);
  const MFraction g = c.variable("G"), cosine = c.variable("cos_l"), alpha = c.variable("alpha");
  return c.field.is_zero(rate - o.a * g - alpha * alpha * g * cosine * cosine);
}

} // namespace

CheckedIdentities check_ziglin_hypotheses(const SplittingData& d) {
  const OrbitSpace& o = d.space;
  bool joined = true;
  for (const CheckedIdentity& c : d.checks)
    joined = joined && c.holds;
  bool poles = !d.residues.empty();
  for (const StripResidues& r : d.residues)
    poles = poles && r.pole_order > 0;
  return {
      {"the saddles (L, l) = (0, 0), (0, pi) are hyperbolic: eigenvalues +-lambda, "
       "lambda = G alpha beta > 0",
       saddles_are_hyperbolic(o)},
      {"an orbit joins them (the identities of the chart and of the orbits)", joined},
      {"dH0/dG = a G + (b - a) G cos(l)^2 >= a G > 0", frequency_is_positive(o)},
      {"M, Gamma and the h_k are rational in z = e^(lambda t) up to z^(i k nu), entire in t, with "
       "poles at z = i and z = -i only; H is a polynomial in M and Gamma at order epsilon^n, so "
       "that "
       "it is analytic away from them, and the h_k are single-valued in the strip",
       poles}};
}

} // namespace kov
