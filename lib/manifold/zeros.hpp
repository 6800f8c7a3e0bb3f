#pragma once
// Zeros of polynomials in some unknowns that are rational over the parameters, one unknown after the
// other by the factors of the equations.  Not all of them are found.
//
// Source  docs/theory/mechanics.md (4)

#include "exact/budget.hpp"
#include "system/relations.hpp"

#include <optional>
#include <tuple>
#include <vector>

namespace kov {

/// Given   const Ring ring = make_ring({"a", "s", "x", "y"});
/// Given   const MPoly a = MPoly::variable(ring, "a"), s = MPoly::variable(ring, "s");
/// Given   const MPoly x = MPoly::variable(ring, "x"), y = MPoly::variable(ring, "y");
/// Given   const MPoly three(ring, Integer(3));
/// Given   ZeroSearch without(ring, {2, 3}, {}, {}), with(ring, {2, 3}, {{1, s*s - three}}, {});
/// Given   without.run({x*y - y, y*y - three*a*a*x}); with.run({x*y - y, y*y - three*a*a*x});
/// Example without.zeros.size()  // -> 1
/// Example without.wanted  // -> {3}
/// Example with.zeros.size()  // -> 3
class ZeroSearch {
public:
  ZeroSearch(Ring ring, std::vector<std::size_t> unknowns, std::vector<QuadraticConstant> constants,
             const Budget& budget)
      : ring_(std::move(ring)), unknowns_(std::move(unknowns)), constants_(std::move(constants)),
        budget_(budget) {}

  /// eliminations: how often resultants may be taken where no factor is linear in an unknown.
  /// Errors  OutOfBudget
  void run(const std::vector<MPoly>& equations, int eliminations = 1) {
    solve(equations, {}, eliminations);
  }

  /// Polynomials that do not vanish: other zeros are not looked for.
  std::vector<MPoly> nonzero;
  std::vector<Substitution> zeros;         ///< of generic parameters, for all unknowns
  std::vector<std::vector<MPoly>> special; ///< without unknowns: where all vanish there may be more
  std::vector<MPoly> wanted; ///< not squares: with a square root of one there may be more

private:
  void solve(const std::vector<MPoly>& given, const Substitution& known, int eliminations);
  void branch(std::vector<MPoly> equations, const MPoly& f, const Substitution& known,
              int eliminations);
  void eliminate(std::vector<MPoly> equations, const std::vector<std::vector<MPoly>>& left,
                 const Substitution& known, int eliminations);
  void at(std::vector<MPoly> equations, std::size_t unknown, const MFraction& value,
          const Substitution& known, int eliminations);
  void at_roots(const std::vector<MPoly>& equations, const MPoly& f, const Substitution& known,
                int eliminations);
  void finish(const Substitution& known, std::vector<MPoly> conditions);
  static std::optional<Substitution> with(const Substitution& step, const Substitution& known);

  [[nodiscard]] MPoly reduced(MPoly f) const;
  [[nodiscard]] std::vector<MPoly> simplified(std::vector<MPoly> equations) const;
  [[nodiscard]] bool uses_constants(const MPoly& f) const;
  [[nodiscard]] std::optional<std::vector<MPoly>>
  factors_of_nonzero(const Substitution& known) const;
  [[nodiscard]] std::optional<MFraction> root_of(const MPoly& discriminant) const;
  [[nodiscard]] std::vector<MPoly> factors_with_unknowns(const MPoly& e) const;
  [[nodiscard]] std::tuple<int, std::size_t, long> cost(const std::vector<MPoly>& factors) const;
  [[nodiscard]] bool has_one_unknown(const std::vector<MPoly>& factors) const;
  [[nodiscard]] std::size_t linear_unknown(const MPoly& f) const;
  [[nodiscard]] MPoly product(const std::vector<MPoly>& factors) const;

  Ring ring_;
  std::vector<std::size_t> unknowns_;
  std::vector<QuadraticConstant> constants_;
  const Budget& budget_;
  int branches_ = 0;
};

} // namespace kov
