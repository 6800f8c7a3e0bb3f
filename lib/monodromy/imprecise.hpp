#pragma once
// "More bits are needed": thrown inside this room, caught where the precision is chosen.

#include "exact/error.hpp"

namespace kov::monodromy {

class Imprecise : public Error {
  using Error::Error;
};

} // namespace kov::monodromy
