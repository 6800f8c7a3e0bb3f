#pragma once
// The steps of the algorithm as data: what was tried, what was found, why something was left out.

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace kov::kovacic {

/// One step, with the numbers of the 1986 paper.
/// Given   Trace steps; static_cast<void>(solve(z, {}, &steps));
/// Example steps.front().text
///         // -> Case 1 is excluded. The order at infinity, -1, is odd and at most 2.
struct Step {
  int kovacic_case = 0; ///< 0: before the cases; 1, 2, 3
  int number = 0;       ///< 0: necessary conditions; 1: exponent sets; 2: families; 3: polynomial
  std::string text;     ///< full sentences
};

using Trace = std::vector<Step>;

/// Appends a step when somebody listens.  `text` is a string, or a function that makes one and is
/// called only then.
template <class Text> void note(Trace* trace, int kovacic_case, int number, Text&& text) {
  if (trace == nullptr) return;
  if constexpr (std::is_invocable_v<Text>)
    trace->push_back({kovacic_case, number, text()});
  else
    trace->push_back({kovacic_case, number, std::forward<Text>(text)});
}

} // namespace kov::kovacic
