// Families: the ones with a natural number d, all of them, without listing the others.

#include "kovacic/exponents.hpp"
#include "kovacic/families.hpp"
#include "kovacic/reader.hpp"
#include "kovacic/solve.hpp"
#include "support/equations.hpp"

#include "exact/error.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace kov::kovacic::families_test {
namespace {

using testing::from_omega;
using testing::from_square;
using testing::pull_back;
using testing::read;
using testing::riemann;

NfElem q(long n, long d = 1) { return NfElem(Rational(n, d)); }

TEST(Families, AgreeWithTheBlindList) {
  std::mt19937 gen(20240607);
  const Field k = make_field({-5, 0, 1}, "s");
  const auto uniform = [&](long a, long b) {
    return std::uniform_int_distribution<long>(a, b)(gen);
  };
  for (int round = 0; round < 60; ++round) {
    std::vector<std::vector<NfElem>> c(static_cast<std::size_t>(uniform(1, 7)));
    for (auto& place : c)
      for (long i = uniform(1, 3); i > 0; --i)
        place.push_back(NfElem(Rational(uniform(-6, 8), uniform(1, 4))) +
                        NfElem::generator(k) * NfElem(uniform(-1, 1)));
    std::set<std::vector<std::size_t>> blind;
    std::vector<std::size_t> choice(c.size());
    long total = 0;
    while (true) {
      ++total;
      NfElem d(0);
      for (std::size_t i = 0; i < c.size(); ++i)
        d += c[i][choice[i]];
      if (is_rational(d) && is_integer(to_rational(d)) && sign(to_rational(d)) >= 0)
        blind.insert(choice);
      std::size_t i = 0;
      while (i < c.size() && ++choice[i] == c[i].size())
        choice[i++] = 0;
      if (i == c.size()) break;
    }
    const Families found = admissible_families(c, {});
    std::set<std::vector<std::size_t>> set;
    for (const Family& family : found.admissible)
      set.insert(family.choice);
    EXPECT_EQ(set, blind);
    EXPECT_EQ(set.size(), found.admissible.size());
    EXPECT_EQ(found.total, Integer(total));
  }
}

TEST(Families, EqualPlacesAreCounted) {
  // 2^200 families, none of which has an integral sum
  std::vector<std::vector<NfElem>> c(200, {q(1, 3), q(-1, 3)});
  c.push_back({q(1, 2)});
  EXPECT_TRUE(admissible_families(c, {}).admissible.empty());
  // 60 different contributions: the halves meet
  std::vector<std::vector<NfElem>> powers;
  for (long i = 0; i < 34; ++i)
    powers.push_back({q(1L << i, 1L << 33), q(0)});
  powers.push_back({q(-1)}); // sums 0 ... 2 - 2^-33, each once
  EXPECT_EQ(admissible_families(powers, {}).admissible.size(), 1u);
}

// Small degrees are there although others are beyond every limit; who needs all is told.
TEST(Families, ImmenseDegreesAreLeftOut) {
  for (const long k : {6, 12, 18}) {
    NfElem immense(1);
    for (long i = 0; i < k; ++i)
      immense = immense * NfElem(10);
    const Families found = admissible_families({{q(0), immense}, {q(1), q(1, 2)}, {q(2)}}, {});
    ASSERT_EQ(found.admissible.size(), 1u);
    EXPECT_EQ(found.admissible.front().degree, 3);
    ASSERT_TRUE(found.left_out);
    EXPECT_EQ(NfElem(Rational(*found.left_out)), immense + NfElem(3));
    EXPECT_THROW(found.require_all({}), OutOfBudget);
  }
  EXPECT_NO_THROW(admissible_families({{q(0), q(5)}, {q(1, 2), q(0)}}, {}).require_all({}));
}

TEST(Families, TheLimitIsAnErrorNotAnAnswer) {
  std::vector<std::vector<NfElem>> c(40, {q(1), q(2)});
  EXPECT_THROW((void)admissible_families(c, {}), OutOfBudget);
  Budget small;
  small.max_families = 3;
  // 4 irregular places with two signs each
  const RationalFunction r = from_omega(read("1/z^2+1/(z-1)^2-2/(z-2)^2+3/(z-5)^2+1/(3*z)"));
  const Outcome limited = solve(r, small);
  ASSERT_TRUE(std::holds_alternative<Unable>(limited));
  EXPECT_EQ(std::get<Unable>(limited).why, Unable::Why::budget);
  EXPECT_EQ(std::get<Unable>(limited).detail.substr(0, 12), "family limit");
  EXPECT_EQ(case_of(solve(r)), 1);
}

TEST(Families, DegreeAndTimeLimits) {
  Budget small;
  small.max_degree = 10;
  const Outcome degree = solve(read("z^2/4-1/2-20"), small);
  ASSERT_TRUE(std::holds_alternative<Unable>(degree));
  EXPECT_EQ(std::get<Unable>(degree).detail.substr(0, 12), "degree limit");
  const Outcome time = solve(read("z^2/4-1/2-20"), Budget::of_seconds(0));
  EXPECT_TRUE(std::holds_alternative<Unable>(time));
}

// More than `many_choices` places with a choice: powers instead of families.
RationalFunction with_many_roots() {
  RationalFunction f(Rational(1, 7));
  for (long i = 1; i <= 11; ++i)
    f *= RationalFunction(Poly::z() - Poly(i));
  return f;
}

TEST(ManyChoices, OneLine) {
  RationalFunction omega = read("z+1/z^2");
  for (long i = 1; i <= 40; ++i)
    omega +=
        RationalFunction(Rational(i % 2 == 0 ? 2 : -5, 3)) / RationalFunction(Poly::z() - Poly(i));
  const Outcome outcome = solve(from_omega(omega));
  ASSERT_TRUE(std::holds_alternative<Exponential>(outcome));
  EXPECT_EQ(std::get<Exponential>(outcome).omega, omega);
}

TEST(ManyChoices, Dihedral) {
  RationalFunction f(Rational(1));
  for (long i = 1; i <= 15; ++i)
    f *= pow(RationalFunction(Poly::z() - Poly(i)), i % 2 == 0 ? 3 : -1);
  const Outcome outcome = solve(from_square(f, q(3)));
  ASSERT_TRUE(std::holds_alternative<Imprimitive>(outcome));
  EXPECT_EQ(std::get<Imprimitive>(outcome).phi, derivative(f) / (RationalFunction(2) * f));
}

TEST(ManyChoices, Quaternion) {
  const RationalFunction r = pull_back(riemann(q(1, 4), q(1, 4), q(1, 4)), with_many_roots());
  EXPECT_EQ(case_of(solve(r)), 2);
}

TEST(ManyChoices, Primitive) {
  const RationalFunction f = with_many_roots();
  const auto group = [&](const NfElem& a, const NfElem& b, const NfElem& c) {
    const Outcome outcome = solve(pull_back(riemann(a, b, c), f));
    const auto* found = std::get_if<Algebraic>(&outcome);
    return found == nullptr ? 0 : static_cast<int>(found->group);
  };
  EXPECT_EQ(group(q(1, 9), q(1, 4), q(1, 9)), 4);
  EXPECT_EQ(group(q(1, 4), q(1, 9), q(1, 9)), 4);
  EXPECT_EQ(group(q(1, 4), q(1, 9), q(1, 16)), 6);
  EXPECT_EQ(group(q(1, 4), q(1, 9), q(1, 25)), 12);
}

TEST(Exponents, SetsOfThePaper) {
  const auto sets = [](const char* text, long m, long N, long scale) {
    const Singularities s = singularities(read(text));
    return exponent_set_text(s.finite.empty() ? s.infinity : s.finite.front(), m, N, scale);
  };
  EXPECT_EQ(sets("-3/(16*z^2)", 2, 2, 2), "{1, 2, 3}");
  EXPECT_EQ(sets("1/z^2+1", 2, 2, 2), "{2}"); // Delta = sqrt 5
  EXPECT_EQ(sets("1/z^5", 2, 2, 2), "{5}");
  EXPECT_EQ(sets("1/z+z", 2, 2, 2), "{4}");
  EXPECT_EQ(sets("-2/(9*z^2)+1", 4, 3, 3), "{4, 5, 6, 7, 8}");
  EXPECT_EQ(sets("-2/(9*z^2)+1", 6, 2, 2), "{4, 6, 8}");
  EXPECT_EQ(sets("-2/(9*z^2)+1", 12, 1, 1), "{4, 5, 6, 7, 8}"); // {6 + k/3, |k| <= 6}
  // the paper prints E_infinity = {1, 2, 4} for order > 2; it is {0, 2, 4}
  const Singularities flat = singularities(read("1/(z^2*(z-1)^2)"));
  EXPECT_EQ(exponent_set_text(flat.infinity, 2, 2, 2), "{0, 2, 4}");
  // order 3 at infinity: a logarithm, so that only the log-free solution is left
  const Singularities log = singularities(read("1/(z^2*(z-1))"));
  EXPECT_EQ(exponent_set_text(log.infinity, 2, 2, 2), "{0}");
}

TEST(Trace, ShowsTheStepsOfThePaper) {
  Trace trace;
  (void)solve(read("(z^2-z+1)*(-3)/(16*z^2*(z-1)^2)"), {}, &trace);
  const auto has = [&](int kovacic_case, int number) {
    return std::any_of(trace.begin(), trace.end(), [&](const Step& s) {
      return s.kovacic_case == kovacic_case && s.number == number;
    });
  };
  for (int kovacic_case : {1, 2})
    for (int number : {0, 1, 2})
      EXPECT_TRUE(has(kovacic_case, number)) << kovacic_case << "." << number;
  EXPECT_TRUE(has(2, 3));
  EXPECT_FALSE(has(3, 0));
}

} // namespace
} // namespace kov::kovacic::families_test
