#pragma once
// Square matrices of complex balls (Arb).

#include "exact/ball.hpp"
#include "exact/flint_matrix.hpp"

namespace kov::monodromy {

/// An n x n matrix of enclosures.
class BallMatrix {
public:
  explicit BallMatrix(long n = 0) { acb_mat_init(m_, n, n); }
  BallMatrix(const BallMatrix& o) : BallMatrix(o.size()) { acb_mat_set(m_, o.m_); }
  BallMatrix(BallMatrix&& o) noexcept : BallMatrix(0) { acb_mat_swap(m_, o.m_); }
  BallMatrix& operator=(BallMatrix o) noexcept {
    acb_mat_swap(m_, o.m_);
    return *this;
  }
  ~BallMatrix() { acb_mat_clear(m_); }

  [[nodiscard]] static BallMatrix identity(long n);

  [[nodiscard]] long size() const noexcept { return acb_mat_nrows(m_); }
  [[nodiscard]] const acb_mat_struct* raw() const noexcept { return m_; }
  [[nodiscard]] acb_mat_struct* raw() noexcept { return m_; }
  [[nodiscard]] acb_struct* entry(long i, long j) noexcept { return acb_mat_entry(m_, i, j); }
  [[nodiscard]] const acb_struct* entry(long i, long j) const noexcept {
    return acb_mat_entry(m_, i, j);
  }

private:
  acb_mat_t m_;
};

[[nodiscard]] BallMatrix multiply(const BallMatrix& a, const BallMatrix& b, long bits);
/// Throws Imprecise when the enclosure of the determinant contains 0.
[[nodiscard]] BallMatrix inverse(const BallMatrix& a, long bits);
/// The same, with entries that may be anything then: nothing can be concluded from them.
[[nodiscard]] BallMatrix inverse_or_unknown(const BallMatrix& a, long bits);
[[nodiscard]] ComplexBall trace(const BallMatrix& a, long bits);
[[nodiscard]] ComplexBall determinant(const BallMatrix& a, long bits);
/// An upper bound of the radius of every entry, as a ball that is one point.
[[nodiscard]] Ball largest_radius(const BallMatrix& a);
/// Do the enclosures meet, entry by entry?  (Equality is never concluded from that.)
[[nodiscard]] bool overlap(const BallMatrix& a, const BallMatrix& b);

} // namespace kov::monodromy
