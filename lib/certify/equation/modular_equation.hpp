#pragma once
// The equation y'' = r y modulo a prime: good primes, expansions at a root of a place, series.

#include "certify/equation/facts.hpp"

namespace kov::certify {

struct Equation {
  Poly num, den; ///< r = num/den, den monic
};

/// r modulo a good prime (certificates.md §1).
struct Reduced {
  PrimeIdeal prime;
  NmodPoly num, den;
};

/// Refuses unless p is an odd prime below 2^62, a is a root of the minimal polynomial modulo p, and
/// r is p-integral.
[[nodiscard]] Reduced reduce(const Equation& e, const Field& k, const PrimeIdeal& prime);
/// Image of f; refuses if f is not p-integral.
[[nodiscard]] NmodPoly reduce(const Poly& f, const PrimeIdeal& prime);
/// Refuses unless f (monic) stays squarefree, and coprime to other, modulo the prime.
void need_squarefree(const Poly& f, const Reduced& r, const Poly* other = nullptr);

/// The curve S^2 = w^2 F0 modulo a prime.
struct ReducedCurve {
  NmodPoly branch; ///< F0
  mp_limb_t w_squared;
};
/// All that is asked of a prime before the curve is looked at modulo it, by both rules about it and
/// by the search for such primes (dihedral_torsion.md 6): refuses unless r is p-integral, a is a
/// simple root of the minimal polynomial, and w^2 is a unit modulo p.
[[nodiscard]] ReducedCurve reduce_curve(const Equation& e, const Field& k, const Poly& branch,
                                        const NfElem& w_squared, const PrimeIdeal& prime);
/// Refuses unless F0 is squarefree modulo p: the curve has good reduction (dihedral_torsion.md 7).
void need_smooth(const ReducedCurve& c);
/// Is f, not 0, a constant times a square over the algebraic closure of F_p?  p odd.
[[nodiscard]] bool is_square(const NmodPoly& f);
/// Inverse of f modulo q; refuses if there is none.
[[nodiscard]] NmodPoly inverse_mod(const NmodPoly& f, const NmodPoly& q);
[[nodiscard]] NmodPoly remainder(const NmodPoly& f, const NmodPoly& q);

/// t^order r = num/den, both not 0 at t = 0; t = z - root, or 1/z for r(1/t)/t^4.
struct Expansion {
  NmodPoly num, den;
  long order = 0;
};
[[nodiscard]] Expansion expand(const Reduced& r, std::optional<mp_limb_t> root, long order);

/// S = t^nu omega with S_0 = s0 modulo t^terms, where omega' + omega^2 = r; nothing when a
/// logarithm forbids it (riccati_one_place.md, 2).  Cost O(terms^2 + terms log terms).
[[nodiscard]] std::optional<std::vector<mp_limb_t>> riccati(const Expansion& e, mp_limb_t s0,
                                                            long terms);

/// Does the place with exponent difference delta (a natural number >= 1) carry a logarithm at the
/// root?  Refuses if not seen modulo p.
void need_log(const Reduced& r, std::optional<mp_limb_t> root, const Rational& delta);

} // namespace kov::certify
