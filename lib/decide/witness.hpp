#pragma once
// Finite data from which the judge (lib/certify) can repeat what the solver knows: one function for
// each rule of docs/theory/certificates.md whose data have to be searched for.  What is found is
// tried on the judge before it is returned; a witness that is not found is an OutOfBudget.

#include "certify/equation/rules.hpp"
#include "exact/budget.hpp"
#include "galois/dihedral.hpp"
#include "linode/singularities.hpp"

namespace kov::witness {

/// How much of the local data a certificate has.
enum class Detail : std::uint8_t {
  places,    ///< where they are, and of which order
  exponents, ///< also Delta^2, logarithms, and proofs that a Delta is not rational
  growth     ///< also eps^2 and polynomials over Q for irrational Delta^2: what D_1 needs
};
/// Rule "local".
/// Cost     per place one evaluation; a logarithm with Delta = N costs O(N^2) modulo one prime
[[nodiscard]] certify::Local local(const certify::Judge& judge, const Singularities& s,
                                   Detail detail, const Budget& budget);

/// Rule "no-exponential": parity, degree, or one recurrence for each line at one place.
/// Cost  a series of 2L terms and Berlekamp-Massey, O(L^2) modulo one prime
[[nodiscard]] certify::NoExponential no_exponential(const certify::Judge& judge,
                                                    const Singularities& s,
                                                    const certify::LocalFact& local,
                                                    const Budget& budget);

/// Rule "no-invariant": degree, or the rank modulo one prime.
[[nodiscard]] certify::NoInvariant no_invariant(const certify::Judge& judge, long m,
                                                const certify::LocalFact& local,
                                                const Budget& budget);

/// Rule "torsion-function": h with h' = n (w/v) h, and for each prime l | n two points that show
/// that h is not an l-th power.  v: the solution g sqrt(F0) of Sym^2.
[[nodiscard]] certify::TorsionFunction
torsion_function(const certify::Judge& judge, const DihedralCurve& curve,
                 const DihedralAnswer& answer, const certify::InvariantFact& v,
                 const certify::LocalFact& local, const Budget& budget);

} // namespace kov::witness
