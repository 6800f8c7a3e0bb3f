#include "splitting/perturbation.hpp"

#include "exact/error.hpp"

namespace kov {
namespace {

// H0 = (a M1^2 + b M2^2 + c M3^2)/2 and nothing else.
std::array<MFraction, 3> free_top(const EulerFamily& family, const MFraction& h0) {
  std::array<MFraction, 3> inverse;
  MFraction rest = h0;
  for (int k = 0; k < 3; ++k) {
    const std::size_t m = family.coordinates[k];
    const MFraction x = MFraction::variable(h0.ring(), m);
    inverse[k] = derivative(derivative(h0, m), m);
    rest -= Rational(Integer(1), Integer(2)) * inverse[k] * x * x;
  }
  for (const auto& a : inverse)
    for (const std::size_t j : family.coordinates)
      if (uses(a, j)) rest = MFraction(h0.ring(), Rational(1));
  if (!is_zero(rest))
    throw DomainError("the unperturbed Hamiltonian " + brief(h0) +
                      " is not that of a free rigid body in principal axes");
  return inverse;
}

} // namespace

EulerPerturbation perturbation_of_euler(const EulerFamily& family) {
  const auto terms = weight_expansion(family.hamiltonian, family.small, 2);
  if (terms.size() < 2 || terms.front().degree != 0)
    throw DomainError("H is not a perturbation: its expansion in the small parameters has no "
                      "first-order term or no term of order 0");
  EulerPerturbation p;
  p.system = family.title;
  p.order = terms[1].degree;
  p.unperturbed = terms[0].value;
  p.first = terms[1].value;
  for (const auto& [i, weight] : family.small)
    if (uses(p.first, i)) p.small.push_back(p.first.ring()->name(i));
  p.positive = family.positive;
  p.coordinates = family.coordinates;
  p.inverse_inertia = free_top(family, p.unperturbed);
  for (const std::size_t j : p.coordinates)
    if (uses(MFraction(p.first.den()), j))
      throw DomainError("the first-order Hamiltonian is not a polynomial in M and Gamma");
  return p;
}

EulerPerturbation perturbation_of_euler(const System& s, const std::vector<std::string>& small) {
  bool on_e3 = s.kind == SystemKind::euler_poisson || s.kind == SystemKind::lagrangian;
  for (const auto& b : s.gyrostat)
    on_e3 = on_e3 && is_zero(b);
  if (!on_e3 || !s.field.hamiltonian || s.field.dimension() != 6)
    throw DomainError("a Hamiltonian system on e(3) without gyrostat was expected");
  EulerFamily family{s.title, *s.field.hamiltonian, {}, {}, {}};
  for (const std::string& name : small)
    family.small[s.ring()->index(name)] = 1;
  for (std::size_t j = 0; j < 6; ++j)
    family.coordinates[j] = s.field.coordinates[j];
  for (const Assumption& x : s.assumptions)
    for (const std::size_t v : used_variables(x.value))
      if (x.is(Sign::positive) && x.value == MFraction::variable(s.ring(), v))
        family.positive.push_back(s.ring()->name(v));
  EulerPerturbation p = perturbation_of_euler(family);
  p.small = small; // in the order of the file
  return p;
}

} // namespace kov
