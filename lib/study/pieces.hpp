#pragma once
// Parameters that are not decided yet, and how exclusions cut them: shared by classify_system(), which
// finds its solutions as it goes, and together(), which has them all.
//
// Source  docs/theory/classify.md (7)

#include "parameters/set.hpp"
#include "study/exclusion.hpp"

#include <stop_token>

namespace kov {

/// One attempt, and its outcome.
struct Tried {
  std::string what, outcome;
};

/// A set for which nothing is known yet.
struct Undecided {
  Set where;
  std::vector<Tried> tried = {};
  std::vector<FoundIntegral> integrals = {}; ///< that were found there, not enough of them

  /// The same on a part of the set.
  [[nodiscard]] Undecided on(Set part) const { return {std::move(part), tried, integrals}; }
};

/// The last outcome of each attempt counts.
void note(Undecided& piece, const std::string& what, const std::string& outcome);

/// No strata yet: what is said of integrability for such a system.
[[nodiscard]] SystemClassification nothing_known(const System& s);
/// All values of parameters and algebraic constants but the levels, under the assumptions; what they say
/// is noted in `told`.
/// Errors  InvalidArgument: there are none
[[nodiscard]] Set all_parameters(const System& s, const std::vector<std::size_t>& levels,
                                 const std::stop_token& stop, SystemClassification& told);
/// Tells which irreducible polynomials may vanish under the assumptions; asks once for each.  s outlives it.
[[nodiscard]] MayVanish may_vanish(const System& s);

/// Cuts the pieces; what is excluded becomes strata of c.  False: of some piece it was too hard to
/// tell, or there are too many; they stay.
bool exclude(std::vector<Undecided>& pieces, const Exclusion& e, const System& s,
             SystemClassification& c);
/// A stratum of c, with what was tried.
void leave_open(Undecided piece, SystemClassification& c);
/// The system exists at no point of the set: it is not a stratum.
[[nodiscard]] bool is_outside_of_the_domain(const System& s, const Set& where);
/// Finds from the strata what the theorem rests on, and puts them in order.
void finish(const System& s, SystemClassification& c);

/// Not the empty text, and nothing twice.
void add_sentence(std::vector<std::string>& all, const std::string& one);

} // namespace kov
