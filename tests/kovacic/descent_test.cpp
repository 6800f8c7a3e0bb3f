// Solutions that live over extensions of the field of r: nothing may be missed over K alone.
// The numbers are those of docs/theory/descent.md.

#include "kovacic/reader.hpp"
#include "kovacic/residue_field.hpp"
#include "kovacic/solve.hpp"
#include "support/equations.hpp"

#include <gtest/gtest.h>

namespace kov::kovacic::descent_test {
namespace {

using testing::from_omega;
using testing::pull_back;
using testing::read;
using testing::riemann;

template <class T> T expect(const Outcome& outcome) {
  const T* found = std::get_if<T>(&outcome);
  EXPECT_NE(found, nullptr) << "another alternative: index " << outcome.index();
  return found != nullptr ? *found : T{};
}

// The two omegas of a pair, if w is in K.
std::optional<std::pair<RationalFunction, RationalFunction>> omegas(const ExponentialPair& pair) {
  const auto w = exact_sqrt(coerce(pair.w_squared, pair.v.field()));
  if (!w) return std::nullopt;
  const RationalFunction dv = derivative(pair.v);
  const RationalFunction twice = RationalFunction(2) * pair.v;
  const RationalFunction constant((Poly(*w)));
  return std::pair{(dv + constant) / twice, (dv - constant) / twice};
}

NfElem q(long n, long d = 1) { return NfElem(Rational(n, d)); }

TEST(ResidueField, SumsOverRootsOfAPlace) {
  const Poly place = read("z^2-5").num();
  // 1/(z-s)^2 + 1/(z+s)^2, s^2 = 5
  EXPECT_EQ(sum_over_roots(Poly(1), place, 2), read("(2*z^2+10)/(z^2-5)^2"));
  // s/(z-s) - s/(z+s)
  EXPECT_EQ(sum_over_roots(Poly::z(), place, 1), read("10/(z^2-5)"));
  EXPECT_EQ(trace(Poly::z() * Poly::z() % place, place), NfElem(10));
}

TEST(ResidueField, SquareRoots) {
  const Poly place = read("z^3-2").num();
  const Poly root = read("1+z-3*z^2/7").num();
  const auto found = square_root(root * root % place, place, {});
  ASSERT_TRUE(found);
  EXPECT_TRUE(*found == root || *found == -root);
  EXPECT_FALSE(square_root(Poly::z(), place, {})); // the norm 2 is not a square
  EXPECT_FALSE(square_root(read("z^2+1").num(), place, {}));
  const auto of_place = square_root(Poly(5), read("z^2-5").num(), {});
  ASSERT_TRUE(of_place); // a rational number that becomes a square
  EXPECT_EQ(*of_place * *of_place % read("z^2-5").num(), Poly(5));
}

TEST(ResidueField, SquareRootsOverANumberField) {
  const Field k = make_field({1, 0, 1}, "I");
  const Poly place = read("z^2-3+a", k).num();
  const Poly root = read("a*z+2-a/3", k).num();
  const auto found = square_root(root * root % place, place, {});
  ASSERT_TRUE(found);
  EXPECT_TRUE(*found == root || *found == -root);
  EXPECT_FALSE(square_root(scale(root * root % place, q(7)), place, {}));
}

// (5b) two lines conjugate over Q(sqrt 5), Q(i), and over a number field
TEST(Descent, ConjugateLines) {
  const auto euler = expect<ExponentialPair>(solve(read("1/z^2")));
  EXPECT_FALSE(omegas(euler));
  EXPECT_TRUE(exact_sqrt(euler.w_squared / q(5)));
  EXPECT_FALSE(omegas(expect<ExponentialPair>(solve(read("-1+6/z^2")))));
  const auto lines = omegas(expect<ExponentialPair>(solve(read("-1+6/z^2+I-I"))));
  ASSERT_TRUE(lines);
  EXPECT_TRUE(is_zero(from_omega(lines->first) - read("-1+6/z^2")));
  // y1 y2 = z^3-2, irreducible: the residues are not rational, one pair of lines all the same
  const RationalFunction f = read("(z^3-2)^2");
  const auto pair = expect<ExponentialPair>(solve(testing::from_square(f, q(3))));
  EXPECT_EQ(pair.v * pair.v / f, RationalFunction(Rational(1)));
}

// (5c) one line, exponents irrational but in the residue field of their place
TEST(Descent, IrrationalExponentsOfASingleLine) {
  for (const char* text :
       {"10/(z^2-5)+1", "(3*z+10)/(z^2-5)+z", "(z^2+4*z)/(z^3-2)+z", "(z^2+1)/(z^3-2)^2+1/z"}) {
    SCOPED_TRACE(text);
    const RationalFunction omega = read(text);
    EXPECT_EQ(expect<Exponential>(solve(from_omega(omega))).omega, omega);
  }
  const Field k = make_field({-5, 0, 1}, "s");
  const RationalFunction omega = read("(1+a)/(2*z)+(1-a)/(2*(z-1))+1+3/(z-2)", k);
  EXPECT_EQ(expect<Exponential>(solve(from_omega(omega))).omega, omega);
}

// (7) three quadratics of the quaternion group, conjugate over Q(2^(1/3))
TEST(Descent, QuaternionGroupOverACubicField) {
  const RationalFunction r = read("-27*z/(8*(z^3-2)^2)");
  const auto triple = expect<ImprimitiveTriple>(solve(r));
  EXPECT_EQ(triple.riccati.size(), 7u);
  // over the cubic field the place splits and one quadratic is found
  const Field k = make_field({-2, 0, 0, 1}, "a");
  expect<Imprimitive>(solve(coerce(r, k)));
  // over Q with a rational root as well
  expect<Imprimitive>(solve(read("-27*z/(16*(z^3-1)^2)")));
}

// (8) the two orbits of four lines are conjugate over Q(sqrt 5), not over Q
TEST(Descent, TetrahedralGroupWithConjugateOrbits) {
  const RationalFunction r = read("-2*(2*z^2+10)/(9*(z^2-5)^2)+37/(144*(z^2-5))");
  const auto over_q = expect<Algebraic>(solve(r));
  EXPECT_EQ(over_q.group, Primitive::tetrahedral);
  EXPECT_EQ(over_q.riccati.size(), 7u);
  const Field k = make_field({-5, 0, 1}, "s");
  const auto over_k = expect<Algebraic>(solve(coerce(r, k)));
  EXPECT_EQ(over_k.group, Primitive::tetrahedral);
  EXPECT_EQ(over_k.riccati.size(), 5u);
}

TEST(Descent, PrimitiveGroupsWithConjugatePlaces) {
  // exponent differences 1/2 at infinity and (1/3, 1/4) etc. cannot be conjugate; pull back instead
  const RationalFunction f = read("z^2/(z^2-5)");
  const RationalFunction octahedral = riemann(q(1, 9), q(1, 4), q(1, 16));
  EXPECT_EQ(expect<Algebraic>(solve(pull_back(octahedral, f))).group, Primitive::octahedral);
  const RationalFunction icosahedral = riemann(q(1, 9), q(1, 4), q(1, 25));
  EXPECT_EQ(expect<Algebraic>(solve(pull_back(icosahedral, f))).group, Primitive::icosahedral);
}

} // namespace
} // namespace kov::kovacic::descent_test
