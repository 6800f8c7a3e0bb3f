#pragma once
// A set of parameter values that is given by a parametrisation, and what is known of reality, signs and
// integers there: a stratum while the tree is built.  (set.hpp has sets of complex values by their equations.)
//
// Equations are solved for a parameter as long as one is linear in them; polynomials are written in the
// parameters that are left.  The polynomials known not to vanish on the set form a list of irreducible ones,
// together with sign proofs from the assumed inequalities.  docs/theory/strata.md, 1 and 2

#include "exact/truth.hpp"
#include "literature/trusted.hpp"
#include "parameters/conditions.hpp"

#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace kov {

/// The points of the parameter space that satisfy the conditions met so far.
///
/// Given   Assumptions assumed; assumed.require(a, Sign::positive);
/// Example ParametrisedSet(ring, assumed).sign_of((a + one).num())  // -> 1
/// Example ParametrisedSet(ring, assumed).provably_nonzero((a - one).num())  // -> no
/// Example to_string(ParametrisedSet(ring, {}).where_nonzero(a.num()).path())  // -> a != 0
class ParametrisedSet {
public:
  /// Nothing is solved yet: the equations of the assumptions are pending().
  ParametrisedSet(Ring ring, Assumptions assumptions);

  [[nodiscard]] const Ring& ring() const noexcept { return ring_; }
  [[nodiscard]] const Substitution& solved() const noexcept { return solved_; }
  [[nodiscard]] const std::vector<Condition>& path() const noexcept { return path_; }
  [[nodiscard]] const std::vector<Membership>& memberships() const noexcept {
    return assumptions_.memberships;
  }
  /// Steps that rest on Z3 alone.
  [[nodiscard]] const std::vector<Trusted>& trusted() const noexcept { return trusted_; }
  [[nodiscard]] bool is_real(std::size_t variable) const;
  [[nodiscard]] bool is_real(const MPoly& p) const; ///< all its variables are
  [[nodiscard]] bool is_rational(std::size_t variable) const;

  /// f in the parameters that are left.  Throws DomainError if its denominator vanishes here.
  [[nodiscard]] MFraction restrict(const MFraction& f) const;

  /// Does p, written in the parameters that are left, vanish nowhere on the stratum?  no means: not
  /// proved.
  [[nodiscard]] bool provably_nonzero(const MPoly& p) const;
  /// +1 or -1 if p is proved to be positive or negative on the whole stratum, else 0.
  [[nodiscard]] int sign_of(const MPoly& p) const;
  /// The same without Z3.
  [[nodiscard]] int exact_sign_of(const MPoly& p) const;
  /// The first irreducible factor of p that is not proved to be nonzero.
  [[nodiscard]] std::optional<MPoly> doubtful_factor(const MPoly& p) const;
  /// Is v in Z by assumption (yes), not in Z (no), or open?
  [[nodiscard]] Truth is_integral(const MFraction& v) const;
  /// All conditions, with `more`, have no point: proved.
  [[nodiscard]] bool refutes(const std::vector<Condition>& more) const;

  /// Follows from the assumed inequalities and the equations solved alone; p as in path().
  [[nodiscard]] bool implies_nonzero(const MPoly& p) const;
  /// The variable that is real because f is: f is a linear fraction of it over real variables, with
  /// a determinant that is known not to vanish.  B C > 0 and B > 0: C is real.
  [[nodiscard]] std::optional<std::size_t> made_real_by(const MFraction& f) const;
  /// p in one real variable has no real root that satisfies the conditions: proved.
  [[nodiscard]] bool has_no_real_root(const MPoly& p) const;

  /// The stratum with p != 0.  p irreducible.
  [[nodiscard]] ParametrisedSet where_nonzero(const MPoly& p) const;

  /// The stratum is empty; what that rests on besides algebra.
  struct Empty {
    std::vector<Trusted> trusted;
  };
  /// First decide whether this vanishes.
  struct Split {
    MPoly by;
  };
  struct Stuck {}; ///< no parameter is linear in p
  /// The stratum with p = 0.  p irreducible, not proved nonzero.
  [[nodiscard]] std::variant<ParametrisedSet, Empty, Split, Stuck> where_zero(const MPoly& p) const;

  /// The stratum with p = 0 where no parameter is linear in p: all parameters are kept, and f != 0
  /// is known where the resultant of f and p in `variable` is.  Requires that p is irreducible over
  /// Q and its leading coefficient in `variable` known != 0.
  /// A p = 0 that the assumptions and path() imply is not repeated in path().
  [[nodiscard]] ParametrisedSet with_relation(const MPoly& p, std::size_t variable,
                                              bool implied) const;
  struct Relation {
    MPoly p;
    std::size_t variable;
  };
  [[nodiscard]] const std::vector<Relation>& relations() const noexcept { return relations_; }

  /// An equation of the assumptions that is not imposed yet, in the parameters that are left; empty
  /// if there is none.
  [[nodiscard]] std::optional<MPoly> pending() const;
  /// Proved: the conditions contradict each other.
  [[nodiscard]] bool is_empty() const;
  [[nodiscard]] bool is_empty_exactly() const; ///< the same without Z3

private:
  [[nodiscard]] int sign_of_irreducible(const MPoly& p) const;
  /// p, irreducible over Q and in one parameter alone, has degree > 1 and the parameter is
  /// rational; or degree 1, and its root is not an integer where one is assumed (or is one where none
  /// is).
  [[nodiscard]] bool has_no_admissible_root(const MPoly& p) const;
  [[nodiscard]] bool equations_contradict() const;
  /// As above, by way of these relations, each of them once.
  [[nodiscard]] std::optional<MPoly> doubtful_factor(const MPoly& p,
                                                     const std::vector<Relation>& unused) const;
  /// f has no zero in common with one of these relations.
  [[nodiscard]] bool differs_from_relations(const MPoly& f,
                                            const std::vector<Relation>& unused) const;
  [[nodiscard]] std::variant<ParametrisedSet, Empty> solve(const MPoly& p,
                                                           std::size_t variable) const;
  /// The conditions whose variables are all real, for Z3.
  [[nodiscard]] std::vector<Condition> real_conditions() const;

  Ring ring_;
  Assumptions assumptions_; ///< in the parameters that are left
  Substitution solved_;
  std::vector<MPoly> nonzero_;
  std::vector<MPoly> assumed_nonzero_; ///< those that are not splits of the tree
  std::vector<Condition> path_;
  std::vector<Relation> relations_;
  mutable std::vector<Trusted> trusted_;
  mutable std::vector<std::pair<MPoly, int>> signs_; ///< what was asked before
};

} // namespace kov
