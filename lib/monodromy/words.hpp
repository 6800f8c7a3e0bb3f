#pragma once
// Proofs from strict inequalities: words in the matrices that generate a group dense in SL(2, C).
//
//   tr(A)^2/det A not in [0, 4],   tr(A B A^-1 B^-1) != 2,   tr(A B A B^-1) != 2 det A
//
// or, where all traces are those of a unitary group,
//
//   tr(A^2 B^2 A^-2 B^-2) != 2,    tr(C)^2/det C not in {0, 1, 2, 4, (3 +- sqrt 5)/2}
//
// Equality is never concluded from balls.  docs/theory/monodromy.md 6

#include "monodromy/monodromy.hpp"

#include <variant>

namespace kov::monodromy {

/// Indices of loops, the first one continued along first.
using Word = std::vector<std::size_t>;

/// tr(A)^2/det A is outside [0, 4].
struct HyperbolicPair {
  Word a, b;
  ComplexBall trace_a;          ///< tr(A)/sqrt(det A)
  ComplexBall trace_commutator; ///< tr(A B A^-1 B^-1)
  ComplexBall trace_normalizer; ///< tr(A B A B^-1)/det A
};
/// A^2 and B^2 have no common eigenvector, and no finite primitive group has an element like C.
struct NoSmallGroup {
  Word a, b, c;
  ComplexBall trace_squares;  ///< tr(A^2 B^2 A^-2 B^-2)
  ComplexBall trace_c_square; ///< tr(C)^2/det C
};
using Sl2Proof = std::variant<HyperbolicPair, NoSmallGroup>;

inline constexpr std::size_t longest_word = 6;

/// The group of y'' = r y (r the normal form) is SL(2, C); nothing when neither a pair with
/// |A| <= 6, |B| = 1 nor a triple with |A|, |B| <= 3, |C| <= 6 shows it, which proves nothing.
/// Requires size 2.
/// Cost  at most some ten thousand products of 2 x 2 matrices
[[nodiscard]] std::optional<Sl2Proof> prove_sl2(const Monodromy& m, const Budget& budget = {});

/// The same by a triple, also where there are hyperbolic words: certificates have one rule.
[[nodiscard]] std::optional<NoSmallGroup> prove_no_small_group(const Monodromy& m,
                                                               const Budget& budget = {});

/// Two loops whose matrices have no common eigenvector: the group is irreducible.
struct NoCommonLine {
  std::size_t a = 0, b = 0;
  ComplexBall trace_commutator; ///< not 2
};
/// Requires size 2; nothing found proves nothing.
[[nodiscard]] std::optional<NoCommonLine> prove_irreducible(const Monodromy& m);

/// A word whose matrix, divided by a root of its determinant, has infinite order.
struct HyperbolicWord {
  Word word;
  ComplexBall trace; ///< tr/sqrt(det), not in [-2, 2]
};
/// Requires size 2; nothing found with words of at most longest_word loops proves nothing.
[[nodiscard]] std::optional<HyperbolicWord> prove_infinite(const Monodromy& m,
                                                           const Budget& budget = {});

/// The matrix of the loops of a word, one after the other.
[[nodiscard]] BallMatrix matrix_of(const Monodromy& m, const Word& w);

} // namespace kov::monodromy
