#pragma once
// Denominators as products of powers of irreducible polynomials, each written once.

#include "exact/multivariate.hpp"

namespace kov {

/// Given   const Ring ring = make_ring({"x", "y"});
/// Given   const MPoly x = MPoly::variable(ring, "x");
class Factors {
public:
  /// den = content * prod all()[k]^exponents[k]
  struct Product {
    Integer content{1};
    std::vector<unsigned long> exponents;
  };
  /// Cost  a factorisation over Z
  /// Example Factors().of(x*x).exponents  // -> {2}
  Product of(const MPoly& den);
  [[nodiscard]] const std::vector<MPoly>& all() const { return all_; }

private:
  std::vector<MPoly> all_;
};

} // namespace kov
