// First logarithms that are known, and integrable families in which none may appear.

#include "jets/obstruction.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace kov::jets {
namespace {

struct Example {
  std::string potential;
  std::string parameters = {}; ///< "'A', 'B'"
  std::string constant = {};   ///< "a^2 = -49"
  std::string manifold = "'q1 = 0', 'p1 = 0'";
  std::string level = {};
};

System system_of(const Example& x) {
  const std::string constants =
      x.constant.empty() ? ""
                         : "constants = ['" + x.constant.substr(0, x.constant.find('^')) +
                               "'], relations = ['" + x.constant + "'], ";
  const std::string levels = x.level.empty() ? "" : ", level = ['" + x.level + "']";
  return read_system(parse_document(
      "system = {kind = 'hamiltonian', coordinates = ['q1', 'q2'], momenta = ['p1', 'p2'], " +
          constants + "parameters = [" + x.parameters + "], hamiltonian = '(p1^2 + p2^2)/2 + " +
          x.potential + "'}\nmanifold = [{name = 'N', equations = [" + x.manifold + "]" + levels +
          "}]",
      "test.toml"));
}

HigherOrders look(const Example& x, int order) {
  const System s = system_of(x);
  HigherOptions options;
  options.order = order;
  return higher_orders(s, s.manifolds.front(), options);
}

/// R up to a constant factor, as text; "none", or why it is open.
std::string residue(const HigherOrders& found) {
  if (!found.obstruction) return found.open.empty() ? "none" : "open: " + found.open;
  const Logarithm& log = found.obstruction->logarithm;
  const auto factors = factor(log.form.num()).second;
  std::string text = "VE_" + std::to_string(log.order);
  for (const MFactor& f : factors)
    text +=
        " (" + to_string(f.base) + ")" + (f.exponent > 1 ? "^" + std::to_string(f.exponent) : "");
  return text;
}

const std::string hh = "(A*q1^2 + B*q2^2)/2 + q1^2*q2 + ";
const std::string quartic = "(A*q1^2 + B*q2^2)/2 + q2^4/2 + ";

struct Known {
  Example system;
  int order;
  std::string found;
};

class FirstLogarithm : public testing::TestWithParam<Known> {};

TEST_P(FirstLogarithm, IsAsComputedByOtherCode) {
  EXPECT_EQ(residue(look(GetParam().system, GetParam().order)), GetParam().found);
}

INSTANTIATE_TEST_SUITE_P(
    HenonHeiles, FirstLogarithm,
    testing::Values(Known{{hh + "2/3*q2^3", "'A', 'B'"}, 3, "VE_3 (c2) (c1)^3"},
                    Known{{hh + "1/3*q2^3", "'A', 'B'"}, 3, "VE_3 (c2) (A - B) (c1)^3"},
                    Known{{hh + "b/3*q2^3", "'A', 'B', 'b'"},
                          3,
                          "open: the exponents at infinity depend on the parameters"},
                    Known{{"(q1^2 + q2^2)/2 + q1^2*q2 + 1/5*q2^3"}, 3, "VE_3 (c2) (c1)^3"},
                    Known{{"(q1^2 + q2^2)/2 + q1^2*q2 + 16/3*q2^3"},
                          3,
                          "open: the first variational equation has a logarithm at infinity"}));

INSTANTIATE_TEST_SUITE_P(
    Homogeneous, FirstLogarithm,
    testing::Values(
        Known{{"q2^3/3 + q1^2*q2/2 + a*q1^3", "'a'"}, 3, "VE_2 (c2) (a) (c1)^2"},
        Known{{"q2^3/3 + q1^2*q2/2"}, 3, "VE_3 (c2) (c1)^3"},
        Known{{"q2^3/3 + 5/2*q1^2*q2"}, 3, "VE_3 (c2) (E) (c1)^3"},
        Known{{"q2^4/2 + q1^2*q2^2 + 2/3*al*q1^3*q2 + be/2*q1^4", "'al', 'be'"},
              3,
              "VE_2 (c2) (al) (c1)^2"},
        Known{{"q2^4/2 + q1^2*q2^2 + be/2*q1^4", "'be'"}, 3, "VE_3 (c2) (be - 1) (c1)^3"},
        Known{{"q2^4/2 + 36*q1^2*q2^2 + a*q1^3*q2 + q1^4", "'a'"}, 2, "VE_2 (a) (c1)^3 (E)^6"},
        // lambda = 3/8: a finite normal group; the same potential at its point of lambda = 136
        Known{{"(1088*q2^4 + 816*q1^2*q2^2 + 3*q1^4)/2"},
              5,
              "open: VE_5 has a logarithm at infinity, R = 8645*c1^6/591872, which commutes with a "
              "quadratic form: nothing follows"},
        Known{{"q2^4/2 + 136*q1^2*q2^2 + 544*q1^4"}, 5, "VE_5 (c2) (c1)^5 (E)^15"}));

INSTANTIATE_TEST_SUITE_P(
    RamifiedPlaces, FirstLogarithm,
    testing::Values(Known{{"q2^5/5 + q1^2*q2^3/2 + q1^4*q2/3"}, 3, "VE_3 (c2) (c1)^3"},
                    Known{{"q2^5/5 + q1^2*q2^3/2 + q1^3*q2^2/5"}, 2, "VE_2 (c2) (c1)^2"},
                    Known{{"q2^6/6 + q1^2*q2^4/2 + q1^3*q2^3/5 + q1^4/7"}, 2, "VE_2 (c2) (c1)^2"},
                    Known{{"q2^6/6 + 5/2*q1^2*q2^4 + q1^4*q2^2/7"}, 3, "VE_3 (E)^2 (c1)^4"},
                    Known{{"q2^4/2 + q2^3/3 + 3*q1^2*q2^2 + q1^2*q2 + q1^4/5 + q1^3/7"},
                          2,
                          "VE_2 (c1 - 1944*c2) (c1)^2"}));

// lambda = Lambda + 1 = m(m + 1)/2; integrable for m = 2
const auto isotropic = [](const std::string& lambda) {
  return Example{"(q2 - j*q1)^2*((q2 + j*q1)^2/4 + " + lambda + "*q1^2/2)", "", "j^2 = -1"};
};
INSTANTIATE_TEST_SUITE_P(IsotropicFamily, FirstLogarithm,
                         testing::Values(Known{isotropic("-1"), 2, "VE_2 (j) (c1)^3"},
                                         Known{isotropic("2"), 5, "none"},
                                         Known{isotropic("5"), 3, "VE_3 (c2) (E) (c1)^3"},
                                         Known{isotropic("9"), 2, "VE_2 (j) (c1)^3 (E)^3"},
                                         Known{isotropic("14"), 2, "VE_2 (c2) (E) (j) (c1)^2"}));

INSTANTIATE_TEST_SUITE_P(
    Quartic, FirstLogarithm,
    testing::Values(Known{{quartic + "3*q1^2*q2^2 + c*q1^4/2", "'A', 'B', 'c'"},
                          3,
                          "VE_3 (c2) (3*A*c - 17*A - 6*B*c + 20*B) (c1)^3"},
                    Known{{quartic + "6*q1^2*q2^2 + 8*q1^4", "'A', 'B'"},
                          3,
                          "VE_3 (c2) (A - 4*B) (A + 11*B) (c1)^3"},
                    Known{{"(-11*B*q1^2 + B*q2^2)/2 + q2^4/2 + 6*q1^2*q2^2 + 8*q1^4", "'B'"},
                          5,
                          "VE_5 (c2) (2556*B^2 - 941*E) (B)^2 (c1)^5"},
                    Known{{quartic + "6*q1^2*q2^2 + 4*q1^4", "'A', 'B'"},
                          3,
                          "VE_3 (c2) (251*A^2 - 1183*A*B - 184*B^2 - 5400*E) (c1)^3"}));

// ---- no false alarm

class Integrable : public testing::TestWithParam<Example> {};

TEST_P(Integrable, HasNoLogarithmUpToOrderSix) { EXPECT_EQ(residue(look(GetParam(), 6)), "none"); }

INSTANTIATE_TEST_SUITE_P(
    Known, Integrable,
    testing::Values(Example{hh + "6/3*q2^3", "'A', 'B'"},
                    Example{"A*(q1^2 + q2^2)/2 + q1^2*q2 + q2^3/3", "'A'"},
                    Example{"A*(q1^2 + 16*q2^2)/2 + q1^2*q2 + 16/3*q2^3", "'A'"},
                    Example{quartic + "q1^2*q2^2 + q1^4/2", "'A', 'B'"},
                    Example{"A*(q1^2 + q2^2)/2 + q2^4/2 + 3*q1^2*q2^2 + q1^4/2", "'A'"},
                    Example{"B*(4*q1^2 + q2^2)/2 + q2^4/2 + 6*q1^2*q2^2 + 8*q1^4", "'B'"},
                    Example{"B*(q1^2 + 4*q2^2)/2 + 16*q2^4 + 12*q1^2*q2^2 + q1^4", "'B'"},
                    Example{"q2^3/3 + a*q1^3 + b*q1^4", "'a', 'b'"},
                    Example{"8*q2^4 + 6*q1^2*q2^2 + q1^4"}, Example{"q2^4 + 6*q1^2*q2^2 + 8*q1^4"},
                    Example{"q2^3/3 + 5/2*q1^2*q2 + a/3*q1^3", "", "a^2 = -49"},
                    Example{"q2^3/3 + 15/2*q1^2*q2 + a/3*q1^3", "", "a^2 = -2023/2"},
                    Example{"q2^3/3 + 15/2*q1^2*q2 + a/3*q1^3", "", "a^2 = -2187/4"},
                    Example{"q2^3/3 + 10/6*q1^2*q2 + a/3*q1^3", "", "a^2 = -484/27"}));

std::string sum(const std::vector<std::string>& terms) {
  std::string text;
  for (std::size_t n = 0; n < terms.size(); ++n)
    text += (n == 0 ? "f" : " + f") + std::to_string(n) + "*(" + terms[n] + ")";
  return text;
}

// Separable in the axes (a, b), (b, -a), along a line that is none of them.
Example rotated(int a, int b, int degree) {
  std::vector<std::string> terms;
  for (int n = 2; n <= degree; ++n) {
    const std::string e = std::to_string(n);
    const std::string u = std::to_string(a) + "*q1 + " + std::to_string(b) + "*q2";
    const std::string w = std::to_string(b) + "*q1 - " + std::to_string(a) + "*q2";
    terms.push_back("(" + u + ")^" + e + (n % 2 == 0 ? " + " : " - ") + "(" + std::to_string(b) +
                    "/" + std::to_string(a) + ")^" + std::to_string(n - 2) + "*(" + w + ")^" + e);
  }
  return {sum(terms), ""};
}

// V_n of the parabolic coordinates: V_(n+1) = 2 q2 V_n + q1^2 V_(n-1).
Example parabolic(int degree) {
  std::vector<std::string> v{"1", "2*q2"};
  for (int n = 1; n < degree; ++n)
    v.push_back("2*q2*(" + v[static_cast<std::size_t>(n)] + ") + q1^2*(" +
                v[static_cast<std::size_t>(n - 1)] + ")");
  return {sum({v.begin() + 1, v.end()}), ""};
}

std::string with_parameters(int count) {
  std::string names;
  for (int n = 0; n < count; ++n)
    names += (n == 0 ? "'f" : ", 'f") + std::to_string(n) + "'";
  return names;
}

void expect_none(Example x, int parameters, int order) {
  x.parameters = with_parameters(parameters);
  EXPECT_EQ(residue(look(x, order)), "none") << x.potential;
}

TEST(IntegrableFamilies, SeparableInRotatedAxes) {
  expect_none(rotated(1, 1, 3), 2, 5);
  expect_none(rotated(1, 2, 4), 3, 4);
  expect_none(rotated(3, 4, 5), 4, 3);
  expect_none(rotated(2, 1, 6), 5, 3);
}
TEST(IntegrableFamilies, Central) {
  expect_none({sum({"q1^2 + q2^2", "(q1^2 + q2^2)^2"})}, 2, 5);
  expect_none({sum({"q1^2 + q2^2", "(q1^2 + q2^2)^2", "(q1^2 + q2^2)^3"})}, 3, 5);
}
TEST(IntegrableFamilies, SeparableInParabolicCoordinates) {
  expect_none(parabolic(3), 3, 5);
  expect_none(parabolic(4), 4, 4);
  expect_none(parabolic(5), 5, 3);
}
TEST(IntegrableFamilies, SeparableInEllipticCoordinates) {
  const std::string r = "(q1^2 + q2^2)", s = "(f3*q1^2 + f4*q2^2)";
  expect_none({sum({r, s + " + " + r + "^2",
                    "f3^2*q1^2 + f4^2*q2^2 + 2*" + r + "*" + s + " + " + r + "^3"})},
              5, 4);
}

// ---- hypotheses

TEST(HigherOrders, NothingIsSaidOfTheTrivialGroupOrOfCommutingLogarithms) {
  // n = 4: at A = B = 0 the normal group is finite, and so for no parameters by the highest terms
  const Example both_equilibria_at_0{"A*q1^2/2 + q1^2*q2 + q2^3/5", "'A'"};
  EXPECT_EQ(residue(look(both_equilibria_at_0, 3)).substr(0, 5), "open:");
}

TEST(HigherOrders, WhyTheGroupIsInfinite) {
  const auto because = [](const Example& x, int order) {
    const auto found = look(x, order);
    return found.obstruction ? std::optional(found.obstruction->because) : std::nullopt;
  };
  EXPECT_EQ(because({"q2^3/3 + q1^2*q2/2"}, 3), InfiniteGroup::homogeneous);
  EXPECT_EQ(because({"q2^3/3 + q1^2*q2/2 + q1^4"}, 3), InfiniteGroup::homogeneous);
  EXPECT_EQ(because({"q2^3/3 + q1^2*q2/2 + q1^2"}, 3), InfiniteGroup::first_family);
  EXPECT_EQ(because({"(q1^2 + q2^2)/2 + q1^2*q2 + 1/5*q2^3"}, 3), InfiniteGroup::equilibria);
  EXPECT_EQ(
      because({"(q1^2 + q2^2)/2 + q1^2*q2 + 1/5*q2^3", "", "", "'q1 = 0', 'p1 = 0'", "H = 3"}, 3),
      InfiniteGroup::decided);
  // lambda = 10/3: a finite group, and a logarithm
  EXPECT_EQ(because({"q2^3/3 + 5/3*q1^2*q2 + q1^3"}, 4), std::nullopt);
  EXPECT_NE(residue(look({"q2^3/3 + 5/3*q1^2*q2 + q1^3"}, 4)), "none");
}

TEST(HigherOrders, ConditionsAreInTheParameters) {
  const auto found = look({hh + "1/3*q2^3", "'A', 'B'"}, 3);
  ASSERT_TRUE(found.obstruction);
  EXPECT_EQ(found.obstruction->because, InfiniteGroup::first_family);
  ASSERT_EQ(found.obstruction->not_all_zero.size(), 1U);
  EXPECT_EQ(to_string(found.obstruction->not_all_zero.front().front()), "A - B");
}

// (2.9): 10/3 is not a sum of two squares of rational numbers
TEST(HigherOrders, TheExponentsAtEquilibriaAreNotAllRational) {
  const auto found = look({hh + "1/5*q2^3", "'A', 'B'"}, 3);
  EXPECT_EQ(residue(found), "VE_3 (c2) (1077*A^2 - 3590*A*B + 2273*B^2) (c1)^3");
  ASSERT_EQ(found.obstruction->not_all_zero.size(), 2U);
  EXPECT_EQ(to_string(found.obstruction->not_all_zero[0].front()), "B");
  EXPECT_EQ(to_string(found.obstruction->not_all_zero[1].front()),
            "1077*A^2 - 3590*A*B + 2273*B^2");
  // on the locus that is left, A/B the root of a quadratic equation
  EXPECT_EQ(look({"(A*q1^2 + q2^2)/2 + q1^2*q2 + 1/5*q2^3", "", "A^2 = 3590/1077*A - 2273/1077"}, 5)
                .obstruction->logarithm.order,
            5);
}

// Is everything that is found accepted by the judge of lib/certify?
TEST(HigherOrders, HaveCertificates) {
  const std::string x = "(q1 - q2)", y = "(q1 + q2)"; // turned by 45 degrees
  const std::vector<std::pair<Example, int>> all{
      {{hh + "1/3*q2^3", "'A', 'B'"}, 3},
      {{hh + "1/5*q2^3", "'A', 'B'"}, 3},
      {{"(q1^2 + q2^2)/2 + q1^2*q2 + 1/5*q2^3", "", "", "'q1 = 0', 'p1 = 0'", "H = 3"}, 3},
      {{"q2^3/3 + q1^2*q2/2 + a*q1^3", "'a'"}, 3},
      {{"q2^5/5 + q1^2*q2^3/2 + q1^4*q2/3"}, 3},
      {{quartic + "6*q1^2*q2^2 + 4*q1^4", "'A', 'B'"}, 3},
      {{"q2^6/6 + 5/2*q1^2*q2^4 + q1^4*q2^2/7"}, 3},
      {{"(A*" + x + "^2 + B*" + y + "^2)/4 + " + x + "^2*" + y + " + 2/3*" + y + "^3", "'A', 'B'",
        "", "'q1 = q2', 'p1 = p2'"},
       3},
      {isotropic("-1"), 2},
      {isotropic("5"), 3},
      {isotropic("9"), 2},
      {isotropic("20"), 5}};
  for (const auto& [example, order] : all) {
    const auto found = look(example, order);
    ASSERT_TRUE(found.obstruction) << example.potential << found.open;
    EXPECT_EQ(found.obstruction->no_certificate, "") << example.potential;
    EXPECT_NE(found.obstruction->certificate, "") << example.potential;
  }
}

HigherOrders of_three(const std::string& potential, int order) {
  const System s = read_system(parse_document(
      "system = {kind = 'hamiltonian', coordinates = ['q1', 'q2', 'q3'], momenta = ['p1', 'p2', "
      "'p3'], parameters = ['A', 'B', 'C'], hamiltonian = '(p1^2 + p2^2 + p3^2)/2 + " +
          potential +
          "'}\nmanifold = [{name = 'N', equations = ['q1 = 0', 'q3 = 0', 'p1 = 0', 'p3 = 0']}]",
      "test.toml"));
  HigherOptions options;
  options.order = order;
  return higher_orders(s, s.manifolds.front(), options);
}

TEST(HigherOrders, InASubspaceOfThreeDegreesOfFreedom) {
  const std::string quadratic = "(A*q1^2 + B*q2^2 + C*q3^2)/2 + ";
  const auto found = of_three(quadratic + "q1^2*q2 + q2^3/3 + 6*q3^2*q2 + q1^2*q3^2", 3);
  EXPECT_EQ(residue(found), "VE_3 (c2) (A - B) (c1)^3");
  EXPECT_EQ(found.obstruction->within, "q3 = p3 = 0");
  EXPECT_EQ(found.obstruction->no_certificate, "");
  EXPECT_NE(found.obstruction->certificate, "");
  // only the second of the two subspaces has a logarithm with consequences
  EXPECT_EQ(of_three(quadratic + "q1^2*q2/6 + q2^3/3 + q3^2*q2", 3).obstruction->within,
            "q1 = p1 = 0");
}

TEST(HigherOrders, NoFalseAlarmInThreeDegreesOfFreedom) {
  // q1 and q2 as in the integrable case of Henon and Heiles, q3 on its own; a central potential
  EXPECT_EQ(residue(of_three("(A*q1^2 + B*q2^2)/2 + q1^2*q2 + 2*q2^3 + C*q3^2", 5)).substr(0, 5),
            "open:");
  EXPECT_EQ(residue(of_three("A*(q1^2 + q2^2 + q3^2) + B*(q1^2 + q2^2 + q3^2)^2", 5)).substr(0, 5),
            "open:");
}

TEST(HigherOrders, ASubspaceThatIsNotInvariant) {
  const auto found = of_three("q2^3/3 + q1^2*q2/2 + q1*q3^2 + q3*q1^2", 3);
  EXPECT_FALSE(found.obstruction);
  EXPECT_NE(found.open.find("no invariant subspace"), std::string::npos) << found.open;
}

TEST(HigherOrders, AnAlgebraicConstantIsNoException) {
  for (const std::string lambda : {"9", "14"}) {
    const auto found = look(isotropic(lambda), 2);
    ASSERT_TRUE(found.obstruction);
    for (const auto& list : found.obstruction->not_all_zero)
      EXPECT_TRUE(std::any_of(list.begin(), list.end(),
                              [](const MPoly& p) { return is_constant(p) && !is_zero(p); }));
  }
  // s^2 = t: where t = 0 the constant is 0
  const auto found = look({"q2^3/3 + q1^2*q2/2 + s*q1^3", "'t'", "s^2 = t"}, 2);
  EXPECT_EQ(to_string(found.obstruction->not_all_zero.front().front()), "t");
}

TEST(HigherOrders, ALineThatIsNoAxis) {
  // HH b = 1 along q1 = q2 ... of A = B is separable there; b = 2 in axes turned by 45 degrees
  const std::string x = "(q1 - q2)", y = "(q1 + q2)"; // sqrt(2) times the coordinates
  const auto found =
      look({"(A*" + x + "^2 + B*" + y + "^2)/4 + " + x + "^2*" + y + " + 2/3*" + y + "^3",
            "'A', 'B'", "", "'q1 = q2', 'p1 = p2'"},
           3);
  EXPECT_EQ(residue(found), "VE_3 (c2) (c1)^3");
}

TEST(HigherOrders, ALineWithAnAlgebraicSlope) {
  const std::string x = "(q1 - s*q2)", y = "(s*q1 + q2)"; // sqrt(3) times the coordinates
  const std::string potential = "(A*" + x + "^2 + B*" + y + "^2)/2 + s*" + x + "^2*" + y;
  const auto along = [&](const std::string& b) {
    return residue(look({potential + " + s*" + b + "*" + y + "^3", "'A', 'B'", "s^2 = 2",
                         "'q1 = s*q2', 'p1 = s*p2'"},
                        3));
  };
  EXPECT_EQ(along("2/3"), "VE_3 (c2) (c1)^3");
  EXPECT_EQ(along("1/3"), "VE_3 (c2) (s) (A - B) (c1)^3");
  EXPECT_EQ(along("2"), "none");
}

TEST(HigherOrders, NamesOfTheRoomMayBeThoseOfTheFile) {
  const System s = read_system(parse_document(
      "system = {kind = 'hamiltonian', coordinates = ['x', 'y'], momenta = ['c1', 'c2'], "
      "parameters = ['e', 'E'], hamiltonian = '(c1^2 + c2^2)/2 + e*x^2/2 + E*y^2/2 + x^2*y + "
      "y^3/3'}\nmanifold = [{name = 'N', equations = ['x = 0', 'c1 = 0']}]",
      "test.toml"));
  const auto found = higher_orders(s, s.manifolds.front());
  EXPECT_EQ(residue(found), "VE_3 (c2_) (e - E) (c1_)^3");
}

// A constant in V is one in h.
TEST(HigherOrders, AConstantInThePotential) {
  EXPECT_EQ(residue(look({"(q1^2 + q2^2)/2 + q1^2*q2 + 1/5*q2^3 + v", "'v'"}, 3)),
            "VE_3 (c2) (c1)^3");
  const auto found = look({hh + "2/3*q2^3 + v", "'A', 'B', 'v'"}, 3);
  EXPECT_EQ(residue(found), "VE_3 (c2) (c1)^3");
}

TEST(HigherOrders, TwoInertias) {
  // q1 -> 2 q1 makes 4 p1^2 of p1^2; all of H times 3 is another time
  EXPECT_EQ(residue(look({"3/2*p1^2 + (A*q1^2/4 + B*q2^2)/2 + q1^2*q2/4 + q2^3/3", "'A', 'B'"}, 3)),
            "VE_3 (c2) (A - B) (c1)^3");
  EXPECT_EQ(
      residue(look(
          {"5*p1^2 + 1*p2^2 + (A*q1^2*3/11 + B*q2^2)/2 + 3/11*q1^2*q2 + q2^3/3", "'A', 'B'"}, 3)),
      "VE_3 (c2) (A - B) (c1)^3");
}

TEST(HigherOrders, TheLevelOfTheFile) {
  const auto at = [](const std::string& level) {
    return look({"(q1^2 + q2^2)/2 + q1^2*q2 + 1/5*q2^3", "", "", "'q1 = 0', 'p1 = 0'", level}, 3);
  };
  ASSERT_TRUE(at("H = 3").obstruction);
  EXPECT_EQ(to_string(*at("H = 3").obstruction->energy), "3");
  EXPECT_EQ(at("H = 3").obstruction->because, InfiniteGroup::decided);
}

TEST(HigherOrders, OutOfScope) {
  const auto open = [](const Example& x) { return look(x, 3).open; };
  EXPECT_EQ(open({"q1^2 + q2^2 + q1^2*q2"}), "the potential on the plane is of degree < 3");
  EXPECT_EQ(open({"q2^3 + q1^2*q2^2"}), "the normal equation is irregular at infinity");
  EXPECT_EQ(open({"q2^3 + q1^2/q2"}), "H is not (a*p1^2 + b*p2^2)/2 + V with a polynomial V");
  EXPECT_EQ(open({"q2^3/3 + q1^2*q2/7"}), "the exponents at infinity are irrational or equal");
  EXPECT_THROW((void)look({"q2^3"}, 1), InvalidArgument);
  EXPECT_THROW((void)look({"q2^3"}, 8), InvalidArgument);
}

TEST(CommutingForms, AreThoseOfTheMonomials) {
  const System s = system_of({"q2^3/3 + q1^2*q2/2"});
  const auto plane = std::get<InvariantPlane>(invariant_plane(s, s.manifolds.front()));
  const MFraction c1 = MFraction::variable(plane.ring, plane.c1);
  const MFraction c2 = MFraction::variable(plane.ring, plane.c2);
  EXPECT_TRUE(commuting_determinants(plane, pow(c1, 3)).empty());
  EXPECT_TRUE(commuting_determinants(plane, pow(c1 + c2, 4)).empty());
  EXPECT_TRUE(commuting_determinants(plane, pow(c1 * c2, 2)).empty());
  EXPECT_TRUE(commuting_determinants(plane, pow(c1 * c1 - c1 * c2 + c2 * c2, 3)).empty());
  EXPECT_FALSE(commuting_determinants(plane, pow(c1, 3) * c2).empty());
  EXPECT_FALSE(commuting_determinants(plane, c1 * c1 * c2).empty());
  EXPECT_FALSE(commuting_determinants(plane, pow(c1, 3) + pow(c2, 3)).empty());
}

TEST(FirstFamily, IsThatOfMoralesRamis) {
  // k = 3: lambda = 0, 1, 2, 5, 7 are p + 3p(p - 1)/2; 1/3 and 10/3 are not
  for (const long difference : {1, 5, 7, 11, 13})
    EXPECT_TRUE(in_first_family(3, difference)) << difference;
  EXPECT_FALSE(in_first_family(3, 3));
  EXPECT_FALSE(in_first_family(3, 9));
  EXPECT_TRUE(in_first_family(4, 3));
  EXPECT_FALSE(in_first_family(4, 2));
  EXPECT_FALSE(in_first_family(4, Rational(1, 2)));
}

} // namespace
} // namespace kov::jets
