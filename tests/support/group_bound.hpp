#pragma once
// Is a group one of those that a bound speaks of?

#include "closed/parts.hpp"
#include "exact/lists.hpp"

namespace kov::strata {

inline bool allows(GroupBound bound, const GaloisGroup& g) {
  using enum GroupType;
  const auto is = [&](std::initializer_list<GroupType> types) { return is_among(g.type, types); };
  switch (bound) {
  case GroupBound::unknown:
    return true;
  case GroupBound::SL2_or_Borel:
    return is({SL2, Borel});
  case GroupBound::torus_normaliser:
    return is({Gm, cyclic, Dinf, D});
  case GroupBound::torus_normaliser_or_T:
    return is({Gm, cyclic, Dinf, D, T});
  case GroupBound::finite_or_normaliser_or_T:
    return !is({SL2, Borel});
  case GroupBound::triangular_or_cyclic:
    return is({T, cyclic});
  case GroupBound::finite:
    return is({cyclic, D, A4, S4, A5});
  }
  return true;
}

} // namespace kov::strata
