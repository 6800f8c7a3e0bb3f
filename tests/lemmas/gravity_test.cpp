// "Case g != 0": from the manifold N to Lame's equation, for symbolic A, C, h.

#include "sliding_top.hpp"

#include "exact/finite_algebra.hpp"
#include "integrability/levels.hpp"

namespace kov::lemmas {
namespace {

class Gravity : public testing::Test {
protected:
  MFraction f(const std::string& text) const { return formula(s, text); }
  System s = sliding_top("gravity.toml");
  ManifoldReport m = stages(s);
};

TEST_F(Gravity, RestrictedSystem) { // eq. (rep)
  const auto on = [&](std::size_t j) { return m.manifold->restrict(s.field.components[j]); };
  EXPECT_TRUE(equal(on(1), f("Gamma3 + M2^2*Gamma1*Gamma3/(A + Gamma3^2)^2")));
  EXPECT_TRUE(equal(on(3), f("-M2*Gamma3/(A + Gamma3^2)")));
  EXPECT_TRUE(equal(on(5), f("M2*Gamma1/(A + Gamma3^2)")));
  for (const std::size_t j : {0U, 2U, 4U})
    EXPECT_TRUE(is_zero(on(j)));
}

TEST_F(Gravity, EnergyOnTheManifold) { // eq. (part); the print has b for A
  EXPECT_TRUE(
      equal(m.manifold->restrict(*s.field.hamiltonian), f("M2^2/(2*(A + Gamma3^2)) + Gamma1")));
}

TEST_F(Gravity, PatternOfTheVariationalEquations) { // eq. (varallv)
  const std::vector<std::string> pattern{"001010", "010101", "101010",
                                         "010001", "101010", "010101"};
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j)
      if (pattern[i][j] == '0') {
        EXPECT_TRUE(is_zero(m.variational.a[i][j])) << i << j;
      }
}

TEST_F(Gravity, NormalSystem) { // eq. (normal_sys)
  ASSERT_EQ(m.normal.system.names, (std::vector<std::string>{"M1", "M3", "Gamma2"}));
  const std::vector<std::vector<std::string>> expected{
      {"0", "(A-C)*M2/(C*(A+Gamma3^2))", "(A-C)*Gamma3*M2^2/(C*(A+Gamma3^2)^2)"},
      {"-M2*Gamma3^2/(A*(A+Gamma3^2))", "Gamma1*Gamma3*M2/(C*(A+Gamma3^2))",
       "Gamma1*Gamma3^2*M2^2/(C*(A+Gamma3^2)^2) - 1"},
      {"Gamma3/A", "-Gamma1/C", "-Gamma1*Gamma3*M2/(C*(A+Gamma3^2))"}};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      EXPECT_TRUE(equal(m.normal.system.a[i][j], f(expected[i][j]))) << i << j;
}

TEST_F(Gravity, LinearIntegral) { // f_2
  ASSERT_EQ(m.normal.integrals.size(), 1U);
  EXPECT_TRUE(equal(m.normal.integrals[0].coefficients[0], f("Gamma1")));
  EXPECT_TRUE(equal(m.normal.integrals[0].coefficients[1], f("Gamma3")));
  EXPECT_TRUE(equal(m.normal.integrals[0].coefficients[2], f("M2")));
  ASSERT_EQ(m.reduced.eliminations.size(), 1U);
  EXPECT_EQ(m.reduced.eliminations[0].unknown, "Gamma2");
}

TEST_F(Gravity, ScalarEquation) { // eq. (rnvegneq0)
  EXPECT_EQ(scalar(m).unknown, "M1");
  EXPECT_TRUE(
      equal_on_curve(m, scalar(m).a1, f("-2*Gamma3/M2 + 2*M2*Gamma1*Gamma3/(A+Gamma3^2)^2")));
  EXPECT_TRUE(equal_on_curve(m, scalar(m).a0,
                             f("-Gamma1*(A-C)*((A+Gamma3^2)^2 - Gamma1*M2^2)/(C*(A+Gamma3^2)^3)")));
}

TEST_F(Gravity, ChangeOfVariable) { // eq. (tran)
  const auto made = FunctionField::make(s.field, *m.manifold, s.z, f("Gamma3/(1+Gamma1)"), {});
  const auto& field = std::get<FunctionField>(made);
  EXPECT_TRUE(equal(*field.in_z(*field.evaluate(f("Gamma1"))), f("(1-z^2)/(1+z^2)")));
  EXPECT_TRUE(equal(*field.in_z(*field.evaluate(f("Gamma3"))), f("2*z/(1+z^2)")));
  // M2 = 2 z' (A + 4 z^2 + 2 A z^2 + A z^4)/(1+z^2)^3
  const auto factor = *field.evaluate(f("2*(A + 4*z^2 + 2*A*z^2 + A*z^4)/(1+z^2)^3"));
  EXPECT_TRUE(field.algebra().multiply(factor, field.z_dot()) == *field.evaluate(f("M2")));
  EXPECT_TRUE(
      equal(*equation(m).z_dot_squared, f("(z^2+1)^3*((h+1)*z^2+h-1)/(2*(A*(z^2+1)^2+4*z^2))")));
  EXPECT_TRUE(equal(*equation(m).z_ddot,
                    f("z*(z^2+1)^2/(A*(z^2+1)^2+4*z^2)^2*(h*(z^2+1)*(A*(z^2+1)^2+6*z^2-2)"
                      " + A*(z^3+z)^2 + 6*z^4 - 4*z^2 + 2)")));
}

TEST_F(Gravity, RationalCoefficients) { // eq. (ppqqdgneq0)
  EXPECT_TRUE(
      equal(*equation(m).p,
            f("z*(2*(A*z^2+A+2)/(A*(z^2+1)^2+4*z^2) + 1/(z^2+1) - (h+1)/((h+1)*z^2+h-1))")));
  EXPECT_TRUE(equal(*equation(m).q, f("(A-C)/C*(-2/(z^2+1)^2 + h/(z^2+1) - h*(h+1)/(h*z^2+h+z^2-1)"
                                      " + 4*(A+1)/(A*(z^2+1)^2+4*z^2))")));
}

TEST_F(Gravity, TheSpecialEnergyIsFound) {
  const auto locus = merging_locus(equation(m).r, s.z, s.ring()->index("h"));
  const MPoly special = f("1 + A - h^2").num();
  EXPECT_TRUE(std::any_of(locus.begin(), locus.end(),
                          [&](const MPoly& e) { return e == special || e == -special; }));
}

class SpecialEnergy : public Gravity {
protected:
  Substitution special{{s.ring()->index("A"), f("h^2 - 1")}};
  MFraction p = substitute(*equation(m).p, special);
  MFraction q = substitute(*equation(m).q, special);
};

TEST_F(SpecialEnergy, Coefficients) { // eq. (pqspec)
  EXPECT_TRUE(equal(p, f("2*z*((h-1)*z^2+h)/(h*(z^2+1)^2-z^4+1)")));
  EXPECT_TRUE(equal(q, f("-2*(z^2-1)*(C-h^2+1)/(C*(z^2+1)^2*((h-1)*z^2+h+1))")));
}

TEST_F(SpecialEnergy,
       ReachedFromTheFile) { // the same equation, with h^2 = 3 put in at the beginning
  CheckOptions options;
  options.stop_at_r = true;
  const ManifoldReport report = test::checked(
      study::FileStudy(sliding_top("gravity.toml", {{"A", "2"}, {"C", "1"}})), options);
  bool seen = false;
  for (const auto& e : report.blocks.at(0).energies) {
    if (sentence(e.at) != "h^2 - 3 = 0") continue;
    seen = true;
    const MFraction p1 = substitute(p, {{s.ring()->index("C"), f("1")}});
    const MFraction r = Rational(1, 4) * (p1 * p1) + Rational(1, 2) * derivative(p1, s.z) -
                        substitute(q, {{s.ring()->index("C"), f("1")}});
    const AlgebraicConstant h{s.ring()->index("h"), e.r->field()};
    EXPECT_EQ(*e.r, to_rational_function(r, s.z, h));
  }
  EXPECT_TRUE(seen);
}

TEST_F(SpecialEnergy, BecomesLame) { // eq. (lamiak)
  // y = 1/(z^2+1) + (h-3)/6 and m'' + p m' + q m = 0 in z, so that in y
  // m_yy + (p y' + y'')/y'^2 m_y + q/y'^2 m = 0
  const MFraction y = f("1/(z^2+1) + (h-3)/6");
  const MFraction y1 = derivative(y, s.z);
  const MFraction y2 = derivative(y1, s.z);
  const auto lame = [&](const std::string& text) { // a function of y, written with z for y
    return substitute(f(text), {{s.z, y}});
  };
  const std::string fy = "(4*z^3 - (h^2/3+1)*z + h*(h^2-9)/27)"; // g3 = -h(h^2-9)/27
  EXPECT_TRUE(equal((p * y1 + y2) / (y1 * y1), lame("(12*z^2 - (h^2/3+1))/(2*" + fy + ")")));
  const std::string alpha = "2*(C-h^2+1)/C";
  const std::string beta = "(-h*(C-h^2+1)/(3*C))";
  EXPECT_TRUE(equal(q / (y1 * y1), lame("-(" + alpha + "*z + " + beta + ")/" + fy)));
  EXPECT_TRUE(equal(substitute(f("2 - 2*A/C"), special), f(alpha)));
  EXPECT_TRUE(equal(substitute(f("h*(A-C)/(3*C)"), special), f(beta)));
  EXPECT_TRUE(equal(f("27*(h*(h^2-9)/27)^2 - (h^2/3+1)^3"), f("-(h^2-1)^2")));
}

TEST_F(SpecialEnergy, DegreesOfLame) { // eq. (lamiasten): (2n+1)^2 = 1 + 4 alpha
  const MFraction square = substitute(f("1 + 4*(2 - 2*A/C)"), {{s.ring()->index("A"), f("2*C")}});
  EXPECT_TRUE(equal(square, f("-7"))); // Kovalevskaya
  EXPECT_TRUE(equal(substitute(f("9 - 8*A/C"), {{s.ring()->index("A"), f("4*C")}}), f("-23")));
}

} // namespace
} // namespace kov::lemmas
