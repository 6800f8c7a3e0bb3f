#pragma once
// The rule for closed answers of the format kovacic-strata/1 (strata_certificates.md 7.8): a
// classical equation after a change of variable, with the numbers that its criterion asks for.

#include "certify/strata/certificate.hpp"
#include "closed/criteria.hpp"
#include "strata/known_facts.hpp"

namespace kov::strata {

/// The leaf as the certificate has it: abelian everywhere, nowhere, or (unset) exactly where the
/// criterion holds; the first two only where the checker can see it, by memberships.
/// Throws  NoProof where something that must not vanish has no exact proof, or the family no rule
[[nodiscard]] certify::LeafNode classical_leaf(const ClassicalAnswer& answer, Truth abelian,
                                               const ParametrisedSet& region, KnownFacts& facts,
                                               std::vector<Lemma>& lemmas);

} // namespace kov::strata
