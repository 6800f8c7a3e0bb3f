#include "monodromy/words.hpp"

#include <deque>

namespace kov::monodromy {
namespace {

constexpr std::size_t most_words = 4000;

ComplexBall quotient(const ComplexBall& a, const ComplexBall& b, long bits) {
  ComplexBall c;
  acb_div(c.raw(), a.raw(), b.raw(), bits);
  return c;
}

bool differs_from_two(const ComplexBall& x) {
  ComplexBall two;
  acb_set_si(two.raw(), 2);
  return acb_overlaps(x.raw(), two.raw()) == 0;
}

// x^2 is certainly outside [0, 4].
bool square_outside(const ComplexBall& square) {
  if (arb_contains_zero(acb_imagref(square.raw())) == 0) return true;
  const arb_struct* re = acb_realref(square.raw());
  Ball four;
  arb_set_si(four.raw(), 4);
  return arb_is_negative(re) != 0 || arb_gt(re, four.raw()) != 0;
}

// tr(A)^2/det A
ComplexBall normalized_square(const BallMatrix& a, long bits) {
  ComplexBall t = trace(a, bits);
  acb_sqr(t.raw(), t.raw(), bits);
  return quotient(t, determinant(a, bits), bits);
}

std::optional<Sl2Proof> inequalities(const BallMatrix& a, const BallMatrix& b, long bits) {
  ComplexBall square = normalized_square(a, bits);
  if (!square_outside(square)) return std::nullopt;
  const BallMatrix ab = multiply(a, b, bits);
  const BallMatrix b_inverse = inverse(b, bits);
  Sl2Proof p;
  p.trace_commutator = trace(multiply(ab, multiply(inverse(a, bits), b_inverse, bits), bits), bits);
  p.trace_normalizer = quotient(trace(multiply(ab, multiply(a, b_inverse, bits), bits), bits),
                                determinant(a, bits), bits);
  if (!differs_from_two(p.trace_commutator) || !differs_from_two(p.trace_normalizer))
    return std::nullopt;
  acb_sqrt(p.trace_a.raw(), square.raw(), bits);
  return p;
}

std::optional<Sl2Proof> with_any_loop(const Monodromy& m, const Word& a, const BallMatrix& matrix) {
  for (std::size_t j = 0; j < m.loops.size(); ++j) {
    if (a == Word{j}) continue;
    if (auto proof = inequalities(matrix, m.loops[j].matrix, m.bits)) {
      proof->a = a;
      proof->b = {j};
      return proof;
    }
  }
  return std::nullopt;
}

} // namespace

BallMatrix matrix_of(const Monodromy& m, const Word& w) {
  BallMatrix product = BallMatrix::identity(m.size());
  for (const std::size_t i : w)
    product = multiply(m.loops.at(i).matrix, product, m.bits);
  return product;
}

std::optional<Sl2Proof> checked(const Monodromy& m, const Word& a, const Word& b) {
  auto proof = inequalities(matrix_of(m, a), matrix_of(m, b), m.bits);
  if (proof) {
    proof->a = a;
    proof->b = b;
  }
  return proof;
}

std::optional<Sl2Proof> prove_sl2(const Monodromy& m, const Budget& budget) {
  if (m.size() != 2) return std::nullopt;
  std::deque<Word> words{{}}; // shorter ones first
  for (std::size_t tried = 0; !words.empty() && tried < most_words; ++tried) {
    budget.check();
    const Word w = words.front();
    words.pop_front();
    const BallMatrix a = matrix_of(m, w);
    if (!w.empty() && square_outside(normalized_square(a, m.bits)))
      if (auto proof = with_any_loop(m, w, a)) return proof;
    if (w.size() == longest_word) continue;
    for (std::size_t i = 0; i < m.loops.size(); ++i) {
      words.push_back(w);
      words.back().push_back(i);
    }
  }
  return std::nullopt;
}

} // namespace kov::monodromy
