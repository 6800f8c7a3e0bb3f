#pragma once
// The same motion at other parameters: x' = Phi(x), p' = pi(p).
//
//   (a) D Phi X_p = time * X_p' o Phi    (b) {Phi_i, Phi_j} = bracket * J_ij o Phi, at p'    (c) det D Phi != 0
//
// So f is an integral at p' where f o Phi is one at p; involution and independence are the same.  Square
// roots r of polynomials in the parameters may occur: both of their values serve.
//
// Source  docs/theory/moves.md (1)

#include "study/classification.hpp"
#include "system/system.hpp"

namespace kov {

/// A map from a system to one of the same family, by a change of variables that is linear.
struct Equivalence {
  Ring ring;                       ///< of the system, and of the root if there is one
  std::optional<std::size_t> root; ///< r, the last variable of the ring
  MPoly square;                    ///< r^2, in the ring of the system; not 0
  bool real = true;                ///< Phi and pi are, r too
  std::vector<MFraction> phase;    ///< Phi, in the order of the coordinates
  Substitution parameters;         ///< pi: those that change
  MFraction time, bracket;         ///< functions of the parameters that are not 0
};

/// "A -> B, B -> A", "a rotation to L2 = 0, L1 = sqrt(L1^2 + L2^2)"
[[nodiscard]] std::string in_words(const Equivalence& e);

/// (a), (b) and (c), by exact computation.
[[nodiscard]] bool holds(const System& s, const Equivalence& e);

/// f(pi(p)) = 0 as a condition on p, where r != 0.  Unset: r and -r have different ones.
[[nodiscard]] std::optional<MPoly> pulled_back(const Equivalence& e, const MPoly& f);
/// 0 exactly where f(pi(p)) is 0 for r or for -r.
[[nodiscard]] MPoly pulled_back_for_some_sign(const Equivalence& e, const MPoly& f);
/// The same of a function of the parameters.  Unset: it depends on the sign of r.
[[nodiscard]] std::optional<MFraction> pulled_back(const Equivalence& e, const MFraction& f);

/// A part of the preimage of a stratum: conditions on the parameters before the map, and what is proved.
/// The new parameters lie in the stratum for r or for -r.
struct Preimage : Cut {
  ClassifiedStratum stratum; ///< with another set
};
/// Unset: two of its equations, or its integrals, depend on the sign of r.
[[nodiscard]] std::optional<Preimage> carried(const System& s, const Equivalence& e,
                                              const ClassifiedStratum& x);

} // namespace kov
