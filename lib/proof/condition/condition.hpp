#pragma once
// Conditions on the values of names, and what is said of a set of points: strata_certificates.md 2, 5, 7.8 and
// theorem_certificates.md 1.

#include "proof/algebra/arithmetic.hpp"
#include "proof/text/json_node.hpp"

#include <cstdint>

namespace kov::certify {

/// positive, nonnegative: the value is real, whatever its names are, and so.
/// dropped: an inequality that a substitution made useless.
enum class Sign : std::uint8_t { positive, nonnegative, nonzero, zero, dropped };

struct Condition {
  MPoly p;
  Sign sign = Sign::nonzero;
  friend bool operator==(const Condition&, const Condition&) = default;
};
using Conditions = std::vector<Condition>;

/// "positive", ...: as the formats have it
[[nodiscard]] std::string to_string(Sign s);
/// Example text_of({x - one, Sign::nonnegative})  // -> x - 1 >= 0
[[nodiscard]] std::string text_of(const Condition& c);
/// Throws InvalidArgument with the path of what is not one of the first four.
[[nodiscard]] Sign read_sign(const Node& n);
/// " >= 0" for nonnegative.
[[nodiscard]] std::string relation(Sign s);
/// The value is real by the sign.
[[nodiscard]] bool is_ordered(Sign s);
/// The value is not 0 by the sign.
[[nodiscard]] bool excludes_zero(Sign s);
/// A value with this sign, 1, 0 or -1, satisfies the condition.
/// Example allows(Sign::nonnegative, 0)  // -> yes
/// Example allows(Sign::nonzero, 0)  // -> no
[[nodiscard]] bool allows(Sign s, int sign);
/// That of an ordered sign is one only where the value is real.
[[nodiscard]] Condition negation(const Condition& c);
/// The same sign, with coprime integer coefficients.
[[nodiscard]] Condition primitive(const Condition& c);
/// [{"p": P, "sign": SIGN}, ...]
/// Throws InvalidArgument with the path of what is wrong.
[[nodiscard]] Conditions read_conditions(const Ring& ring, const Node& n,
                                         const std::vector<bool>& names);

struct Fraction {
  MPoly num, den;
};
/// num/den, if it is a constant.
[[nodiscard]] std::optional<Rational> constant_value(const Fraction& f);
/// f + c g; denominators are multiplied.
[[nodiscard]] Fraction combined(const Fraction& f, const Rational& c, const Fraction& g,
                                Arithmetic& a);

/// num/den is an integer, or is not one; den is not 0.
struct Membership {
  Fraction value;
  bool integral = true;
};
struct MultipleOfMembership {
  Integer times;
  std::size_t membership = 0;
};
/// Memberships settle the value v; w is that of `membership`, s the sum of the multiples `with`,
/// which all are integers.
///   integral:        w is an integer, and times w + s - v is an integer constant
///   w is none:       times v + s - w is an integer constant, so v is none
///   w is an integer: times v + s - w is a constant that is no integer, so v is none
struct ShownMembership {
  Fraction value;
  bool integral = false;
  Integer times{1};
  std::size_t membership = 0;
  std::vector<MultipleOfMembership> with{};
};

/// c q^2 times powers of conditions, by their numbers; c > 0.
struct SignTerm {
  Rational c{1};
  MPoly q;
  std::vector<std::pair<std::size_t, unsigned long>> powers{};
};

} // namespace kov::certify
