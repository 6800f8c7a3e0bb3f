#pragma once
// Polynomial arithmetic for hostile input: every product is counted before it is computed, and the
// run is refused (refused.hpp) when it costs too much (strata_certificates.md 2). Divisions,
// resultants and determinants are made of these counted products.

#include "exact/multivariate.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace kov::certify {

/// A polynomial in one variable over the others, ascending, without zeros at the end.
using Coefficients = std::vector<MPoly>;

class Arithmetic {
public:
  /// Refuses when the whole run is too much work.
  void charge(double products, double words = 0);

  [[nodiscard]] MPoly times(const MPoly& a, const MPoly& b);
  [[nodiscard]] MPoly power(const MPoly& f, unsigned long e);
  /// sum c_i p^i q^(n-i), n + 1 the length of c, which is not 0.
  [[nodiscard]] MPoly homogeneous(const Coefficients& c, const MPoly& p, const MPoly& q);
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
/// f = c g with a number c that is not 0.
[[nodiscard]] bool is_multiple(const MPoly& f, const MPoly& g);
/// By variable of the ring: no other one occurs.
[[nodiscard]] bool is_in(const MPoly& f, const std::vector<bool>& names);
/// The same polynomial in another ring, by its names.  Refuses a name that the ring has not.
[[nodiscard]] MPoly in_ring(const MPoly& f, const Ring& ring);
/// Determinants and resultants, fraction-free.
class Elimination {
public:
  explicit Elimination(Arithmetic& a) : a_(a) {}

  /// The remainder of lead(g)^(n+1) f by g, n the difference of their lengths.  Requires g != 0.
  [[nodiscard]] Coefficients pseudo_remainder(Coefficients f, const Coefficients& g);
  /// Res(f, g) up to its sign, by the subresultant sequence (Collins, Brown; Cohen 1993, 3.3.7).
  [[nodiscard]] MPoly resultant(Coefficients f, Coefficients g);
  /// det, with its sign, by Bareiss' elimination.
  [[nodiscard]] MPoly determinant(std::vector<std::vector<MPoly>> rows);

private:
  Arithmetic& a_;
};

/// A polynomial in the notation of strata_certificates.md 2; Throws InvalidArgument with what is wrong.
[[nodiscard]] MPoly read_polynomial(const Ring& ring, std::string_view text);
/// The same in a file: the error names the place.
[[nodiscard]] MPoly read_poly(const Ring& ring, const class Node& n);
/// Names that are different and well formed.
[[nodiscard]] Ring ring_of(const Node& n, const std::vector<std::string>& names);
/// Only in some names, by variable of the ring.
[[nodiscard]] MPoly read_poly(const Ring& ring, const Node& n, const std::vector<bool>& names);

} // namespace kov::certify
