#include "algebraize/algebraize.hpp"

#include "linode/normal_form.hpp"
#include "support/equations.hpp"
#include "variation/systems.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

using namespace testing;

MFraction normal_form_of(const MFraction& p, const MFraction& q, std::size_t z) {
  return Rational(1, 4) * (p * p) + Rational(1, 2) * derivative(p, z) - q;
}

struct Curve {
  OnManifold s;
  NormalVariationalEquation e;
  [[nodiscard]] MFraction f(const std::string& text) const { return formula(s.system, text); }
  [[nodiscard]] std::variant<AlgebraicOde, ChangeFailure> in(const MFraction& phi) const {
    auto field = FunctionField::make(s.v(), s.m, s.system.z, phi, e.divisors);
    if (auto* failure = std::get_if<ChangeFailure>(&field)) return *std::move(failure);
    return algebraize(
        std::make_shared<const FunctionField>(std::get<FunctionField>(std::move(field))),
        s.system.z, phi, e);
  }
  [[nodiscard]] std::variant<AlgebraicOde, ChangeFailure> in(const std::string& phi) const {
    return in(f(phi));
  }
  [[nodiscard]] AlgebraicOde ode(const std::string& phi) const {
    auto result = in(phi);
    if (const auto* failure = std::get_if<ChangeFailure>(&result))
      throw std::invalid_argument(failure->message);
    return std::get<AlgebraicOde>(std::move(result));
  }
  [[nodiscard]] FunctionField field(const std::string& phi) const {
    auto result = FunctionField::make(s.v(), s.m, s.system.z, f(phi), e.divisors);
    if (const auto* failure = std::get_if<ChangeFailure>(&result))
      throw std::invalid_argument(failure->message);
    return std::get<FunctionField>(std::move(result));
  }
  /// Of the equation in z = phi, without parameters.
  [[nodiscard]] RationalFunction r(const std::string& phi) const {
    return to_rational_function(ode(phi).r, s.system.z);
  }
};

// The potential q2^2/2 + ... on the plane of (q2, p2); the normal equation is y'' + (1 + 2 q2) y =
// 0.
Curve numeric(const std::string& energy = "1/6", const std::string& cubic = "2") {
  Curve c{on_manifold(R"t([system]
kind = "hamiltonian"
coordinates = ["q1", "q2"]
momenta = ["p1", "p2"]
hamiltonian = "(p1^2 + p2^2)/2 + (q1^2 + q2^2)/2 + q1^2*q2 + )t" +
                      cubic + R"t(/3*q2^3"
[[manifold]]
equations = ["q1 = 0", "p1 = 0"]
level = "H = )t" + energy +
                      "\""),
          {}};
  const LinearSystem normal = normal_system(c.s.v(), c.s.m, {}).system;
  c.e = scalar_equation(c.s.v(), c.s.m, normal, {0, 1}, 0).value();
  return c;
}

Curve on_the_circle() {
  Curve c{circle(), {}};
  const LinearSystem normal = normal_system(c.s.v(), c.s.m, {}).system;
  c.e = scalar_equation(c.s.v(), c.s.m, normal, {1, 2}, 1).value();
  return c;
}

// d/dz is the derivation with dz/dz = 1 that d/dt = z' d/dz asks for.
TEST(FunctionField, ChainRule) {
  const struct {
    Curve c;
    std::string phi;
    std::vector<std::string> functions;
  } table[] = {{numeric(), "q2", {"q2", "p2", "q2*p2", "p2^2 + 3*q2", "1/(q2 + 5)", "p2/(q2 + 7)"}},
               {numeric(), "q2^2", {"q2", "p2", "q2*p2", "1/(q2 + 5)"}},
               {numeric(), "p2", {"q2", "p2^2", "q2^2*p2"}},
               {on_the_circle(), "x", {"x", "y", "x*y", "y/(x + 2)"}},
               {on_the_circle(), "x/(1 + y)", {"x", "y", "1/(3 + x)"}}};
  for (const auto& [c, phi, functions] : table) {
    SCOPED_TRACE(phi);
    const FunctionField k = c.field(phi);
    const FiniteAlgebra& algebra = k.algebra();
    const auto one = algebra.constant(MFraction(c.s.v().ring, Rational(1)));
    const auto value = [&](const std::string& text) { return k.evaluate(c.f(text)).value(); };
    const auto dot = [&](const MFraction& g) {
      return k.evaluate(lie_derivative(c.s.v(), g)).value();
    };
    EXPECT_EQ(k.derivative(value(phi)), one);
    EXPECT_TRUE(is_zero(k.derivative(one)));
    EXPECT_EQ(k.z_dot(), dot(c.f(phi)));
    EXPECT_EQ(algebra.multiply(k.z_dot(), k.inverse_z_dot()), one);
    EXPECT_EQ(k.z_ddot(), dot(lie_derivative(c.s.v(), c.f(phi))));
    EXPECT_EQ(k.z_ddot(), algebra.multiply(k.derivative(k.z_dot()), k.z_dot()));
    for (const std::string& text : functions) {
      const auto g = value(text);
      EXPECT_EQ(algebra.multiply(k.derivative(g), k.z_dot()), dot(c.f(text))) << text;
      EXPECT_EQ(k.evaluate(k.lift(g)).value(), g);
      for (const std::string& second : functions) { // Leibniz
        const auto h = value(second);
        EXPECT_EQ(k.derivative(algebra.multiply(g, h)),
                  algebra.multiply(k.derivative(g), h) + algebra.multiply(g, k.derivative(h)));
        EXPECT_EQ(k.derivative(g + h), k.derivative(g) + k.derivative(h));
      }
    }
  }
}

TEST(FunctionField, DegreesAndElementsOfTheBase) {
  const Curve c = numeric();
  EXPECT_EQ(c.field("q2").degree(), 2U); // p2 is a square root over Q(q2)
  EXPECT_EQ(c.field("p2").degree(), 3U); // q2 is a root of a cubic over Q(p2)
  EXPECT_EQ(c.field("q2^2").degree(), 4U);
  const FunctionField k = c.field("q2");
  EXPECT_FALSE(k.in_z(*k.evaluate(c.f("p2"))));
  const auto square = k.in_z(*k.evaluate(c.f("p2^2")));
  ASSERT_TRUE(square);
  const MFraction z = MFraction::variable(c.s.v().ring, c.s.system.z);
  const MFraction third(c.s.v().ring, Rational(1, 3));
  EXPECT_EQ(*square, third - z * z - Rational(4, 3) * z * z * z);
  EXPECT_FALSE(k.evaluate(c.f("1/(3*p2^2 - 1 + 3*q2^2 + 4*q2^3)"))); // the curve itself
}

// y'' + a1 y' + a0 y = z'^2 (y_zz + p y_z + q y).
TEST(Algebraize, CoefficientsFromTheChainRule) {
  for (const auto& [c, phi] : {std::pair(numeric(), "q2"), {numeric("1/5", "1"), "1/q2"}}) {
    const AlgebraicOde ode = c.ode(phi);
    const FunctionField k = c.field(phi);
    const auto& algebra = k.algebra();
    if (!ode.p) continue;
    const auto square = algebra.multiply(k.z_dot(), k.z_dot());
    const auto a1 = k.evaluate(c.e.a1).value();
    EXPECT_EQ(scale(square, *ode.p), k.z_ddot() + algebra.multiply(a1, k.z_dot()));
    EXPECT_EQ(scale(square, *ode.q), k.evaluate(c.e.a0).value());
    EXPECT_EQ(ode.r, normal_form_of(*ode.p, *ode.q, ode.z));
    const auto one_variable = [&](const MFraction& f) { return to_rational_function(f, ode.z); };
    EXPECT_EQ(normal_form(one_variable(*ode.p), one_variable(*ode.q)).r, one_variable(ode.r));
    EXPECT_EQ(algebra.constant(*ode.z_dot_squared), square);
    EXPECT_EQ(ode.field_degree, k.degree());
    EXPECT_FALSE(ode.checks.empty());
  }
}

// Two changes of variable of one curve: r transforms with the Schwarzian.
TEST(Algebraize, ChangesOfVariableAreComposed) {
  const Curve c = numeric();
  const RationalFunction z(Poly::z());
  const RationalFunction r = c.r("q2");
  EXPECT_EQ(pull_back(c.r("2*q2 + 3"), RationalFunction(2) * z + RationalFunction(3)), r);
  EXPECT_EQ(pull_back(c.r("1/q2"), RationalFunction(1) / z), r);
  EXPECT_EQ(
      pull_back(c.r("(q2 + 1)/(q2 - 2)"), (z + RationalFunction(1)) / (z - RationalFunction(2))),
      r);
}

// With an even potential q^2 is a variable, too: a branched change.
TEST(Algebraize, SquaresOfAVariable) {
  Curve c{on_manifold(R"t([system]
kind = "hamiltonian"
coordinates = ["x", "q"]
momenta = ["px", "p"]
hamiltonian = "(px^2 + p^2)/2 + q^4/4 + x^2*q^2"
[[manifold]]
equations = ["x = 0", "px = 0"]
level = "H = 1/4")t"),
          {}};
  c.e =
      scalar_equation(c.s.v(), c.s.m, normal_system(c.s.v(), c.s.m, {}).system, {0, 1}, 0).value();
  const RationalFunction z(Poly::z());
  EXPECT_EQ(pull_back(c.r("q^2"), z * z), c.r("q"));
  EXPECT_EQ(pull_back(c.r("q^4"), pow(z, 4)), c.r("q"));
  EXPECT_EQ(finite_singularities(c.ode("q^4").r, c.s.system.z), 2); // 0 and 1
}

TEST(Algebraize, ParametersMayTakeValuesAfterwards) {
  Curve generic{henon_heiles(), {}};
  generic.e = scalar_equation(generic.s.v(), generic.s.m,
                              normal_system(generic.s.v(), generic.s.m, {}).system, {0, 1}, 0)
                  .value();
  const AlgebraicOde ode = generic.ode("q2");
  const Ring& ring = generic.s.v().ring;
  const Substitution at{{ring->index("b"), MFraction(ring, Rational(2))},
                        {ring->index("h"), MFraction(ring, Rational(1, 6))}};
  for (const MPoly& g : ode.generic)
    ASSERT_FALSE(is_zero(substitute(g, at))) << to_string(g);
  EXPECT_EQ(to_rational_function(substitute(ode.r, at), generic.s.system.z), numeric().r("q2"));
}

TEST(Algebraize, WhatCannotBeUsedIsRefusedWithAReason) {
  const Curve c = numeric();
  const auto reason = [&](const std::string& phi) {
    const auto result = c.in(phi);
    const auto* failure = std::get_if<ChangeFailure>(&result);
    return failure == nullptr ? "accepted" : failure->message;
  };
  EXPECT_NE(reason("p2^2/2 + q2^2/2 + 2/3*q2^3").find("constant along the curve"),
            std::string::npos);
  EXPECT_NE(reason("3").find("constant along the curve"), std::string::npos);
  EXPECT_NE(reason("p2").find("algebraic of degree 3"), std::string::npos) << reason("p2");
}

// In z = y the coefficients lie in the quadratic extension by x; the better change that is named
// makes them rational.
TEST(Algebraize, ABetterChangeIsNamedAndWorks) {
  const Curve c = on_the_circle();
  const auto result = c.in("y");
  const auto* failure = std::get_if<ChangeFailure>(&result);
  ASSERT_NE(failure, nullptr);
  ASSERT_TRUE(failure->better) << failure->message;
  const auto again = c.in(*failure->better);
  const auto* worse = std::get_if<ChangeFailure>(&again);
  EXPECT_EQ(worse, nullptr) << worse->message;
}

TEST(Algebraize, ProposedChangesMove) {
  for (const Curve& c : {numeric(), on_the_circle()}) {
    const auto all = propose_changes(c.s.v(), c.s.m);
    EXPECT_GE(all.size(), 5U);
    for (const MFraction& phi : all)
      EXPECT_FALSE(c.s.m.vanishes_on_curve(lie_derivative(c.s.v(), c.s.m.restrict(phi))))
          << to_string(phi);
  }
}

TEST(NormalFormOf, IsTheFormulaOfOneVariable) {
  const Ring ring = make_ring({"z", "a"});
  const MFraction z = MFraction::variable(ring, 0);
  const MFraction a = MFraction::variable(ring, 1);
  const MFraction p = (a * z + a) / (z * z - a);
  const MFraction q = a / (z + a);
  for (const long value : {-3L, 2L, 5L}) {
    const Substitution at{{1, MFraction(ring, Rational(value))}};
    const auto f = [&](const MFraction& g) { return to_rational_function(substitute(g, at), 0); };
    EXPECT_EQ(normal_form(f(p), f(q)).r, f(normal_form_of(p, q, 0)));
  }
  EXPECT_EQ(finite_singularities(normal_form_of(p, q, 0), 0), 3); // z^2 = a and z = -a
  EXPECT_EQ(finite_singularities(MFraction(ring), 0), 0);
}

} // namespace
} // namespace kov
