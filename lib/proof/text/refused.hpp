#pragma once
// How a judge says no.

#include <string>

namespace kov::certify {

/// Thrown inside the judge by a check that fails; check() turns it into Rejected.
struct Refused {
  std::string why;
  bool limit = false; ///< only a size: what the step states may be true, it is not looked at
};

inline void need(bool condition, const char* why) {
  if (!condition) throw Refused{why};
}
/// The sizes of limits.hpp.
inline void need_within(bool condition, const char* why) {
  if (!condition) throw Refused{why, true};
}

} // namespace kov::certify
