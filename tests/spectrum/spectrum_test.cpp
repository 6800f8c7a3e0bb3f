// Textbook spectra: the values of E with Liouvillian solutions, and the solutions.

#include "decide/decide.hpp"
#include "exact/ideal.hpp"
#include "spectrum/spectrum.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

#include <set>

namespace kov::spectrum {
namespace {

const Ring ring = make_ring({"z", "E", "a", "b", "L", "J"});
MFraction x(const char* name) { return MFraction::variable(ring, name); }
MFraction number(long p, long q = 1) { return MFraction(ring, Rational(p, q)); }
const std::size_t energy = 1;

AlgebraicSpectrum spectrum_of(const MFraction& r) {
  strata::Question q;
  q.r = r;
  return algebraic_spectrum(q, energy);
}

std::set<std::string> formulas(const AlgebraicSpectrum& s) {
  std::set<std::string> all;
  for (const Piece& p : s.pieces)
    for (const Series& one : p.series)
      all.insert(one.value ? kov::to_string(*one.value) : kov::to_string(one.equation));
  return all;
}

// By other code: y is checked with its logarithmic derivative.
void expect_solution(const MFraction& r, const Eigenfunction& y, const std::vector<MPoly>& where) {
  MFraction p(ring);
  for (std::size_t i = 0; i < y.p.size(); ++i)
    p += y.p[i] * pow(x("z"), static_cast<long>(i));
  MFraction theta = derivative(p, 0) / p + derivative(y.exponent, 0);
  for (const auto& [base, power] : y.powers)
    theta += power * derivative(MFraction(base), 0) / MFraction(base);
  const MFraction rest = derivative(theta, 0) + theta * theta - r;
  if (is_zero(rest)) return;
  const Ideal ideal(ring, {1, 2, 3, 4, 5}, where); // all but z
  EXPECT_TRUE(ideal.contains(rest.num())) << kov::to_string(rest);
}

void expect_solutions(const MFraction& r, const AlgebraicSpectrum& s) {
  const auto check = [&](const Level& level) {
    if (!level.y) return;
    Substitution put;
    if (level.fixed) put[level.fixed->first] = level.fixed->second;
    expect_solution(substitute(r, put), *level.y, level.equations);
  };
  for (const Piece& p : s.pieces) {
    for (const Series& one : p.series)
      for (const Level& level : one.first)
        check(level);
    for (const DegreeFamily& f : p.families)
      for (const Level& level : f.first)
        check(level);
  }
}

struct Textbook {
  const char* name;
  MFraction r;
  std::set<std::string> energies;
};
void PrintTo(const Textbook& t, std::ostream* out) { *out << t.name; }

// Exponent differences l, m, n (given by their squares) at 0, 1 and infinity.
MFraction riemann(const MFraction& l, const MFraction& m, const MFraction& n) {
  const MFraction one = number(1);
  const MFraction at_one = (x("z") - one) * (x("z") - one);
  return number(1, 4) * ((l - one) / (x("z") * x("z")) + (m - one) / at_one +
                         (one - l - m + n) / (x("z") * (x("z") - one)));
}

class Spectra : public testing::TestWithParam<Textbook> {};

TEST_P(Spectra, AreThoseOfTheTextbooks) {
  const AlgebraicSpectrum s = spectrum_of(GetParam().r);
  EXPECT_TRUE(s.decided());
  EXPECT_FALSE(s.pieces.empty());
  EXPECT_EQ(formulas(s), GetParam().energies);
  expect_solutions(GetParam().r, s);
}

INSTANTIATE_TEST_SUITE_P(
    OfPotentials, Spectra,
    testing::Values(
        Textbook{"Oscillator", x("z") * x("z") - x("E"), {"2*N + 1"}},
        Textbook{"RadialOscillator",
                 x("z") * x("z") + x("L") * (x("L") + number(1)) / (x("z") * x("z")) - x("E"),
                 {"2*L + 4*N + 3", "-2*L - 4*N - 3"}},
        Textbook{"Coulomb",
                 x("L") * (x("L") + number(1)) / (x("z") * x("z")) - number(1) / x("z") - x("E"),
                 {"-1/(4*L^2 + 8*L*N + 8*L + 4*N^2 + 8*N + 4)"}},
        // e^(-2x) - 2 b e^(-x) - E in z = e^(-x), y = z^(-1/2) u
        Textbook{"Morse",
                 number(1) - number(2) * x("b") / x("z") +
                     (-x("E") - number(1, 4)) / (x("z") * x("z")),
                 {"(-4*b^2 - 8*b*N - 4*b - 4*N^2 - 4*N - 1)/4"}}),
    [](const auto& one) { return std::string(one.param.name); });

// z^6 - (4J - 1) z^2: Turbiner; Bender and Dunne.
TEST(Spectrum, QuasiExactlySolvableSextic) {
  const auto sextic = [](const MFraction& j) {
    return pow(x("z"), 6) - (number(4) * j - number(1)) * x("z") * x("z") - x("E");
  };
  const auto equations = [&](long j) {
    const AlgebraicSpectrum s = spectrum_of(sextic(number(j)));
    EXPECT_TRUE(s.decided());
    expect_solutions(sextic(number(j)), s);
    std::vector<std::string> all;
    for (const Piece& p : s.pieces)
      for (const DegreeFamily& f : p.families)
        for (const Level& level : f.first)
          for (const MPoly& g : level.equations)
            all.push_back(to_factored_string(MFraction(g)));
    return all;
  };
  EXPECT_EQ(equations(1), std::vector<std::string>{"E"});
  EXPECT_EQ(equations(2), std::vector<std::string>{"(E^2 - 8)"});
  EXPECT_EQ(equations(3), std::vector<std::string>{"E*(E - 8)*(E + 8)"});
  const AlgebraicSpectrum all = spectrum_of(sextic(x("J")));
  expect_solutions(sextic(x("J")), all);
  std::size_t levels = 0;
  for (const Piece& p : all.pieces)
    for (const DegreeFamily& f : p.families)
      levels += f.first.size();
  EXPECT_GE(levels, 4U);
}

// z^4 - E z: the degree of P depends on E, and P exists unless N is 2 modulo 3.
TEST(Spectrum, TheDegreeDependsOnTheEnergy) {
  const MFraction r = pow(x("z"), 4) - x("E") * x("z");
  const AlgebraicSpectrum s = spectrum_of(r);
  expect_solutions(r, s);
  std::set<std::string> values;
  for (const Piece& p : s.pieces)
    for (const DegreeFamily& f : p.families)
      for (const Level& level : f.first)
        if (level.equations.empty()) values.insert(kov::to_string(level.fixed->second));
  EXPECT_EQ(values, (std::set<std::string>{"-8", "-4", "-2", "2", "4", "8"}));
}

// The solver without parameters, at points in the spectrum and beside it.
TEST(Spectrum, AgreesWithTheSolverAtPoints) {
  const MFraction quartic = pow(x("z"), 4) + x("a") * x("z") * x("z") + x("b") * x("z") - x("E");
  const AlgebraicSpectrum s = spectrum_of(quartic);
  expect_solutions(quartic, s);
  for (const Piece& p : s.pieces)
    for (const DegreeFamily& f : p.families)
      for (const Level& level : f.first) {
        ASSERT_TRUE(level.fixed && level.equations.size() == 1);
        for (long a = -2; a <= 2; ++a)
          for (long e = -2; e <= 2; ++e) {
            Substitution put{{ring->index("a"), number(a)}, {energy, number(e)}};
            if (level.fixed->first != ring->index("b")) continue;
            put[ring->index("b")] = substitute(level.fixed->second, put);
            const bool member = is_zero(substitute(level.equations[0], put));
            const Decision d = decide(
                {.r = to_rational_function(substitute(quartic, put), 0), .p = RationalFunction()});
            ASSERT_TRUE(d.group);
            EXPECT_EQ(d.group->type != GroupType::SL2, member) << a << " " << e;
          }
      }
}

// Two differences depend on E: sqrt(a - E) +- sqrt(b - E) +- 1/3 is odd (Rosen-Morse).  Each value of
// the formula has solutions, and the values between have none, by the solver without parameters.
TEST(Spectrum, TwoSquareRoots) {
  const MFraction r = riemann(x("a") - x("E"), x("b") - x("E"), number(1, 9));
  const AlgebraicSpectrum s = spectrum_of(r);
  const auto has_solution = [&](const MFraction& e, const MFraction& a, const MFraction& b) {
    const MFraction there = substitute(r, {{1, e}, {2, a}, {3, b}});
    const Decision d = decide({.r = to_rational_function(there, 0), .p = RationalFunction()});
    EXPECT_TRUE(d.group);
    return d.group && d.group->type != GroupType::SL2;
  };
  std::size_t compared = 0;
  for (const Piece& p : s.pieces)
    for (const Series& one : p.series) {
      if (!one.value) continue;
      const Ring& wide = one.equation.ring();
      for (long n = -2; n <= 2; ++n)
        for (long a = 0; a < 3; ++a) {
          const MFraction b = number(5, 7);
          const MFraction e =
              transfer(substitute(*one.value, {{one.n, MFraction(wide, Rational(n))},
                                               {2, MFraction(wide, Rational(a))},
                                               {3, MFraction(wide, Rational(5, 7))}}),
                       ring);
          EXPECT_TRUE(has_solution(e, number(a), b)) << kov::to_string(e);
          EXPECT_FALSE(has_solution(e + number(1, 1009), number(a), b)) << kov::to_string(e);
          ++compared;
        }
    }
  EXPECT_GE(compared, 15U);
}

// Legendre: of integer degree every E = -mu^2 is a value.
TEST(Spectrum, EveryEnergyWhereTheDegreeIsAnInteger) {
  const AlgebraicSpectrum s =
      spectrum_of(riemann(-x("E"), -x("E"), pow(number(2) * x("a") + number(1), 2)));
  bool found = false;
  for (const Piece& p : s.pieces)
    for (const Series& one : p.series)
      found = found || one.every_energy;
  EXPECT_TRUE(found);
}

// A family of degrees is never dropped: E z^2 has its first solution at N = 4.
TEST(Spectrum, WhatIsNotLookedAtIsOpen) {
  const AlgebraicSpectrum s = spectrum_of(pow(x("z"), 6) - x("E") * x("z") * x("z") - number(8));
  ASSERT_EQ(s.pieces.size(), 1U);
  EXPECT_EQ(s.pieces[0].status, Piece::Status::degrees);
  EXPECT_FALSE(s.decided());
  for (const DegreeFamily& f : s.pieces[0].families)
    EXPECT_FALSE(f.open.empty());
}

// a = -15 needs E = 0 and E^2 = -96: no level.  a = 0 is another stratum.
TEST(Spectrum, ContradictoryConditionsAreNoLevel) {
  const MFraction r =
      number(6) / (x("z") * x("z")) + pow(x("z"), 6) - x("a") * x("z") * x("z") - x("E");
  for (const Piece& p : spectrum_of(r).pieces)
    for (const DegreeFamily& f : p.families)
      for (const Level& level : f.first)
        EXPECT_LT(level.equations.size(), 2U) << f.first.size();
}

// Values that contradict the assumptions are not levels.
TEST(Spectrum, AssumptionsHoldAtEachLevel) {
  strata::Question q;
  q.r = pow(x("z"), 6) - x("a") * x("z") * x("z") - x("E");
  q.assumptions.require(x("a") - number(5), Sign::positive);
  for (const Piece& p : algebraic_spectrum(q, energy).pieces)
    for (const DegreeFamily& f : p.families)
      for (const Level& level : f.first)
        EXPECT_GT(to_rational(level.fixed->second), Rational(5));
}

// J is (or is not) an integer, a half-integer, ... by assumption: the levels are those of the family
// without the assumption whose J is so.
TEST(Spectrum, IntegersAreAssumedAtEachLevel) {
  test::random_rounds(12, [](test::Random& random) {
    const long scale = random.between(1, 4), shift = random.between(0, 3), c = random.between(1, 4);
    strata::Question q;
    q.r = pow(x("z"), 6) - number(scale) * (x("J") + number(shift, 4)) * x("z") * x("z") - x("E");
    const auto levels = [&] {
      std::set<std::string> all;
      for (const Piece& p : algebraic_spectrum(q, energy).pieces)
        for (const DegreeFamily& f : p.families)
          for (const Level& level : f.first)
            all.insert(kov::to_string(level.fixed->second));
      return all;
    };
    const std::set<std::string> free = levels();
    ASSERT_FALSE(free.empty());
    const bool in_integers = random.once_in(2);
    const MFraction value = number(c) * x("J") + number(random.between(0, 3), 4);
    q.assumptions.require_integral(value, in_integers);
    std::set<std::string> expected;
    for (const std::string& text : free) {
      const auto slash = text.find('/');
      const Rational j(Integer::parse(text.substr(0, slash)),
                       slash == std::string::npos ? Integer(1)
                                                  : Integer::parse(text.substr(slash + 1)));
      const Rational there = to_rational(substitute(value, {{5, MFraction(ring, j)}}));
      if (is_integer(there) == in_integers) expected.insert(text);
    }
    EXPECT_EQ(levels(), expected) << kov::to_string(value) << (in_integers ? " in Z" : " not in Z");
  });
}

// Turbiner's radial sextic: irregular and one regular place, so that no group is dihedral.
TEST(Spectrum, OneRegularPlaceMakesNoDihedralGroup) {
  const MFraction r = x("L") * (x("L") + number(1)) / (x("z") * x("z")) + pow(x("z"), 6) -
                      x("a") * x("z") * x("z") - x("E");
  const AlgebraicSpectrum s = spectrum_of(r);
  expect_solutions(r, s);
  std::size_t levels = 0;
  for (const Piece& p : s.pieces)
    for (const DegreeFamily& f : p.families)
      levels += f.first.size();
  EXPECT_GE(levels, 8U);
}

} // namespace
} // namespace kov::spectrum
