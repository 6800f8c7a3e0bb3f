#pragma once
// What a classification says at single points of the parameters.

#include "study/classification.hpp"

#include <algorithm>
#include <map>
#include <string>

namespace kov::test {

using Point = std::map<std::string, Rational>;

// Is the point in the stratum?
inline bool contains(const ClassifiedStratum& s, const Point& point) {
  Set there = s.where;
  for (const auto& [name, value] : point) {
    const MPoly x = MPoly::variable(there.ring(), name);
    there = there.where_zero((MFraction(x) - MFraction(there.ring(), value)).num());
  }
  return !there.is_empty() &&
         std::all_of(s.where.statements().begin(), s.where.statements().end(), [&](const auto& c) {
           const auto here = on_set(c, there);
           return std::holds_alternative<bool>(here) && std::get<bool>(here);
         });
}

// What the theorem says there: each point is in exactly one stratum.
inline std::string status_at(const SystemClassification& c, const Point& point) {
  std::string status;
  for (const ClassifiedStratum& s : c.strata)
    if (contains(s, point)) status += (status.empty() ? "" : " and ") + to_string(s.status);
  return status;
}

} // namespace kov::test
