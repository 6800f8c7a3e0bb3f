#pragma once
// The certificate of what Darboux points exclude (docs/theory/theorem_certificates.md 16).

#include "certify/theorem/darboux.hpp"
#include "parameters/case_proof.hpp"

namespace kov {

/// What a step about Darboux points says, and of which part of the potential.
struct DarbouxSaid {
  bool relation = true; ///< else: a point is multiple
  certify::PotentialPart part = certify::PotentialPart::all;
};

/// The members of the step beside `system`, `at` and `region`; given: what is known there, with the values
/// put in.   Errors  DomainError: none is found; OutOfBudget, certify::Refused
[[nodiscard]] Json::Object darboux_members(const certify::FamilyStratum& x,
                                           const std::vector<Condition>& given,
                                           const DarbouxSaid& said, const CaseProof& proof);

} // namespace kov
