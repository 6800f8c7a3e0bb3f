#include "splitting/perturbation.hpp"

#include "exact/error.hpp"
#include "system/weights.hpp"

namespace kov {
namespace {

// H0 = (a M1^2 + b M2^2 + c M3^2)/2 and nothing else.
std::array<MFraction, 3> free_top(const System& s, const MFraction& h0) {
  std::array<MFraction, 3> inverse;
  MFraction rest = h0;
  for (int k = 0; k < 3; ++k) {
    const std::size_t m = s.field.coordinates[k];
    const MFraction x = MFraction::variable(s.ring(), m);
    inverse[k] = derivative(derivative(h0, m), m);
    rest -= Rational(Integer(1), Integer(2)) * inverse[k] * x * x;
  }
  for (const auto& a : inverse)
    for (const std::size_t j : s.field.coordinates)
      if (uses(a, j)) rest = MFraction(s.ring(), Rational(1));
  if (!is_zero(rest))
    throw DomainError("the unperturbed Hamiltonian " + brief(h0) +
                      " is not that of a free rigid body in principal axes");
  return inverse;
}

} // namespace

EulerPerturbation perturbation_of_euler(const System& s, const std::vector<std::string>& small) {
  bool on_e3 = s.kind == SystemKind::euler_poisson || s.kind == SystemKind::lagrangian;
  for (const auto& b : s.gyrostat)
    on_e3 = on_e3 && is_zero(b);
  if (!on_e3 || !s.field.hamiltonian || s.field.dimension() != 6)
    throw DomainError("a Hamiltonian system on e(3) without gyrostat was expected");
  Weights weights;
  for (const std::string& name : small)
    weights[s.ring()->index(name)] = 1;
  const auto terms = weight_expansion(*s.field.hamiltonian, weights, 2);
  if (terms.size() < 2 || terms.front().degree != 0)
    throw DomainError("H is not a perturbation: its expansion in the small parameters has no "
                      "first-order term or no term of order 0");
  EulerPerturbation p;
  p.system = s.title;
  p.small = small;
  p.order = terms[1].degree;
  p.unperturbed = terms[0].value;
  p.first = terms[1].value;
  for (const Assumption& x : s.assumptions)
    for (const std::size_t v : used_variables(x.value))
      if (x.relation == Assumption::Relation::positive &&
          x.value == MFraction::variable(s.ring(), v))
        p.positive.push_back(s.ring()->name(v));
  for (std::size_t j = 0; j < 6; ++j)
    p.coordinates[j] = s.field.coordinates[j];
  p.inverse_inertia = free_top(s, p.unperturbed);
  for (const std::size_t j : s.field.coordinates)
    if (uses(MFraction(p.first.den()), j))
      throw DomainError("the first-order Hamiltonian is not a polynomial in M and Gamma");
  return p;
}

} // namespace kov
