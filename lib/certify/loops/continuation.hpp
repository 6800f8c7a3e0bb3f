#pragma once
// Continuation of Y' = A(z) Y along polygons with proven errors: one Taylor series for each segment,
// whose residual is computed as a polynomial, and Gronwall's inequality.
// docs/theory/loop_certificates.md 3

#include "certify/loops/certificate.hpp"
#include "exact/ball.hpp"
#include "exact/flint_matrix.hpp"

namespace kov::certify {

/// A square matrix of enclosures.
class Enclosures {
public:
  explicit Enclosures(long n) { acb_mat_init(m_, n, n); }
  Enclosures(const Enclosures& o) : Enclosures(o.size()) { acb_mat_set(m_, o.m_); }
  Enclosures& operator=(const Enclosures& o) = delete;
  ~Enclosures() { acb_mat_clear(m_); }
  [[nodiscard]] long size() const noexcept { return acb_mat_nrows(m_); }
  [[nodiscard]] acb_mat_struct* raw() noexcept { return m_; }
  [[nodiscard]] const acb_mat_struct* raw() const noexcept { return m_; }
  [[nodiscard]] acb_struct* at(long i, long j) noexcept { return acb_mat_entry(m_, i, j); }
  [[nodiscard]] const acb_struct* at(long i, long j) const noexcept {
    return acb_mat_entry(m_, i, j);
  }

private:
  acb_mat_t m_;
};

/// M with Y -> Y M along the closed polygon, Y = 1 at its first point.
/// Throws Refused
[[nodiscard]] Enclosures along(const std::vector<LoopRow>& rows, const Polygon& polygon, long bits,
                               double& work);

} // namespace kov::certify
