#include "linode/normal_form.hpp"

namespace kov {

NormalForm normal_form(const RationalFunction& p, const RationalFunction& q) {
  const RationalFunction r = p * p * RationalFunction(Rational(1, 4)) +
                             derivative(p) * RationalFunction(Rational(1, 2)) - q;
  return {.r = r, .p = p};
}

} // namespace kov
