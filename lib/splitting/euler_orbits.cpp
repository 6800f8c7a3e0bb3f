#include "splitting/euler_orbits.hpp"

#include "exact/error.hpp"

namespace kov {
namespace {

Triple cross(const Triple& a, const Triple& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

MFraction at_zero(const MFraction& f, std::size_t z) {
  return substitute(f, {{z, MFraction(f.ring())}});
}

MFraction at_infinity(const MFraction& f, std::size_t z) {
  return at_zero(substitute(f, {{z, pow(MFraction::variable(f.ring(), z), -1)}}), z);
}

} // namespace

OrbitSpace orbit_space(const std::vector<std::string>& more) {
  std::vector<std::string> names{"alpha", "beta", "delta", "b", "z"};
  names.insert(names.end(), more.begin(), more.end());
  AndoyerChart chart = andoyer_chart(names);
  const Ring& r = chart.ring;
  const auto x = [&](const char* n) { return MFraction::variable(r, n); };
  const MFraction alpha = x("alpha"), beta = x("beta"), b = x("b");
  SurdField field(r, {{r->index("i"), MFraction(r, Rational(-1))},
                      {r->index("delta"), alpha * alpha + beta * beta},
                      {r->index("s"), x("G") * x("G") - x("F") * x("F")}});
  return {chart,
          field,
          b - alpha * alpha,
          b,
          b + beta * beta,
          x("G") * alpha * beta,
          b / (alpha * beta)};
}

DoublyAsymptotic doubly_asymptotic(const OrbitSpace& o, int sign) {
  const auto x = [&](const char* n) { return o.chart.variable(n); };
  const MFraction one(o.chart.ring, Rational(1)), sigma(o.chart.ring, Rational(sign));
  const MFraction z = x("z"), circle = z * z + one;
  const MFraction sech = Rational(2) * z / circle, tanh = (z * z - one) / circle;
  DoublyAsymptotic orbit;
  orbit.sign = sign;
  orbit.momentum = {x("G") * x("beta") / x("delta") * sech, -sigma * x("G") * tanh,
                    sigma * x("G") * x("alpha") / x("delta") * sech};
  const MFraction gamma = x("alpha") + x("i") * x("beta");
  const MFraction conjugate = x("alpha") - x("i") * x("beta");
  orbit.phase = o.field.reduce(x("delta") * circle / (x("G") * (conjugate * z * z - gamma)));
  return orbit;
}

CheckedIdentities check_orbit(const OrbitSpace& o, const DoublyAsymptotic& orbit) {
  const auto x = [&](const char* n) { return o.chart.variable(n); };
  const std::size_t z = o.chart.ring->index("z");
  const auto time_derivative = [&](const MFraction& f) {
    return o.lambda * x("z") * derivative(f, z);
  };
  const Triple& m = orbit.momentum;
  const Triple omega{o.a * m[0], o.b * m[1], o.c * m[2]};
  const Triple right = cross(m, omega);
  bool euler = true;
  for (int k = 0; k < 3; ++k)
    euler = euler && o.field.is_zero(time_derivative(m[k]) - right[k]);
  const MFraction g2 = x("G") * x("G");
  const MFraction sigma(o.chart.ring, Rational(orbit.sign));
  bool limits = true;
  for (const int k : {0, 2})
    limits = limits && is_zero(at_zero(m[k], z)) && is_zero(at_infinity(m[k], z));
  limits = limits && is_zero(at_zero(m[1], z) - sigma * x("G")) &&
           is_zero(at_infinity(m[1], z) + sigma * x("G"));
  // g' = dH0/dG = G (a sin^2 l + b cos^2 l) = G (a M1^2 + b M2^2)/p^2, and
  // log(e^(ig)) = i nu log z + log f + log p.
  const MFraction p2 = g2 - m[2] * m[2];
  const MFraction rate = x("G") * (o.a * m[0] * m[0] + o.b * m[1] * m[1]) / p2;
  const MFraction left = x("i") * o.nu * o.lambda + time_derivative(orbit.phase) / orbit.phase +
                         Rational(Integer(1), Integer(2)) * time_derivative(p2) / p2;
  const MFraction modulus =
      orbit.phase * o.field.conjugate(orbit.phase, o.chart.ring->index("i")) * p2;
  const std::string which = orbit.sign > 0 ? " (orbit +)" : " (orbit -)";
  return {{"M' = M x Omega with ' = lambda z d/dz" + which, euler},
          {"M^2 = G^2 and M . Omega = b G^2" + which,
           o.field.is_zero(dot(m, m) - g2) && o.field.is_zero(dot(m, omega) - o.b * g2)},
          {"M -> (0, +-G, 0) as t -> -+ infinity" + which, limits},
          {"g' = dH0/dG along the orbit for e^(ig) = z^(i nu) p f(z), and |p f| = 1" + which,
           o.field.is_zero(left - x("i") * rate) &&
               o.field.is_zero(modulus - MFraction(o.chart.ring, Rational(1)))}};
}

MFraction mode_on_orbit(const OrbitSpace& o, const DoublyAsymptotic& orbit, const MFraction& mode,
                        long k) {
  const Ring& r = o.chart.ring;
  const MFraction p = o.chart.variable("p");
  const Triple& m = orbit.momentum;
  const std::size_t index = r->index("p");
  const SurdField with_p(
      r, {{r->index("i"), MFraction(r, Rational(-1))},
          {r->index("delta"), o.chart.variable("alpha") * o.chart.variable("alpha") +
                                  o.chart.variable("beta") * o.chart.variable("beta")},
          {r->index("s"), o.chart.variable("G") * o.chart.variable("G") -
                              o.chart.variable("F") * o.chart.variable("F")},
          {index, o.field.reduce(o.chart.variable("G") * o.chart.variable("G") - m[2] * m[2])}});
  const MFraction value = substitute(
      mode, {{r->index("L"), m[2]}, {r->index("sin_l"), m[0] / p}, {r->index("cos_l"), m[1] / p}});
  const MFraction h = with_p.reduce(value * pow(p * orbit.phase, k));
  if (uses(h, index)) throw DomainError("an odd power of sqrt(G^2 - L^2) is left on the orbit");
  return h;
}

} // namespace kov
