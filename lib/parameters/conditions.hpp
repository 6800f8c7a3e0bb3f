#pragma once
// Conditions on parameters: what a file assumes, and what a stratum of the parameter space is.
//
//   p = 0    p != 0    p > 0    p >= 0        for polynomials p in the parameters, over Q
//   v in Z   v not in Z                       for rational functions v of them
//
// A parameter that occurs in an inequality is real; the others range over the complex numbers.

#include "certify/strata/certificate.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace kov {

using certify::Condition;
using certify::Sign;

/// `value` is an integer, or is none.
struct Membership {
  MFraction value;
  bool in_integers = true;
};

/// A conjunction.
struct Assumptions {
  std::vector<Condition> conditions;
  std::vector<Membership> memberships;
  std::vector<std::size_t> real;     ///< variables known to be real
  std::vector<std::size_t> rational; ///< variables known to be rational

  /// f = 0, f != 0, f > 0, f >= 0 for a rational function, whose denominator is then not 0.
  void require(const MFraction& f, Sign sign);
  /// f in Z, or not; its denominator is not 0.
  void require_integral(const MFraction& f, bool in_integers);
};

/// "C = 2*A", "A - C != 0", "A > 0": an equation is solved where a variable is linear with a
/// constant coefficient.
/// Given   Assumptions assumed; assumed.require(a, Sign::positive);
/// Example to_string(assumed.conditions)  // -> a > 0
[[nodiscard]] std::string to_string(const Condition& c);
/// Joined by ", "; "always" for none.
[[nodiscard]] std::string to_string(const std::vector<Condition>& all);

/// Everything that is assumed, one sentence for each: "A > 0", "n is an integer", "l is rational".
[[nodiscard]] std::vector<std::string> in_words(const Assumptions& all, const Ring& ring);

/// The irreducible factors of p that are not constant, each once.  Requires p != 0.
/// Example irreducible_parts((a * a * (z - a)).num())  // -> {z - a, a}
[[nodiscard]] std::vector<MPoly> irreducible_parts(const MPoly& p);

} // namespace kov
