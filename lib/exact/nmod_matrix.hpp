#pragma once
// Matrices over F_p: FLINT's nmod_mat as a value.

#include "exact/flint.hpp"

#include <vector>

namespace kov {

/// A matrix over F_p, 0 at first.
///
/// Given   NmodMatrix m(2, 3, 7);
/// Given   m(0, 0) = 1; m(0, 1) = 2; m(1, 0) = 3; m(1, 1) = 6; m(1, 2) = 1;
/// Example m.has_independent_columns()  // -> no
/// Example m.kernel().size() // -> 1
/// Example m.row_reduce()  // -> {0, 2}
class NmodMatrix {
public:
  NmodMatrix(std::size_t rows, std::size_t columns, mp_limb_t p) {
    nmod_mat_init(m_, static_cast<slong>(rows), static_cast<slong>(columns), p);
  }
  NmodMatrix(const NmodMatrix&) = delete;
  NmodMatrix& operator=(const NmodMatrix&) = delete;
  ~NmodMatrix() { nmod_mat_clear(m_); }

  [[nodiscard]] nmod_t mod() const { return m_->mod; }
  [[nodiscard]] std::size_t rows() const { return static_cast<std::size_t>(m_->r); }
  [[nodiscard]] std::size_t columns() const { return static_cast<std::size_t>(m_->c); }
  [[nodiscard]] mp_limb_t& operator()(std::size_t i, std::size_t j) {
    return nmod_mat_entry(m_, i, j);
  }

  /// Sets each entry to value(i, j); false, and nothing is said of the rest, where that is unset.
  template <class Value> [[nodiscard]] bool fill(const Value& value) {
    for (std::size_t i = 0; i < rows(); ++i)
      for (std::size_t j = 0; j < columns(); ++j) {
        const auto x = value(i, j);
        if (!x) return false;
        (*this)(i, j) = *x;
      }
    return true;
  }
  [[nodiscard]] bool has_independent_columns() const { return nmod_mat_rank(m_) == m_->c; }
  /// A basis of the x with m x = 0.
  [[nodiscard]] std::vector<std::vector<mp_limb_t>> kernel() const {
    NmodMatrix x(columns(), columns(), m_->mod.n);
    std::vector<std::vector<mp_limb_t>> basis(
        static_cast<std::size_t>(nmod_mat_nullspace(x.m_, m_)));
    for (std::size_t k = 0; k < basis.size(); ++k)
      for (std::size_t j = 0; j < columns(); ++j)
        basis[k].push_back(x(j, k));
    return basis;
  }
  /// Makes it the reduced echelon form; returns the columns of the pivots, of which the i-th is in row i.
  std::vector<std::size_t> row_reduce() {
    std::vector<std::size_t> pivots(static_cast<std::size_t>(nmod_mat_rref(m_)));
    for (std::size_t i = 0, j = 0; i < pivots.size(); ++i, ++j) {
      while ((*this)(i, j) == 0)
        ++j;
      pivots[i] = j;
    }
    return pivots;
  }

private:
  nmod_mat_t m_;
};

} // namespace kov
