#pragma once
// The Galois group of y'' = r y by polynomial-time engines: local data, degree bounds, the
// trichotomy, one exponential search, a few invariant searches, the torsion test.
//
//   T1  a place is irregular, or an exponent difference is irrational: G0 contains a torus, and
//       G0 is abelian <=> Sym^4 has a rational solution;  then Gm or Dinf, else SL2 or Borel.
//   T2  regular, exponent differences rational, a logarithm: T_m if an exponential solution exists,
//       else SL2.
//   T3  regular, rational, no logarithm: cyclic, T_m, D_n, Dinf, A4, S4, A5, SL2 by invariants.
//
// Source  docs/theory/trichotomy.md, with proofs

#include "galois/dihedral.hpp"
#include "galois/exponential_form.hpp"
#include "galois/group.hpp"
#include "invariant/invariant.hpp"
#include "pcurvature/p_curvature.hpp"
#include "riccati/exponential.hpp"

#include <optional>
#include <string>
#include <vector>

namespace kov {

enum class Trichotomy : std::uint8_t {
  irregular_or_irrational,
  logarithmic,
  rational_without_log,
  undetermined
};

/// How the group, or as much as is stated, follows from the evidence (docs/theory/trichotomy.md, 6).
enum class Argument : std::uint8_t {
  none,               ///< nothing is settled
  zero,               ///< r = 0
  p_curvature,        ///< one prime: SL2
  torus_two_lines,    ///< a torus, y1 y2 rational: Gm
  torus_dihedral,     ///< a torus, (y1 y2)^2 rational and y1 y2 not: Dinf
  torus_no_invariant, ///< a torus, no invariant of degree 4: not abelian; a line or not is open
  torus_one_line,     ///< the same with a line: Borel
  torus_no_line,      ///< the same without: SL2
  logarithm_one_line, ///< T_n
  logarithm_no_line,  ///< SL2
  integral_exponents, ///< no logarithm, all Delta integers: {1} or {+-1}
  two_quartics,       ///< two invariants of degree 4: the quaternion group
  two_radicals,       ///< two lines, cyclic
  fourth_power,       ///< the invariant of degree 4 is y^4: T_n
  dihedral,           ///< (y1 y2)^2 rational and y1 y2 not: D_n or Dinf, as `dihedral` says
  one_radical,        ///< exactly one line, and no invariant of degree 4: T_n
  line_alone,         ///< one line y, and v' = 2 (y'/y) v + 1 has no rational solution v
  no_invariant,       ///< no line, no invariant of degree 12: SL2
  primitive           ///< no line, none of degree 4: A4, S4 or A5 by the first invariant
};

/// The group together with everything that proves it.
struct Classification {
  std::optional<Singularities> local; ///< unset for r = 0
  Trichotomy kind = Trichotomy::undetermined;
  PlaceIndex decisive{}; ///< the place that decides the kind, but for rational_without_log

  std::optional<GaloisGroup> group;
  std::optional<Connected> component;
  Truth abelian = Truth::unknown;
  Argument argument = Argument::none;
  std::optional<Unable> undecided;

  // evidence: positive findings are verified, absences carry their proofs
  std::optional<ExponentialSolution> exponential; ///< over K, the only one
  std::optional<ExponentialPair> pair;            ///< two of them
  std::vector<InvariantSearch> invariants;        ///< every search that found something
  std::vector<NoInvariant> no_invariants;
  std::optional<NoExponential> no_exponential;
  std::optional<PCurvatureProof> p_curvature; ///< proves SL2 by itself
  std::optional<DihedralCurve> curve;
  std::optional<DihedralAnswer> dihedral;
};

/// Never throws for lack of budget: what stayed open is in `undecided`.
/// Cost    local data, then at most one exponential and three invariant searches, polynomial in the
///         degrees and the bounds D_m
/// Example describe(*classify(z).group)  // -> SL(2, C)
/// Example classify(z*z + 3).argument  // -> Argument::torus_one_line
/// Example classify(RationalFunction(16*z - 3, 16*z*z)).component  // -> Gm
[[nodiscard]] Classification classify(const RationalFunction& r, const Budget& budget = {});

/// The local data decide the branch, by the place `decisive`.
struct Branch {
  Trichotomy kind = Trichotomy::undetermined;
  PlaceIndex decisive{};
};
/// Given   const Singularities s = singularities(RationalFunction(-1, 4*z*z));
/// Example trichotomy(s).kind  // -> Trichotomy::logarithmic
[[nodiscard]] Branch trichotomy(const Singularities& s);

/// The argument as a sentence about an equation in `variable`.  (words.cpp has every sentence about a
/// classification.)
[[nodiscard]] std::string reason(const Classification& c, const std::string& variable = "z");

} // namespace kov
