#include "moves/splitting.hpp"

#include "families.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace kov {
namespace {

std::vector<std::string> names(const System& s, const std::vector<std::size_t>& all) {
  std::vector<std::string> text;
  for (const std::size_t i : all)
    text.push_back(s.ring()->name(i));
  return text;
}
std::size_t families(const SplittingFinding& found) {
  std::size_t sum = 0;
  for (const OrderOfMoments& o : found.orders)
    sum += o.left.size();
  return sum;
}

TEST(SplittingMove, HeavyTopHasNoFamilyThatIsLeft) {
  const System s = heavy_top_family();
  const auto found = find_splitting(s, {});
  ASSERT_TRUE(found);
  EXPECT_THAT(names(s, found->direction), testing::ElementsAre("L1", "L2", "L3"));
  EXPECT_EQ(found->orders.size(), 6U);
  EXPECT_EQ(families(*found), 0U);
  const Exclusion e = exclusion(s, *found);
  EXPECT_EQ(e.by.integrals.kind, IntegralClass::Kind::real_analytic);
  EXPECT_EQ(e.not_all_zero.size(), 4U); // three differences of moments, and L
}

// Names that the criterion uses for its own variables.
TEST(SplittingMove, ParametersMayHaveAnyNames) {
  const System s = on_e3("'i', 'g', 'Y', 'L', 'z', 'p'",
                         "M1^2/(2*i) + M2^2/(2*g) + M3^2/(2*Y) + L*G1 + z*G2 + p*G3",
                         "[assume]\ni = 'positive'\ng = 'positive'\nY = 'positive'\n"
                         "L = 'real'\nz = 'real'\np = 'real'\n");
  const auto found = find_splitting(s, {});
  ASSERT_TRUE(found);
  EXPECT_THAT(names(s, found->direction), testing::ElementsAre("L", "z", "p"));
  EXPECT_EQ(families(*found), 0U);
}

// Moments may be given by their inverses.
TEST(SplittingMove, InverseMoments) {
  const System s = on_e3("'a', 'b', 'c', 'L1'", "(a*M1^2 + b*M2^2 + c*M3^2)/2 + L1*G1",
                         "[assume]\na = 'positive'\nb = 'positive'\nc = 'positive'\nL1 = 'real'\n");
  const auto found = find_splitting(s, {});
  ASSERT_TRUE(found);
  EXPECT_EQ(to_string(found->body.moments[0]), "1/a");
  EXPECT_EQ(found->orders.size(), 6U);
}

// What is written with a parameter may be written with its opposite: the same sets are excluded.
TEST(SplittingMove, AParameterMayBeNegative) {
  using Sets = std::set<std::set<std::string>>;
  const auto sets = [](const System& s, const Substitution& opposites) {
    Sets all;
    const auto found = find_splitting(s, {});
    if (!found) return all;
    for (const auto& list : exclusion(s, *found).not_all_zero) {
      std::set<std::string> one;
      for (const MPoly& f : list) {
        const MPoly g = substitute(f, opposites).num();
        one.insert(to_string(sign(g.coefficient(0)) < 0 ? -g : g));
      }
      all.insert(one);
    }
    return all;
  };
  const auto system = [](bool opposite, const std::string& order) {
    const auto sign = [&](const std::string& p) { return opposite ? "(-" + p + ")" : p; };
    return on_e3("'a', 'B', 'c', 'k', 'l', 'L2'",
                 sign("a") + "*M1^2/2 + M2^2/(2*B) + M3^2/(2*" + sign("c") + ") + (" + sign("k") +
                     " + l)*G1 + L2*G2",
                 "[assume]\nB = 'positive'\nl = 'positive'\nL2 = 'real'\nconditions = ['" +
                     sign("a") + " > 0', '" + sign("c") + " > 0', '" + sign("k") + " > 0'" + order +
                     "]\n");
  };
  Substitution opposites;
  const System negative = system(true, "");
  for (const char* name : {"a", "c", "k"})
    opposites[negative.ring()->index(name)] =
        -MFraction::variable(negative.ring(), negative.ring()->index(name));
  const Sets plain = sets(system(false, ""), {});
  EXPECT_GE(plain.size(), 4U);
  EXPECT_EQ(sets(negative, opposites), plain);
  const auto ordered =
      find_splitting(system(true, ", 'a*B > -1', 'B + c > 0'"), {}); // 1/-a > B > -c
  ASSERT_TRUE(ordered);
  ASSERT_EQ(ordered->orders.size(), 1U);
  EXPECT_EQ(ordered->orders.front().axes, (std::array<std::size_t, 3>{0, 1, 2}));
}

// Or they are numbers, or multiples of one another: what holds for all moments holds for these.
TEST(SplittingMove, MomentsThatAreNoParameters) {
  const std::string assumed = "[assume]\nA = 'positive'\nL1 = 'real'\nL2 = 'real'\nL3 = 'real'\n";
  const System numbers = on_e3("'L1', 'L2', 'L3'", "M1^2/4 + M2^2/6 + M3^2/8 + " + weight,
                               "[assume]\nL1 = 'real'\nL2 = 'real'\nL3 = 'real'\n");
  const auto found = find_splitting(numbers, {});
  ASSERT_TRUE(found);
  ASSERT_EQ(found->orders.size(), 1U); // 4 > 3 > 2
  EXPECT_EQ(found->orders.front().axes, (std::array<std::size_t, 3>{2, 1, 0}));
  EXPECT_EQ(families(*found), 0U);
  const Exclusion e = exclusion(numbers, *found);
  ASSERT_EQ(e.not_all_zero.size(), 1U); // L1, L2, L3 are not all 0
  EXPECT_EQ(e.not_all_zero.front().size(), 3U);
  const System twice =
      on_e3("'A', 'L1', 'L2', 'L3'", "M1^2/(2*A) + M2^2/(4*A) + M3^2/6 + " + weight, assumed);
  const auto some = find_splitting(twice, {});
  ASSERT_TRUE(some);
  EXPECT_EQ(some->orders.size(), 3U); // 2 A > A: where 3 stands
  // a sign that is not known, and two equal moments
  EXPECT_FALSE(
      find_splitting(on_e3("'A', 'L1', 'L2', 'L3'", "M1^2/(2*A) + M2^2/6 + M3^2/8 + " + weight,
                           "[assume]\nL1 = 'real'\nL2 = 'real'\nL3 = 'real'\n"),
                     {}));
  EXPECT_FALSE(find_splitting(on_e3("'L1', 'L2', 'L3'", "M1^2/4 + M2^2/4 + M3^2/8 + " + weight,
                                    "[assume]\nL1 = 'real'\nL2 = 'real'\nL3 = 'real'\n"),
                              {}));
  EXPECT_FALSE(find_splitting(on_e3("'L1', 'L2', 'L3'", "M1^2/4 - M2^2/6 + M3^2/8 + " + weight,
                                    "[assume]\nL1 = 'real'\nL2 = 'real'\nL3 = 'real'\n"),
                              {}));
}

TEST(SplittingMove, AnOrderThatIsAssumedIsTheOnlyOne) {
  const System s = heavy_top_family(body_assumed + "conditions = ['A > B', 'B > C']\n");
  const auto found = find_splitting(s, {});
  ASSERT_TRUE(found);
  ASSERT_EQ(found->orders.size(), 1U);
  EXPECT_EQ(found->orders.front().axes, (std::array<std::size_t, 3>{0, 1, 2}));
}

// A factor without a sign: nothing is said where it is 0.
TEST(SplittingMove, AFactorOfThePerturbation) {
  const System s = on_e3("'A', 'B', 'C', 'g', 'L1', 'L2', 'L3'", free_top + " + g*(" + weight + ")",
                         body_assumed + "g = 'real'\n");
  const auto found = find_splitting(s, {});
  ASSERT_TRUE(found);
  const Exclusion e = exclusion(s, *found);
  const auto says = [&](const MPoly& f) {
    return std::find(e.not_all_zero.begin(), e.not_all_zero.end(), std::vector{f}) !=
               e.not_all_zero.end() ||
           std::any_of(found->direction.begin(), found->direction.end(),
                       [&](std::size_t p) { return MPoly::variable(s.ring(), p) == f; });
  };
  EXPECT_TRUE(says(MPoly::variable(s.ring(), "g")));
}

// Parameters without a sign are independent of one another: nothing is said where a factor of H1 vanishes.
TEST(SplittingMove, FactorsOfParametersWithoutSign) {
  struct Factor {
    std::string text;
    long k, l; // a zero
  };
  for (const Factor& x :
       {Factor{"1 + k - l", 1, 2}, Factor{"1 + k^2 - k*l", 1, 2}, Factor{"2 + l - k", 2, 0}}) {
    const System s = on_e3("'A', 'B', 'C', 'k', 'l', 'L1'", free_top + " + L1*(" + x.text + ")*G1",
                           "[assume]\nA = 'positive'\nB = 'positive'\nC = 'positive'\n"
                           "L1 = 'real'\nk = 'real'\nl = 'real'\n");
    const auto found = find_splitting(s, {});
    ASSERT_TRUE(found) << x.text;
    const Substitution zero{{s.ring()->index("k"), MFraction(s.ring(), Rational(x.k))},
                            {s.ring()->index("l"), MFraction(s.ring(), Rational(x.l))}};
    const auto vanishes = [&](const MPoly& f) { return is_zero(substitute(f, zero)); };
    const Exclusion e = exclusion(s, *found);
    EXPECT_TRUE(std::any_of(e.not_all_zero.begin(), e.not_all_zero.end(), [&](const auto& some) {
      return std::all_of(some.begin(), some.end(), vanishes);
    })) << x.text;
  }
}

// Without it the integrals of the class need not be excluded: complex L, moments without a sign.
TEST(SplittingMove, EverythingIsReal) {
  EXPECT_FALSE(find_splitting(heavy_top_family("[assume]\nA = 'positive'\nB = 'positive'\n"
                                               "C = 'positive'\nL1 = 'real'\nL2 = 'real'\n"),
                              {}));
  EXPECT_FALSE(find_splitting(heavy_top_family("[assume]\nA = 'real'\nB = 'positive'\n"
                                               "C = 'positive'\nL1 = 'real'\nL2 = 'real'\n"
                                               "L3 = 'real'\n"),
                              {}));
}

// There is no change of scale that makes L small beside 1, or the moments are equal.
TEST(SplittingMove, WhereThereIsNoSmallParameter) {
  EXPECT_FALSE(find_splitting(on_e3("'A', 'B', 'C'", free_top + " + G1",
                                    "[assume]\nA = 'positive'\nB = 'positive'\nC = 'positive'\n"),
                              {}));
  EXPECT_FALSE(find_splitting(on_e3("'A', 'C', 'L1'", "(M1^2 + M2^2)/(2*A) + M3^2/(2*C) + L1*G1",
                                    "[assume]\nA = 'positive'\nC = 'positive'\nL1 = 'real'\n"),
                              {}));
}

System sliding_top(const std::string& conditions) {
  return read_system(parse_document(
      "[system]\nkind = 'lagrangian'\n"
      "coordinates = ['M1', 'M2', 'M3', 'G1', 'G2', 'G3']\n"
      "angular_velocity = ['W1', 'W2', 'W3']\n"
      "parameters = ['A', 'B', 'C', 'L1', 'L2', 'L3']\n"
      "lagrangian = '(A*W1^2 + B*W2^2 + C*W3^2 + s^2)/2'\n"
      "define = {s = 'G1*(W2*L3 - W3*L2) + G2*(W3*L1 - W1*L3) + G3*(W1*L2 - W2*L1)'}\n" +
          body_assumed + "conditions = ['A > B', 'B > C'" + conditions + "]\n",
      "sliding.toml"));
}

// The second family, A + C = 4 B, violates the triangle inequality strictly: it is left where nothing is
// assumed of it.
TEST(SplittingMove, FamiliesThatAreLeft) {
  const System free = sliding_top(""), body = sliding_top(", 'B + C >= A'");
  const auto all = find_splitting(free, {}), some = find_splitting(body, {});
  ASSERT_TRUE(all);
  ASSERT_TRUE(some);
  EXPECT_EQ(all->order, 2);
  EXPECT_EQ(families(*all), 2U);
  ASSERT_EQ(families(*some), 1U);
  const auto& left = some->orders.front().left.front();
  const MPoly a = MPoly::variable(body.ring(), "A"), b = MPoly::variable(body.ring(), "B"),
              c = MPoly::variable(body.ring(), "C");
  const MPoly condition = a + a - b - b - c;
  EXPECT_TRUE(std::any_of(left.begin(), left.end(),
                          [&](const MPoly& f) { return f == condition || f == -condition; }));
  EXPECT_EQ(left.size(), 3U);         // and L2 = L3 = 0
  EXPECT_TRUE(some->trusted.empty()); // the judge accepts the proof that the other one is empty
}

// The sums depend on the levels: the criterion says nothing, and that is no error.
TEST(SplittingMove, SumsThatDependOnTheLevels) {
  EXPECT_FALSE(find_splitting(
      on_e3("'A', 'B', 'C', 'k'", free_top + " + k*G1^2*G2",
            "[assume]\nA = 'positive'\nB = 'positive'\nC = 'positive'\nk = 'real'\n"),
      {}));
}

// Clebsch's condition where one coefficient is 0 is B k - C k - A c + B c = 0: both coefficients have one sign for each
// order of the moments, k and c have not.
TEST(SplittingMove, ADirectionHasNoSigns) {
  const std::string assumed =
      "[assume]\nA = 'positive'\nB = 'positive'\nC = 'positive'\nk = 'real'\nc = 'real'\n";
  for (const std::string potential : {"k*G1^2 + c*G3^2", "k*G2^2 + c*G3^2", "k*G1^2 + c*G2^2"}) {
    const auto found =
        find_splitting(on_e3("'A', 'B', 'C', 'k', 'c'", free_top + " + " + potential, assumed), {});
    ASSERT_TRUE(found) << potential;
    EXPECT_EQ(found->orders.size(), 6U);
    for (const OrderOfMoments& o : found->orders) {
      ASSERT_FALSE(o.left.empty()) << potential;
      for (const auto& equations : o.left)
        for (const MPoly& f : equations)
          EXPECT_FALSE(is_constant(f)) << potential << ": " << to_string(f);
    }
  }
}

// Clebsch: M1^2 ... with a quadratic potential; the family of integrable ones must be among what is left.
TEST(SplittingMove, AnIntegrablePotentialIsLeft) {
  const System s = on_e3("'A', 'B', 'C', 'k'", free_top + " + k*(A*G1^2 + B*G2^2 + C*G3^2)/2",
                         "[assume]\nA = 'positive'\nB = 'positive'\nC = 'positive'\nk = 'real'\n");
  EXPECT_FALSE(find_splitting(s, {})); // all of them: it says nothing
}

} // namespace
} // namespace kov
