#include "flow/number/big_real.hpp"

namespace kov::flow {

std::string to_string(const BigReal& x, int digits) {
  char* text = nullptr;
  mpfr_asprintf(&text, "%.*Re", digits - 1, x.raw());
  std::string out(text);
  mpfr_free_str(text);
  return out;
}

} // namespace kov::flow
