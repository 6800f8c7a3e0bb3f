#include "algebraize/algebraize.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"

#include <algorithm>

namespace kov {

long finite_singularities(const MFraction& r, std::size_t z) {
  if (is_zero(r)) return 0;
  long sum = 0;
  for (const auto& f : factor(r.den()).second)
    sum += std::max(degree(f.base, z), 0L);
  return sum;
}

namespace {

// A polynomial in z and the parameters vanishes identically in z only where all its coefficients
// do.
std::vector<MPoly> conditions_on_parameters(const std::vector<MPoly>& inverted, std::size_t z) {
  std::vector<MPoly> kept;
  for (const auto& g : inverted) {
    const auto c = coefficients(g, z);
    if (std::ranges::none_of(c, [](const MPoly& f) { return !is_zero(f) && is_constant(f); }))
      kept.push_back(g);
  }
  return kept;
}

// A divisor is a unit also after a specialisation of the parameters at which neither the numerator
// nor the denominator of its norm vanishes identically in z.
void add_norm(std::vector<MPoly>& all, const FunctionField& f, const FunctionField::Element& e) {
  const MFraction norm = f.algebra().minimal_polynomial(e).front();
  for (const MPoly& side : {norm.num(), norm.den()})
    if (!is_constant(side)) all.push_back(side);
}

// Norms of the divisors, of dz/dt (where it vanishes nothing moves), and of the denominator of
// phi.
std::vector<MPoly> norms(const FunctionField& f, const std::vector<MPoly>& divisors,
                         const MFraction& phi) {
  std::vector<MPoly> all;
  for (const auto& d : divisors) {
    const auto e = f.evaluate(MFraction(d));
    KOV_ENSURE(e); // a unit: FunctionField::make
    add_norm(all, f, *e);
  }
  add_norm(all, f, f.z_dot());
  if (const auto e = f.evaluate(MFraction(phi.den()))) add_norm(all, f, *e);
  return all;
}

// f = square^2 * core up to constants of K; returns {square, core} with core squarefree in z.
std::pair<MFraction, MPoly> split_squares(const MFraction& f) {
  const Ring& ring = f.ring();
  MFraction square(ring, Rational(1));
  MPoly core(ring, Integer(1));
  const MPoly product = f.num() * f.den(); // f = product/den^2
  const auto [content, factors] = factor(product);
  if (const auto root = exact_sqrt(sign(content) < 0 ? -content : content)) {
    square *= MFraction(ring, Rational(*root));
    core = MPoly(ring, Integer(sign(content)));
  } else {
    core = MPoly(ring, content);
  }
  for (const auto& [base, exponent] : factors) {
    square *= MFraction(pow(base, static_cast<unsigned long>(exponent / 2)));
    if (exponent % 2 != 0) core *= base;
  }
  return {square / MFraction(f.den()), core};
}

// A parameter of the conic w^2 = core(z), if it has a point over K that is seen at once: core
// linear in z; a root of core in K; a square as leading coefficient.
std::optional<MFraction> parametrization(const MPoly& core, const MFraction& w,
                                         const MFraction& phi, std::size_t z) {
  const long d = degree(core, z);
  if (d == 1) return w;
  if (d != 2) return std::nullopt;
  for (const auto& f : factor(core).second)
    if (const auto c = coefficients(f.base, z); c.size() == 2)
      return w / (phi + MFraction(c[0], c[1]));
  const MPoly lead = coefficients(core, z)[2];
  const auto [root, rest] = split_squares(MFraction(lead));
  if (is_one(rest)) return w - root * phi;
  return std::nullopt;
}

// The failure when r is not a function of z: in one sentence, and the way out if there is one.
ChangeFailure what_is_left(const FunctionField& f, const FunctionField::Element& r, std::size_t z,
                           const MFraction& phi) {
  const auto quadratic = f.algebra().minimal_polynomial(r, 2);
  ChangeFailure failure{"z = " + to_string(phi) + " does not rationalize the equation: r is " +
                        "algebraic of degree " + (quadratic ? "2" : "3 or more") +
                        " over the rational functions of z: r = " + brief(f.lift(r))};
  if (!quadratic) return failure;
  const auto& minimal = *quadratic;
  // (2 r + c1)^2 = c1^2 - 4 c0
  const MFraction discriminant = minimal[1] * minimal[1] - Rational(4) * minimal[0];
  if (is_zero(discriminant)) {
    failure.message += "; the equations of the curve have multiplicities there";
    return failure;
  }
  const auto [square, core] = split_squares(discriminant);
  failure.message +=
      "; it lies in the quadratic extension by w with w^2 = " + brief(MFraction(core));
  const auto two_r =
      scale(r, MFraction(core.ring(), Rational(2))) + f.algebra().constant(minimal[1]);
  const MFraction w = substitute(f.lift(two_r) / square, {{z, phi}});
  failure.better = parametrization(core, w, phi, z);
  return failure;
}

} // namespace

std::variant<AlgebraicOde, ChangeFailure> algebraize(std::shared_ptr<const FunctionField> field,
                                                     std::size_t z, const MFraction& phi,
                                                     const NormalVariationalEquation& e,
                                                     bool look_for_better) {
  const FunctionField& f = *field;
  const auto a1 = f.evaluate(e.a1);
  const auto a0 = f.evaluate(e.a0);
  if (!a1 || !a0)
    return ChangeFailure{"a coefficient of the scalar equation has a pole along the whole curve"};
  const FiniteAlgebra& algebra = f.algebra();
  const auto& inverse = f.inverse_z_dot();
  const auto square = algebra.multiply(inverse, inverse);
  const auto p = algebra.multiply(f.z_ddot() + algebra.multiply(*a1, f.z_dot()), square);
  const auto q = algebra.multiply(*a0, square);
  const MFraction quarter(algebra.ring(), Rational(1, 4));
  const MFraction half(algebra.ring(), Rational(1, 2));
  const auto r = scale(algebra.multiply(p, p), quarter) + scale(f.derivative(p), half) - q;
  const auto r_in_z = f.in_z(r);
  if (!r_in_z && !look_for_better)
    return ChangeFailure{"z = " + to_string(phi) + " does not rationalize the equation"};
  if (!r_in_z) return what_is_left(f, r, z, phi);
  AlgebraicOde ode;
  ode.unknown = e.unknown;
  ode.change = algebra.ring()->name(z) + " = " + to_string(phi);
  ode.phi = phi;
  ode.z = z;
  ode.z_dot_squared = f.in_z(algebra.multiply(f.z_dot(), f.z_dot()));
  ode.z_ddot = f.in_z(f.z_ddot());
  ode.p = f.in_z(p);
  ode.q = f.in_z(q);
  if (!ode.p || !ode.q) ode.p = ode.q = std::nullopt;
  ode.r = *r_in_z;
  ode.field_degree = f.degree();
  ode.generic = conditions_on_parameters(f.inverted(), z);
  ode.divided_by = f.divided_by();
  for (const auto& g : conditions_on_parameters(norms(f, e.divisors, phi), z))
    add_once(ode.generic, g);
  ode.singular_places = finite_singularities(ode.r, z);
  ode.checks = {"z is not constant along the curve",
                "the function field of the curve is a finite extension of degree " +
                    std::to_string(ode.field_degree) + " of the rational functions of z, so that " +
                    "the identity component is the same in z as in t",
                "everything that was divided by is invertible on the curve"};
  ode.field = std::move(field);
  return ode;
}

std::vector<MFraction> propose_changes(const VectorField& v, const InvariantManifold& m) {
  std::vector<std::size_t> moving;
  for (const std::size_t i : m.curve->main())
    if (!m.vanishes_on_curve(lie_derivative(v, m.restrict(MFraction::variable(v.ring, i)))))
      moving.push_back(i);
  const auto x = [&](std::size_t i) { return MFraction::variable(v.ring, i); };
  const MFraction one(v.ring, Rational(1));
  auto all = mapped<MFraction>(moving, [&](const std::size_t i) { return x(i); });
  for (const std::size_t i : moving)
    all.push_back(x(i) * x(i));
  for (const std::size_t i : moving)
    for (const std::size_t j : moving)
      if (i != j && m.vanishes_on_curve(x(i) * x(i) + x(j) * x(j) - one))
        all.push_back(x(i) / (one + x(j)));
  for (const std::size_t i : moving)
    for (const std::size_t j : moving)
      if (i != j && !m.vanishes_on_curve(lie_derivative(v, x(i) / x(j))))
        all.push_back(x(i) / x(j));
  return all;
}

} // namespace kov
