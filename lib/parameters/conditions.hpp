#pragma once
// Conditions on parameters: what a file assumes, and what a stratum of the parameter space is.
//
//   p = 0    p != 0    p > 0    p >= 0        for polynomials p in the parameters, over Q
//   v in Z   v not in Z                       for rational functions v of them
//
// Parameters range over the complex numbers but those that are said to be real.  A quantity in an
// inequality of the author is real; that is a fact about his own names (`real`), and a rewritten
// condition says nothing of the kind: if A = C*D, then A > 0 holds for C = i, D = -i.

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

  /// f = 0, f != 0, f > 0, f >= 0 for a rational function, whose denominator is then not 0.  An
  /// order makes f real (declare_real), not all that it is made of.  Requires that what is known to
  /// be real is in `real`: num/den > 0 is num*den > 0 for a real den, and else num != 0 is kept.
  void require(const MFraction& f, Sign sign);
  /// f is real; so is x, if f is a linear fraction over Q of x alone.
  void declare_real(const MFraction& f);
  void declare_rational(const MFraction& f); ///< the same, with "rational"
  /// f in Z, or not; its denominator is not 0.
  void require_integral(const MFraction& f, bool in_integers);
};

/// "C = 2*A", "A - C != 0", "A > 0", "t^2 = 3/4": an equation is solved where a variable is linear with a
/// constant coefficient, or where it has two terms.
/// Given   Assumptions assumed; assumed.require(a, Sign::positive);
/// Example to_string(assumed.conditions)  // -> a > 0
[[nodiscard]] std::string to_string(const Condition& c);
/// b = a and b = -a as one condition, b^2 = a^2; unset for others.
/// Example to_string(Condition{*up_to_sign((z - a).num(), (z + a).num()), Sign::zero})  // -> a^2 = z^2
[[nodiscard]] std::optional<MPoly> up_to_sign(const MPoly& p, const MPoly& q);
/// The same of two sets that differ by such conditions; b = -a may have been looked at where b != a.
[[nodiscard]] std::optional<std::vector<Condition>> up_to_sign(const std::vector<Condition>& a,
                                                               const std::vector<Condition>& b);
/// The same of inequations, "b != a" and "b != -a".
[[nodiscard]] std::vector<Condition> in_pairs(std::vector<Condition> all);
/// Joined by ", "; "always" for none.
[[nodiscard]] std::string to_string(const std::vector<Condition>& all);

/// Everything that is assumed, one sentence for each: "A > 0", "n is an integer", "l is rational".
[[nodiscard]] std::vector<std::string> in_words(const Assumptions& all, const Ring& ring);

/// The irreducible factors of p that are not constant, each once.  Requires p != 0.
/// Example irreducible_parts((a * a * (z - a)).num())  // -> {z - a, a}
[[nodiscard]] std::vector<MPoly> irreducible_parts(const MPoly& p);

} // namespace kov
