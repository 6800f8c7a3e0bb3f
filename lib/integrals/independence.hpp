#pragma once
// Functional independence, at all parameter values of a set.
//
// Source  docs/theory/integrals.md (3)

#include "integrals/ansatz.hpp"

namespace kov {

/// Rows (gradients) of which a minor vanishes identically at no parameter value.
class IndependentRows {
public:
  explicit IndependentRows(const PhaseSpace& p) : p_(&p) {}

  /// The effect of a new row: taken, proved dependent, or the parameters must be split first, by an
  /// irreducible polynomial.
  struct Answer {
    bool taken = false;
    std::optional<MPoly> split = {};
  };
  /// Cost  one determinant for each coordinate
  [[nodiscard]] Answer add(const Set& where, const std::vector<MFraction>& row,
                           const Budget& budget = {});
  [[nodiscard]] std::size_t size() const noexcept { return rows_.size(); }

private:
  [[nodiscard]] MPoly minor(const std::vector<MPoly>& row, std::size_t column) const;

  const PhaseSpace* p_;
  std::vector<std::vector<MPoly>> rows_;
  std::vector<std::size_t> columns_;
};

/// The determinant of a square matrix; fraction-free elimination (Bareiss).
/// Given   const Ring ring = make_ring({"a", "b"});
/// Given   const MPoly a = MPoly::variable(ring, "a"), b = MPoly::variable(ring, "b");
/// Example determinant({{a, b}, {b, a}})  // -> a^2 - b^2
[[nodiscard]] MPoly determinant(std::vector<std::vector<MPoly>> m);

} // namespace kov
