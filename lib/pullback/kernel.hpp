#pragma once
// The kernel of a matrix over K.

#include "exact/budget.hpp"
#include "exact/number_field.hpp"

#include <vector>

namespace kov::pullback {

using Row = std::vector<NfElem>;

/// A basis of the x with M x = 0; `columns` is the length of each row.
/// Cost    one prime ideal where there is nothing; otherwise one elimination over K
/// Throws  OutOfBudget
/// Example kernel({{1, 2}, {2, 4}}, 2)  // -> {{-2, 1}}
/// Example kernel({{1, 2}, {2, 5}}, 2)  // -> {}
[[nodiscard]] std::vector<Row> kernel(const std::vector<Row>& rows, std::size_t columns,
                                      const Budget& budget = {});

} // namespace kov::pullback
