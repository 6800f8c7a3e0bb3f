#pragma once
// Step 2: families, that is one class of exponents for every place, for which
//
//   d = (growth exponent at infinity) - sum_c (exponent at c)      is a natural number.
//
// The families are never listed blindly.  Partial sums over the first places are merged when they
// are equal (places with equal exponents are counted, not told apart), in two halves that meet in
// the middle; what is irrational must cancel and what is left must be integral and >= 0.  Only
// families that pass are written out.
//
// Source  [Kovacic1986] §3.1, §4.1, §5.1 step 2

#include "exact/budget.hpp"
#include "exact/number_field.hpp"

#include <optional>
#include <vector>

namespace kov::kovacic {

/// One choice for every place, with its d.
struct Family {
  std::vector<std::size_t> choice; ///< one index for each place, in the order given
  long degree = 0;                 ///< d
};

/// The families with d a natural number, and the number of all families.
struct Families {
  std::vector<Family> admissible; ///< d a natural number; by ascending d
  Integer total;                  ///< how many there were before that condition
  /// Set when the families of this d and of all greater ones are left out: above max_degree.
  std::optional<Integer> left_out{};

  /// Asks for all families.  Throws OutOfBudget("degree limit: ...") when some are left out.
  void require_all(const Budget& budget) const;
};

/// With more than this many places that leave a choice, a power of what is looked for is sought
/// instead: its exponents at each place differ by integers, so that there is one family.
inline constexpr long many_choices = 9;

/// Shape   contributions[i][j]: what choice j at place i adds to d
/// Throws  OutOfBudget("family limit: ...") when more than max_families families pass, or more
///         than that many partial sums are different
/// Cost    about the square root of `total` when all sums differ, polynomial when many agree
/// Example admissible_families({{1, -2}, {0, Rational(1, 2)}, {2, 3}}, {})
///         // -> {{{{1, 0, 0}, 0}, {{1, 0, 1}, 1}, {{0, 0, 0}, 3}, {{0, 0, 1}, 4}}, 8, none}
[[nodiscard]] Families admissible_families(const std::vector<std::vector<NfElem>>& contributions,
                                           const Budget& budget);

} // namespace kov::kovacic
