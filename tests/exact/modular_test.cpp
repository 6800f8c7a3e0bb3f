#include "exact/modular.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

TEST(Roots, OfQuadraticPolynomialsAreThoseThatTheValuesShow) {
  for (const mp_limb_t p : {3UL, 5UL, 7UL, 13UL, 17UL, 31UL})
    for (mp_limb_t lead = 1; lead < p; lead += p / 2)
      for (mp_limb_t b = 0; b < p; ++b)
        for (mp_limb_t c = 0; c < p; ++c) {
          NmodPoly f(p);
          f.set_coeff(0, c);
          f.set_coeff(1, b);
          f.set_coeff(2, lead);
          std::vector<mp_limb_t> expected;
          for (mp_limb_t x = 0; x < p; ++x)
            if (evaluate(f, x) == 0) expected.push_back(x);
          EXPECT_EQ(roots(f), expected) << lead << " " << b << " " << c << " mod " << p;
        }
}

} // namespace
} // namespace kov
