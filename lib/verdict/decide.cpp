#include "verdict/decide.hpp"

namespace kov {

Decision decide(const NormalForm& equation, const Options&) {
  Decision d;
  d.r = equation.r;
  d.undecided = Unable{Unable::Why::not_implemented, "the driver is not furnished yet"};
  d.reason = d.undecided->detail;
  return d;
}

} // namespace kov
