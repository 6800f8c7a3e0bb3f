// Unipotent by exponents, and what does not commute.

#include "monodromy/identity_component.hpp"

#include "exact/error.hpp"

#include <gmock/gmock.h>

#include <optional>
#include <tuple>

namespace {

using namespace kov;
using namespace kov::monodromy;
using testing::Eq;
using testing::Optional;
using Matrix = std::vector<std::vector<RationalFunction>>;

RationalFunction z() { return {Poly::z(), Poly(1)}; }
RationalFunction q(long n, long d = 1) { return {Rational(Integer(n), Integer(d))}; }
Poly place(long at) { return Poly::z() - Poly(at); }

// exponents 1/3 + 1 and -1/2 + 0 at 0 in a triangular system
Matrix triangular(const RationalFunction& first, const RationalFunction& second,
                  const RationalFunction& coupling) {
  return {{first, coupling}, {q(0), second}};
}

TEST(UnipotentPower, IsTheCommonDenominatorOfTheExponents) {
  const Matrix a = triangular(q(4, 3) / z(), q(-1, 2) / z(), q(1) / z());
  EXPECT_THAT(unipotent_power(make_system(a), place(0)), Optional(Eq(6)));
  EXPECT_THAT(unipotent_power(make_system(a), place(1)), Optional(Eq(1))); // an ordinary point
  EXPECT_THAT(unipotent_power_at_infinity(make_system(a)), Optional(Eq(6)));
}

TEST(UnipotentPower, ResonanceIsNoHindrance) {
  const Matrix a = triangular(q(2) / z(), q(0), q(5) / z());
  EXPECT_THAT(unipotent_power(make_system(a), place(0)), Optional(Eq(1)));
}

TEST(UnipotentPower, ExponentsThatAreNotRationalSayNothing) {
  const Poly f = Poly::z() * Poly::z() - Poly(2); // residue z at each root: +-sqrt 2
  const RationalFunction pole = RationalFunction(derivative(f)) / RationalFunction(f);
  EXPECT_EQ(unipotent_power(make_system(triangular(z() * pole, q(0), q(1))), f), std::nullopt);
  EXPECT_THAT(unipotent_power(make_system(triangular(q(1, 5) * pole, q(0), q(1))), f),
              Optional(Eq(5)));
  // eigenvalues +-i of the residue: rational coefficients, no rational roots
  const Matrix rotation{{q(0), q(1) / z()}, {q(-1) / z(), q(0)}};
  EXPECT_EQ(unipotent_power(make_system(rotation), place(0)), std::nullopt);
}

TEST(UnipotentPower, AFieldThatIsNotQ) {
  const Field k = make_field({-2, 0, 1}, "s", 0);
  const RationalFunction s{Poly(NfElem::generator(k))};
  const Poly at = Poly::z() - Poly(NfElem::generator(k));
  const Matrix a = triangular(q(1, 2) / (z() - s), s / z(), q(3) / z());
  EXPECT_THAT(unipotent_power(make_system(a), at), Optional(Eq(2)));
  EXPECT_EQ(unipotent_power(make_system(a), coerce(place(0), k)), std::nullopt);
}

// y'' = 2/z^2 y as a system with a double pole in one corner and nothing in the other
TEST(UnipotentPower, HigherPolesThatWeightsTakeAway) {
  const Matrix regular{{q(0), q(1)}, {q(2) / (z() * z()), q(0)}};
  EXPECT_THAT(unipotent_power(make_system(regular), place(0)), Optional(Eq(1)));
  const Matrix other_way{{q(0), q(2) / (z() * z())}, {q(1), q(0)}};
  EXPECT_THAT(unipotent_power(make_system(other_way), place(0)), Optional(Eq(1)));
  const Matrix irregular{{q(0), q(1) / z()}, {q(2) / (z() * z()), q(0)}};
  EXPECT_EQ(unipotent_power(make_system(irregular), place(0)), std::nullopt);
  const Matrix growing{{q(1) / (z() * z()), q(0)}, {q(0), q(0)}};
  EXPECT_EQ(unipotent_power(make_system(growing), place(0)), std::nullopt);
}

std::optional<NonAbelianProof> proof_for(const Matrix& a) {
  const DifferentialSystem s = make_system(a);
  const Monodromy m = monodromy::monodromy(s, {20, {}, {}});
  return prove_non_abelian(m, unipotent_elements(s, m));
}

// The dilogarithm: M_0 = exp(2 pi i E12), M_1 = exp(2 pi i E23) up to conjugation.
TEST(IdentityComponent, TheDilogarithm) {
  const Matrix a{{q(0), q(1) / z(), q(0)}, {q(0), q(0), q(1) / (z() - q(1))}, {q(0), q(0), q(0)}};
  const auto proof = proof_for(a);
  ASSERT_TRUE(proof.has_value());
  EXPECT_FALSE(acb_contains_zero(proof->entry.raw()));
}

// Logarithms only: an abelian unipotent group.
TEST(IdentityComponent, LogarithmsProveNothing) {
  const RationalFunction f = q(1) / z() + q(3) / (z() - q(1));
  EXPECT_FALSE(proof_for({{q(0), f, q(1) / z()}, {q(0), q(0), q(0)}, {q(0), q(0), q(0)}}));
}

// The square of M_0 is unipotent, M_0 is not; what does not commute is only M_0 itself.
TEST(IdentityComponent, ElementsOutsideOfTheComponentProveNothing) {
  // diag(z^(1/2), 1) acts on the additive group of int dz/(sqrt z (z - 1)): G0 = Ga, G not abelian
  const Matrix a = triangular(q(1, 2) / z(), q(0), q(1) / (z() - q(1)));
  EXPECT_FALSE(proof_for(a));
}

// A block with unipotent matrices that generate a group dense in SL(2): Legendre's equation.
TEST(IdentityComponent, EllipticPeriods) {
  const RationalFunction w = z() * (q(1) - z());
  const auto proof = proof_for({{q(0), q(1)}, {q(1, 4) / w, (q(2) * z() - q(1)) / w}});
  EXPECT_TRUE(proof.has_value());
}

// Words in matrices with a unitary structure: no word is hyperbolic.
Monodromy of_hypergeometric(const Rational& a, const Rational& b, const Rational& c) {
  const RationalFunction p =
      (RationalFunction(c) - RationalFunction(a + b + 1) * z()) / (z() * (q(1) - z()));
  return monodromy::monodromy(p, -RationalFunction(a * b) / (z() * (q(1) - z())), {20, {}, {}});
}

TEST(ProveSl2, UnitaryGroupsThatAreNotFinite) {
  const Monodromy m = of_hypergeometric(Rational(-3, 70), Rational(17, 70), Rational(3, 5));
  EXPECT_FALSE(prove_infinite(m));
  ASSERT_TRUE(prove_sl2(m));
  EXPECT_TRUE(std::holds_alternative<NoSmallGroup>(*prove_sl2(m)));
}

TEST(ProveSl2, NotOfFiniteGroups) { // Schwarz' list: tetrahedral, octahedral, icosahedral, dihedral
  using R = Rational;
  for (const auto& [a, b, c] :
       {std::tuple(R(1, 4), R(-1, 12), R(2, 3)), std::tuple(R(-1, 24), R(7, 24), R(3, 4)),
        std::tuple(R(-1, 60), R(11, 60), R(2, 3)), std::tuple(R(1, 5), R(-1, 5), R(1, 2))})
    EXPECT_FALSE(prove_sl2(of_hypergeometric(a, b, c)));
}

} // namespace
