#pragma once
// Claims about a system, proved or refuted exactly.
//
//   integral F   X(F) = 0        modulo the relations, and on the level if one is named
//   casimir  F   J grad F = 0
//   darboux  G   X(G) = K G      for a function K defined where G = 0 is
//   poisson      {F, G} = value
//   equal        left = right, or: this field equals another one (Euler-Lagrange form, other file)
//
// A proof is an ideal membership; a refutation shows the function that is not zero.

#include "system/system.hpp"

namespace kov {

/// Proved or refuted, with the function that shows it.
struct ClaimResult {
  bool proved = false;
  std::string detail; ///< proved: how; refuted: the function that is not zero
  /// integral: X(F) reduced; darboux, proved: the cofactor; poisson, equal: the difference
  MFraction witness;
  std::vector<MPoly> generic; ///< parameters for which the proof holds: none of these is 0
  std::string open;           ///< the limit that left it neither proved nor refuted (decide_claim)
};

/// Requires a claim with a function, not `other`.
/// Errors  InvalidArgument for a casimir or poisson claim on a system without a bracket;
/// OutOfBudget
/// Given   const System oscillator = read_system(parse_document(
///             "system = {kind = 'hamiltonian', coordinates = ['q'], momenta = ['p'], "
///             "parameters = ['a'], hamiltonian = 'p^2/2 + a*q^2/2'}", "oscillator.toml"));
/// Given   SystemClaim energy, position;
/// Given   energy.value = formula(oscillator, "H"), position.value = formula(oscillator, "q");
/// Example check_claim(oscillator.field, energy).proved  // -> yes
/// Example check_claim(oscillator.field, position).witness  // -> p
[[nodiscard]] ClaimResult check_claim(const VectorField& v, const SystemClaim& claim,
                                      const Budget& budget = {});

/// The Euler-Lagrange form on the group against the Poisson form, component by component:
///   M' = (M - B) x Omega + dL/dGamma x Gamma,  Gamma' = Gamma x Omega,  Omega = Omega(M, Gamma).
/// Requires kind lagrangian.   Source  [PrzybylskaMaciejewski2024] eq. (lag_borisov)
[[nodiscard]] ClaimResult check_euler_lagrange(const System& s);

/// The components of two fields, matched by the names of their variables.
[[nodiscard]] ClaimResult check_same_field(const VectorField& v, const VectorField& other);

/// The same system; on e(3)* its Casimir functions are among the claims, in no line of the file if it does
/// not name them.
/// Given   const System body = read_system(parse_document(
///             "system = {kind = 'euler-poisson', coordinates = ['M1', 'M2', 'M3', 'G1', 'G2', 'G3'], "
///             "hamiltonian = 'M1^2 + M2^2 + 2*M3^2 + G1'}", "body.toml"));
/// Example with_known_casimirs(body).claims.size()  // -> 2
/// Example with_known_casimirs(oscillator).claims.size()  // -> 0
[[nodiscard]] System with_known_casimirs(System s);

/// Any claim of a file; other files are found beside it.
[[nodiscard]] ClaimResult check_claim(const System& s, const SystemClaim& claim,
                                      const Budget& budget = {});
/// The same, and a limit is a result.
[[nodiscard]] ClaimResult decide_claim(const System& s, const SystemClaim& claim,
                                       const Budget& budget = {});
struct ClaimReport {
  SystemClaim claim;
  ClaimResult result;
};
/// Every claim of the system; a limit is a result.
[[nodiscard]] std::vector<ClaimReport> decide_claims(const System& s, const Budget& budget = {});
/// Neither more nor less was found than the file says.
[[nodiscard]] bool is_met(const SystemClaim& claim, const ClaimResult& result) noexcept;

} // namespace kov
