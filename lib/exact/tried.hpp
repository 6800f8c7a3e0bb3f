#pragma once
// An action that may fail in ways that are named; then nothing was found.

#include "exact/error.hpp"

#include <type_traits>

namespace kov {

/// The value of the action, or an empty one (false, nothing, no elements) if it throws one of the errors that
/// are named; true at the end of an action without a value.  Other errors pass, and every InternalError does,
/// whatever is named.
/// Given   const auto two = [] { return 2; };
/// Given   const auto limit = [] { throw OutOfBudget("a limit"); };
/// Example tried<DomainError>(two)  // -> 2
/// Example tried<DomainError, OutOfBudget>(limit)  // -> no
/// Example tried<DomainError>(limit)  // -> throws OutOfBudget
/// Given   const auto bug = [] { throw InternalError("a bug"); };
/// Example tried<Error>(bug)  // -> throws InternalError
template <class Caught, class... Others, class Action> auto tried(const Action& action) {
  using Result = decltype(action());
  using Value = std::conditional_t<std::is_void_v<Result>, bool, Result>;
  try {
    if constexpr (sizeof...(Others) > 0)
      return Value(tried<Others...>(action));
    else if constexpr (std::is_void_v<Result>)
      return action(), true;
    else
      return action();
  } catch (const InternalError&) {
    throw;
  } catch (const Caught&) {
    return Value{};
  }
}

} // namespace kov
