#include "moves/axes.hpp"

#include "families.hpp"
#include "support/random.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov {
namespace {

using test::Random;
using test::random_rounds;
using testing::HasSubstr;
using testing::Not;

// The rotation of the unit quaternion (a + b i + c j + d k)/|.|, which is rational.
std::vector<std::vector<Rational>> rotation(long a, long b, long c, long d) {
  const Rational n(a * a + b * b + c * c + d * d);
  std::vector<std::vector<Rational>> r{
      {a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)},
      {2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)},
      {2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d}};
  for (auto& row : r)
    for (Rational& x : row)
      x = x / n;
  return r;
}
std::string row(const std::vector<Rational>& r, const std::string& x) {
  std::string text = "(";
  for (std::size_t i = 0; i < 3; ++i)
    text += (i ? " + (" : "(") + to_string(r[i]) + ")*" + x + std::to_string(i + 1);
  return text + ")";
}
// m[i] (R M)_i^2/2 + l[i] (R Gamma)_i
std::string turned(const std::vector<std::vector<Rational>>& r, const std::vector<std::string>& m,
                   const std::vector<std::string>& l) {
  std::string text = "0";
  for (std::size_t i = 0; i < 3; ++i)
    text += " + (" + m[i] + ")*" + row(r[i], "M") + "^2/2 + (" + l[i] + ")*" + row(r[i], "G");
  return text;
}
bool is_diagonal(const System& s) {
  const auto& x = s.field.coordinates;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!is_zero(derivative(derivative(*s.field.hamiltonian, x[i]), x[j]))) return false;
  return true;
}

TEST(Axes, ATurnedBodyIsTurnedBack) {
  random_rounds(12, [](Random& random) {
    const auto r = rotation(random.between(1, 4), random.between(-3, 3), random.between(-3, 3),
                            random.between(1, 3));
    for (const std::vector<std::string>& moments :
         {std::vector<std::string>{"1", "2", "3"}, {"1", "a", "-3"}, {"b", "b", "a"}}) {
      const System s = on_e3("'a', 'b', 'x'", turned(r, moments, {"x", "0", "b"}));
      const auto change = on_principal_axes(s);
      ASSERT_TRUE(change) << turned(r, moments, {"x", "0", "b"});
      EXPECT_TRUE(is_diagonal(change->system));
      EXPECT_TRUE(is_canonical(s, *change));
      EXPECT_EQ(change->system.field.parameters.size(), s.field.parameters.size());
    }
  });
}

// H has no value at a = 0, and "not integrable except for a = 0" would be about no system.
TEST(Axes, TheDomainIsThatOfTheSystem) {
  const System s =
      on_e3("'a', 'b'", turned(rotation(1, 2, -1, 3), {"1", "2", "1/a"}, {"b", "0", "1/(a - b)"}));
  ASSERT_EQ(s.domain.lists().size(), 2U);
  const auto change = on_principal_axes(s);
  ASSERT_TRUE(change);
  const System& now = change->system;
  const auto zero = [&](const std::string& name, const MPoly& p) {
    const std::size_t i = now.ring()->index(name);
    return p == MPoly::variable(now.ring(), i) || p == -MPoly::variable(now.ring(), i);
  };
  EXPECT_EQ(now.domain.lists().size(), 2U);
  EXPECT_TRUE(now.domain.excludes([&](const MPoly& p) { return zero("a", p); }));
  EXPECT_FALSE(now.domain.excludes([&](const MPoly& p) { return zero("b", p); }));
}

TEST(Axes, OfEqualMomentsTheLeverChoosesOne) {
  const auto change =
      on_principal_axes(on_e3("'x'", "(M1^2 + M2^2)/2 + 3*M3^2/2 + x*(3*G1 + 4*G2) + G3"));
  ASSERT_TRUE(change);
  const VectorField& v = change->system.field;
  std::size_t used = 0;
  for (std::size_t i = 3; i < 6; ++i)
    used += uses(*v.hamiltonian, v.coordinates[i]) ? 1 : 0;
  EXPECT_EQ(used, 2) << to_string(*v.hamiltonian);
}

TEST(Axes, ThatAreNotTurnedOrNotRationalAreLeft) {
  for (const std::string h : {"M1^2 + 2*M2^2 + 3*M3^2 + G1 + G2", "M1^2 + M2^2 + M3^2 + G1 + G2",
                              "M1^2 + M1*M2 + 2*M2^2 + M3^2",        // eigenvalues with a root
                              "M1^2 + M1*M2 + M2^2 + M3^2 + G3",     // lengths with a root
                              "M1^2 + M2^2 + 2*M3^2 + G1 + G2 + G3", // the lever has one
                              "M1^2 + M2^2 + 2*M3^2 + x*G1 + y*G2",  // a frame with parameters
                              "(M1 + M2)*M3/(G1 + G2)"})             // a pole
    EXPECT_FALSE(on_principal_axes(on_e3("'x', 'y'", h))) << h;
}

// (1, i, 0) has length 0.
TEST(Axes, AnIsotropicAxisIsNone) {
  const System s = on_e3("'a'", "(M1^2 - M2^2)/2 + a*M1*M2 + 5*M3^2 + G1");
  EXPECT_FALSE(on_principal_axes(s));
}

// A change whose brackets or Hamiltonian are others is refused, whoever found it.
TEST(Axes, FalseChangesAreRefused) {
  const System s = on_e3("'x'", turned(rotation(1, 2, 0, 1), {"1", "2", "3"}, {"x", "0", "1"}));
  const auto change = on_principal_axes(s);
  ASSERT_TRUE(change);
  for (std::size_t i = 0; i < 6; ++i) {
    CanonicalChange wrong = *change;
    wrong.variables[i] = -wrong.variables[i];
    EXPECT_FALSE(is_canonical(s, wrong));
    wrong.variables[i] = MFraction(s.ring());
    EXPECT_FALSE(is_canonical(s, wrong));
  }
  CanonicalChange other = *change;
  other.system.field.hamiltonian = Rational(2) * *other.system.field.hamiltonian;
  EXPECT_FALSE(is_canonical(s, other));
  other = *change;
  other.system.field.poisson = Matrix(6, std::vector<MFraction>(6, MFraction(other.system.ring())));
  EXPECT_FALSE(is_canonical(s, other));
}

} // namespace
} // namespace kov
