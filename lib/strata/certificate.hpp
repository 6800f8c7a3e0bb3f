#pragma once
// The findings of decide_strata(), written down for the checker: a certificate in the format
// kovacic-strata/1 (docs/theory/strata_certificates.md).

#include "strata/decide_strata.hpp"
#include "strata/leaf_certificate.hpp"

#include <string>

namespace kov::strata {

/// A verdict that the checker has to believe, or does not hear of.
struct Uncertified {
  Gap gap = Gap::rule;                   ///< what is missing
  Conclusion theorem = Conclusion::none; ///< that shows the verdict; none: the stratum is empty
  Trusted told;
};

struct StrataCertificate {
  std::string json;
  bool says_anything = false; ///< some stratum is decided
  std::string refusal;        ///< what the checker of lib/certify has against it; empty: accepted
  bool limit = false;         ///< refused for its size, or not read: nothing was found to be false
  std::vector<Uncertified> trusted;  ///< nodes that rest on Z3 or on a theorem without a rule
  std::vector<Uncertified> left_out; ///< decided strata below a node that is left open
};

/// Why there is no accepted certificate, as a sentence: it is refused, or too large for the checker.
[[nodiscard]] std::string objection(const StrataCertificate& c);

/// Strata that the rules do not cover become `trusted` (decided by the solver alone) or `open`
/// (undecided) nodes.
///
/// Requires  a = decide_strata(...) with Options::want_certificate
/// Throws    InvalidArgument where a name is not an identifier; OutOfBudget
/// Cost      about that of the verdicts of all leaves once more; none where a.certificate is set
/// Given   Question airy; airy.r = z + a;
/// Given   StrataLimits limits; limits.decide.want_certificate = true;
/// Example certificate(decide_strata(airy, limits)).trusted.size()  // -> 0
[[nodiscard]] StrataCertificate certificate(const StrataAnswer& a, const Budget& budget = {});

/// Sets a.certificate, and a.refusal where our own checker refuses it, for another reason than its
/// size: then every verdict is taken back.  A step that the checker believes or does not hear of becomes a
/// trusted step of the answer, all of it where no certificate can be written.
void certify(StrataAnswer& a, const Budget& budget = {});

} // namespace kov::strata
