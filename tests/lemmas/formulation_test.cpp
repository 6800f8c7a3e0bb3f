// "Formulation of the problem" and "Preliminary considerations": equations of motion, integrals,
// Lemma 1.

#include "sliding_top.hpp"
#include "system/weights.hpp"

namespace kov::lemmas {
namespace {

using Vector = std::vector<MFraction>;

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
MFraction dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector scaled(const MFraction& c, const Vector& a) { return {c * a[0], c * a[1], c * a[2]}; }
Vector plus(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

class Formulation : public testing::Test {
protected:
  Vector vector(const std::string& name) {
    Vector v;
    for (const char* i : {"1", "2", "3"})
      v.push_back(formula(s, name + i));
    return v;
  }
  Vector times_inertia(const Vector& v) const { return {A * v[0], B * v[1], C * v[2]}; }
  MFraction name(const char* n) { return formula(s, n); }
  /// Omega as free variables of the ring, for statements about the Lagrangian itself.
  Vector free_omega() {
    Vector v;
    for (const std::size_t i : s.velocities)
      v.push_back(MFraction::variable(s.ring(), i));
    return v;
  }
  Vector dt(const Vector& v) {
    Vector d;
    for (const auto& f : v)
      d.push_back(lie_derivative(s.field, f));
    return d;
  }

  System s = sliding_top("sliding_top.toml");
  Vector M = vector("M"), Gamma = vector("Gamma"), L = vector("L"), Omega = vector("Omega");
  MFraction A = name("A"), B = name("B"), C = name("C"), m = name("m"), g = name("g");
};

TEST_F(Formulation, DerivativesOfTheLagrangian) { // eq. (dL)
  const Vector w = free_omega();
  const Vector l_gamma = cross(L, Gamma);
  const Vector by_omega = plus(times_inertia(w), scaled(m * dot(w, l_gamma), l_gamma));
  const Vector w_l = cross(w, L);
  const Vector by_gamma = minus(scaled(m * dot(Gamma, w_l), w_l), scaled(m * g, L));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(equal(derivative(*s.lagrangian, s.velocities[i]), by_omega[i]));
    EXPECT_TRUE(equal(derivative(*s.lagrangian, s.field.coordinates[3 + i]), by_gamma[i]));
  }
}

TEST_F(Formulation, EquationsForOmega) { // eq. (lag_borisovexpl)
  const Vector l_gamma = cross(L, Gamma);
  const Vector acceleration = dt(Omega);
  const Vector left =
      plus(times_inertia(acceleration), scaled(m * dot(l_gamma, acceleration), l_gamma));
  const Vector right = minus(cross(times_inertia(Omega), Omega),
                             scaled(m * (dot(cross(Gamma, Omega), cross(Omega, L)) + g), l_gamma));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(equal(left[i], right[i]));
    EXPECT_TRUE(equal(s.field.components[3 + i], cross(Gamma, Omega)[i]));
  }
}

TEST_F(Formulation, EquationsForM) { // eq. (lag_borisovMM)
  const Vector w_l = cross(Omega, L);
  const Vector right = plus(minus(cross(M, Omega), scaled(m * g, cross(L, Gamma))),
                            scaled(m * dot(Gamma, w_l), cross(w_l, Gamma)));
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_TRUE(equal(s.field.components[i], right[i]));
}

TEST_F(Formulation, ProjectionsOfM) {
  EXPECT_TRUE(equal(dot(M, Gamma), dot(times_inertia(Omega), Gamma)));
  EXPECT_TRUE(equal(dot(M, L), dot(times_inertia(Omega), L)));
}

TEST_F(Formulation, EnergyInBothForms) { // eqs. (integrals), (integralsM)
  const MFraction s1 = dot(Gamma, cross(Omega, L));
  const MFraction energy = Rational(1, 2) * dot(Omega, times_inertia(Omega)) +
                           Rational(1, 2) * (m * s1 * s1) + m * g * dot(Gamma, L);
  EXPECT_TRUE(equal(energy, *s.field.hamiltonian));
  EXPECT_TRUE(is_zero(lie_derivative(s.field, energy)));
}

TEST_F(Formulation, TheBracketIsPoisson) {
  EXPECT_FALSE(structure_failure(s.field, *s.field.poisson, relation_ideal(s.field)));
}

TEST_F(Formulation, Lemma1LowestOrderTermsAreTheHeavyTop) { // eqs. (H2), (H6), (heavytop)
  const LowestSystem low = lowest_system(s, 2);
  const Vector w = {M[0] / A, M[1] / B, M[2] / C};
  const MFraction s1 = dot(Gamma, cross(w, L));
  ASSERT_EQ(low.hamiltonian.size(), 2U);
  EXPECT_EQ(low.hamiltonian[0].degree, 2);
  EXPECT_TRUE(equal(low.hamiltonian[0].value, Rational(1, 2) * dot(M, w) + m * g * dot(Gamma, L)));
  EXPECT_EQ(low.hamiltonian[1].degree, 6);
  EXPECT_TRUE(equal(low.hamiltonian[1].value, Rational(-1, 2) * (m * s1 * s1)));
  EXPECT_EQ(low.structure, std::optional<long>(1)); // deg {F, G} = deg F + deg G - 1
  EXPECT_EQ(low.degree, 1);
  EXPECT_TRUE(low.is_hamiltonian);
  const Vector m_dot = minus(cross(M, w), scaled(m * g, cross(L, Gamma)));
  const Vector gamma_dot = cross(Gamma, w);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(equal(low.components[i], m_dot[i]));
    EXPECT_TRUE(equal(low.components[3 + i], gamma_dot[i]));
  }
}

TEST(Formulation2, GyrostatEquations) { // eq. (lag_with_gyro)
  const System s = sliding_top("gyrostat.toml");
  EXPECT_TRUE(check_euler_lagrange(s).proved);
}

} // namespace
} // namespace kov::lemmas
