// One system in many notations: it is found to be the same, and its verdict is.

#include "canonical/elementary.hpp"
#include "canonical/simplify.hpp"
#include "canonical/systems.hpp"
#include "support/checked.hpp"

#include <gmock/gmock.h>

#include <algorithm>

namespace kov {
namespace {

using test::Random;
using test::random_rounds;
using test::shape;

std::string simple_shape(const System& s) {
  const auto change = simplified(s);
  if (change) {
    EXPECT_TRUE(is_canonical(s, *change));
  }
  return shape(change ? change->system : s);
}

// The field is B = d_x A_y - d_y A_x; the potentials A + df have the same one.
TEST(CanonicalNotation, AllGaugesOfAFieldHaveOneForm) {
  random_rounds(4, [](Random& random) {
    const auto number = [&] { return "(" + std::to_string(random.between(-3, 3)) + ")"; };
    const std::string k = number(), l = number(), m = number(), n = number();
    const std::string au = k + "*y + " + l + "*y^2 + a*y", av = m + "*x^2 - x*y";
    const std::string v = "x^4 + 2*y^4 + x*y";
    const std::string fu = l + "*y + " + n + "*2*x*y + 3*x^2", fv = l + "*x + " + n + "*x^2 - a";
    const auto written = [&](const std::string& u, const std::string& w) {
      return "((u + " + u + ")^2 + (v + " + w + ")^2)/2 + " + v;
    };
    EXPECT_EQ(simple_shape(test::planar(written(au, av))),
              simple_shape(test::planar(written(au + " + " + fu, av + " + " + fv))))
        << written(au, av);
  });
}

TEST(CanonicalNotation, AShiftIsUndone) {
  random_rounds(8, [](Random& random) {
    const std::string v = random.one_of(std::vector<std::string>{
        "(X^2 + Y^2)/2 + X^2*Y - Y^3/3", "X^4 + 3*X^2*Y^2 + 2*Y^4 + a*X^2", "a*X^2/(X^2 + 2*Y^2)"});
    const auto number = [&] {
      return std::to_string(random.between(-5, 5)) + "/" + std::to_string(random.between(1, 3));
    };
    const auto at = [&](const std::string& x, const std::string& y) {
      std::string text = "(u^2 + 2*v^2)/2 + " + v;
      for (std::size_t i; (i = text.find_first_of("XY")) != std::string::npos;)
        text.replace(i, 1, text[i] == 'X' ? x : y);
      return test::planar(text);
    };
    const std::string x = "(x + " + number() + ")", y = "(y - b + " + number() + ")";
    EXPECT_EQ(simple_shape(at(x, y)), simple_shape(at("x", "y"))) << v << " at " << x << ", " << y;
  });
}

// All eight sets of pairs.
TEST(CanonicalNotation, AnExchangeIsUndone) {
  const std::string h = "(U^2 + 2*V^2 + 3*W^2)/2 + X^4 + 5*Y^4 + Z^4 + X^2*Z^2";
  const auto exchanged = [&](unsigned set) {
    const std::string q = "xyt", p = "uvw", Q = "XYZ", P = "UVW";
    std::string text = h;
    for (std::size_t i = 0; i < 3; ++i)
      for (char& c : text) {
        const bool other = (set >> i & 1U) != 0;
        c = c == Q[i] ? (other ? p : q)[i] : c == P[i] ? (other ? q : p)[i] : c;
      }
    return test::hamiltonian("'x', 'y', 't'", "'u', 'v', 'w'", text);
  };
  for (unsigned set = 1; set < 8; ++set)
    EXPECT_EQ(simple_shape(exchanged(set)), shape(exchanged(0))) << set;
}

TEST(CanonicalNotation, ASecondPassChangesNothing) {
  for (const char* h :
       {"((u + x^2*y)^2 + (v + x^3/3)^2)/2 + (x - 1)^4", "((u - y)^2 + v^2)/2 + (x + a)^4 + y^2",
        "(x^2 + v^2)/2 + u^4 + u^2*(y - 2)^2", "(u^2 + v^2/x^2)/2 + x^4*cos(y)^2",
        "u*v + u*x^2 + (y - b)^3", "(u^2 + v^2)/2 + b*u + 1/((x - a)^2 + y^2)"}) {
    const auto once = simplified(test::planar(h));
    ASSERT_TRUE(once) << h;
    EXPECT_EQ(simple_shape(once->system), shape(once->system)) << h;
  }
}

TEST(CanonicalNotation, NamesDoNotMeet) {
  const System s =
      test::hamiltonian("'X', 'X1'", "'U', 'R'", "(U^2 + R^2/X^2)/2 + 1/X + x1*X*cos(X1)",
                        "parameters = ['x1', 'V', 'Y']\n");
  const auto change = simplified(s);
  ASSERT_TRUE(change);
  EXPECT_TRUE(is_canonical(s, *change));
  auto names = change->system.ring()->names();
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
  for (const char* parameter : {"x1", "V", "Y"})
    EXPECT_THAT(names, testing::Contains(parameter));
}

// a is not in the new Hamiltonian, and is still a parameter that is positive.
TEST(CanonicalNotation, AParameterThatCancelsIsKept) {
  const System s = test::planar("(u^2 + v^2)/2 + (x - a)^4 + (y - a)^4",
                                "parameters = ['a', 'b']\n[assume]\na = 'positive'\n");
  const auto change = simplified(s);
  ASSERT_TRUE(change);
  const System& now = change->system;
  EXPECT_FALSE(uses(*now.field.hamiltonian, now.ring()->index("a")));
  EXPECT_EQ(now.field.parameters.size(), 2U);
  ASSERT_EQ(now.assumptions.size(), s.assumptions.size());
  EXPECT_EQ(to_string(now.assumptions.front().value), "a");
}

TEST(CanonicalNotation, CylindricalCoordinates) {
  const System s = test::lagrangian("'r', 't', 'y'", "'k', 'l', 'm'",
                                    "(k^2 + r^2*l^2 + m^2)/2 - a*r^2*sin(t)^2 - y*r*cos(t)");
  const auto change = simplified(s);
  ASSERT_TRUE(change);
  const VectorField& v = change->system.field;
  for (std::size_t i = 3; i < 6; ++i) // p^2/2 alone
    EXPECT_EQ(v.components[i - 3], MFraction::variable(v.ring, v.coordinates[i]));
  EXPECT_TRUE(v.functions.empty());
}

// Curvature is no notation: a half-plane, a sphere, a paraboloid.
TEST(CanonicalNotation, ACurvedSurfaceStaysCurved) {
  for (const char* h : {"y^2*(u^2 + v^2)/2 + x", "(u^2 + v^2/sin(x)^2)/2 + cos(x)",
                        "(u^2/(1 + x^2) + v^2/x^2)/2 + x^2"}) {
    const System s = test::planar(h);
    const auto change = simplified(s);
    const auto g = kinetic_matrix(*form_of(change ? change->system : s));
    ASSERT_TRUE(g) << h;
    const Form form = *form_of(change ? change->system : s);
    EXPECT_FALSE(form.is_constant_of_motion((*g)[0][0]) && form.is_constant_of_motion((*g)[1][1]))
        << h;
  }
}

// Nothing, or too little, depends on the momenta; or it is another type of system.
TEST(CanonicalNotation, NothingIsFoundWhereThereIsNothing) {
  for (const char* h : {"0", "a", "x^2 + y^2", "u*y - v*x", "u^2/2 + v*x", "u^4 + v^4 + x^4 + y^4",
                        "(u + v)^2/2 + x^2*y", "exp(u) + v^2 + x^2"}) {
    const System s = test::planar(h);
    if (const auto change = simplified(s)) {
      EXPECT_TRUE(is_canonical(s, *change)) << h;
    }
    EXPECT_FALSE(kinetic_matrix(*form_of(s))) << h;
  }
}

TEST(CanonicalNotation, TheKineticMatrixIsThatOfThePolynomial) {
  const auto matrix = [](const char* h) {
    const auto g = kinetic_matrix(*form_of(test::planar(h)));
    std::string text;
    if (g)
      for (const auto& row : *g)
        for (const MFraction& x : row)
          text += to_string(x) + " ";
    return text;
  };
  EXPECT_EQ(matrix("a*u^2/2 + u*v + x*u + y"), "a 1 1 0 ");
  EXPECT_EQ(matrix("x*(u^2 - v^2)/2 + sin(y)"), "x 0 0 -x ");
  EXPECT_EQ(matrix("(u^2 + v^2)/2 + u^2*v"), "");
  EXPECT_EQ(matrix("(u^2 + v^2)/(2*(1 + u))"), "");
  EXPECT_EQ(matrix("u^2/2 + v^2*cos(u)"), "");
  EXPECT_EQ(matrix("(u + x*v)^2/2 + y"), "");
}

// The equations of the invariant plane go along; where their solution becomes a root of degree 3 it is
// not followed.
TEST(CanonicalNotation, AnInvariantPlaneKeepsItsVerdict) {
  struct Known {
    std::string v;
    Verdict verdict;
  };
  const std::vector<Known> all{{"(x^2 + y^2)/2 + x^2*y - y^3/3", Verdict::non_integrable},
                               {"x^4 + 3*x^2*y^2 + y^4", Verdict::non_integrable},
                               {"x^4 + 6*x^2*y^2 + y^4", Verdict::no_obstruction},
                               {"x^2*y + 2*y^3", Verdict::no_obstruction}};
  long kept = 0;
  random_rounds(6, [&](Random& random) {
    const Known& known = random.one_of(all);
    const System s = test::planar("(u^2 + v^2)/2 + " + known.v, "parameters = ['a']\n");
    const Form form = *form_of(s);
    const test::Step step = test::random_step(form, random);
    const auto text = [&](const std::string& name) {
      const std::size_t i = s.ring()->index(name);
      return to_string(substitute(form.variable(i), step.old));
    };
    const std::string file =
        "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
        "parameters = ['a']\nhamiltonian = '" +
        to_string(*test::changed(form, step).field.hamiltonian) +
        "'\n[[manifold]]\nname = 'N'\nequations = ['" + text("x") + " = 0', '" + text("u") +
        " = 0']\nlevel = 'H = 1'\n";
    const Verdict verdict = test::checked(file).verdict;
    EXPECT_TRUE(verdict == known.verdict || verdict == Verdict::undecided) << file;
    if (verdict == known.verdict) ++kept;
  });
  EXPECT_GE(kept, 5);
}

} // namespace
} // namespace kov
