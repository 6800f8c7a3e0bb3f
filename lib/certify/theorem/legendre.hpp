#pragma once
// A Hamiltonian that comes from a Lagrangian: theorem_certificates.md 1, (L1) to (L3).

#include "certify/system/certificate.hpp"
#include "proof/algebra/arithmetic.hpp"

namespace kov::certify {

/// Quadratic in the velocities, which come after the names of phase space in the ring.
struct LagrangianForm {
  PhaseFunction value;
  std::vector<std::size_t> momenta;      ///< coordinates, one for each velocity
  std::vector<PhaseFunction> velocities; ///< on phase space
};

/// LAGRANGIAN, checked.
/// Errors  InvalidArgument, Refused
[[nodiscard]] LagrangianForm read_lagrangian(const Node& n, const PhaseSystem& s, Arithmetic& a);
/// "  H is the energy of the Lagrangian L = ..., M1 = dL/dOmega1"
[[nodiscard]] std::string shown_lagrangian(const LagrangianForm& l, const PhaseSystem& s);

} // namespace kov::certify
