#pragma once
// Conditions that no polynomial in the parameters can say: an exponent difference is special.
//
// "Abelian only if Delta is rational" excludes all parameters but those with special Delta.
//
// Source  docs/theory/classify.md (2)

#include "closed/arithmetic.hpp"
#include "integrals/stratum.hpp"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace kov {

[[nodiscard]] inline bool operator==(const Residues& a, const Residues& b) {
  return a.a == b.a && a.step == b.step;
}

/// Some root of `squares` is special; or all of them are rational, where that is enough.
///
/// Given   const Ring ring = make_ring({"a"});
/// Given   const MPoly a = MPoly::variable(ring, "a");
/// Given   const ParameterSet all(ring, {0});
/// Given   const DifferenceCondition integer{DifferenceCondition::Kind::integer, {a}};
/// Example to_string(integer)  // -> sqrt(a) is an integer
/// Example std::get<bool>(on_set(integer, all.where_zero(a - MPoly(ring, 4))))  // -> yes
/// Example std::get<bool>(on_set(integer, all.where_zero(a - MPoly(ring, 3))))  // -> no
struct DifferenceCondition {
  enum class Kind : std::uint8_t {
    rational,     ///< Delta in Q
    half_integer, ///< 2 Delta in Z
    integer,      ///< Delta in Z
    odd_half,     ///< Delta - 1/2 in Z
    classes       ///< Delta in one of the classes below
  };
  Kind kind = Kind::rational;
  std::vector<MFraction> squares; ///< Delta^2 in the parameters; never empty
  bool or_all_rational = false;
  bool holds = true;                  ///< false: it is required that nothing of this is so
  std::vector<Residues> classes = {}; ///< each a + step Z and -a + step Z, none in another

  friend bool operator==(const DifferenceCondition&, const DifferenceCondition&) = default;
};

/// The condition at the points of a set: true or false where it is the same at all of them, and
/// else what is left of it.
[[nodiscard]] std::variant<bool, DifferenceCondition> on_set(const DifferenceCondition& c,
                                                             const ParameterSet& where);
/// a implies b, by its kind: proved.
[[nodiscard]] bool implies(const DifferenceCondition& a, const DifferenceCondition& b);
/// A condition that holds in all parts, each a conjunction: one difference is special.  Unset: none is seen.
/// Given   const MFraction b = MFraction(a);
/// Given   const ArithmeticCondition halves{SumIn{{b}, {{Rational(1, 2), Rational(2)}}}};
/// Given   const ArithmeticCondition other{InHalves{{b}, 1}};
/// Example to_string(*necessary_condition({{halves}, {other}}))  // -> sqrt(a) - 1/2 is an integer
[[nodiscard]] std::optional<DifferenceCondition>
necessary_condition(const std::vector<std::vector<ArithmeticCondition>>& parts);
/// One of the two numbers Delta^2, and its values.
struct CommonValues {
  MFraction square;
  std::vector<Rational> values; ///< ascending
};
/// The values at which both conditions may hold; unset: not known to be finitely many.
/// Two differences D1, D2 in (1/N) Z with D2^2 = F(D1^2), F a rational function with a finite limit at
/// infinity: near the limit D2^2 takes no special value.  If F falls to minus infinity D2 may be any
/// rational number: a square is not negative.
/// Cost   the numbers of (1/N) Z below a bound on the zeros of F
/// Given   const MFraction other = MFraction(ring, Rational(16)) / MFraction(a);
/// Given   const DifferenceCondition inverse{DifferenceCondition::Kind::integer, {other}};
/// Example common_values(integer, inverse)->values.size()  // -> 3
[[nodiscard]] std::optional<CommonValues> common_values(const DifferenceCondition& a,
                                                        const DifferenceCondition& b);

/// N with all special Delta in (1/N) Z.  Requires that not all rational numbers are special.
/// Example denominator(integer)  // -> 1
[[nodiscard]] Integer denominator(const DifferenceCondition& c);
/// The squares of the special values up to `bound` in absolute value, ascending.
/// Example special_squares(integer, 2)  // -> {0, 1, 4}
[[nodiscard]] std::vector<Rational> special_squares(const DifferenceCondition& c, long bound);

[[nodiscard]] DifferenceCondition negation(DifferenceCondition c);
[[nodiscard]] std::string to_string(const DifferenceCondition& c);

} // namespace kov
