// First integrals that are known, found without a hint, and the parameters at which they exist.

#include "integrals/find.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::Field;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

System planar(const std::string& hamiltonian, const std::string& parameters = "") {
  return read_system(parse_document(
      "system = {kind = 'hamiltonian', coordinates = ['x', 'y'], momenta = ['u', 'v'], "
      "parameters = [" +
          parameters + "], hamiltonian = '" + hamiltonian + "'}",
      "test.toml"));
}

System field(const std::string& x, const std::string& y, const std::string& z,
             const std::string& parameters) {
  return read_system(parse_document(
      "[system]\nkind = 'vector-field'\ncoordinates = ['x', 'y', 'z']\nparameters = [" +
          parameters + "]\n[system.field]\nx = '" + x + "'\ny = '" + y + "'\nz = '" + z + "'\n",
      "test.toml"));
}

/// The equations of the sets on which something was found, as texts.
std::vector<std::vector<std::string>> where_found(const IntegralSearch& search) {
  std::vector<std::vector<std::string>> all;
  for (const IntegralsOfSet& s : search.sets) {
    all.emplace_back();
    for (const MPoly& f : s.equations)
      all.back().push_back(to_string(f));
  }
  return all;
}

bool all_proved(const IntegralSearch& search) {
  return std::all_of(search.sets.begin(), search.sets.end(), [](const IntegralsOfSet& s) {
    return s.complete_for_smooth && s.liouville && s.commuting.size() == 2;
  });
}

TEST(Integrals, HenonHeiles) {
  const auto found = find_integrals(
      planar("(u^2 + v^2 + A*x^2 + B*y^2)/2 + x^2*y + b/3*y^3", "'A', 'B', 'b'"), {.degree = 4});
  EXPECT_THAT(where_found(found),
              UnorderedElementsAre(ElementsAre("b - 1", "A - B"), ElementsAre("b - 6"),
                                   ElementsAre("b - 16", "B", "A"),
                                   ElementsAre("b - 16", "16*A - B")));
  EXPECT_TRUE(all_proved(found));
  ASSERT_TRUE(found.elsewhere);
  EXPECT_EQ(found.elsewhere->found(), 0);
  EXPECT_TRUE(found.elsewhere->complete_for_smooth);
}

// No number stands in front, and the first coefficient is positive.
TEST(Integrals, ArePrimitive) {
  for (const char* h :
       {"(u^2 + v^2)/2 + x*y", "(u^2 + v^2)/2 + 3*(x*v - y*u)", "(u^2 + v^2)/2 + k*(x^2 + y^2)",
        "(u^2 + v^2)/2 + 2*x^3 + 6*x*y^2", "(u^2 + v^2)/2 + k*(x*v - y*u) + k^2*(x^2 + y^2)/2"})
    for (const IntegralsOfSet& set : find_integrals(planar(h, "'k'"), {.degree = 2}).sets)
      for (const FoundIntegral& f : set.integrals) {
        if (f.hamiltonian) continue;
        Integer content;
        for (long i = 0; i < f.value.num().length(); ++i)
          content = gcd(content, f.value.num().coefficient(i));
        EXPECT_EQ(content, Integer(1)) << h << ": " << to_string(f);
        EXPECT_GT(sign(f.value.num().coefficient(0)), 0) << h << ": " << to_string(f);
      }
}

// The same with the axes exchanged, other units, and a potential that is shifted.
TEST(Integrals, AnotherFrame) {
  const auto found = find_integrals(
      planar("(u^2 + 4*v^2)/2 + x*y^2 + b*x^3 + c*(x + y)", "'b', 'c'"), {.degree = 2});
  EXPECT_TRUE(all_proved(found));
  // y = 2 Y, v = V/2: (u^2 + V^2)/2 + 4 (x Y^2 + b x^3/4) + c (x + 2 Y), so b/4 = 2 (1:6) or, where
  // the linear force allows it, 1/3 (1:1).
  for (const auto& equations : where_found(found))
    EXPECT_THAT(equations, testing::AnyOf(testing::Contains("b - 8"), testing::Contains("3*b - 4")))
        << testing::PrintToString(equations);
  EXPECT_THAT(found.sets, testing::SizeIs(testing::Ge(2)));
}

TEST(Integrals, QuarticPotentials) {
  const auto found = find_integrals(planar("(u^2 + v^2)/2 + x^4 + b*x^2*y^2 + c*y^4", "'b', 'c'"));
  for (const auto& equations : where_found(found))
    EXPECT_THAT(equations,
                testing::AnyOf(ElementsAre("b"), ElementsAre("c", "b"),
                               ElementsAre("c - 1", "b - 2"), ElementsAre("c - 1", "b - 6"),
                               ElementsAre("c - 16", "b - 12"), ElementsAre("16*c - 1", "4*b - 3"),
                               ElementsAre("c - 1", "b")))
        << testing::PrintToString(equations);
  EXPECT_TRUE(all_proved(found));
}

// A leading coefficient that vanishes makes no new integral, and loses none.
TEST(Integrals, WhereTheKineticEnergyDegeneratesNothingSmoothIsExcluded) {
  const auto found = find_integrals(planar("u^2 + m*v^2 + x*y", "'m'"), {.degree = 1});
  ASSERT_EQ(found.sets.size(), 1);
  EXPECT_THAT(where_found(found), ElementsAre(ElementsAre("m")));
  EXPECT_TRUE(found.sets[0].complete);
  EXPECT_EQ(to_string(found.sets[0].integrals.at(1).value), "y");
  EXPECT_FALSE(found.sets[0].complete_for_smooth); // y is constant, and so is any function of it
  EXPECT_TRUE(found.elsewhere->complete_for_smooth);
}

TEST(Integrals, PowersOfTheHamiltonianAreNothingNew) {
  for (const char* h : {"(u^2 + v^2)/2 + x^4*y + y^3 + x", "u^2 + v^2 + 2*u*v/3 + x^3*y + x"}) {
    const auto found = find_integrals(planar(h), {.degree = 4});
    EXPECT_THAT(found.sets, IsEmpty()) << h;
    EXPECT_EQ(found.elsewhere->integrals.size(), 1) << h;
    EXPECT_TRUE(found.elsewhere->complete_for_smooth) << h;
  }
}

// With u v = 1 undeclared, u v is a constant and not an integral; nothing is said to be complete.
TEST(Integrals, FunctionSymbolsProveNoAbsence) {
  const System s = read_system(parse_document(
      "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['p', 'r']\n"
      "hamiltonian = '(p^2 + r^2)/2 + u + v*y^2'\n"
      "[[system.function]]\nname = 'u'\nderivative = { x = 'u' }\n"
      "[[system.function]]\nname = 'v'\nderivative = { x = '-v' }\n",
      "test.toml"));
  const auto found = find_integrals(s, {.degree = 2});
  EXPECT_THAT(found.sets, IsEmpty());
  EXPECT_FALSE(found.elsewhere->complete);
  EXPECT_FALSE(found.elsewhere->complete_for_smooth);
  EXPECT_TRUE(found.elsewhere->only_declared_relations);
}

TEST(Integrals, TheTop) {
  const System top = read_system(parse_document(
      "system = {kind = 'euler-poisson', coordinates = ['M1', 'M2', 'M3', 'G1', 'G2', 'G3'], "
      "parameters = ['c', 'x'], hamiltonian = '(M1^2 + M2^2 + c*M3^2)/2 + x*G1'}\n"
      "assume = {x = 'nonzero'}",
      "top.toml"));
  const auto found = find_integrals(top, {.degree = 4});
  EXPECT_THAT(where_found(found), UnorderedElementsAre(ElementsAre("c - 1"), ElementsAre("c - 2")));
  for (const IntegralsOfSet& s : found.sets)
    EXPECT_TRUE(s.liouville && s.complete && s.commuting.size() == 4);
  EXPECT_EQ(found.elsewhere->integrals.size(), 3);
}

TEST(Integrals, LotkaVolterra) {
  const auto found =
      find_integrals(field("x*(a*y + z)", "y*(b*z + x)", "z*(c*x + y)", "'a', 'b', 'c'"),
                     {.degree = 1, .darboux = false});
  EXPECT_THAT(where_found(found), ElementsAre(ElementsAre("a*b*c + 1")));
}

// At a = 0 y is constant; (x + a y)^3 with a^2 = -1 is a null direction, and has p, too.
TEST(Integrals, ComplexParameterValues) {
  const auto found =
      find_integrals(planar("(u^2 + a*v^2)/2 + (x^2 + y^2)^2", "'a'"), {.degree = 1});
  EXPECT_THAT(where_found(found), UnorderedElementsAre(ElementsAre("a - 1"), ElementsAre("a")));
  const auto line = find_integrals(planar("(u^2 + v^2)/2 + (x + a*y)^3", "'a'"), {.degree = 2});
  bool null_direction = false;
  for (const IntegralsOfSet& s : line.sets) {
    EXPECT_TRUE(s.liouville);
    for (const MPoly& f : s.equations)
      if (to_string(f) == "a^2 + 1") null_direction = true;
  }
  EXPECT_TRUE(null_direction);
}

TEST(Integrals, ABudgetEndsInWhatIsKnown) {
  const auto found =
      find_integrals(planar("(u^2 + v^2 + A*x^2 + B*y^2)/2 + x^2*y + b/3*y^3", "'A', 'B', 'b'"),
                     {.degree = 4, .budget = Budget::of_seconds(0)});
  EXPECT_FALSE(found.finished());
  EXPECT_FALSE(found.elsewhere);
}

System poisson(const std::string& bracket, const std::string& hamiltonian,
               const std::string& assumed) {
  return read_system(parse_document(
      "system = {kind = 'poisson', coordinates = ['x', 'y', 'z', 'w'], parameters = ['a'], "
      "bracket = [" +
          bracket + "], hamiltonian = '" + hamiltonian + "'}\nassume = {conditions = [" + assumed +
          "]}",
      "test.toml"));
}

// What the file assumes restricts the answer, and is said with it.
TEST(Integrals, AssumedEquationsStayWithTheAnswer) {
  const auto found = find_integrals(poisson("['0', 'x*y', '0', '0'], ['-x*y', '0', '0', '0'], "
                                            "['0', '0', '0', 'a*z'], ['0', '0', '-a*z', '0']",
                                            "x + y + z + w", "'a = 0'"),
                                    {.degree = 1});
  ASSERT_EQ(found.assumed_equations.size(), 1U);
  EXPECT_EQ(to_string(found.assumed_equations.front()), "a");
  const System sharp = read_system(parse_document(
      "system = {kind = 'hamiltonian', coordinates = ['x', 'y'], momenta = ['u', 'v'], parameters "
      "= ['b'], hamiltonian = '(u^2 + v^2)/2 + b*x^2*y'}\nassume = {conditions = ['b = 1']}",
      "test.toml"));
  EXPECT_EQ(find_integrals(sharp).assumed_equations.size(), 1U);
}

// Where the bracket or a denominator has no meaning nothing is said.
TEST(Integrals, DenominatorsOfTheBracketAreLeftOut) {
  const auto found = find_integrals(poisson("['0', 'z/a', '-y/a', '0'], ['-z/a', '0', 'x/a', '0'], "
                                            "['y/a', '-x/a', '0', '0'], ['0', '0', '0', '0']",
                                            "a*(x^2 + 2*y^2 + 3*z^2)/2", ""),
                                    {.degree = 2});
  EXPECT_TRUE(found.not_covered.empty()); // where a = 0 there is no system
}

System on_a_circle(const std::string& potential) {
  return read_system(parse_document(
      "[system]\nkind = 'hamiltonian'\ncoordinates = ['x']\nmomenta = ['u']\nparameters = ['a']\n"
      "relations = ['s^2 + c^2 = 1']\nhamiltonian = 'u^2/2 + " +
          potential +
          "'\n[[system.function]]\nname = 's'\nderivative = {x = 'c'}\n[[system.function]]\nname = "
          "'c'\nderivative = {x = '-s'}\n",
      "test.toml"));
}

TEST(Integrals, DenominatorsAreReducedByTheRelations) {
  const auto found = find_integrals(on_a_circle("1/(s^2 + c^2 - a)"), {.degree = 1});
  ASSERT_EQ(found.not_covered.size(), 1U);
  EXPECT_EQ(to_string(found.not_covered.front()), "a - 1");
  EXPECT_THROW(static_cast<void>(find_integrals(on_a_circle("1/(s^2 + c^2 - 1)"))), InputError);
}

// After a limit nothing is gathered: what was decided stays in the list.
TEST(Integrals, ElsewhereIsSaidOnlyOfAWholeSearch) {
  const std::string cubic = "(u^2 + v^2)/2 + a*x^3 + b*x^2*y + c*x*y^2 + d*y^3";
  const auto found = find_integrals(planar(cubic, "'a', 'b', 'c', 'd'"), {.max_sets = 2});
  EXPECT_FALSE(found.finished());
  EXPECT_FALSE(found.elsewhere);
}

TEST(Integrals, ContradictoryAssumptions) {
  const System s = read_system(parse_document(
      "system = {kind = 'hamiltonian', coordinates = ['x'], momenta = ['u'], parameters = ['a'], "
      "hamiltonian = 'u^2 + a*x^2'}\nassume = {conditions = ['a = 0', 'a - 0 != 0']}",
      "test.toml"));
  EXPECT_THROW(static_cast<void>(find_integrals(s)), InvalidArgument);
}

System of(const std::string& text) { return read_system(parse_document(text, "test.toml")); }

// Rational and algebraic potentials: the highest part is a Killing tensor, denominators come below.
TEST(Integrals, PotentialsThatAreNoPolynomials) {
  const auto search = [](const System& s, long degree) {
    IntegralOptions options;
    options.degree = degree;
    options.until_integrable = true;
    return find_integrals(s, options);
  };
  const auto is_integrable = [](const IntegralSearch& found) {
    const auto& set = found.sets.empty() ? *found.elsewhere : found.sets.front();
    return set.liouville;
  };
  EXPECT_TRUE(is_integrable(search(planar("(u^2 + v^2)/2 + 3/x^2 + 5/y^2 + x^2 + y^2"), 2)));
  EXPECT_FALSE(is_integrable(search(planar("(u^2 + v^2)/2 + 3/x^2 + 5/y^2 + x^2 + 2*y^2*x"), 2)));
  const std::string root = // r^2 = x^2 + y^2
      "relations = ['r^2 = x^2 + y^2']\n[[system.function]]\nname = 'r'\n"
      "derivative = {x = 'x/r', y = 'y/r'}\n";
  const std::string two = "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\n"
                          "momenta = ['u', 'v']\nhamiltonian = '(u^2 + v^2)/2 + ";
  EXPECT_TRUE(is_integrable(search(of(two + "1/r + x'\n" + root), 2))); // Stark
  EXPECT_FALSE(is_integrable(search(of(two + "1/r + x^2'\n" + root), 2)));
  const std::string cube =
      "relations = ['w^3 = x']\n[[system.function]]\nname = 'w'\nderivative = {x = '1/(3*w^2)'}\n";
  EXPECT_TRUE( // Holt: a cubic integral
      is_integrable(search(of(two + "3/4*w^4 + (y^2 + 2)/w^2'\n" + cube), 3)));
}

// Where V grows, so do the numerators, with each power of the denominator.
TEST(Integrals, RationalPotentialsThatGrow) {
  const auto generic_set = [](const std::string& h, long degree) {
    const auto found = find_integrals(planar(h, "'a', 'b'"), {.degree = degree});
    const auto whole = std::find_if(found.sets.begin(), found.sets.end(),
                                    [](const auto& s) { return s.equations.empty(); });
    return whole == found.sets.end() ? IntegralsOfSet{} : *whole;
  };
  const std::vector<std::pair<std::string, long>> integrable = {
      {"(u^2 + v^2)/2 + a*(x^4 + 12*x^2*y^2 + 16*y^4) + b/x^2", 2},
      {"u*v/2 + a*(5*x^4 - 60*x^3*y + 126*x^2*y^2 - 60*x*y^3 + 5*y^4) + b/(x + y)^2", 2},
      {"((u + 2*x*y)^2 + (v + x^2)^2)/2 + a*(x^4 + 12*x^2*y^2 + 16*y^4) + b/x^2", 2}, // a gauge
      {"(u^2 + v^2 + a*x^2 + 16*a*y^2)/2 + x^2*y + 16*y^3/3 + b/x^2", 4}, // Henon-Heiles KK
      {"(u^2 + v^2)/2 + x*y^2 + 2*x^3 + a/y^2", 2}};
  for (const auto& [h, degree] : integrable) {
    const auto set = generic_set(h, degree);
    EXPECT_TRUE(set.liouville && set.complete && !set.complete_for_smooth) << h;
    EXPECT_THAT(set.searched, testing::EndsWith("rational functions of the coordinates")) << h;
  }
  const auto none = find_integrals(planar("(u^2 + v^2)/2 + x^4 + y/x^2"), {.degree = 3});
  EXPECT_TRUE(none.sets.empty() && none.elsewhere->complete);
}

// Polynomials beside momenta of degree 1: no denominator, and smooth coefficients are polynomials.
TEST(Integrals, MagneticFieldsNeedNoBound) {
  const auto search = [](const std::string& h) {
    const auto found = find_integrals(planar(h), {.degree = 2});
    return found.sets.empty() ? *found.elsewhere : found.sets.front();
  };
  const auto separable = search("((u + x^2*y)^2 + (v + x^3/3)^2)/2 + x^4 + y^6");
  EXPECT_TRUE(separable.liouville && separable.complete_for_smooth);
  const auto none = search("((u + y^3)^2 + (v - x^3)^2)/2 + x^4 + y^6 + x");
  EXPECT_TRUE(!none.liouville && none.complete_for_smooth);
}

// Momentum first, then what commutes with it: n integrals in involution, and not only n of them.
TEST(Integrals, TheSearchForIntegrabilityAsksForInvolution) {
  const System s = of(
      "system = {kind = 'hamiltonian', coordinates = ['x', 'y', 'z'], momenta = ['u', 'v', 'w'], "
      "hamiltonian = '(u^2 + v^2 + w^2)/2 + 1/(x-y)^2 + 1/(y-z)^2 + 1/(z-x)^2'}");
  IntegralOptions options;
  options.degree = 3;
  options.until_integrable = true;
  const auto found = find_integrals(s, options);
  ASSERT_EQ(found.sets.size(), 1U);
  EXPECT_TRUE(found.sets.front().liouville);
  EXPECT_EQ(found.sets.front().commuting.size(), 3U);
  EXPECT_FALSE(found.sets.front().complete); // there are others, not in involution
}

/// Integrable with as many integrals in involution, on every set.
void expect_integrable(const System& s, std::size_t commuting, long degree) {
  for (const bool until : {false, true}) {
    IntegralOptions options;
    options.degree = degree;
    options.until_integrable = until;
    const auto found = find_integrals(s, options);
    std::vector<IntegralsOfSet> sets = found.sets;
    if (found.elsewhere) sets.push_back(*found.elsewhere);
    ASSERT_FALSE(sets.empty());
    for (const IntegralsOfSet& set : sets) {
      EXPECT_TRUE(set.liouville);
      ASSERT_EQ(set.commuting.size(), commuting);
      for (const std::size_t i : set.commuting)
        for (const std::size_t j : set.commuting)
          EXPECT_TRUE(
              is_zero(poisson_bracket(s.field, set.integrals[i].value, set.integrals[j].value)));
    }
  }
}

// The angular momenta do not commute; the square of one does with all.
TEST(Integrals, CentralPotentialsInSpace) {
  const std::string space = "system = {kind = 'hamiltonian', coordinates = ['x', 'y', 'z'], "
                            "momenta = ['u', 'v', 'w'], parameters = ['b'], hamiltonian = "
                            "'(u^2 + v^2 + w^2)/2 + ";
  for (const char* potential : {"(x^2 + y^2 + z^2)^3", "(x^2 + y^2 + z^2)^2 + b*(x^2 + y^2 + z^2)",
                                "1/(x^2 + y^2 + z^2)^2 + b*(x^2 + y^2 + z^2)^2"})
    expect_integrable(of(space + potential + "'}"), 3, 1);
  expect_integrable(of("system = {kind = 'hamiltonian', coordinates = ['x', 'y', 'z', 't'], "
                       "momenta = ['u', 'v', 'w', 's'], hamiltonian = "
                       "'(u^2 + v^2 + w^2 + s^2)/2 + (x^2 + y^2 + z^2 + t^2)^2'}"),
                    4, 1);
}

// Three spins with two bonds: the total spin, and the square of it.
TEST(Integrals, SpinsWithTwoBonds) {
  expect_integrable(of(R"t([system]
kind = "poisson"
coordinates = ["S1", "S2", "S3", "T1", "T2", "T3", "R1", "R2", "R3"]
hamiltonian = "S1*T1 + S2*T2 + S3*T3 + 2*(T1*R1 + T2*R2 + T3*R3)"
bracket = [
  ["0", "S3", "-S2", "0", "0", "0", "0", "0", "0"],
  ["-S3", "0", "S1", "0", "0", "0", "0", "0", "0"],
  ["S2", "-S1", "0", "0", "0", "0", "0", "0", "0"],
  ["0", "0", "0", "0", "T3", "-T2", "0", "0", "0"],
  ["0", "0", "0", "-T3", "0", "T1", "0", "0", "0"],
  ["0", "0", "0", "T2", "-T1", "0", "0", "0", "0"],
  ["0", "0", "0", "0", "0", "0", "0", "R3", "-R2"],
  ["0", "0", "0", "0", "0", "0", "-R3", "0", "R1"],
  ["0", "0", "0", "0", "0", "0", "R2", "-R1", "0"]]
)t"),
                    6, 2);
}

// x^2 is r^2 - y^2 + ... modulo the relations: the highest part contains it all the same.
TEST(Integrals, DistancesToTwoCentres) {
  const std::string centres =
      "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
      "parameters = ['n']\nhamiltonian = '(u^2 + v^2)/2 - 1/r - n/s'\n"
      "relations = ['r^2 = (x - 1)^2 + y^2', 's^2 = (x + 1)^2 + y^2']\n"
      "[[system.function]]\nname = 'r'\nderivative = {x = '(x - 1)/r', y = 'y/r'}\n"
      "[[system.function]]\nname = 's'\nderivative = {x = '(x + 1)/s', y = 'y/s'}\n";
  const auto found = find_integrals(of(centres), {.degree = 2});
  for (const IntegralsOfSet& set : found.sets)
    EXPECT_TRUE(set.liouville);
  EXPECT_FALSE(found.sets.empty());
  EXPECT_FALSE(found.elsewhere);
}

// In a magnetic field {P, Q} is a constant: no function of P and Q commutes with P but those of P.
TEST(Integrals, NoFunctionOfTwoConjugateOnesIsNew) {
  IntegralOptions options;
  options.degree = 1;
  options.until_integrable = true;
  const auto found =
      find_integrals(of("system = {kind = 'hamiltonian', coordinates = ['x', 'y', 'z'], momenta = "
                        "['u', 'v', 'w'], "
                        "hamiltonian = '((u + y/2)^4 + (v - x/2)^2 + w^2)/2 + z^4'}"),
                     options);
  ASSERT_EQ(found.sets.size(), 1U);
  EXPECT_EQ(found.sets.front().integrals.size(), 3U);
  EXPECT_EQ(found.sets.front().commuting.size(), 2U);
  EXPECT_FALSE(found.sets.front().liouville);
}

// Angles stay out of the ansatz; the sum of the momenta is found all the same.
TEST(Integrals, Angles) {
  const System s = of(
      "[system]\nkind = 'hamiltonian'\ncoordinates = ['f', 'g']\nmomenta = ['p', 'q']\n"
      "hamiltonian = '(p^2 - 2*p*q*c + 2*q^2)/(2*(1 + s^2))'\nrelations = ['s^2 + c^2 = 1']\n"
      "[[system.function]]\nname = 's'\nmeans = 'sin(f - g)'\nderivative = {f = 'c', g = '-c'}\n"
      "[[system.function]]\nname = 'c'\nmeans = 'cos(f - g)'\nderivative = {f = '-s', g = 's'}\n");
  IntegralOptions options;
  options.degree = 2;
  options.until_integrable = true;
  const auto found = find_integrals(s, options);
  ASSERT_EQ(found.sets.size(), 1U);
  EXPECT_TRUE(found.sets.front().liouville);
}

// r^2 - x^2 - y^2 is 0, however it is written.
TEST(Integrals, TheShortestFormOfZero) {
  const System s = planar("(u^2 + v^2)/2 - 1/sqrt(x^2 + y^2)");
  for (const char* zero : {"0", "root1^2 - x^2 - y^2", "(u - v)*(x^2 + y^2 - root1^2)/root1",
                           "root1^4*v - (x^2+y^2)^2*v"})
    EXPECT_TRUE(is_zero(shortest_form(s.field, formula(s, zero)))) << zero;
  EXPECT_EQ(to_string(shortest_form(s.field, formula(s, "x^2 + y^2 - u - root1^2"))), "u");
}

} // namespace
} // namespace kov
