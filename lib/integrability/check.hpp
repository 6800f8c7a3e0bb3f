#pragma once
// From a system to its verdict: every stage, the theorem, and the class of first integrals.
//
//   claims -> manifolds (proved) -> VE -> normal part -> linear integrals -> blocks
//          -> scalar equation -> change of variable -> r(z) -> group -> verdict
//
// The verdict of a manifold is
//   non-integrable   a block of order 2 has a non-abelian identity component (a theorem), or the
//                    whole of VE, by certified monodromy matrices,
//   no obstruction   all blocks have abelian ones, and they are the whole of VE up to a vector
//                    group (variation/whole.hpp): nothing follows,
//   undecided        anything else, with the reason.
//
// Source  [MoralesRamis2001] Theorem 7 (Hamiltonian systems, also on symplectic leaves of a
// Poisson
//         manifold); [AyoulZung2010] (general vector fields)

#include "algebraize/algebraize.hpp"
#include "decide/decide.hpp"
#include "integrability/constants.hpp"
#include "integrability/integral_class.hpp"
#include "integrability/variational_monodromy.hpp"
#include "literature/literature.hpp"
#include "strata/decide_strata.hpp"

namespace kov {

enum class VerdictKind : std::uint8_t {
  non_integrable,
  no_obstruction,
  depends, ///< on the parameters: decided on every stratum, not everywhere the same
  undecided
};
[[nodiscard]] std::string to_string(VerdictKind v); ///< "non-integrable", ..., "depends"

struct WayToR; // way.hpp
struct ManifoldReport;

/// One value of a parameter (the energy) at which r was decided.
struct EnergyResult {
  std::string condition; ///< "h^2 - 3 = 0", or "h = 1/2"
  std::string why;       ///< "singularities merge", "sample"
  std::optional<RationalFunction> r;
  std::optional<Decision> decision;
  std::optional<strata::StrataAnswer> strata; ///< r still depends on other parameters
  std::string note;                           ///< why there is none
  std::shared_ptr<const WayToR> way;          ///< at this value; for `decision`
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
  std::string level; ///< the one that decides, if it is not a general one: "h = 0"
  std::string note;  ///< why something is missing
  /// The way to r for the checkers, accepted by our own; null: none, and why.
  std::shared_ptr<const WayToR> way;
  std::string no_way;
  bool refused =
      false; ///< no_way is a refusal by our own checker: what the block said is withdrawn
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
  std::string not_studied; ///< what of VE the blocks leave out, as a clause; empty: nothing
  std::vector<MPoly> coupling_divisors; ///< what it was divided by to see that nothing is left out
  /// Set where the blocks decide nothing and the whole of VE is proved to be not abelian.
  std::shared_ptr<const MatrixEvidence> matrices;
  VerdictKind verdict = VerdictKind::undecided;
  std::optional<TheoremUsed> by; ///< the theorem behind the verdict; unset: it was not reached
  std::string statement;         ///< what the theorem says, where it says something
  std::string not_checked;       ///< a hypothesis of the verdict that is not proved, as a sentence
  std::vector<std::string> reasons;
};

struct ClaimReport {
  SystemClaim claim;
  ClaimResult result;
};

struct CheckReport {
  System system;
  std::vector<ClaimReport> claims;
  std::vector<ManifoldReport> manifolds;
  double seconds = 0;
};

struct CheckOptions {
  Options decide;
  std::string only_manifold; ///< empty: all
  bool stop_at_r = false;    ///< stages only, no group
  /// Also what couples normal unknowns to the curve, where it lies in the boundary of what a
  /// system is meant for: first integrals with logarithms may be lost there.
  bool along_the_curve = false;
};

/// Errors  OutOfBudget is turned into "undecided"; InputError and InternalError pass
/// Given   const System system = read_system(parse_document("system = {kind = 'hamiltonian', "
///             "coordinates = ['q1', 'q2'], momenta = ['p1', 'p2'], parameters = ['h'], "
///             "hamiltonian = '(p1^2 + p2^2)/2 + q1^2*q2 + q2^3/2'}\n"
///             "manifold = [{name = 'N', equations = ['q1 = 0', 'p1 = 0'], level = ['H = h']}]",
///             "cubic.toml"), {{"h", "1"}});
/// Example check_system(system).manifolds.front().verdict  // -> non-integrable
[[nodiscard]] CheckReport check_system(const System& s, const CheckOptions& options = {});
/// One manifold of it; claims: those of the system with their results.
[[nodiscard]] ManifoldReport check_manifold(const System& s, const ManifoldSpec& spec,
                                            const std::vector<ClaimReport>& claims,
                                            const CheckOptions& options = {});

/// The manifolds that the options ask for.
/// Errors  InvalidArgument if the one named is not there
[[nodiscard]] std::vector<const ManifoldSpec*> manifolds_to_check(const System& s,
                                                                  const CheckOptions& options);
/// Every claim of the file; a limit is a result.
[[nodiscard]] std::vector<ClaimReport> decide_claims(const System& s, const CheckOptions& options);

/// The steps on which a verdict rests besides the theorem, exact computation and certificates that
/// the checkers accept: the one list for `check`, `prove`, `report` and certificates.
[[nodiscard]] std::vector<std::string> trusted_steps(const ManifoldReport& m);

} // namespace kov
