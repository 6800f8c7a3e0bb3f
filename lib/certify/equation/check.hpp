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

/// Never throws.
/// Cost  a few products of the size of each step's data; series proofs
///       O(terms * (deg num + deg den)), expansions at a place O(terms^2)
[[nodiscard]] std::variant<Accepted, Rejected> check(const Certificate& c);

} // namespace kov::certify
