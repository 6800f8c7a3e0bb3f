// Invariant straight lines: V = F(x + m y) + u^2 G with u = y - m x - n has the line u = 0, wherever it
// is moved.

#include "manifold/lines.hpp"

#include "manifold/find.hpp"
#include "system/read_system.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov::lines_test {
namespace {

System planar(const std::string& potential, const std::string& kinetic = "(p^2 + q^2)/2") {
  return read_system(parse_document("[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\n"
                                    "momenta = ['p', 'q']\nparameters = ['a', 'b']\n"
                                    "hamiltonian = '" +
                                        kinetic + " + " + potential + "'\n",
                                    "test.toml"));
}

// The text as a function.
MFraction function(const std::string& text) {
  const System s = planar(text), zero = planar("0");
  return *s.field.hamiltonian - transfer(*zero.field.hamiltonian, s.ring());
}
std::string value(const std::string& text) { return to_string(function(text)); }

bool has(const Lines& all, const std::string& slope, const std::string& offset) {
  return std::any_of(all.lines.begin(), all.lines.end(), [&](const Line& line) {
    return line.dependent == 1 && to_string(line.slope) == value(slope) &&
           to_string(line.offset) == value(offset);
  });
}
bool has_vertical(const Lines& all, const std::string& offset) {
  return std::any_of(all.lines.begin(), all.lines.end(), [&](const Line& line) {
    return line.dependent == 0 && to_string(line.offset) == value(offset);
  });
}

// F and G without symmetries of their own.
std::string with_line(const std::string& m, const std::string& n, const std::string& rest = "0") {
  const std::string along = "(x + (" + m + ")*y)", u = "(y - (" + m + ")*x - (" + n + "))";
  return along + "^3/3 + b*" + along + "^4 + " + u + "^2*(x^2 + 3*y + a) + (" + rest + ")*" + u;
}

TEST(Lines, ThroughTheOriginOrNot) {
  for (const std::string m : {"0", "2", "-1/3", "a", "1/b", "a/(a + b)"})
    for (const std::string n : {"0", "5", "b", "a - 2*b"})
      EXPECT_TRUE(has(find_lines(planar(with_line(m, n)).field), m, n)) << m << ' ' << n;
}

TEST(Lines, OfAConstantFirstCoordinate) {
  for (const std::string n : {"3", "-1/2", "a", "a/b"})
    EXPECT_TRUE(has_vertical(
        find_lines(planar("y^3 + b*y^4 + (x - (" + n + "))^2*(y + x^2 + a)").field), n))
        << n;
}

TEST(Lines, OfRationalPotentials) {
  EXPECT_TRUE(has(find_lines(planar("1/(x + a*y) + (y - a*x - b)^2/(x^2 + y)").field), "a", "b"));
}

// p = M^-1 q': the momenta on y = m x + n are in another ratio than the coordinates.
TEST(Lines, WithMassesTheMomentaHaveARatioOfTheirOwn) {
  const System s = planar("(9*x + 4*y)^3 + (y - 2*x - a)^2*(x^2 + y)", "(p^2 - 4*p*q + 5*q^2)/2");
  const Lines found = find_lines(s.field);
  EXPECT_TRUE(has(found, "2", "a"));
  for (const Line& line : found.lines)
    if (line.dependent == 1) {
      // x' = p - 2q, y' = -2p + 5q, and y' = m x' on the line
      const MFraction m = line.slope, k = line.ratio, one(s.ring(), Rational(1));
      const MFraction two = one + one, five = two + two + one;
      EXPECT_TRUE(is_zero(five * k - two - m * (one - two * k)));
    }
}

// Where the force across the line vanishes for special parameters only.
TEST(Lines, ForSpecialParameters) {
  for (const std::string c : {"a - 2*b", "a^2 - b", "a*b + 1"}) {
    const Lines found = find_lines(planar(with_line("3", "b", c)).field);
    EXPECT_FALSE(has(found, "3", "b")) << c;
    EXPECT_TRUE(std::any_of(found.special.begin(), found.special.end(), [&](const auto& list) {
      return std::all_of(list.begin(), list.end(), [&](const MPoly& p) {
        const MPoly f = transfer(function(c), p.ring()).num();
        return divides(f, p);
      });
    })) << c;
  }
}

// What is found is proved by other code; there is nothing where no line is.
TEST(Lines, AreProved) {
  for (const std::string& potential :
       {with_line("2", "a"), std::string("x^2 + y^2 + x^2*y + b*y^3"),
        std::string("(x^2 + y^2)^2 + a*(x^2 + y^2)"), std::string("x^4 + a*x^2*y^2 + y^4 + x^2"),
        std::string("x^3 + x*y + a*y^5 + b*x^2*y^2"), std::string("a*x^2/2 + b*y^2/2"),
        std::string("(x^2 + y^2)^3"), std::string("x + a*y"), std::string("a*x*y"),
        std::string("1/(x^2 + y^2)"), std::string("1/(x - y) + 1/(x + y)"), std::string("0")}) {
    const System s = planar(potential);
    for (const Line& line : find_lines(s.field).lines) {
      const auto x = [&](std::size_t j) {
        return MFraction::variable(s.ring(), s.field.coordinates[j]);
      };
      const std::size_t i = line.dependent;
      ManifoldSpec spec;
      spec.equations = {{x(i) - line.slope * x(1 - i) - line.offset, "the line"},
                        {x(i + 2) - line.ratio * x(3 - i), "its momenta"}};
      spec.levels = {{*s.field.hamiltonian - MFraction(s.ring(), Rational(7)), "H = 7"}};
      EXPECT_TRUE(std::holds_alternative<InvariantManifold>(prove_invariant(s.field, spec)))
          << potential;
    }
  }
  EXPECT_TRUE(find_lines(planar("x^3 + x*y + a*y^5 + b*x^2*y^2").field).lines.empty());
}

} // namespace
} // namespace kov::lines_test
