#pragma once
// The results of `check` along the manifolds that a file names: `classify` begins with it.
//
// Here the file is studied as it stands, with its own claims, levels and assumptions.  Later stages
// study the same sets in another system (more integrals, free levels), and under a limit they may
// prove less.
//
// Source  docs/theory/classify.md (7, 8)

#include "classify/classify.hpp"
#include "study/exclusion.hpp"

namespace kov {

/// One manifold of the file.
struct StatedSolution {
  std::string name;
  std::vector<Exclusion> exclusions = {}; ///< in the ring of the file's system
  std::string outcome;                    ///< in words, for those parameters that stay open
  Spent spent = {};
  bool finished = false; ///< no limit ended it
};

struct StatedSolutions {
  std::vector<ClaimReport> claims; ///< of the file
  std::vector<StatedSolution> all;
  bool decided = false; ///< together they exclude all parameters
};

/// options.so_far is called before each manifold; those with a name in options.skip are left out.
/// Nothing is concluded where the file restricts a level so that there may be none for some
/// parameters (is_free_of_levels() in stated.cpp).
[[nodiscard]] StatedSolutions stated_solutions(const System& s, const ClassifyOptions& options);

/// The same conditions in a ring that has the same names.
[[nodiscard]] Exclusion in_ring(Exclusion e, const Ring& ring);

/// The outcome along a manifold that excludes nothing, in words.
[[nodiscard]] std::string outcome(const ManifoldReport& report);

} // namespace kov
