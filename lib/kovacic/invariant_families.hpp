#pragma once
// Products v of m solutions with v^N in K(z), for m = 2, 4, 6, 12: steps 1 to 3 in common.

#include "kovacic/families.hpp"
#include "kovacic/polynomial.hpp"
#include "kovacic/trace.hpp"
#include "linode/singularities.hpp"

#include <functional>
#include <string>
#include <vector>

namespace kov::kovacic {

/// v = P prod q^(e_q), given by theta = sum e_q q'/q and P.
struct RadicalProduct {
  std::vector<Rational> exponent; ///< e_q, parallel to Singularities::finite
  RationalFunction theta;
  Poly P;
  std::vector<Poly> chain; ///< P_m, ..., P_0, P_{-1} = 0
  Poly S;

  [[nodiscard]] RationalFunction phi() const; ///< v'/v
};

/// The kind of product that is looked for, and how the paper writes its exponents.
struct ProductSearch {
  int kovacic_case = 2;
  long m = 2;
  long scale = 2; ///< the paper's e_c are scale times the exponents of v
  long N = 2;     ///< v^N is rational
  /// One class of exponents for each entry, for a place: see exponents.hpp.
  std::function<std::vector<Rational>(const Singularity&)> classes;
  bool all = false; ///< all solutions, not the first one only
  std::string name; ///< "n = 6", for the trace
  std::function<bool(const std::vector<Rational>&)> wanted = {}; ///< on the exponents of a family
};

/// The first product found, or a basis of each class when `all`.
/// Throws  OutOfBudget
[[nodiscard]] std::vector<RadicalProduct>
products(const Singularities& s, const ProductSearch& search, const Budget& budget, Trace* trace);

/// Rational v (N = 1): one family stands for all, so that this is one linear system.
/// Throws  OutOfBudget
/// Example rational_products(singularities(RationalFunction(2, z*z)), 2, 1, "", {}, nullptr).size()
///         // -> 3
[[nodiscard]] std::vector<RadicalProduct> rational_products(const Singularities& s, long m,
                                                            int kovacic_case, std::string name,
                                                            const Budget& budget, Trace* trace);

/// prod of q^(max(1, ceil(order/2))): S^2 r is a polynomial, and S theta is one for every family.
/// Example common_denominator(singularities(RationalFunction(1, pow(z, 3))))  // -> z^2
[[nodiscard]] Poly common_denominator(const Singularities& s);

/// prod q^(e_q) * P for integral exponents.
[[nodiscard]] RationalFunction rational_value(const Singularities& s, const RadicalProduct& v);

} // namespace kov::kovacic
