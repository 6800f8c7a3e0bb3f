// Sets of parameters that follow others: by a symmetry of the family, or by a rotation.

#include "classify/classify.hpp"

#include "exact/error.hpp"
#include "system/read_system.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov::followers_test {
namespace {

System plane(const std::string& parameters, const std::string& potential,
             const std::string& assume = "") {
  return read_system(parse_document(
      "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
      "parameters = [" +
          parameters + "]\nhamiltonian = '(u^2 + v^2)/2 + " + potential + "'\n" + assume,
      "test.toml"));
}

const std::string ring_potential = "a*x + b*y + (x^2 + y^2)^2";
const std::string real = "[assume]\na = 'real'\nb = 'real'\n";

bool is_moved(const ClassifiedStratum& s) {
  return std::any_of(s.by.begin(), s.by.end(), [](const ExclusionReason& by) {
    return by.solution.find("moved by") != std::string::npos;
  });
}

// Only b = 0 is studied; what is excluded there is excluded in all directions.
TEST(Followers, ARotation) {
  const auto c = classify_system(plane("'a', 'b'", ring_potential, real));
  EXPECT_EQ(c.status(), Verdict::depends) << statement(c);
  EXPECT_TRUE(std::any_of(c.strata.begin(), c.strata.end(), is_moved));
}

// a = i b is taken to no b = 0: it is a set of its own, of which nothing is said by the rotation.
TEST(Followers, TheIsotropicDirectionsOfComplexParameters) {
  const auto c = classify_system(plane("'a', 'b'", ring_potential));
  const Ring& ring = c.strata.front().where.ring();
  const MPoly a = MPoly::variable(ring, "a"), b = MPoly::variable(ring, "b");
  bool found = false;
  for (const ClassifiedStratum& s : c.strata) {
    if (!s.where.vanishes(a * a + b * b) || s.where.vanishes(b)) continue;
    found = true;
    EXPECT_FALSE(is_moved(s));
    EXPECT_FALSE(s.status == StratumStatus::open && s.open_after.empty()) << "not looked at";
  }
  EXPECT_TRUE(found);
}

// The field of the rotation may be there, and the assumptions do not turn: all is studied as it is.
TEST(Followers, AnAssumptionThatDoesNotTurn) {
  const auto c = classify_system(
      plane("'a', 'b'", ring_potential, "[assume]\na = 'positive'\nb = 'positive'\n"));
  EXPECT_EQ(c.status(), Verdict::non_integrable) << statement(c);
  EXPECT_FALSE(std::any_of(c.strata.begin(), c.strata.end(), is_moved));
}

// Integrals are carried too: x u' and the like.  Each is an integral on its set.
TEST(Followers, IntegralsOfTheSetsThatFollow) {
  const System s = read_system(parse_document(
      "[system]\nkind = 'euler-poisson'\ncoordinates = ['M1', 'M2', 'M3', 'G1', 'G2', 'G3']\n"
      "parameters = ['L1', 'L2']\nhamiltonian = '(M1^2 + M2^2 + 2*M3^2)/2 + L1*G1 + L2*G2'\n"
      "[assume]\nL1 = 'real'\nL2 = 'real'\n",
      "kovalevskaya.toml"));
  const auto c = classify_system(s);
  EXPECT_EQ(c.status(), Verdict::integrable) << statement(c);
  for (const ClassifiedStratum& x : c.strata)
    for (const FoundIntegral& f : x.integrals) {
      const MFraction derivative = lie_derivative(s.field, transfer(f.value, s.ring()));
      EXPECT_TRUE(is_zero(derivative) || x.where.vanishes(MPoly::variable(x.where.ring(), "L2")))
          << to_string(f);
    }
}

} // namespace
} // namespace kov::followers_test
