#pragma once
// One leaf of a certificate over strata: the places, the exponents and the theorem that make the
// solver's verdict checkable.  docs/theory/strata_certificates.md, 6 and 7

#include "strata/known_facts.hpp"
#include "strata/proof_tree.hpp"

#include <stdexcept>

namespace kov::strata {

/// The verdict of the solver is not a case of the certificate's rules, or rests on Z3.
class NoProof : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// The leaf node for y'' = r y on the stratum `region`, known to the judge as `facts`; the lemmas
/// that it needs are appended.  Requires leaf.abelian = yes or no.
/// Throws  NoProof, OutOfBudget
[[nodiscard]] certify::Json leaf_certificate(const Leaf& leaf, const MFraction& r, std::size_t z,
                                             const Region& region, KnownFacts& facts,
                                             std::vector<Lemma>& lemmas, const Budget& budget);

/// The certificate of an equation without parameters, as a JSON value.
[[nodiscard]] certify::Json number_certificate(const Decision& d);

} // namespace kov::strata
