#pragma once
// How the strata were found: the splits p = 0 / p != 0 with a verdict at each leaf.  A
// certificate over strata is written from this tree (docs/theory/strata_certificates.md, 4).

#include "literature/trusted.hpp"
#include "strata/leaf.hpp"

#include <memory>

namespace kov::strata {

/// Why a stratum is open: there are too many of them, or a limit or an error ended it, in its words.
struct TooManyStrata {};
struct Ended {
  std::string shown;
};
/// Why a stratum is empty.
struct ContradictsAssumptions {};
struct AssumedEquationFails {};
/// Or a decision of Z3 that it is empty; nothing is said of other nodes.
using WhyEnded = std::variant<std::monostate, TooManyStrata, Ended, ContradictsAssumptions,
                              AssumedEquationFails, Trusted>;

struct ProofTree;
using ProofTreePtr = std::shared_ptr<const ProofTree>;

/// Given   Question bessel; bessel.r = a / z;
/// Example decide_strata(bessel).tree->kind  // -> Kind::split
/// Example decide_strata(bessel).tree->p  // -> a
struct ProofTree {
  enum class Kind : std::uint8_t {
    split,   ///< p = 0 (zero) and p != 0 (nonzero)
    assumed, ///< p = 0 follows from an assumed equation: zero only
    leaf,    ///< the verdict `leaf`
    root,    ///< the verdict at a root of p, as one number in Q[x]/(p)
    related, ///< p = 0 is kept as a relation; the stratum goes on with `zero`
    empty,   ///< the stratum has no point
    open     ///< nothing is known
  };
  Kind kind = Kind::open;
  MPoly p;
  std::shared_ptr<const ParametrisedSet>
      region; ///< of this node; of a zero branch that was not solved: of its parent
  ProofTreePtr nonzero, zero;
  std::optional<Leaf> leaf;
  WhyEnded ended{}; ///< of an empty or an open one
};

} // namespace kov::strata
