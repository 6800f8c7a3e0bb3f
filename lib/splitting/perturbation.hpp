#pragma once
// A Hamiltonian on e(3)* as a perturbation of the Euler top, in powers of a small vector.
//
//   H(M, Gamma; eps S) = H0(M) + eps^n H1(M, Gamma; S) + ...,
//   H0 = (a M1^2 + b M2^2 + c M3^2)/2,   H1 a polynomial in M and Gamma.

#include "splitting/andoyer_chart.hpp"
#include "system/weights.hpp"

namespace kov {

/// H on e(3)*, and the parameters that are made small: eps^w times a parameter of weight w.
struct EulerFamily {
  std::string title;
  MFraction hamiltonian;
  std::array<std::size_t, 6> coordinates; ///< M1 M2 M3 Gamma1 Gamma2 Gamma3
  Weights small;                          ///< positive
  std::vector<std::string> positive;
};

struct EulerPerturbation {
  std::string system;                     ///< title of the case file
  std::vector<std::string> small;         ///< the parameters in H1 that are scaled: L = eps S
  std::vector<std::string> positive;      ///< parameters that the file assumes to be positive
  long order = 0;                         ///< n
  MFraction unperturbed, first;           ///< H0, H1 in the ring of the system; `small` now means S
  std::array<std::size_t, 6> coordinates; ///< M1 M2 M3 Gamma1 Gamma2 Gamma3
  std::array<MFraction, 3> inverse_inertia; ///< a, b, c
};

/// Requires coordinates M1 M2 M3 Gamma1 Gamma2 Gamma3.
/// Errors  DomainError with a sentence when H0 is not a free top or H1 is not polynomial
[[nodiscard]] EulerPerturbation perturbation_of_euler(const System& s,
                                                      const std::vector<std::string>& small);

/// The same of any family; `small` are those of its small parameters that occur in H1.
/// Errors  DomainError with a sentence when H0 is not a free top or H1 is not polynomial
[[nodiscard]] EulerPerturbation perturbation_of_euler(const EulerFamily& family);

} // namespace kov
