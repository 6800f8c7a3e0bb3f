#pragma once
// The kernel of a matrix over Q[parameters] at all parameter values: a tree of cases.
//
// Source  docs/theory/integrals.md (2)

#include "exact/error.hpp"
#include "parameters/set.hpp"

#include <functional>

namespace kov {

/// The entries of one row that are not 0, by column.
using SparseRow = std::map<std::size_t, MPoly>;

/// The vector times the common denominator of its entries.
[[nodiscard]] SparseRow without_denominators(const Ring& ring,
                                             const std::map<std::size_t, MFraction>& vector);
/// The row on the set, up to a factor that vanishes nowhere there.
[[nodiscard]] SparseRow restricted(const Set& where, const SparseRow& row);

/// A matrix on its way to an echelon form.
struct EchelonForm {
  std::size_t columns = 0;
  std::vector<SparseRow> rows; ///< that are still to be reduced
  struct Pivot {
    std::size_t column;
    SparseRow row;
  };
  std::vector<Pivot> pivots{}; ///< in the order in which they were taken
};

/// Calls `leaf` with the parts of `where` and the echelon form there: no rows are left, and the
/// kernel has dimension columns - pivots at every point of the part.  The parts are disjoint and
/// cover `where`.
/// Errors  OutOfBudget
using KernelLeaf = std::function<void(const Set&, const EchelonForm&)>;
void for_each_kernel(Set where, EchelonForm e, const KernelLeaf& leaf, const Budget& budget = {});

/// The same where `leaf` may go on working on its part, within a budget that the parts share: where a
/// factor is 0 half of what is left may be spent, so that no part keeps all others waiting.  `open` is
/// called with the parts that a limit left.
struct KernelParts {
  std::function<void(const Set&, const EchelonForm&, const Budget&)> leaf;
  std::function<void(const Set&, const OutOfBudget&)> open;
};
void share_among_kernels(Set where, EchelonForm e, const KernelParts& parts, const Budget& budget);

/// A basis of the kernel; the entry of its own free column is 1, denominators vanish nowhere.
/// Requires an elimination without rows.
[[nodiscard]] std::vector<std::map<std::size_t, MFraction>> kernel_basis(const Set& where,
                                                                         const EchelonForm& e);

/// Columns that the span of the rows allows to be made 0 in any vector: pivots that vanish nowhere.
[[nodiscard]] std::vector<std::size_t> gauge_columns(const Set& where, EchelonForm e,
                                                     const Budget& budget = {});

/// True only if the columns are independent for certain: no parameter occurs and the rank modulo
/// one prime is full.
[[nodiscard]] bool independent_modulo_a_prime(const EchelonForm& e);

} // namespace kov
