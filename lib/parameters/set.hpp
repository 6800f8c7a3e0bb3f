#pragma once
// A set of parameter values: some polynomials vanish there, others vanish nowhere on it, and statements hold;
// and how a set is cut, and sets are united.
//
// Source  docs/theory/integrals.md (2), docs/theory/classify.md (2)

#include "exact/ideal.hpp"
#include "parameters/statement.hpp"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace kov {

/// The parameter values over the complex numbers at which some polynomials vanish, others do not, and statements
/// hold.
///
/// Given   const Ring ring = make_ring({"a", "b"});
/// Given   const MPoly a = MPoly::variable(ring, "a"), b = MPoly::variable(ring, "b");
/// Given   const Set all(ring, {0, 1});
/// Example all.where_nonzero(a).is_nonzero(a*a)  // -> yes
/// Example all.where_zero(a*b).where_nonzero(a).restrict(b)  // -> 0
/// Example all.where_zero(a).where_nonzero(a).is_empty()  // -> yes
/// Example all.where_zero(a*a + b).where_zero(b).vanishes(a)  // -> yes
/// Given   const Statement integer{SomeIn{{MFraction(a)}, Classes{all_integers}}};
/// Example all.where(integer)->where_zero(a - MPoly(ring, 3)).settled().has_value()  // -> no
class Set {
public:
  Set(Ring ring, std::vector<std::size_t> parameters, Budget budget = {});

  /// All values of the same parameters.
  [[nodiscard]] Set plain() const { return {ring_, parameters_, budget_}; }
  /// The points of `all` that satisfy the same conditions.  Requires that its ring has the names of this one.
  [[nodiscard]] Set within(const Set& all) const;
  /// The part where p vanishes, and the part where it does not.  Statements stay as they are: settled().
  [[nodiscard]] Set where_zero(const MPoly& p) const;
  [[nodiscard]] Set where_nonzero(const MPoly& p) const;

  /// These vanish nowhere, instead of what did not: a larger or smaller set.
  [[nodiscard]] Set with_inequations(const std::vector<MPoly>& nonzero) const;
  /// The part where it holds, of what follows from another each once; nothing: it holds nowhere.
  [[nodiscard]] std::optional<Set> where(const Statement& s) const;
  [[nodiscard]] std::optional<Set> where(const std::vector<Statement>& all) const;
  /// Statements as what is left of them here; nothing if one holds nowhere.
  [[nodiscard]] std::optional<Set> settled() const {
    return without_statements().where(statements_);
  }
  [[nodiscard]] Set without_statements() const;

  /// By its polynomials.
  [[nodiscard]] bool is_empty() const;
  /// f as a function on the set; its denominator is an integer.  f in the parameters.
  [[nodiscard]] MFraction restrict(const MPoly& f) const;
  /// f vanishes at all points of the set.  f in the parameters.
  [[nodiscard]] bool vanishes(const MPoly& f) const;
  /// f vanishes at no point of the set.  f in the parameters.
  [[nodiscard]] bool is_nonzero(const MPoly& f) const;
  /// The irreducible factors of f that may vanish somewhere on the set.  Requires f != 0.
  [[nodiscard]] std::vector<MPoly> doubtful_factors(const MPoly& f) const;

  [[nodiscard]] const Ring& ring() const noexcept { return ring_; }
  [[nodiscard]] const std::vector<std::size_t>& parameters() const noexcept { return parameters_; }
  /// A Gröbner basis of the equations.
  [[nodiscard]] std::vector<MPoly> equations() const;
  [[nodiscard]] const std::vector<MPoly>& inequations() const noexcept { return nonzero_; }
  [[nodiscard]] const std::vector<Statement>& statements() const noexcept { return statements_; }
  /// Polynomials say all.
  [[nodiscard]] bool is_algebraic() const noexcept { return statements_.empty(); }
  /// The inequations that say something beside the equations: not those that follow from these.
  [[nodiscard]] std::vector<MPoly> proper_inequations() const;

private:
  [[nodiscard]] bool irreducible_is_nonzero(const MPoly& f) const;
  [[nodiscard]] const std::vector<MPoly>& factors_of_inequations() const;
  /// Saturated by the inequations.
  [[nodiscard]] Ideal ideal_of(const std::vector<MPoly>& equations) const;
  void add_equation(MPoly p);
  void add_inequations(const std::vector<MPoly>& p);

  Ring ring_;
  std::vector<std::size_t> parameters_;
  Budget budget_;
  std::vector<MPoly> nonzero_;                ///< irreducible, each once
  std::vector<Statement> statements_;         ///< all of them hold
  std::optional<Ideal> ideal_;                ///< saturated by nonzero_; unset without equations
  mutable std::map<std::string, bool> known_; ///< what was asked before
  mutable std::optional<std::vector<MPoly>>
      factors_; ///< of the inequations, where the set is a graph
};

/// The statement at the points of a set: true or false where it is the same at all of them, and else what is
/// left of it.
/// Given   const auto at = [&](long n) { return std::get<bool>(on_set(integer, all.where_zero(a - MPoly(ring, n)))); };
/// Example at(4)  // -> yes
/// Example at(3)  // -> no
[[nodiscard]] std::variant<bool, Statement> on_set(const Statement& s, const Set& where);

/// All of `zero` vanish, of each list in `not_all_zero` some polynomial does not, and the statements hold.
struct Cut {
  std::vector<MPoly> zero = {};
  std::vector<std::vector<MPoly>> not_all_zero = {};
  std::vector<Statement> statements = {};
};
/// The same with each function f of the parameters as move(f); of a polynomial the numerator counts.
[[nodiscard]] Cut moved(Cut cut, const std::function<MFraction(const MFraction&)>& move);
/// The conditions of a set.
[[nodiscard]] Cut cut_of(const Set& where);

/// The parts are disjoint and not empty; together they are the set.
struct CutParts {
  std::vector<Set> inside, outside;
};

/// Tells which irreducible polynomials in the parameters may vanish somewhere.
using MayVanish = std::function<bool(const MPoly&)>;

/// Inside: where all conditions of the cut hold.
/// Errors  OutOfBudget, of the sets
/// Given   const MayVanish any = [](const MPoly&) { return true; };
/// Example split(all, {.not_all_zero = {{a, b}}}, any).inside.size()  // -> 2
/// Example split(all, {.not_all_zero = {{a, b}}}, any).outside.size()  // -> 1
/// Example split(all, {.zero = {a*b}}, any).inside.size()  // -> 2
[[nodiscard]] CutParts split(const Set& where, const Cut& cut, const MayVanish& may_vanish);

/// The equations of the set that do not follow from `known` and the ones before, simple ones first.
/// Example proper_equations(all.where_zero(a*a).where_zero(a), {}).size()  // -> 1
[[nodiscard]] std::vector<MPoly> proper_equations(const Set& where,
                                                  const std::vector<MPoly>& known);
/// The factors that do not vanish on the set, each as a function on it, and without constants.
/// Example inequations(all.where_zero(b).where_nonzero(a - b))  // -> {a}
[[nodiscard]] std::vector<MPoly> inequations(const Set& where);

/// Fewer sets with the same union, if they have the same statements: W with p = 0 and W with p != 0 are W.
/// Example united({all.where_zero(a), all.where_nonzero(a)}).size()  // -> 1
[[nodiscard]] std::vector<Set> united(std::vector<Set> sets);

/// Parameters as rational functions of the others, from the equations of the set that are linear in
/// one with a slope that vanishes nowhere there.  `left`: the equations that were not solved.
struct SolvedSet {
  Substitution values;
  std::vector<MPoly> left;
};
/// Example to_string(solve(all.where_zero(a - b*b)).values.at(0))  // -> b^2
[[nodiscard]] SolvedSet solve(const Set& where);

/// Disjoint parts, one for each factor that an equation has when others are solved: on c = a^2 - 1,
/// c = 3 these are a = 2 and a = -2.  The set itself if there are none.
/// Example by_factors(all.where_zero(b - a*a).where_zero(b - MPoly(ring, Integer(4))), any).size()  // -> 2
/// Example by_factors(all.where_zero(b - a*a), any).size()  // -> 1
[[nodiscard]] std::vector<Set> by_factors(const Set& where, const MayVanish& may_vanish);

} // namespace kov
