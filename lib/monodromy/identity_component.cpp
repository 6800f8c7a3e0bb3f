#include "monodromy/identity_component.hpp"

namespace kov::monodromy {
namespace {

constexpr std::size_t longest_power_word = 4;
constexpr std::size_t most_power_words = 60;

BallMatrix difference(const BallMatrix& a, const BallMatrix& b, long bits) {
  BallMatrix c(a.size());
  acb_mat_sub(c.raw(), a.raw(), b.raw(), bits);
  return c;
}

BallMatrix power(const BallMatrix& a, long n, long bits) {
  BallMatrix c(a.size());
  acb_mat_pow_ui(c.raw(), a.raw(), static_cast<ulong>(n), bits);
  return c;
}

BallMatrix unconjugated(const Monodromy& m, const UnipotentElement& u) {
  return power(u.loops ? matrix_of(m, *u.loops) : m.large_circle.value(), u.power, m.bits);
}

BallMatrix conjugated(const Monodromy& m, const BallMatrix& a, const Word& w) {
  const BallMatrix by = matrix_of(m, w);
  return multiply(inverse_or_unknown(by, m.bits), multiply(a, by, m.bits), m.bits);
}

void ensure_unipotent(const Monodromy& m, const BallMatrix& u) {
  const BallMatrix nilpotent = difference(u, BallMatrix::identity(u.size()), m.bits);
  if (!overlap(power(nilpotent, u.size(), m.bits), BallMatrix(u.size())))
    throw InternalError("a matrix that is unipotent by its exponents is not");
}

// An entry of a b - b a that is not 0.
std::optional<NonAbelianProof> commutator(const BallMatrix& a, const BallMatrix& b, long bits) {
  const BallMatrix c = difference(multiply(a, b, bits), multiply(b, a, bits), bits);
  for (long i = 0; i < c.size(); ++i)
    for (long j = 0; j < c.size(); ++j)
      if (acb_contains_zero(c.entry(i, j)) == 0) {
        NonAbelianProof p;
        p.row = static_cast<std::size_t>(i);
        p.column = static_cast<std::size_t>(j);
        acb_set(p.entry.raw(), c.entry(i, j));
        return p;
      }
  return std::nullopt;
}

// All words in n loops of at most this many letters, short ones first.
std::vector<Word> words(std::size_t n, std::size_t longest) {
  std::vector<Word> all{{}};
  for (std::size_t k = 0; k < all.size(); ++k)
    for (std::size_t i = 0; i < n && all[k].size() < longest; ++i) {
      all.push_back(all[k]);
      all.back().push_back(i);
    }
  return all;
}

} // namespace

std::vector<UnipotentElement> unipotent_elements(const DifferentialSystem& s, const Monodromy& m,
                                                 const Budget& budget) {
  std::vector<UnipotentElement> all;
  for (std::size_t k = 0; k < m.loops.size(); ++k)
    if (const auto n = unipotent_power(s, m.loops[k].place.factor, budget))
      all.push_back({Word{k}, *n, {}});
  if (m.large_circle)
    if (const auto n = unipotent_power_at_infinity(s, budget))
      all.push_back({std::nullopt, *n, {}});
  return all;
}

std::vector<UnipotentElement> all_short_words(const Monodromy& m, long power) {
  std::vector<UnipotentElement> all;
  for (const Word& w : words(m.loops.size(), longest_power_word))
    if (!w.empty() && all.size() < most_power_words) all.push_back({w, power, {}});
  return all;
}

std::optional<NonAbelianProof> checked(const Monodromy& m, const UnipotentElement& a,
                                       const UnipotentElement& b) {
  auto proof = commutator(conjugated(m, unconjugated(m, a), a.conjugator),
                          conjugated(m, unconjugated(m, b), b.conjugator), m.bits);
  if (proof) {
    proof->a = a;
    proof->b = b;
  }
  return proof;
}

std::optional<NonAbelianProof> prove_non_abelian(const Monodromy& m,
                                                 const std::vector<UnipotentElement>& unipotent,
                                                 const Budget& budget) {
  std::vector<BallMatrix> matrices;
  for (const UnipotentElement& u : unipotent) {
    matrices.push_back(unconjugated(m, u));
    ensure_unipotent(m, matrices.back());
  }
  long left = most_commutators;
  for (const Word& w : words(m.loops.size(), longest_conjugator))
    for (std::size_t j = 0; j < unipotent.size(); ++j) {
      budget.check();
      const BallMatrix b = conjugated(m, matrices[j], w);
      for (std::size_t i = 0; i < unipotent.size() && left > 0; ++i, --left)
        if (auto proof = commutator(matrices[i], b, m.bits)) {
          proof->a = unipotent[i];
          proof->b = {unipotent[j].loops, unipotent[j].power, w};
          return proof;
        }
    }
  return std::nullopt;
}

} // namespace kov::monodromy
