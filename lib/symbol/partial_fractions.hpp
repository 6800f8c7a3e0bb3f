#pragma once
// Sums of fractions whose numerators and denominators are given as products of linear factors.

#include "exact/budget.hpp"
#include "exact/rational_function.hpp"

#include <vector>

namespace kov {

/// unit * product of base^exponent; the bases monic, linear, sorted, different; exponents not 0.
struct SplitFraction {
  struct Factor {
    Poly base;
    long exponent;
  };
  NfElem unit;
  std::vector<Factor> factors{};

  void times(const Poly& base, long exponent);
};

/// A sum of such fractions.  The common denominator is seen without a gcd: the factors are equal or
/// coprime.
///
/// Cost    a balanced tree of products, and one gcd at the end (which is 1 unless terms cancel)
/// Errors  OutOfBudget when the denominator exceeds the largest degree
/// Given   const Budget budget; PartialFractions two(rationals(), budget);
/// Given   two.add({1, {{z, -1}}}); two.add({1, {{z - 1, -1}}});
/// Example two.sum()  // -> (2*z - 1)/(z^2 - z)
class PartialFractions {
public:
  PartialFractions(Field k, const Budget& budget) : k_(std::move(k)), budget_(budget) {}
  void add(SplitFraction term) { terms_.push_back(std::move(term)); }
  [[nodiscard]] bool empty() const noexcept { return terms_.empty(); }
  [[nodiscard]] RationalFunction sum() const;

private:
  struct Partial;
  [[nodiscard]] Partial sum(std::size_t from, std::size_t to) const;

  Field k_;
  const Budget& budget_;
  std::vector<SplitFraction> terms_;
};

} // namespace kov
