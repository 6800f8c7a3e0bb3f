// Many exponent differences are judged by one identity: each false one must still be seen.

#include "certify/equation/facts.hpp"
#include "certify/equation/rules.hpp"
#include "exact/rational_function.hpp"

#include <gtest/gtest.h>

namespace kov::certify::exponents_test {
namespace {

const Poly z = Poly::z();

// r = z + sum a_c/(z-c)^2 + sum over q = z^2-2, z^2-3 of (u_q)/(q^2), and a place of order 4.
struct Example {
  Judge judge;
  Local local;
};

Example example() {
  Example e;
  e.local.prime = PrimeIdeals::large(rationals()).next();
  RationalFunction r(z);
  const auto add = [&](const Poly& q, const Poly& a, const Poly& delta2) {
    r = r + RationalFunction(a, q * q);
    LocalPlace place;
    place.q = q;
    place.order = 2;
    place.delta2 = delta2;
    e.local.places.push_back(place);
  };
  for (long c = 1; c < 8; ++c) // 1 + 4a
    add(z - Poly(c), Poly(Rational(c, 5)), Poly(Rational(5 + 4 * c, 5)));
  // u/(q'^2) at the roots: with q = z^2-d, q'^2 = 4d; u = z: Delta^2 = 1 + z/d
  for (long d = 2; d < 4; ++d)
    add(z * z - Poly(d), z, Poly(1) + scale(z, NfElem(Rational(1, d))));
  r = r + RationalFunction(Poly(1), pow(z, 4));
  LocalPlace irregular;
  irregular.q = z;
  irregular.order = 4;
  e.local.places.push_back(irregular);
  e.judge.field = rationals();
  e.judge.equation = {r.num(), r.den()};
  return e;
}

TEST(Exponents, TheTruthIsAccepted) {
  const Example e = example();
  const LocalFact fact = check_local(e.judge, e.local);
  EXPECT_EQ(fact.all.size(), 11U);
}

TEST(Exponents, OneFalseValueIsRefused) {
  for (std::size_t i = 0; i < 9; ++i)
    for (const Poly& wrong : {Poly(1), z, Poly(Rational(1, 1000003))}) {
      Example e = example();
      LocalPlace& place = e.local.places[i];
      if (degree(wrong) >= degree(place.q)) continue;
      *place.delta2 += wrong;
      EXPECT_THROW(check_local(e.judge, e.local), Refused) << i;
    }
}

TEST(Exponents, TwoValuesThatChangePlacesAreRefused) {
  for (std::size_t i = 0; i + 1 < 7; ++i) {
    Example e = example();
    std::swap(e.local.places[i].delta2, e.local.places[i + 1].delta2);
    EXPECT_THROW(check_local(e.judge, e.local), Refused) << i;
  }
  Example e = example(); // errors that cancel in a sum
  *e.local.places[0].delta2 += Poly(1);
  *e.local.places[1].delta2 -= Poly(1);
  EXPECT_THROW(check_local(e.judge, e.local), Refused);
}

TEST(Exponents, OrdersThatAreNotTwoHaveNoDelta) {
  Example e = example();
  e.local.places.back().delta2 = Poly(1);
  EXPECT_THROW(check_local(e.judge, e.local), Refused);
}

} // namespace
} // namespace kov::certify::exponents_test
