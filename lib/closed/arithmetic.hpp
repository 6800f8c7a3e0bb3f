#pragma once
// Conditions on parameters that are not algebraic: "nu is in 1/2 + Z", "some l +- m +- n is an odd
// integer", "a and b are rational".  The closed answers of classical equations are told apart by
// them.  Numbers are given by their squares, since no condition depends on their signs.
//
// Source  docs/theory/strata.md, 10

#include "exact/poly.hpp"
#include "exact/square_root.hpp"
#include "galois/group.hpp"

#include <functional>
#include <variant>

namespace kov {

/// The squares of numbers x1, x2, ... that depend on parameters.
using Squares = std::vector<MFraction>;

/// a + step Z, and -a + step Z.
struct Residues {
  Rational a, step;
};

/// Some x1 +- x2 +- ... is in one of the classes.  Three numbers: the class of odd integers alone.
struct SumIn {
  Squares squares; ///< one to three
  std::vector<Residues> classes;
};
struct AllRational {
  Squares squares;
};
struct InHalves { ///< at least `count` of them are in 1/2 + Z
  Squares squares;
  std::size_t count = 2;
};
/// x1 is, up to sign, a natural number N >= 1 and x2 is one of N-1, N-3, ..., 1-N.
struct Separated {
  Squares squares; ///< two
};
/// Numbers d1, d2 with d1^2 + d2^2 = x2 and d1^2 d2^2 = x3: x1 is the square of a natural number
/// N >= 1, and some +-d1 +- d2 is one of N-1, N-3, ..., 1-N.
struct SeparatedPair {
  Squares squares; ///< x1, x2, x3
};
/// At least one of x1, x2, x3 is an integer, and each one that is is up to sign a natural number N
/// with the sum or the difference of the other two among N-1, N-3, ..., 1-N.
struct WithoutLogarithm {
  Squares squares; ///< three
};
/// Rows of the table of Schwarz and Kimura with this group.
struct InRow {
  Squares squares; ///< three
  GroupType group = GroupType::A5;
};

/// Lame's equation (lame.hpp), n not an integer, has a finite group: a condition on B, g2, g3 for
/// each n.
struct LameIsFinite {
  Squares squares;   ///< (2n+1)^2; then B, g2, g3 themselves
  bool half = false; ///< n in 1/2 + Z: Brioschi's determinant vanishes
};

using ArithmeticStatement = std::variant<SumIn, AllRational, InHalves, Separated, SeparatedPair,
                                         WithoutLogarithm, InRow, LameIsFinite>;
struct ArithmeticCondition {
  ArithmeticStatement statement;
  bool holds = true; ///< false: the statement does not hold
};

/// The conditions in the words of a mathematician.
/// Given   const Ring ring = make_ring({"nu"});
/// Given   const MFraction nu = MFraction::variable(ring, 0);
/// Example to_string({SumIn{{nu * nu}, {{Rational(1, 2), 1}}}})  // -> nu is in 1/2 + Z
/// Example to_string({SumIn{{nu}, {{1, 2}}}, false})  // -> sqrt(nu) is not an odd integer
[[nodiscard]] std::string to_string(const ArithmeticCondition& c);

/// The value of a function of the parameters at one point.
using ValueAt = std::function<NfElem(const MFraction&)>;
/// Decided exactly: rational numbers, or roots of polynomials over the field of the values.
/// Throws  what `value` throws
[[nodiscard]] bool is_so(const ArithmeticCondition& c, const ValueAt& value);

/// The same about three numbers that are known together, by (T - x1^2)(T - x2^2)(T - x3^2): those of conjugate
/// places.  A square that is not in Q is that of no rational number.
[[nodiscard]] bool is_so_of_three(const ArithmeticStatement& s, const Poly& squares);

/// The statement holds exactly where one of these is an integer; unset: some number has no square
/// root among the functions of the parameters.
[[nodiscard]] std::optional<std::vector<MFraction>> integral_somewhere(const SumIn& s);

} // namespace kov
