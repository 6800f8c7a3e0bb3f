#pragma once
// A proof that the identity component of the group of a system is not abelian: two elements that
// are unipotent exactly (unipotent.hpp) and, by a strict inequality of balls, do not commute.
//
// A unipotent element U of an algebraic group lies in its identity component: the closure of its
// powers is exp(C log U), which is connected.  docs/theory/monodromy.md 7

#include "monodromy/unipotent.hpp"
#include "monodromy/words.hpp"

namespace kov::monodromy {

/// A power of the matrix of a word that is unipotent, continued along another word first and back
/// after: W^-1 M^power W.
struct UnipotentElement {
  std::optional<Word> loops; ///< none: the large circle
  long power = 1;
  Word conjugator{};
};

/// The unipotent elements that the exponents prove, of every loop and of the large circle.
[[nodiscard]] std::vector<UnipotentElement>
unipotent_elements(const DifferentialSystem& s, const Monodromy& m, const Budget& budget = {});
/// The short words, where the N-th power of every element of the group is known to be unipotent.
[[nodiscard]] std::vector<UnipotentElement> all_short_words(const Monodromy& m, long power);

struct NonAbelianProof {
  UnipotentElement a, b;
  std::size_t row = 0, column = 0;
  ComplexBall entry; ///< of A B - B A; does not contain 0
};

inline constexpr std::size_t longest_conjugator = 3;
inline constexpr long most_commutators = 4000;

/// Nothing when no two elements of the list, one conjugated by a word of at most three loops, are
/// seen not to commute, which proves nothing.
/// Errors  InternalError: (U - 1)^n does not contain 0 for an element of the list
/// Cost    at most most_commutators of them
[[nodiscard]] std::optional<NonAbelianProof>
prove_non_abelian(const Monodromy& m, const std::vector<UnipotentElement>& unipotent,
                  const Budget& budget = {});

/// Do these two not commute?  (The caller knows that they are unipotent.)
[[nodiscard]] std::optional<NonAbelianProof> checked(const Monodromy& m, const UnipotentElement& a,
                                                     const UnipotentElement& b);

} // namespace kov::monodromy
