#pragma once
// The judge of certificates over strata: accepts one or names the first node that fails.  It links
// lib/exact only and searches for nothing (docs/theory/strata_certificates.md).

#include "certify/equation/check.hpp"
#include "certify/strata/certificate.hpp"

namespace kov::certify {

/// A leaf or a certificate that says "not abelian", for the class of first integrals (system_certificates.md 7).
struct Denial {
  bool regular = false; ///< all places are regular singular
  bool has_sl2 = false; ///< the group is SL(2)
  std::size_t trusted = 0;
  std::vector<Condition> path{}; ///< of a leaf: the conditions on the way to it
};
/// A certificate that says "not abelian".
[[nodiscard]] Denial denial_of(const Certificate& c, std::size_t trusted);

/// A leaf that says "abelian exactly where", as a denial elsewhere.
struct CriterionLeaf {
  Denial elsewhere;
  std::optional<OneDifference> difference;
};

struct StrataAccepted {
  std::size_t trusted = 0; ///< nodes and steps taken on faith, counted and never hidden
  // leaves, by what they say of the identity component
  std::size_t abelian = 0, not_abelian = 0;
  std::size_t by_criterion = 0;             ///< abelian exactly where a closed criterion holds
  std::size_t open = 0;                     ///< nothing is said
  std::size_t outside = 0;                  ///< no admitted points
  std::size_t empty = 0;                    ///< no points
  std::optional<bool> claim = {};           ///< of all admitted points
  std::vector<Denial> denials = {};         ///< the leaves that say "not abelian", in their order
  std::vector<CriterionLeaf> criteria = {}; ///< those that say "where"
  std::vector<std::string> lines = {};      ///< of the statement, for each leaf with points
};

/// Never throws.  Rejected::step is the path of the node.
/// Cost  counted polynomial products (Arithmetic), bounded by section 2 of the page.
[[nodiscard]] std::variant<StrataAccepted, Rejected> check_strata(const StrataCertificate& c);

} // namespace kov::certify
