#pragma once
// The monodromy and Stokes matrices as a second opinion on y'' = r y: what strict inequalities between balls
// prove of the group, beside the answer that was found by algebra.
//
// Equality is never concluded from balls, so the opinion is a lower bound of the group: it can
// prove SL(2, C), irreducibility, that the group is infinite, and contradict an answer that is too
// small.

#include "decide/decide.hpp"
#include "integrability/loops_certificate.hpp"
#include "monodromy/words.hpp"

namespace kov {

struct MonodromyOpinion {
  std::size_t loops = 0;  ///< around the finite singularities
  std::size_t stokes = 0; ///< Stokes matrices at infinity (monodromy/stokes.hpp)
  std::optional<monodromy::Sl2Proof> sl2;
  std::optional<monodromy::NoCommonLine> irreducible; ///< looked for where sl2 is unset
  std::optional<monodromy::HyperbolicWord> infinite;  ///< likewise
  std::string limit;               ///< why there are no matrices; empty: there are
  std::optional<LoopsProof> proof; ///< of SL(2, C), where it was asked for and is proved
};

/// Matrices of y'' = r y with radii below 10^-digits, and what they prove.  A certificate is one of
/// loops only: Stokes matrices are not replayed.
[[nodiscard]] MonodromyOpinion monodromy_opinion(const RationalFunction& r, long digits,
                                                 const Budget& budget = {},
                                                 bool with_certificate = false);

/// The part of the answer that cannot be, as a clause; empty: nothing.
[[nodiscard]] std::string contradiction(const MonodromyOpinion& opinion, const Decision& answer);

} // namespace kov
