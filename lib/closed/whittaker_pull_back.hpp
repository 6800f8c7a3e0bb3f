#pragma once
// Is y'' = r y Whittaker's (or Bessel's) equation after a change of variable x = f(z), f in K(z)?
//
//   r = f'^2 (a + b/f + c/f^2) - S(f)/2,   S(f) = (f''/f')' - (f''/f')^2/2
//
// f' is known at its poles, which are the irregular places: there it is [sqrt r]/sqrt(a).  So f is
// known up to signs and a constant, and the constant makes a regular place a zero of f.  What is
// found is proved: the identity is compared exactly.
//
// Source  docs/theory/whittaker_pull_back.md, with proofs

#include "closed/recognize.hpp"
#include "exact/budget.hpp"
#include "linode/singularities.hpp"

#include <optional>

namespace kov {

/// u'' = (a + b/x + c/x^2) u with y = u(f)/sqrt(f').
struct WhittakerPullBack {
  NfElem a, b, c;
  RationalFunction f; ///< up to a factor: (a, b, c) go with it
};

/// Nothing found proves nothing: only signs over K, at most six irregular places, zeros of f at
/// places of r are tried, and of a what one irregular place of least degree says (1 at an even one
/// above 2).
/// Throws   OutOfBudget
/// Cost     for each choice of signs and of a zero a few products of the size of r
[[nodiscard]] std::optional<WhittakerPullBack> whittaker_pull_back(const Singularities& s,
                                                                   const Budget& budget = {});

/// The same as a recognised equation, with its answer where the group is connected: then the change
/// of variable does not make it smaller.
[[nodiscard]] std::optional<Recognized>
recognize_pull_back(const Singularities& s, const std::string& variable, const Budget& budget = {});

} // namespace kov
