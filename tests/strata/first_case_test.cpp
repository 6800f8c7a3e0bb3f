// The explanation beside the proof: exponents, families and the conditions of degree 0.

#include "strata/first_case.hpp"

#include "decide/words.hpp"

#include <gtest/gtest.h>

namespace kov::strata::first_case_test {
namespace {

const Ring ring = make_ring({"a", "b", "z"});
MFraction x(const char* name) { return MFraction::variable(ring, name); }
MFraction number(long n, long d = 1) { return {ring, Rational(n, d)}; }

std::string steps(const MFraction& r) {
  Assumptions positive;
  positive.require(x("a"), Sign::positive);
  positive.require(x("b"), Sign::positive);
  std::string all;
  const ParametrisedSet region(ring, positive);
  const auto places = scheme(r, ring->index("z"), region);
  for (const kovacic::Step& s : first_case(std::get<Scheme>(places), region))
    all += name(s) + ": " + s.text + "\n";
  return all;
}

TEST(FirstCase, DegreeZeroGivesAConditionOnTheParameters) {
  const MFraction z = x("z");
  // exponents 3/4, 1/4 at 0 and 1; simple terms a
  const MFraction r = number(-3, 16) / (z * z) -
                      number(3, 16) / ((z - number(1)) * (z - number(1))) +
                      x("a") / (z * (z - number(1)));
  const std::string text = steps(r);
  EXPECT_NE(text.find("case 1, step 1, exponent sets: z = 0: Delta^2 = 1/4, exponents 3/4, 1/4"),
            std::string::npos)
      << text;
  // at infinity the exponent depends on a
  EXPECT_NE(text.find("not a finite list"), std::string::npos) << text;
}

TEST(FirstCase, FamiliesWithANaturalDegreeAreListed) {
  const MFraction z = x("z");
  const MFraction w = z - x("b");
  // omega = 1/(4 z) - 1/(4 (z - b))
  const MFraction omega = number(1, 4) / z - number(1, 4) / w;
  const MFraction r = derivative(omega, ring->index("z")) + omega * omega;
  const std::string text = steps(r);
  EXPECT_NE(text.find("step 2, families: d = 0: 1/4 at z = 0, -1/4 at z = b, "), std::string::npos)
      << text;
  EXPECT_NE(text.find("r = omega' + omega^2 holds"), std::string::npos) << text;
}

} // namespace
} // namespace kov::strata::first_case_test
