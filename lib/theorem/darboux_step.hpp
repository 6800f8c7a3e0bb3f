#pragma once
// The certificate of what Darboux points exclude (docs/theory/theorem_certificates.md 16).

#include "certify/theorem/computed.hpp"
#include "parameters/case_proof.hpp"

#include <variant>

namespace kov {

/// The statement of a step about Darboux points, and the part of the potential it is about.
struct DarbouxSaid {
  bool relation = true; ///< else: a point is multiple
  certify::PotentialPart part = certify::PotentialPart::all;
};

/// Why a step about Darboux points has no certificate, in the order in which it is looked for.
struct NoDarbouxStep {
  enum class Why : std::uint8_t {
    other_system, ///< not two degrees of freedom with constant masses and a polynomial potential
    no_potential,
    refused,       ///< by the judge's own functions
    at_infinity,   ///< a direction is not in the chart
    form_vanishes, ///< a form of the chart is 0
    none_proper,   ///< no direction is one of a Darboux point
    zero_value,    ///< what must not be 0 is 0
    not_shown,     ///< of a polynomial: that it is 0, or is not 0
    improper,      ///< a direction of no Darboux point is not shown to be one
    unknown_sum,   ///< of the inverses of the eigenvalues
    eigenvalues,   ///< their polynomial has another degree
    choice,        ///< a set of eigenvalues is not excluded
    limit          ///< the work that a step may cost
  };
  /// The choice that may change it: a failure that depends on no chart is one in each of them.
  enum class Depends : std::uint8_t { on_nothing, on_chart, on_statement };
  Why why = Why::other_system;
  std::string of{}; ///< of which polynomial, or eigenvalues
  /// not_shown, choice: where one of these vanishes, or none does, more may be known
  std::vector<MPoly> unknown{};
  Depends depends = Depends::on_nothing;
};
[[nodiscard]] std::string sentence(const NoDarbouxStep& no);

/// The members of the step beside `system`, `at` and `region`; given: what is known there, with the values
/// put in.   Errors  OutOfBudget
[[nodiscard]] std::variant<Json::Object, NoDarbouxStep>
darboux_members(const certify::StepPlace& x, const std::vector<Condition>& given,
                const DarbouxSaid& said, const CaseProof& proof);

} // namespace kov
