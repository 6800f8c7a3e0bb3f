#pragma once
// The findings of the solver, written down for the judge: a certificate
// (docs/theory/certificates.md) of the group, or of as much as is known.

#include "certify/equation/certificate.hpp"
#include "decide/afterwards.hpp"
#include "galois/classify.hpp"

#include <string>

namespace kov {

/// The judge has looked at a step and refuses it: what was found is in doubt.
class RefusedByChecker : public Contradiction {
  using Contradiction::Contradiction;
};

/// Steps and witnesses for everything that `c` states about y'' = r y.
///
/// Requires  c = classify(r), with something stated (a group, or whether G0 is abelian)
/// Cost      that of the searches it repeats on the judge's own bounds: some recurrences and ranks
///           modulo one prime
/// Throws    OutOfBudget where a witness was not found within the limits; RefusedByChecker
[[nodiscard]] certify::Certificate certificate(const Classification& c, const RationalFunction& r,
                                               const Budget& budget = {});

/// The judge's opinion of a certificate in its final form, as text.
struct Judged {
  std::string json;
  std::string refusal; ///< empty: accepted
  bool limit = false;  ///< refused for its size, or not read: nothing was found to be false
};
/// Example judged(certificate(classify(z), z)).refusal.empty()  // -> yes
[[nodiscard]] Judged judged(const certify::Certificate& c);

} // namespace kov
