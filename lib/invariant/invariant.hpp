#pragma once
// Invariants of degree m of the Galois group = rational solutions v of the m-th symmetric power,
// from the power series of two solutions at one ordinary point and m+1 unknowns.
//
// The value v = F(y1, y2) of an invariant form F is P prod q^e_q with deg P <= D_m
// (degree_bounds.hpp).  So the coefficients beyond D_m of  sum_i c_i y1^i y2^(m-i) prod q^-e_q must
// vanish: a matrix with m+1 rows.  Rank m+1 modulo one good prime proves that no invariant exists;
// a kernel modulo primes is only a guess until it is lifted and checked by the recurrence of
// symmetric_power.hpp.
//
// Source  docs/theory/invariants_one_point.md, with proofs

#include "exact/modular.hpp"
#include "linode/degree_bounds.hpp"

#include <optional>
#include <vector>

namespace kov {

/// v = p * prod q_i^e_i over the finite places of the equation.
struct Invariant {
  long m = 0;
  Poly p;
  std::vector<long> e;
};

/// Why Sym^m has no rational solution.
struct NoInvariant {
  long m = 0;
  std::optional<Obstruction> obstruction{}; ///< the exponents alone exclude it
  PrimeIdeal prime{};                       ///< otherwise: rank m+1 modulo this prime ...
  mp_limb_t point = 0;                      ///< ... at this ordinary point ...
  long terms = 0;                           ///< ... from this many terms
};

/// All rational solutions of Sym^m, with the proof that there are no more.
struct InvariantSearch {
  long m = 0;
  std::vector<Invariant> basis; ///< a basis of all rational solutions, each verified
  std::optional<NoInvariant> none;
  /// The prime whose rank proves that there are no more than basis.size().
  std::optional<NoInvariant> no_more;
};

/// Requires  m even
/// Cost      O(m (n + D_m)) modulo each prime; as many primes as the answer has digits
/// Throws    OutOfBudget
/// Given     const Singularities s = singularities(RationalFunction(16*z - 3, 16*z*z));
/// Example   value(invariants(s, 4).basis.front(), s)  // -> z
[[nodiscard]] InvariantSearch invariants(const Singularities& s, long m, const Budget& budget = {});

/// Absence alone: a proof that Sym^m has no rational solution, or nothing (which proves nothing).
/// Cost  O(m (n + D_m)) modulo one prime
/// Throws OutOfBudget
/// Example no_invariant(singularities(z), 4)->obstruction->kind  // -> Kind::negative_degree
/// Example no_invariant(s, 4).has_value()  // -> no
[[nodiscard]] std::optional<NoInvariant> no_invariant(const Singularities& s, long m,
                                                      const Budget& budget = {});

/// The rational function v.
[[nodiscard]] RationalFunction value(const Invariant& v, const Singularities& s);

} // namespace kov
