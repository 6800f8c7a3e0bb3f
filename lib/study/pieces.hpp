#pragma once
// Parameters that are not decided yet, and how exclusions cut them: shared by classify_system(), which
// finds its solutions as it goes, and together(), which has them all.
//
// Source  docs/theory/classify.md (7)

#include "study/exclusion.hpp"
#include "study/parameter_split.hpp"

#include <stop_token>

namespace kov {

/// One attempt, and its outcome.
struct Tried {
  std::string what, outcome;
};

struct Piece {
  ParameterSet where;
  std::vector<DifferenceCondition> special; ///< besides; all of them
  std::vector<Tried> tried = {};
  std::vector<FoundIntegral> integrals = {}; ///< that were found there, not enough of them
};

/// The last outcome of each attempt counts.
void note(Piece& piece, const std::string& what, const std::string& outcome);
/// The piece with one condition more; nothing if it holds nowhere.
[[nodiscard]] std::optional<Piece> with_condition(Piece piece, const DifferenceCondition& c);
/// The same on a part of its set; nothing if a condition fails there.
[[nodiscard]] std::optional<Piece> on_part(const Piece& piece, ParameterSet part);

/// No strata yet: what is said of integrability for such a system.
[[nodiscard]] SystemClassification nothing_known(const System& s);
/// All values of parameters and algebraic constants but the levels, under the assumptions; what they say
/// is noted in `told`.
/// Errors  InvalidArgument: there are none
[[nodiscard]] ParameterSet all_parameters(const System& s, const std::vector<std::size_t>& levels,
                                          const std::stop_token& stop, SystemClassification& told);
/// Tells which irreducible polynomials may vanish under the assumptions; asks once for each.  s outlives it.
[[nodiscard]] MayVanish may_vanish(const System& s);

/// Cuts the pieces; what is excluded becomes strata of c.  False: of some piece it was too hard to
/// tell, or there are too many; they stay.
bool exclude(std::vector<Piece>& pieces, const Exclusion& e, const System& s,
             SystemClassification& c);
/// A stratum of c, with what was tried.
void leave_open(Piece piece, SystemClassification& c);
/// The system exists at no point of the set: it is not a stratum.
[[nodiscard]] bool is_outside_of_the_domain(const System& s, const ParameterSet& where);
/// Finds from the strata what the theorem rests on, and puts them in order.
void finish(const System& s, SystemClassification& c);

/// Not the empty text, and nothing twice.
void add_sentence(std::vector<std::string>& all, const std::string& one);

} // namespace kov
