#pragma once
// The results of a study along invariant manifolds, as values, and its options: all that a module needs
// which only names results.

#include "algebraize/algebraize.hpp"
#include "decide/decide.hpp"
#include "integrability/missing.hpp"
#include "integrability/variational_monodromy.hpp"
#include "integrability/verdict.hpp"
#include "literature/levels.hpp"
#include "literature/literature.hpp"
#include "literature/trusted.hpp"
#include "strata/decide_strata.hpp"
#include "system/claims.hpp"

namespace kov {

struct WayToR; // way.hpp
struct ManifoldReport;

/// One value of a parameter (the energy) at which r was decided.
struct EnergyResult {
  LevelEquation at;    ///< "h^2 - 3 = 0", or "h = 1/2"
  bool sample = false; ///< one value of many; else singular places merge there
  std::optional<RationalFunction> r;
  std::optional<Decision> decision;
  std::optional<strata::StrataAnswer> strata; ///< r still depends on other parameters
  std::vector<Missing> missing;
  std::shared_ptr<const WayToR> way; ///< at this value; for `decision`
};

/// A diagonal block of the reduced normal system.
struct BlockReport {
  std::vector<std::string> unknowns;
  std::vector<NormalVariationalEquation> scalar; ///< for each cyclic vector
  std::optional<AlgebraicOde> ode;               ///< the one chosen
  std::optional<NormalForm> equation;            ///< without parameters
  std::optional<Decision> decision;
  std::optional<strata::StrataAnswer> strata; ///< r depends on parameters
  std::vector<MPoly> special; ///< where singular places of r merge, in the energy parameter
  std::vector<EnergyResult> energies;
  Truth abelian = Truth::unknown;
  std::vector<LevelChoice> level; ///< the one that decides, if it is not a general one
  std::vector<Missing> missing;
  /// The way to r for the checkers, accepted by our own; null: none, and why.
  std::shared_ptr<const WayToR> way;
  std::optional<NoWay> no_way;
  /// The studies of strata on which r means nothing, as far as `strata` rests on them.
  std::vector<std::shared_ptr<const ManifoldReport>> special_studies;
};

struct ManifoldReport {
  std::string name;
  std::optional<ManifoldFailure> failure;
  std::optional<InvariantManifold> manifold;
  LinearSystem variational;
  std::vector<std::vector<std::size_t>> variational_blocks;
  NormalSystem normal;
  ReducedSystem reduced;
  std::vector<BlockReport> blocks;
  std::optional<LeftOut> left_out;      ///< what of VE the blocks leave out
  std::vector<MPoly> coupling_divisors; ///< what it was divided by to see that nothing is left out
  /// Set where the blocks decide nothing and the whole of VE is proved to be not abelian.
  std::shared_ptr<const MatrixEvidence> matrices;
  Verdict verdict = Verdict::undecided;
  std::optional<TheoremUsed> by; ///< the theorem behind the verdict; unset: it was not reached
  std::string meant_functions;   ///< for which it is not checked that the curve has points
  bool components_open = false;  ///< it may have others at special values of the parameters
  std::vector<Missing> missing;  ///< what ended the study, or a part of it
};
/// The statement of the theorem; empty where it says nothing.
[[nodiscard]] std::string statement(const ManifoldReport& m);
/// The hypotheses of the verdict that are not proved; empty: there is none.
[[nodiscard]] std::string not_checked(const ManifoldReport& m);
/// The reasons of the verdict, block by block, or why nothing decides.
[[nodiscard]] std::vector<std::string> reasons(const ManifoldReport& m);
/// Why something is missing; empty: nothing is.
[[nodiscard]] std::string note(const std::vector<Missing>& all);
/// "singular places merge", "sample": why one looks there.
[[nodiscard]] std::string why(const EnergyResult& e);

/// The steps on which a verdict rests besides the theorem, exact computation and certificates that
/// the checkers accept: the one list for `check`, `prove`, `report` and certificates.
[[nodiscard]] std::vector<Trusted> trusted_steps(const ManifoldReport& m);

struct CheckOptions {
  Options decide;
  std::string only_manifold; ///< empty: all
  bool stop_at_r = false;    ///< stages only, no group
  /// Also studies blocks of order two that couple a normal variation to the motion along the curve.
  /// This is for a curve in the boundary of what a system is meant for: first integrals with
  /// logarithms may be lost there.
  bool along_the_curve = false;
};

} // namespace kov
