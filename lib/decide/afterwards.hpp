#pragma once
// Work after a verdict (certificates, solutions, special functions, second opinions, printing)
// may fail; that costs this part only.  What puts the verdict itself in doubt does not stay here.

#include "exact/error.hpp"

#include <functional>
#include <string>
#include <string_view>

namespace kov {

/// Two results exclude each other, or our own checker refuses a proof: what was found is in doubt, and
/// nothing keeps it.
class Contradiction : public InternalError {
  using InternalError::InternalError;
};

/// Does one part of the work behind a verdict.  Returns a sentence on what went wrong; empty: nothing
/// did.  Limits (OutOfBudget, no memory) and Contradiction pass.
/// Example failure_of("the solutions", [] {}).empty()  // -> yes
[[nodiscard]] std::string failure_of(std::string_view part, const std::function<void()>& work);
/// The same, and a limit of work or time is such a sentence as well.
/// Example failure_or_limit_of("orders", [] {}).empty()  // -> yes
[[nodiscard]] std::string failure_or_limit_of(std::string_view part,
                                              const std::function<void()>& work);
/// The same sentence for what failed elsewhere.
/// Example failure_of("the solutions", "1 != 1")  // -> an error of the program in the solutions: 1 != 1
[[nodiscard]] std::string failure_of(std::string_view part, std::string_view why);

/// Called when a part begins, and again when it is done; what it throws counts as thrown by the part.
/// For tests.  Empty: nobody looks.
using PartObserver = std::function<void(std::string_view part)>;
void observe_parts(PartObserver observer);

} // namespace kov
