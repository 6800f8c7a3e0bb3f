#pragma once
// Polynomial arithmetic for hostile input: every product is counted before it is computed, and the
// run is refused (facts.hpp, Refused) when it costs too much (strata_certificates.md 2). Divisions,
// resultants and determinants are made of these counted products.

#include "exact/multivariate.hpp"

#include <optional>
#include <vector>

namespace kov::certify {

class Arithmetic {
public:
  /// Refuses when the whole run is too much work.
  void charge(double products, double words = 0);

  [[nodiscard]] MPoly times(const MPoly& a, const MPoly& b);
  [[nodiscard]] MPoly power(const MPoly& f, unsigned long e);
  [[nodiscard]] MPoly plus(const MPoly& a, const MPoly& b);
  [[nodiscard]] MPoly minus(const MPoly& a, const MPoly& b);
  /// The numbers below fractions: they grow as well.
  [[nodiscard]] Integer times(const Integer& a, const Integer& b);
  [[nodiscard]] Integer common_multiple(const Integer& a, const Integer& b);
  [[nodiscard]] MPoly scaled(const MPoly& f, const Integer& c);
  /// a/b in Z[t], if it exists.  Requires b != 0.
  /// Cost  counted: terms of the quotient times terms of b
  [[nodiscard]] std::optional<MPoly> quotient(const MPoly& a, const MPoly& b);

private:
  MPoly divided(const MPoly& a, const MPoly& b); // refuses an inexact division

  double products_ = 0;
  double words_ = 0;

  friend class Elimination;
};

/// f without its integer content; the sign stays.  0 for 0.
[[nodiscard]] MPoly primitive(const MPoly& f);
[[nodiscard]] MPoly scaled(const MPoly& f, const Integer& c);
/// A polynomial in one variable over the others, ascending, without zeros at the end.
using Coefficients = std::vector<MPoly>;

/// Determinants and resultants, fraction-free.
class Elimination {
public:
  explicit Elimination(Arithmetic& a) : a_(a) {}

  /// The remainder of lead(g)^k f by g for some k.  Requires g != 0.
  [[nodiscard]] Coefficients pseudo_remainder(Coefficients f, const Coefficients& g);
  /// Res(f, g) up to its sign, by the subresultant sequence (Collins, Brown; Cohen 1993, 3.3.7).
  [[nodiscard]] MPoly resultant(Coefficients f, Coefficients g);
  /// det, with its sign, by Bareiss' elimination.
  [[nodiscard]] MPoly determinant(std::vector<std::vector<MPoly>> rows);

private:
  Coefficients full_pseudo_remainder(Coefficients f, const Coefficients& g);

  Arithmetic& a_;
};

} // namespace kov::certify
