#pragma once
// An identity that was checked, and what it says: the material of reports.

#include <string>
#include <vector>

namespace kov {

struct CheckedIdentity {
  std::string statement;
  bool holds = false;
};
using CheckedIdentities = std::vector<CheckedIdentity>;

[[nodiscard]] inline bool all_hold(const CheckedIdentities& c) {
  for (const CheckedIdentity& x : c)
    if (!x.holds) return false;
  return !c.empty();
}

} // namespace kov
