// "Special symmetric case with d = 0": from the manifold M to r(z), for symbolic A and C.

#include "sliding_top.hpp"

namespace kov::lemmas {
namespace {

class Lemma3 : public testing::Test {
protected:
  MFraction f(const std::string& text) const { return formula(s, text); }
  MFraction at(const MFraction& g, const std::string& name, const std::string& value) const {
    return substitute(g, {{s.ring()->index(name), f(value)}});
  }
  System s = sliding_top("lemma3.toml");
  ManifoldReport m = stages(s);
};

TEST_F(Lemma3, RestrictedSystem) { // eq. (partsolgeqdeq0); the manifold has Gamma2^2 + Gamma3^2 = 1
  const auto on = [&](std::size_t j) { return m.manifold->restrict(s.field.components[j]); };
  EXPECT_TRUE(is_zero(on(0)));
  EXPECT_TRUE(equal(on(4), f("M1*Gamma3/A")));
  EXPECT_TRUE(equal(on(5), f("-M1*Gamma2/A")));
}

TEST_F(Lemma3, PatternOfTheVariationalEquations) { // eq. (varallvd00)
  const std::vector<std::string> pattern{"000000", "011000", "011000",
                                         "011000", "100001", "100010"};
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j)
      EXPECT_EQ(is_zero(m.variational.a[i][j]), pattern[i][j] == '0') << i << j;
}

TEST_F(Lemma3, ScalarEquation) { // eq. (rnve)
  const std::string common = "((A*(C+Gamma2^2)+C*Gamma3^2)*((A-C)*(A+Gamma3^2)-A*Gamma2^2))";
  EXPECT_EQ(scalar(m).unknown, "M2");
  EXPECT_TRUE(
      equal_on_curve(m, scalar(m).a1, f("2*A*Gamma2*Gamma3*M1*(A+Gamma2^2+Gamma3^2)/" + common)));
  EXPECT_TRUE(equal_on_curve(m, scalar(m).a0,
                             f("M1^2/(A^2*" + common +
                               ")*(A^2*Gamma2^4 + A*Gamma2^2*(Gamma3^2*(3*A-2*C)+A*(C-A))"
                               " + C*Gamma3^2*(A-C)*(A+Gamma3^2))")));
}

TEST_F(Lemma3, ChangeOfVariable) { // eq. (trantryg)
  EXPECT_TRUE(equal(*equation(m).z_dot_squared, f("-4*mu^2*(z-1)*z/A^2")));
  EXPECT_TRUE(equal(*equation(m).z_ddot, f("2*mu^2*(1-2*z)/A^2")));
}

TEST_F(Lemma3, RationalCoefficients) { // p and q; the print has c for C in q
  EXPECT_TRUE(equal(*equation(m).p, f("1/(2*z) + 1/(2*(z-1)) + (A-C)/(z*(A-C)-A*(C+1))"
                                      " + (C-2*A)/(z*(2*A-C)+A*(A-C-1))")));
  EXPECT_TRUE(equal(*equation(m).q, f("-1/(4*(C+1)*z) - 1/(4*(A+1)*(z-1))"
                                      " + (A-2*C-2)*(A-C)^2/(4*A*(A+1)*(C+1)*(z*(A-C)-A*(C+1)))"
                                      " + (2*A-C)^2/(2*A*(A+1)*(z*(2*A-C)+A*(A-C-1)))")));
}

TEST_F(Lemma3, NormalForm) { // eq. (rrdgeq0); the print has 2c^2(C+1) for 2C^2(C+1)
  EXPECT_TRUE(equal(
      equation(m).r,
      f("-3/(16*z^2) - 3/(16*(z-1)^2) - 1/(4*(z-A*(C+1)/(A-C))^2) + 3/(4*(z-A*(C-A+1)/(2*A-C))^2)"
        " - (2*A^2+(A+3)*C^2-(A+3)*A*C)/(8*(A+1)*C*(A-C)*(z-1))"
        " + (-A*(C+1)+C^2-3)/(8*(C+1)*(A-C-1)*z)"
        " - (A-C)^2*(A^2*(C+1)-A*C*(2*C+1)+2*C^2*(C+1))/(4*A^2*(A+1)*C*(C+1)*(A*(1+C)+(C-A)*z))"
        " + (C-2*A)^2*(2*A^3-4*A^2*C+A*C*(4*C+1)-2*C^2*(C+1))"
        "/(4*A^2*(A+1)*(A-C-1)*(A-C)*(A*(A-C-1)+(2*A-C)*z))")));
}

TEST_F(Lemma3, PolesAndInfinity) {
  const auto leading = [&](const std::string& pole) { // lim (z - pole)^2 r
    const MFraction g = equation(m).r * pow(f("z") - f(pole), 2);
    return at(g, "z", pole);
  };
  EXPECT_TRUE(equal(leading("0"), f("-3/16")));
  EXPECT_TRUE(equal(leading("1"), f("-3/16")));
  EXPECT_TRUE(equal(leading("A*(C+1)/(A-C)"), f("-1/4")));
  EXPECT_TRUE(equal(leading("A*(C-A+1)/(2*A-C)"), f("3/4")));
  // order 3 at infinity: z^3 r tends to -A (2A-C)/(4 (A-C))
  const MFraction tail = substitute(equation(m).r * f("z^3"), {{s.z, f("1/z")}});
  EXPECT_TRUE(equal(at(tail, "z", "0"), f("-A*(2*A-C)/(4*(A-C))")));
}

TEST_F(Lemma3, WhereSingularitiesMerge) {
  const auto difference = [&](const std::string& text) { return f(text); };
  EXPECT_TRUE(
      equal(difference("A*(C+1)/(A-C) - A*(C-A+1)/(2*A-C)"), f("A^2*(A+1)/((A-C)*(2*A-C))")));
  EXPECT_TRUE(equal(difference("1 - A*(C+1)/(A-C)"), f("-C*(A+1)/(A-C)")));
  EXPECT_TRUE(equal(difference("1 - A*(C-A+1)/(2*A-C)"), f("(A+1)*(A-C)/(2*A-C)")));
}

// omega = sum e_i/(z - z_i) for the two families of degree 0: omega' + omega^2 - r is not 0.
TEST_F(Lemma3, ConditionsOfDegreeZero) {
  const auto defect = [&](const std::string& e1, const std::string& e2) {
    const MFraction omega = f(e1 + "/z + " + e2 +
                              "/(z-1) + (1/2)/(z-A*(C+1)/(A-C))"
                              " - (1/2)/(z-A*(C-A+1)/(2*A-C))");
    return derivative(omega, s.z) + omega * omega - equation(m).r;
  };
  const MFraction four = f("4*z*(z-1)*(z*(A-C)-A*(C+1))*(z*(2*A-C)-A*(C-A+1))");
  EXPECT_TRUE(equal(defect("(3/4)", "(1/4)") * four, f("A*((2*A-C)^2*z - A*(A*C+4*A-C^2-3*C))")));
  EXPECT_TRUE(equal(defect("(1/4)", "(3/4)") * four, f("A*((2*A-C)^2*z - A*(C+2)*(A-C-1))")));
}

TEST_F(Lemma3, SpecialBodies) { // C = 2A and C = A - 1
  EXPECT_TRUE(equal(at(equation(m).r, "C", "2*A"),
                    f("-3/(16*z^2) - 3/(16*(z-1)^2) - 1/(4*(2*A+z+1)^2) + (3-2*A)/(16*A*z+8*z)"
                      " + (A+4)/(8*(A+1)*(z-1)) - (10*A+7)/(8*(A+1)*(2*A+1)*(2*A+z+1))")));
  EXPECT_TRUE(equal(at(equation(m).r, "C", "A-1"),
                    f("5/(16*z^2) - 3/(16*(z-1)^2) - 1/(4*(A^2-z)^2) + ((A-2)*A+2)/(8*A^2*z)"
                      " - ((A-2)*A+3)/(8*(A^2-1)*(z-1)) + (A^2-A+1)/(4*(A-1)*A^2*(A+1)*(z-A^2))")));
}

TEST_F(Lemma3,
       TheSpecialBodiesFromTheirOwnFiles) { // specialising before and after gives the same r
  for (const auto& [c, value] : {std::pair("2*A", "2*A"), std::pair("A - 1", "A-1")}) {
    const System special = sliding_top("lemma3.toml", {{"C", c}});
    const ManifoldReport stages_there = stages(special);
    EXPECT_TRUE(equal(transfer(equation(stages_there).r, s.ring()), at(equation(m).r, "C", value)));
  }
}

} // namespace
} // namespace kov::lemmas
