#include "monodromy/words.hpp"

#include <deque>

namespace kov::monodromy {
namespace {

constexpr std::size_t most_words = 4000;
constexpr std::size_t longest_square = 3; // of the words that are squared
constexpr std::size_t most_squares = 40;

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

std::optional<HyperbolicPair> inequalities(const BallMatrix& a, const BallMatrix& b, long bits) {
  ComplexBall square = normalized_square(a, bits);
  if (!square_outside(square)) return std::nullopt;
  const BallMatrix ab = multiply(a, b, bits);
  const BallMatrix b_inverse = inverse_or_unknown(b, bits);
  HyperbolicPair p;
  p.trace_commutator = trace_commutator(a, b, bits);
  p.trace_normalizer = quotient(trace(multiply(ab, multiply(a, b_inverse, bits), bits), bits),
                                determinant(a, bits), bits);
  if (!differs_from_two(p.trace_commutator) || !differs_from_two(p.trace_normalizer))
    return std::nullopt;
  acb_sqrt(p.trace_a.raw(), square.raw(), bits);
  return p;
}

std::optional<HyperbolicPair> with_any_loop(const Monodromy& m, const Word& a,
                                            const BallMatrix& matrix) {
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

// Calls visit(w, matrix) for words of at least one loop, shorter ones first, until it returns true.
template <class Visit>
void each_word(const Monodromy& m, std::size_t longest, const Budget& budget, Visit visit) {
  std::deque<std::pair<Word, BallMatrix>> words{{{}, BallMatrix::identity(m.size())}};
  for (std::size_t tried = 0; !words.empty() && tried < most_words; ++tried) {
    budget.check();
    const auto [w, a] = std::move(words.front());
    words.pop_front();
    if (!w.empty() && visit(w, a)) return;
    if (w.size() == longest) continue;
    for (std::size_t i = 0; i < m.loops.size(); ++i) {
      words.emplace_back(w, multiply(m.loops[i].matrix, a, m.bits));
      words.back().first.push_back(i);
    }
  }
}

// Calls visit(w, matrix, tr^2/det) for words whose tr^2/det is certainly outside of [0, 4].
template <class Visit>
void each_hyperbolic_word(const Monodromy& m, const Budget& budget, Visit visit) {
  each_word(m, longest_word, budget, [&](const Word& w, const BallMatrix& a) {
    const ComplexBall square = normalized_square(a, m.bits);
    return square_outside(square) && visit(w, a, square);
  });
}

// x (x - 1)(x - 2)(x - 4)(x^2 - 3 x + 1), 0 exactly where an element of order 1, 2, 3, 4, 5, 6, 8
// or 10 of SL(2, C) has the squared trace x.
ComplexBall small_orders(const ComplexBall& x, long bits) {
  ComplexBall product, factor = x;
  acb_sub_si(factor.raw(), factor.raw(), 3, bits);
  acb_mul(product.raw(), factor.raw(), x.raw(), bits);
  acb_add_si(product.raw(), product.raw(), 1, bits);
  for (const long root : {0, 1, 2, 4}) {
    acb_sub_si(factor.raw(), x.raw(), root, bits);
    acb_mul(product.raw(), product.raw(), factor.raw(), bits);
  }
  return product;
}

} // namespace

BallMatrix matrix_of(const Monodromy& m, const Word& w) {
  BallMatrix product = BallMatrix::identity(m.size());
  for (const std::size_t i : w)
    product = multiply(m.loops.at(i).matrix, product, m.bits);
  return product;
}

std::optional<NoSmallGroup> prove_no_small_group(const Monodromy& m, const Budget& budget) {
  NoSmallGroup p;
  each_word(m, longest_word, budget, [&](const Word& w, const BallMatrix& c) {
    p.trace_c_square = normalized_square(c, m.bits);
    const bool found = acb_contains_zero(small_orders(p.trace_c_square, m.bits).raw()) == 0;
    if (found) p.c = w;
    return found;
  });
  if (p.c.empty()) return std::nullopt;
  std::vector<std::pair<Word, BallMatrix>> squares;
  bool found = false;
  each_word(m, longest_square, budget, [&](const Word& w, const BallMatrix& b) {
    const BallMatrix square = multiply(b, b, m.bits);
    for (const auto& [word, other] : squares) {
      p.trace_squares = trace_commutator(other, square, m.bits);
      found = differs_from_two(p.trace_squares);
      if (!found) continue;
      p.a = word;
      p.b = w;
      return true;
    }
    if (squares.size() < most_squares) squares.emplace_back(w, square);
    return false;
  });
  return found ? std::optional(std::move(p)) : std::nullopt;
}

std::optional<Sl2Proof> prove_sl2(const Monodromy& m, const Budget& budget) {
  if (m.size() != 2) return std::nullopt;
  std::optional<HyperbolicPair> pair;
  each_hyperbolic_word(m, budget, [&](const Word& w, const BallMatrix& a, const ComplexBall&) {
    pair = with_any_loop(m, w, a);
    return pair.has_value();
  });
  if (pair) return Sl2Proof(*std::move(pair));
  if (auto other = prove_no_small_group(m, budget)) return Sl2Proof(*std::move(other));
  return std::nullopt;
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
