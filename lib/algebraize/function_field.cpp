#include "algebraize/function_field.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"

#include <algorithm>

namespace kov {
namespace {

std::vector<MPoly> curve_generators(const InvariantManifold& m) {
  return mapped<MPoly>(m.curve->basis(),
                       [&](const auto& g) { return m.curve->from_kpoly(g).num(); });
}

} // namespace

std::variant<FunctionField, ChangeFailure>
FunctionField::make(const VectorField& v, const InvariantManifold& m, std::size_t z,
                    const MFraction& phi, const std::vector<MPoly>& divisors, const Budget& budget,
                    std::size_t max_degree) {
  const auto& main = m.curve->main();
  for (const std::size_t i : v.main_variables())
    if (uses(phi, i) && !is_among(i, main))
      return ChangeFailure{"z = " + to_string(phi) + " uses '" + v.ring->name(i) +
                           "', which is not algebraic on the curve"};
  const MFraction zdot = lie_derivative(v, phi);
  if (m.vanishes_on_curve(zdot))
    return ChangeFailure{"z = " + to_string(phi) + " is constant along the curve"};
  auto generators = curve_generators(m);
  const MFraction graph =
      MFraction(phi.den()) * MFraction::variable(v.ring, z) - MFraction(phi.num());
  generators.push_back(graph.num());
  std::vector<MPoly> nonzero(m.nonzero);
  nonzero.push_back(phi.den());
  // Without the divisors first: usually they are units, and the saturation is cheaper.
  for (int attempt = 0; attempt < 2; ++attempt) {
    Ideal ideal(v.ring, m.curve->main(), generators, nonzero, budget);
    if (ideal.is_unit())
      return ChangeFailure{"z = " + to_string(phi) + " is constant along the curve, or something " +
                           "that was divided by vanishes on it"};
    if (ideal.dimension() != 0)
      return ChangeFailure{"z = " + to_string(phi) +
                           " is constant on a component of the curve; name it in 'nonzero'"};
    if (ideal.standard_monomials().size() > max_degree)
      return ChangeFailure{"z = " + to_string(phi) + " takes each value too often on the curve"};
    FunctionField f(FiniteAlgebra(std::move(ideal)), z);
    f.divided_by_ = divisors;
    f.divided_by_.push_back(phi.den());
    f.divided_by_.push_back(zdot.num());
    const bool units = std::ranges::all_of(divisors, [&](const MPoly& d) {
      const auto e = f.algebra_.evaluate(MFraction(d));
      return e && f.algebra_.invert(*e).has_value();
    });
    if (!units && attempt == 0) {
      nonzero.insert(nonzero.end(), divisors.begin(), divisors.end());
      for (const auto& x : v.components)
        nonzero.push_back(x.den());
      nonzero.push_back(zdot.num());
      continue;
    }
    if (auto failure = f.find_derivatives(v, phi)) {
      if (attempt == 1) return *std::move(failure);
      nonzero.insert(nonzero.end(), divisors.begin(), divisors.end());
      for (const auto& x : v.components)
        nonzero.push_back(x.den());
      nonzero.push_back(zdot.num());
      continue;
    }
    return f;
  }
  throw InternalError("FunctionField::make: a divisor is not a unit after saturation by it");
}

std::optional<ChangeFailure> FunctionField::find_derivatives(const VectorField& v,
                                                             const MFraction& phi) {
  const MFraction zdot = lie_derivative(v, phi);
  const auto z1 = evaluate(zdot);
  const auto z2 = evaluate(lie_derivative(v, zdot));
  if (!z1 || !z2) return ChangeFailure{"the derivative of z is not defined on the curve"};
  const auto inverse = algebra_.invert(*z1);
  if (!inverse) return ChangeFailure{"z is constant on a component of the curve"};
  z_dot_ = *z1;
  z_ddot_ = *z2;
  inverse_z_dot_ = *inverse;
  const auto& main = algebra_.ideal().main();
  std::vector<Element> derivatives; // of the main variables, by z
  for (const std::size_t i : main) {
    const auto e = evaluate(lie_derivative(v, MFraction::variable(v.ring, i)));
    if (!e) return ChangeFailure{"the vector field is not defined on the curve"};
    derivatives.push_back(algebra_.multiply(*e, inverse_z_dot_));
  }
  const auto is_constant_variable = [&](std::size_t i) { return is_among(main[i], v.constants); };
  for (const auto& monomial : algebra_.basis()) {
    Element sum = algebra_.zero();
    bool constant = true;
    for (std::size_t i = 0; i < monomial.size(); ++i) {
      if (monomial[i] == 0) continue;
      if (!is_constant_variable(i)) constant = false;
      KPoly rest(MonomialOrder{0});
      Monomial m(monomial);
      --m[i];
      rest.emplace(std::move(m), MFraction(v.ring, Rational(static_cast<long>(monomial[i]))));
      const auto factor = evaluate(algebra_.ideal().from_kpoly(rest));
      sum = sum + algebra_.multiply(*factor, derivatives[i]);
    }
    basis_derivative_.push_back(std::move(sum));
    constant_basis_.push_back(constant);
  }
  return std::nullopt;
}

std::size_t FunctionField::degree() const {
  const auto constants = static_cast<std::size_t>(std::ranges::count(constant_basis_, true));
  return algebra_.dimension() / std::max<std::size_t>(constants, 1);
}

FunctionField::Element FunctionField::derivative(const Element& a) const {
  Element sum = algebra_.zero();
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (is_zero(a[i])) continue;
    sum[i] += kov::derivative(a[i], z_);
    sum = sum + scale(basis_derivative_[i], a[i]);
  }
  return sum;
}

std::optional<MFraction> FunctionField::in_z(const Element& a) const {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!constant_basis_[i] && !is_zero(a[i])) return std::nullopt;
  return algebra_.lift(a);
}

} // namespace kov
