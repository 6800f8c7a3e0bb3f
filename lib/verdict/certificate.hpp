#pragma once
// What the solver found, written down for the judge: a certificate (docs/theory/certificates.md)
// of the group, or of as much as is known.

#include "certify/certificate.hpp"
#include "galois/classify.hpp"

#include <string>

namespace kov {

/// Steps and witnesses for everything that `c` states about y'' = r y.
///
/// Requires  c = classify(r), with something stated (a group, or whether G0 is abelian)
/// Cost      that of the searches it repeats on the judge's own bounds: some recurrences and ranks
///           modulo one prime
/// Throws    OutOfBudget where a witness was not found within the limits
[[nodiscard]] certify::Certificate certificate(const Classification& c, const RationalFunction& r,
                                               const Budget& budget = {});

/// The judge's opinion of a certificate in its final form, as text.
struct Judged {
  std::string json;
  std::string refusal; ///< empty: accepted
};
[[nodiscard]] Judged judged(const certify::Certificate& c);

} // namespace kov
