#pragma once
// Errors are exceptions with one base; "cannot decide" is a value (truth.hpp), never an exception
// that a caller of the public interface sees.

#include <stdexcept>
#include <string>

namespace kov {

/// Base of everything this library throws.  what() is a full sentence with the offending value.
class Error : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The caller broke a precondition.
class InvalidArgument : public Error {
  using Error::Error;
};

/// Mathematically undefined: a division by the zero function, an inverse that does not exist.
class DomainError : public Error {
  using Error::Error;
};

/// A limit of the Budget was reached; the drivers turn it into Unable{budget}.
class OutOfBudget : public Error {
  using Error::Error;
};

/// A self-check failed: a bug of ours, never a property of the input.
class InternalError : public Error {
  using Error::Error;
};

namespace detail {
[[noreturn]] void ensure_failed(const char* condition, const char* file, int line);
}

/// Always on, also in release builds: a false theorem is worse than a stopped program.
/// Example KOV_ENSURE(1 + 1 == 3)  // -> throws InternalError
#define KOV_ENSURE(condition)                                                                      \
  ((condition) ? static_cast<void>(0)                                                              \
               : ::kov::detail::ensure_failed(#condition, __FILE__, __LINE__))

} // namespace kov
