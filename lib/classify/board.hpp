#pragma once
// The sets that are decided and those that are open while a system is classified, and the rounds in
// which it is done.
//
// Source  docs/theory/classify.md (7)

#include "classify/solutions.hpp"
#include "classify/stated.hpp"
#include "moves/equivalence.hpp"
#include "moves/scale.hpp"
#include "study/pieces.hpp"

namespace kov {

/// With what is known of it.
struct KnownSystem {
  System system;
  std::vector<ClaimReport> claims;
  std::vector<KnownLevel> levels;
};

/// One system with its solutions and integrals, on some pieces of the parameters.
struct Round : KnownSystem {
  Undecided whole;
  std::vector<Undecided> pieces = {whole};
  std::vector<ManifoldSpec> at_energy_zero = {}, at_all_levels = {}; ///< solutions for what is left
  std::vector<std::vector<MPoly>> special = {}; ///< where there may be more solutions
  std::vector<Exclusion> late =
      {}; ///< with exceptions that take long to write down: for what is left
  std::vector<ManifoldSpec> solutions = {};
  bool studied_at_once = false;             ///< one answer for all parameters was enough
  bool integrals_known = false;             ///< for all of these parameters, from a round before,
  std::vector<MPoly> integrals_unless = {}; ///< but not where one of these vanishes
  bool only_special_values = false;         ///< are left: the system is studied there at once
  std::size_t decided = 0;                  ///< strata that were there before
  bool limited = false;                     ///< some task ended at its share of the work
  std::vector<std::string> cut = {};        ///< the solutions whose share was too small
  bool last = false;                        ///< after all others, with all the work that is left
  /// If these parameters are not 0, a rescaling makes them 1: solutions are studied there.
  std::optional<ScaledSystem> scale = {};
  std::optional<KnownSystem> at_scale = {};

  [[nodiscard]] const KnownSystem& studied() const { return at_scale ? *at_scale : *this; }
  [[nodiscard]] Exclusion before(Exclusion e) const {
    return scale ? scale->before(std::move(e)) : e;
  }
  /// The same set on levels of the integrals as they are without the scale.
  [[nodiscard]] ManifoldSpec before(ManifoldSpec m) const;
};

/// A set of parameters that a change of variables takes into another one: what is proved there holds here.
struct Follower {
  Undecided piece;
  Set of;
  Equivalence by;
};

struct Board {
  ClassifyOptions options; ///< its budget is that of the whole
  const StatedSolutions& stated;
  KnownSystem known = {};             ///< with names for levels
  bool is_as_stated = false;          ///< the system is that of the file, but for names of levels
  double begin = meter();             ///< the reading when the work began
  std::optional<double> further = {}; ///< units left for searches with larger options
  std::string ended = {};             ///< the task in which a limit of the whole ended the work
  bool begun = false;                 ///< some round is done, or at work
  std::vector<Round> waiting = {};    ///< parts of the parameters that were not studied yet
  std::vector<Round> later = {};      ///< those that their share did not suffice for
  std::vector<Equivalence> symmetries = {}; ///< of the family
  std::vector<Set> studied = {};            ///< sets of rounds, whole ones
  std::vector<Follower> followers = {};
  std::vector<Undecided> open = {}; ///< for which there is nothing more to try
  SystemClassification result = {};
  SystemClassification so_far = {}; ///< what `result` was when a task began, the rest open

  [[nodiscard]] const Budget& budget() const { return options.check.decide.budget; }
};

[[nodiscard]] inline bool is_over(const Budget& budget) {
  return budget.is_spent() || budget.is_cut_short();
}
/// A normal part may have order four.
[[nodiscard]] bool may_have_large_blocks(const System& s);
/// Later rounds have fewer parameters.
[[nodiscard]] bool is_the_first(const Board& b, const Round& round);
/// Two degrees of freedom: of more variables there are very many monomials.
[[nodiscard]] bool is_small(const Round& round);
/// Each parameter that labels no level has a value.
[[nodiscard]] bool is_at_numbers(const Round& round);

/// The algebraic constants that System::adjoined names, by their variables.
[[nodiscard]] std::vector<std::size_t> adjoined_constants(const System& s);

/// Notes an outcome for all pieces that are open.
void note(Round& round, const std::string& what, const std::string& outcome);
/// Cuts the pieces; what is too hard to tell for now is kept for later.
/// Errors  Contradiction
void exclude(Board& b, Round& round, const Exclusion& e);
/// The same for exclusions with exceptions that take long to write down: these come last.
void exclude_or_defer(Board& b, Round& round, Exclusion e);

/// They are not meromorphic functions, and contradict no theorem on these.
[[nodiscard]] bool has_logarithms(const std::vector<FoundIntegral>& integrals);
/// Our own check: a theorem on integrals and one on variational equations cannot contradict.  Where
/// these integrals are enough nothing is excluded by this round.   Errors  Contradiction
void contradict_nothing(const Board& b, const Round& round, const Exclusion& where,
                        const IntegralsOfSet& set);

/// The parts of a piece on which two of its conditions hold together at common values only.
[[nodiscard]] std::vector<Undecided> met(Board& b, const Round& round, const Undecided& piece);

/// No real parameters that the file admits lie in it: proved.
[[nodiscard]] bool has_no_real_point(Board& b, const Set& where);
/// The same where inequalities of several parameters are assumed: A >= B >= C say that C = A, C != B is
/// nowhere.  Signs of single parameters are seen as sets are split.
[[nodiscard]] bool is_ruled_out_by_an_order(Board& b, const Set& where);
/// The parts of the pieces where the conditions hold; `pieces` are what is left.
/// Errors  OutOfBudget; then some of the pieces may be gone
[[nodiscard]] std::vector<Undecided> cut(std::vector<Undecided>& pieces, const Cut& x,
                                         const MayVanish& possible, const Budget& budget = {});
/// Whether the piece follows another set by a symmetry; then it is noted, and need not be studied.
[[nodiscard]] bool follows_another(Board& b, const Undecided& piece);
/// Knowledge of the sets that they follow is carried over; what is open there is open.  The rest,
/// if any, waits to be studied by itself.
void settle_followers(Board& b);

/// The levels that are left at these values; those of claims that are not proved any more are not
/// levels.
[[nodiscard]] std::vector<KnownLevel> at_values(std::vector<KnownLevel> levels,
                                                const Substitution& values,
                                                const std::vector<ClaimReport>& claims);
/// Goes on with what is open after a round: special systems where equations hold, once more where
/// work is left, or open for good.
void go_on(Board& b, const Round& round);
/// Parameters that the set determines, as functions of the others, are put into the system.
/// Unset: there is none, or something has no value there.
[[nodiscard]] std::optional<Round> in_solved_parameters(const Round& round, const Undecided& piece);

} // namespace kov
