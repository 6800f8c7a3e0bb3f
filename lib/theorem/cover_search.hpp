#pragma once
// Searches the tree of a cover (docs/theory/theorem_certificates.md 8): every real point with the
// assumptions lies in a region, or a product of symmetries sends it there.

#include "parameters/refutation.hpp"

namespace kov {

/// A region with the symmetries that are applied to the point, the last one first.
struct CoverPiece {
  std::size_t part = 0;
  std::vector<std::size_t> word;
  std::vector<Condition> region; ///< with the symmetries put in
};

/// The tree, or nothing if it is not found.   Errors  OutOfBudget
[[nodiscard]] std::optional<Json> cover_tree(const Ring& ring,
                                             const std::vector<Condition>& assumed,
                                             const std::vector<CoverPiece>& pieces,
                                             const Budget& budget = {});

} // namespace kov
