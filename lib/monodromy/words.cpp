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

// tr(A B A^-1 B^-1)
ComplexBall trace_commutator(const BallMatrix& a, const BallMatrix& b, long bits) {
  return trace(multiply(multiply(a, b, bits),
                        multiply(inverse_or_unknown(a, bits), inverse_or_unknown(b, bits), bits),
                        bits),
               bits);
}

std::optional<Sl2Proof> inequalities(const BallMatrix& a, const BallMatrix& b, long bits) {
  ComplexBall square = normalized_square(a, bits);
  if (!square_outside(square)) return std::nullopt;
  const BallMatrix ab = multiply(a, b, bits);
  const BallMatrix b_inverse = inverse_or_unknown(b, bits);
  Sl2Proof p;
  p.trace_commutator = trace_commutator(a, b, bits);
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

// Calls visit(w, matrix, tr^2/det) for words whose tr^2/det is certainly outside of [0, 4], shorter
// ones first, until it returns true.
template <class Visit>
void each_hyperbolic_word(const Monodromy& m, const Budget& budget, Visit visit) {
  std::deque<std::pair<Word, BallMatrix>> words{{{}, BallMatrix::identity(m.size())}};
  for (std::size_t tried = 0; !words.empty() && tried < most_words; ++tried) {
    budget.check();
    const auto [w, a] = std::move(words.front());
    words.pop_front();
    const ComplexBall square = normalized_square(a, m.bits);
    if (!w.empty() && square_outside(square) && visit(w, a, square)) return;
    if (w.size() == longest_word) continue;
    for (std::size_t i = 0; i < m.loops.size(); ++i) {
      words.emplace_back(w, multiply(m.loops[i].matrix, a, m.bits));
      words.back().first.push_back(i);
    }
  }
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
  std::optional<Sl2Proof> proof;
  if (m.size() == 2)
    each_hyperbolic_word(m, budget, [&](const Word& w, const BallMatrix& a, const ComplexBall&) {
      proof = with_any_loop(m, w, a);
      return proof.has_value();
    });
  return proof;
}

std::optional<NoCommonLine> prove_irreducible(const Monodromy& m) {
  if (m.size() != 2) return std::nullopt;
  for (std::size_t i = 0; i < m.loops.size(); ++i)
    for (std::size_t j = i + 1; j < m.loops.size(); ++j) {
      const ComplexBall t = trace_commutator(m.loops[i].matrix, m.loops[j].matrix, m.bits);
      if (differs_from_two(t)) return NoCommonLine{i, j, t};
    }
  return std::nullopt;
}

std::optional<HyperbolicWord> prove_infinite(const Monodromy& m, const Budget& budget) {
  std::optional<HyperbolicWord> proof;
  if (m.size() == 2)
    each_hyperbolic_word(m, budget,
                         [&](const Word& w, const BallMatrix&, const ComplexBall& square) {
                           proof = HyperbolicWord{w, square};
                           ComplexBall& t = proof->trace;
                           acb_sqrt(t.raw(), t.raw(), m.bits);
                           return true;
                         });
  return proof;
}

} // namespace kov::monodromy
