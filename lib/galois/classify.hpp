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

/// The group together with everything that proves it.
struct Classification {
  std::optional<Singularities> local; ///< unset for r = 0
  Trichotomy kind = Trichotomy::undetermined;
  std::string kind_reason; ///< which place decides the kind

  std::optional<GaloisGroup> group;
  std::optional<Connected> component;
  Truth abelian = Truth::unknown;
  std::string reason;
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
[[nodiscard]] Classification classify(const RationalFunction& r, const Budget& budget = {});

/// The local data decide the branch.
[[nodiscard]] Trichotomy trichotomy(const Singularities& s, std::string& reason);

} // namespace kov
