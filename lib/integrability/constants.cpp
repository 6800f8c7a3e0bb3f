#include "integrability/constants.hpp"

#include "exact/error.hpp"
#include "exact/factor.hpp"
#include "exact/finite_algebra.hpp"
#include "exact/lists.hpp"
#include "exact/to_poly.hpp"

#include <algorithm>

namespace kov {

std::pair<Field, NfElem> field_of_root(const Poly& f, const std::string& name) {
  const auto factors = irreducible_factors(f);
  if (factors.size() != 1 || factors[0].exponent != 1)
    throw InvalidArgument("the polynomial " + to_string(f) + " is not irreducible over Q");
  const Poly m = factors[0].base;
  const long d = degree(m);
  if (d == 1) return {rationals(), NfElem(to_rational(-m.coeff(0)))};
  Integer scale(1); // scale * theta is integral
  for (long i = 0; i < d; ++i)
    fmpz_lcm(scale.raw(), scale.raw(), fmpq_denref(to_rational(m.coeff(i)).raw()));
  std::vector<Integer> minpoly;
  for (long i = 0; i <= d; ++i) {
    const Rational c =
        to_rational(m.coeff(i)) * Rational(pow(scale, static_cast<unsigned long>(d - i)));
    minpoly.push_back(floor(c));
  }
  const Field k = make_field(minpoly, name, 0, scale);
  return {k, NfElem::generator(k) / NfElem(Rational(scale))};
}

namespace {

Ideal relations_among_constants(const VectorField& v) {
  const auto is_constant_variable = [&](std::size_t i) { return is_among(i, v.constants); };
  std::vector<MPoly> generators;
  for (const auto& f : v.relations) {
    const auto used = used_variables(f);
    if (!used.empty() && std::ranges::all_of(used, is_constant_variable)) generators.push_back(f);
  }
  return {v.ring, v.constants, generators};
}

Ideal constant_relations(const VectorField& v) {
  Ideal ideal = relations_among_constants(v);
  if (ideal.dimension() != 0)
    throw InvalidArgument(
        "the algebraic constants are not determined by numbers; values are needed "
        "for the parameters in their relations");
  return ideal;
}

// c_1 + k c_2 + k^2 c_3 + ...: generates the field for all but finitely many k.
MFraction primitive_candidate(const VectorField& v, long k) {
  MFraction theta(v.ring);
  Rational weight(1);
  for (const std::size_t c : v.constants) {
    theta += weight * MFraction::variable(v.ring, c);
    weight *= Rational(k);
  }
  return theta;
}

} // namespace

bool constants_are_numbers(const VectorField& v) {
  return v.constants.empty() || relations_among_constants(v).dimension() == 0;
}

ConstantField ConstantField::make(const VectorField& v) {
  if (v.constants.empty()) return {};
  const FiniteAlgebra algebra(constant_relations(v));
  for (long k = 1; k < 50; ++k) {
    const MFraction candidate = primitive_candidate(v, k);
    const auto theta = *algebra.evaluate(candidate);
    const auto minimal = algebra.minimal_polynomial(theta);
    if (minimal.size() != algebra.dimension() + 1) continue;
    auto coefficients = mapped<NfElem>(minimal, [&](const auto& c) { return to_rational(c); });
    const std::string name = v.constants.size() == 1 ? v.ring->name(v.constants[0]) : "theta";
    const auto [field, root] = field_of_root(Poly::from_coefficients(coefficients), name);
    ConstantField result;
    result.field_ = field;
    if (!field->is_rational()) result.generator_ = Rational(field->scale()) * candidate;
    Matrix powers(algebra.dimension()); // columns: 1, theta, theta^2, ...
    auto power = algebra.constant(MFraction(v.ring, Rational(1)));
    for (std::size_t i = 0; i < algebra.dimension(); ++i) {
      for (std::size_t r = 0; r < powers.size(); ++r)
        powers[r].push_back(power[r]);
      power = algebra.multiply(power, theta);
    }
    for (const std::size_t c : v.constants) {
      const auto x = solve_linear(powers, *algebra.evaluate(MFraction::variable(v.ring, c)));
      NfElem value(field);
      for (std::size_t i = x->size(); i-- > 0;)
        value = value * root + NfElem(to_rational((*x)[i]), field);
      result.values_[c] = value;
    }
    return result;
  }
  throw InvalidArgument("the relations of the algebraic constants do not define a field");
}

RationalFunction ConstantField::convert(const MFraction& f, std::size_t z) const {
  if (is_zero(f)) return {Poly(field_)};
  return {to_poly(f.num(), z, field_, values_), to_poly(f.den(), z, field_, values_)};
}

} // namespace kov
