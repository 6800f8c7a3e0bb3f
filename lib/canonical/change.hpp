#pragma once
// Canonical changes of variables of a Hamiltonian system: the same motion, written as the searches
// of other rooms want it.
//
//   (q, p) -> (Q, P)  with  {Q_i, Q_j} = {P_i, P_j} = 0,  {Q_i, P_j} = delta_ij
//
// On e(3)*: an invertible change of M, Gamma to others with the same brackets.
//
// A change is proposed by a search (simplify.hpp) and accepted by is_canonical(), which knows nothing
// of that search: brackets, Hamiltonian, relations and derivatives are compared exactly.
//
// Source  docs/theory/canonical.md

#include "system/system.hpp"

namespace kov {

struct CanonicalChange {
  System system; ///< in the new variables; only the parameters and what is assumed of them are kept
  /// The new coordinates and momenta as functions of the old variables, in the order of
  /// system.field.coordinates, in the ring of the old system.
  std::vector<MFraction> variables;
  /// The same for function symbols that the old system does not have, by their variable.
  std::map<std::size_t, MFraction> functions = {};
};

/// Every bracket, the Hamiltonian, each relation and each derivative of a function symbol of the new
/// system, put back into the old variables: proved, for all parameters at which both systems are
/// defined.
[[nodiscard]] bool is_canonical(const System& old, const CanonicalChange& change,
                                const Budget& budget = {});

/// "q1 = q - 1", "p": each coordinate and momentum, and functions that are new.
[[nodiscard]] std::vector<std::string> in_words(const CanonicalChange& change);

/// A function of the new variables in the old ones.
/// Errors  DomainError: it has no value there
[[nodiscard]] MFraction in_old_variables(const CanonicalChange& change, const Ring& old,
                                         const MFraction& f);

} // namespace kov
