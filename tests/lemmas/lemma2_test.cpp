// "Case g = 0", d != 0: from the manifold N to r(z), for symbolic a, b, c, d, h.

#include "exact/finite_algebra.hpp"
#include "sliding_top.hpp"

namespace kov::lemmas {
namespace {

class Lemma2 : public testing::Test {
protected:
  MFraction f(const std::string& text) const { return formula(s, text); }
  System s = sliding_top("lemma2.toml");
  ManifoldReport m = stages(s);
};

TEST_F(Lemma2, RestrictedSystem) { // eqs. (repgeq0), (partgeq0)
  const auto on = [&](std::size_t j) { return m.manifold->restrict(s.field.components[j]); };
  EXPECT_TRUE(equal(on(1), f("M2^2*Gamma1*Gamma3/(b + Gamma3^2)^2")));
  EXPECT_TRUE(equal(on(3), f("-M2*Gamma3/(b + Gamma3^2)")));
  EXPECT_TRUE(equal(on(5), f("M2*Gamma1/(b + Gamma3^2)")));
  EXPECT_TRUE(equal(m.manifold->restrict(*s.field.hamiltonian), f("M2^2/(2*(b + Gamma3^2))")));
}

TEST_F(Lemma2, NormalSystem) { // eq. (norvariat), with the two missing parentheses
  const std::vector<std::vector<std::string>> expected{
      {"-2*b*d*M2/((a*c-4*d^2)*(b+Gamma3^2))", "(a*(b-c)+4*d^2)*M2/((a*c-4*d^2)*(b+Gamma3^2))",
       "(a*(b-c)+4*d^2)*M2^2*Gamma3/((a*c-4*d^2)*(b+Gamma3^2)^2)"},
      {"M2*(a*c-2*d*(2*d+Gamma1*Gamma3)-c*(b+Gamma3^2))/((a*c-4*d^2)*(b+Gamma3^2))",
       "M2*(a*Gamma1*Gamma3+2*d*(b+Gamma3^2))/((a*c-4*d^2)*(b+Gamma3^2))",
       "M2^2*Gamma3*(a*Gamma1*Gamma3+2*d*(b+Gamma3^2))/((a*c-4*d^2)*(b+Gamma3^2)^2)"},
      {"(2*d*Gamma1+c*Gamma3)/(a*c-4*d^2)", "-(a*Gamma1+2*d*Gamma3)/(a*c-4*d^2)",
       "-M2*Gamma3*(a*Gamma1+2*d*Gamma3)/((a*c-4*d^2)*(b+Gamma3^2))"}};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      EXPECT_TRUE(equal_on_curve(m, m.normal.system.a[i][j], f(expected[i][j]))) << i << j;
}

TEST_F(Lemma2, ScalarEquation) { // eq. (rnvegeq0)
  EXPECT_EQ(scalar(m).unknown, "M1");
  EXPECT_TRUE(equal_on_curve(m, scalar(m).a1, f("2*M2*Gamma1*Gamma3/(b+Gamma3^2)^2")));
  EXPECT_TRUE(equal_on_curve(m, scalar(m).a0,
                             f("M2^2/((a*c-4*d^2)*(b+Gamma3^2)^3)*(Gamma1^2*(a*(b-c)+4*d^2)"
                               " - (b+Gamma3^2)*((a-b)*(b-c)+4*d^2) + 2*b*Gamma1*Gamma3*d)")));
}

TEST_F(Lemma2, ChangeOfVariable) {
  EXPECT_TRUE(equal(*equation(m).z_dot_squared, f("h*(z^2+1)^4/(2*(b*(z^2+1)^2+4*z^2))")));
  EXPECT_TRUE(
      equal(*equation(m).z_ddot, f("h*z*(z^2+1)^3*(b*(z^2+1)^2+6*z^2-2)/(b*(z^2+1)^2+4*z^2)^2")));
}

TEST_F(Lemma2, RationalCoefficients) { // eq. (ppqqgeq0)
  EXPECT_TRUE(equal(*equation(m).p, f("2*z*(b*z^2+b+2)/(b*(z^2+1)^2+4*z^2)")));
  EXPECT_TRUE(
      equal(*equation(m).q,
            f("-4/(a*c-4*d^2)*(((2*a-b)*(b-c)+2*b*d*z+8*d^2)/(z^2+1)^2 + b*d*z/(z^2+1)"
              " - (a*(b+1)*(b-c) + d*(4*(b+1)*d + b*z*(b*(z^2+3)+4)))/(b*(z^2+1)^2+4*z^2))")));
}

const char* const r_text =
    "4*((2*a-b)*(b-c)+2*b*d*z+8*d^2)/((a*c-4*d^2)*(z^2+1)^2) + 4*b*d*z/((a*c-4*d^2)*(z^2+1))"
    " - 12*(b+1)*z^2/(b*(z^2+1)^2+4*z^2)^2"
    " + (a*(5*b+6)*c - 4*a*b*(b+1) - 4*d*((5*b+6)*d + b*z*(b*(z^2+3)+4)))"
    "/((b*(z^2+1)^2+4*z^2)*(a*c-4*d^2))";

TEST_F(Lemma2, NormalForm) { // the r of Lemma 2 in [PrzybylskaMaciejewski2024]
  EXPECT_TRUE(equal(equation(m).r, f(r_text)));
  EXPECT_EQ(equation(m).singular_places, 6);
}

TEST_F(Lemma2, LeadingCoefficientsAtThePoles) { // alpha_i and U
  // alpha = lim (z - z0)^2 r; over z^2 + 1 = 0 that is r (z^2+1)^2/(2 z)^2 there
  const FiniteAlgebra circle(Ideal(s.ring(), {s.z}, {f("z^2+1").num()}));
  const auto near = circle.evaluate(equation(m).r * f("(z^2+1)^2/(4*z^2)"));
  ASSERT_TRUE(near);
  EXPECT_TRUE(equal(circle.lift(*near), f("2 + b*(b-2*a-c)/(a*c-4*d^2) - 2*b*d*z/(a*c-4*d^2)")));
  // the product of the two alphas, cleared: 4 (bd)^2 + (2(ac-4d^2) + b(b-2a-c))^2 = U
  EXPECT_TRUE(equal(f("4*b^2*d^2 + (2*(a*c-4*d^2) + b*(b-2*a-c))^2"),
                    f("(b-2*a)^2*(b-c)^2 + 4*(8*a*(b-c)+b*(4*c-3*b))*d^2 + 64*d^4")));
  const MPoly quartic = f("b*(z^2+1)^2+4*z^2").num();
  const FiniteAlgebra four(Ideal(s.ring(), {s.z}, {quartic}));
  const MFraction slope(derivative(quartic, s.z));
  const auto alpha = four.evaluate(equation(m).r * pow(MFraction(quartic) / slope, 2));
  ASSERT_TRUE(alpha);
  EXPECT_TRUE(equal(four.lift(*alpha), f("-3/16")));
}

TEST_F(Lemma2, OrderAtInfinity) { // V
  // z^4 r at infinity is V/(b (ac - 4 d^2))
  const MFraction u = MFraction(s.ring(), Rational(1)) / f("z");
  const MFraction tail = substitute(equation(m).r * f("z^4"), {{s.z, u}});
  EXPECT_TRUE(equal(substitute(tail, {{s.z, MFraction(s.ring())}}) * f("b*(a*c-4*d^2)"),
                    f("4*a*b*(b-1) - 3*a*(b-2)*c + 4*b^2*(c-b) + 12*(b-2)*d^2")));
}

TEST_F(Lemma2, DiscriminantOfU) { // u as a polynomial in y = c/a, with x = b/a and z = d/a
  const MPoly u = f("(b-2)^2*c^2 - 2*(b-2)*((b-2)*b - 8*d^2)*c + (b-2)^2*b^2 + 4*(8-3*b)*b*d^2"
                    " + 64*d^4")
                      .num();
  EXPECT_TRUE(equal(MFraction(discriminant(u, s.ring()->index("c"))), f("-16*(b-2)^2*b^2*d^2")));
}

TEST_F(Lemma2, PrincipalAxes) {
  // a = A l1^2 + C l3^2, b = A, c = C l1^2 + A l3^2, 2d = (C-A) l1 l3 with l1^2 + l3^2 = 1; the
  // letters M1, M3, b, h of the file stand for l1, l3, A, C here
  Substitution axes{{s.ring()->index("a"), f("b*M1^2 + h*M3^2")},
                    {s.ring()->index("c"), f("h*M1^2 + b*M3^2")},
                    {s.ring()->index("d"), f("(h-b)*M1*M3/2")}};
  const Ideal unit(s.ring(), {s.ring()->index("M1"), s.ring()->index("M3")},
                   {f("M1^2+M3^2-1").num()});
  EXPECT_TRUE(unit.contains(substitute(f("(a-b)*(b-c)+4*d^2"), axes).num()));
  EXPECT_TRUE(unit.contains(substitute(f("a*c-4*d^2-b*h"), axes).num()));
}

} // namespace
} // namespace kov::lemmas
