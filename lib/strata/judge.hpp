#pragma once
// The verdict on one stratum, or what has to be decided first.
//
//   G0 is abelian  <=>  Sym^4 has a rational solution             some place irregular or
//   irrational
//                  <=>  Sym^12 or Sym^n has one                   all Delta rational constants, n
//                  the
//                                                                 least common denominator of the
//                                                                 exponents (1 + Delta)/2
//
// and where an exponent difference is open, abelian forces it into an explicit set of rational
// numbers; if its square is bounded that set is finite, and every element is a stratum of its own.
// docs/theory/strata.md, 5 to 7

#include "strata/invariant_system.hpp"
#include "verdict/decide.hpp"

namespace kov::strata {

struct Leaf {
  Truth abelian = Truth::unknown;
  std::optional<GaloisGroup> group; ///< where it is the same on the whole stratum
  std::string group_text;           ///< for people: "SL(2, C)", "in the infinite dihedral group"
  std::string reason;
  std::string open_condition;     ///< undecided: "abelian only if ..."
  bool irregular = false;         ///< some singular place is irregular on the stratum
  bool no_equation = false;       ///< undecided because r does not mean anything here
  std::optional<Decision> number; ///< the equation has no parameters here
  std::optional<ParametricInvariant> invariant; ///< abelian because of it
  std::vector<TraceStep> trace; ///< if asked for: the first case, as it is done by hand
};

/// r in the parameters left in the region.
[[nodiscard]] std::variant<Leaf, Needs> judge(const MFraction& r, std::size_t z,
                                              const Region& region, const Options& options = {});

/// The leaf of an equation without parameters.
[[nodiscard]] Leaf leaf_of(const Decision& d);

/// Abelian at most where `otherwise`, or on a thin set that was not looked at, where the
/// polynomials vanish.
[[nodiscard]] Leaf unsettled(const Unsettled& where, const std::string& otherwise = {});

} // namespace kov::strata
