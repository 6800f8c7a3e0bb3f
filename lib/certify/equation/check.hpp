#pragma once
// The judge: accepts a certificate or names the first step that fails.  It links lib/exact only and
// searches for nothing.

#include "certify/equation/certificate.hpp"
#include "proof/text/refused.hpp"

#include <cstddef>
#include <string>
#include <variant>

namespace kov::certify {

struct Rejected : Refused {
  std::string step = {}; ///< id of the step; empty: the certificate as a whole
  std::string id = {};   ///< of a theorem: of the step, as the certificate has it
};

struct Accepted {
  std::size_t trusted_steps = 0; ///< steps taken on faith, counted and never hidden
};

/// The finding of a judge, or its refusal at the rule that `at` names by then.
template <class Judge>
auto verdict_at(const std::string& at, const Judge& judge)
    -> std::variant<decltype(judge()), Rejected> {
  try {
    return judge();
  } catch (const Refused& no) {
    return Rejected{no, at};
  } catch (const std::exception& e) {
    return Rejected{{e.what()}, at};
  }
}

/// The finding of the judge of a certificate within another one, whose refusal begins with this.
template <class Found>
const Found& found_within(const std::variant<Found, Rejected>& verdict,
                          const std::string& before = "") {
  if (const auto* no = std::get_if<Rejected>(&verdict))
    throw Refused{before + (no->step.empty() ? "" : no->step + ": ") + no->why, no->limit};
  return std::get<Found>(verdict);
}

/// Never throws.
/// Cost  a few products of the size of each step's data; series proofs
///       O(terms * (deg num + deg den)), expansions at a place O(terms^2)
[[nodiscard]] std::variant<Accepted, Rejected> check(const Certificate& c);

} // namespace kov::certify
