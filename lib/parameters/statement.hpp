#pragma once
// Statements on numbers that depend on parameters, which no polynomial can say: "nu is in 1/2 + Z", "some
// l +- m +- n is an odd integer", "a and b are rational".  "Abelian only if Delta is rational" excludes all
// parameters but those of such a statement.  Numbers are given by their squares, since no statement depends
// on their signs.
//
// Source  docs/theory/strata.md, 10; docs/theory/classify.md (2)

#include "exact/poly.hpp"
#include "exact/square_root.hpp"
#include "galois/group.hpp"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace kov {

/// The squares of numbers x1, x2, ... that depend on parameters.
using Squares = std::vector<MFraction>;

/// a + step Z, and -a + step Z.
struct Residues {
  Rational a, step;
  friend bool operator==(const Residues& x, const Residues& y) {
    return x.a == y.a && x.step == y.step;
  }
};
using Classes = std::vector<Residues>;
inline const Residues all_integers{Rational(0), Rational(1)};
inline const Residues odd_integers{Rational(1), Rational(2)};
inline const Residues half_integers{Rational(1, 2), Rational(1)};       ///< 1/2 + Z
inline const Residues multiples_of_a_half{Rational(0), Rational(1, 2)}; ///< (1/2) Z

[[nodiscard]] bool contains(const Residues& r, const Rational& x);
[[nodiscard]] bool contains(const Classes& all, const Rational& x);
/// Example to_string(Residues{Rational(1, 6), 2})  // -> +-1/6 + 2*Z
[[nodiscard]] std::string to_string(const Residues& r);
/// After "is" or "is not".
/// Example to_string(Classes{odd_integers})  // -> an odd integer
/// Example to_string(Classes{half_integers, {Rational(1, 6), 2}})  // -> in 1/2 + Z or +-1/6 + 2*Z
[[nodiscard]] std::string to_string(const Classes& all);

/// At least `count` of the numbers are in one of the classes; or all are rational, if that is enough.
struct SomeIn {
  Squares squares;                     ///< never empty
  std::optional<Classes> classes = {}; ///< unset: Q
  bool or_all_rational = false;
  std::size_t count = 1;
  friend bool operator==(const SomeIn&, const SomeIn&) = default;
};
/// Some x1 +- x2 +- ... is in one of the classes.  Three numbers: the class of odd integers alone.
struct SumIn {
  Squares squares; ///< one to three
  Classes classes;
  friend bool operator==(const SumIn&, const SumIn&) = default;
};
struct AllRational {
  Squares squares;
  friend bool operator==(const AllRational&, const AllRational&) = default;
};
/// x1 is, up to sign, a natural number N >= 1 and x2 is one of N-1, N-3, ..., 1-N.
struct Separated {
  Squares squares; ///< two
  friend bool operator==(const Separated&, const Separated&) = default;
};
/// Numbers d1, d2 with d1^2 + d2^2 = x2 and d1^2 d2^2 = x3: x1 is the square of a natural number
/// N >= 1, and some +-d1 +- d2 is one of N-1, N-3, ..., 1-N.
struct SeparatedPair {
  Squares squares; ///< x1, x2, x3
  friend bool operator==(const SeparatedPair&, const SeparatedPair&) = default;
};
/// At least one of x1, x2, x3 is an integer, and each one that is is up to sign a natural number N
/// with the sum or the difference of the other two among N-1, N-3, ..., 1-N.
struct WithoutLogarithm {
  Squares squares; ///< three
  friend bool operator==(const WithoutLogarithm&, const WithoutLogarithm&) = default;
};
/// Rows of the table of Schwarz and Kimura with this group.
struct InRow {
  Squares squares; ///< three
  GroupType group = GroupType::A5;
  friend bool operator==(const InRow&, const InRow&) = default;
};
/// Lame's equation (closed/lame.hpp), n not an integer, has a finite group: a condition on B, g2, g3 for
/// each n.
struct LameIsFinite {
  Squares squares;   ///< (2n+1)^2; then B, g2, g3 themselves
  bool half = false; ///< n in 1/2 + Z: Brioschi's determinant vanishes
  friend bool operator==(const LameIsFinite&, const LameIsFinite&) = default;
};

using Assertion = std::variant<SomeIn, SumIn, AllRational, Separated, SeparatedPair,
                               WithoutLogarithm, InRow, LameIsFinite>;

/// Given   const Ring ring = make_ring({"a", "nu"});
/// Given   const MFraction a = MFraction::variable(ring, 0), nu = MFraction::variable(ring, 1);
/// Given   const Statement integer{SomeIn{{a}, {{all_integers}}}};
/// Example to_string(integer)  // -> sqrt(a) is an integer
/// Example to_string({SumIn{{nu * nu}, {half_integers}}})  // -> nu is in 1/2 + Z
/// Example to_string({SumIn{{nu}, {odd_integers}}, false})  // -> sqrt(nu) is not an odd integer
struct Statement {
  Assertion says;
  bool holds = true; ///< false: it is said that nothing of this is so
  friend bool operator==(const Statement&, const Statement&) = default;
};

/// The numbers that it is about.
[[nodiscard]] const Squares& squares_of(const Assertion& s);
[[nodiscard]] Squares& squares_of(Assertion& s);
/// It depends on no parameter.
[[nodiscard]] bool is_number(const MFraction& f);

[[nodiscard]] Statement negation(Statement s);
/// a implies b, as far as one number, or its multiple, is in classes: proved.
[[nodiscard]] bool implies(const Statement& a, const Statement& b);
/// In the words of a mathematician.
[[nodiscard]] std::string to_string(const Statement& s);

/// A statement, and what holds where it does not.
struct WithContrary {
  std::string text, contrary;
};
/// Each of them; that numbers are in no row for A4, S4 and A5 is one.
/// Given   const auto no_row = [&](GroupType g) { return Statement{InRow{{a, a, nu}, g}, false}; };
/// Example with_contraries({no_row(GroupType::A4), no_row(GroupType::S4), integer}).size()  // -> 2
[[nodiscard]] std::vector<WithContrary> with_contraries(const std::vector<Statement>& all);

/// The statement holds exactly where one of these is an integer; unset: some number has no square
/// root among the functions of the parameters.
[[nodiscard]] std::optional<std::vector<MFraction>> integral_somewhere(const SumIn& s);

/// The same classes, each once and in few rows: a in [0, step/2], and a + step Z with a + step/2 + step Z is
/// a + (step/2) Z.
[[nodiscard]] Classes simplified(const Classes& classes);

/// Some root of one square in classes: the form of a statement that is about one number alone.  Unset: it is
/// not, or does not hold.
/// Example one_number({SumIn{{nu}, {odd_integers}}})->classes->size()  // -> 1
[[nodiscard]] std::optional<SomeIn> one_number(const Statement& s);

/// A rational function of one variable over Q.
struct Univariate {
  std::vector<Rational> num, den; ///< ascending, without common factor
};
/// g as a function of f; unset: none is seen.
/// Given   const MFraction inverse_square = MFraction(ring, Rational(1)) / (a * a);
/// Example in_terms_of(a, inverse_square)->den.size()  // -> 3
[[nodiscard]] std::optional<Univariate> in_terms_of(const MFraction& f, const MFraction& g);
/// One of the two numbers Delta^2, and its values.
struct CommonValues {
  MFraction square;
  std::vector<Rational> values; ///< ascending
};
/// The values at which both statements may hold; unset: not known to be finitely many.
/// Two differences D1, D2 in (1/N) Z with D2^2 = F(D1^2), F a rational function with a finite limit at
/// infinity: near the limit D2^2 takes no special value.  If F falls to minus infinity D2 may be any
/// rational number: a square is not negative.
/// Cost   the numbers of (1/N) Z below a bound on the zeros of F
/// Given   const MFraction other = MFraction(ring, Rational(16)) / a;
/// Given   const Statement inverse{SomeIn{{other}, {{all_integers}}}};
/// Example common_values(integer, inverse)->values.size()  // -> 3
[[nodiscard]] std::optional<CommonValues> common_values(const Statement& a, const Statement& b);

/// N with all classes in (1/N) Z.
/// Example denominator({all_integers})  // -> 1
[[nodiscard]] Integer denominator(const Classes& classes);
/// The squares of the numbers in the classes up to `bound` in absolute value, ascending.
/// Errors  OutOfBudget: too many
/// Example squares_in({all_integers}, 2)  // -> {0, 1, 4}
[[nodiscard]] std::vector<Rational> squares_in(const Classes& classes, long bound);

} // namespace kov
