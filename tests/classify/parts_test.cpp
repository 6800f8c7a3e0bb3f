// The pieces of a classification: sets cut along polynomials, and conditions on differences.

#include "classify/components.hpp"
#include "closed/arithmetic.hpp"
#include "parameters/few_sets.hpp"
#include "study/necessary.hpp"
#include "support/statements.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov::parts_test {
namespace {

using test::Kind;
using test::numbers;
using test::some;

class Parts : public testing::Test {
protected:
  Ring ring_ = make_ring({"a", "b", "h"});
  MPoly a_ = MPoly::variable(ring_, "a"), b_ = MPoly::variable(ring_, "b");
  Set all_{ring_, {0, 1}};
  MayVanish any_ = [](const MPoly&) { return true; };

  MPoly number(long n) const { return MPoly(ring_, Integer(n)); }
  // In how many of the sets is the point?
  int count(const std::vector<Set>& sets, long a, long b) const {
    int n = 0;
    for (const Set& s : sets)
      if (!s.where_zero(a_ - number(a)).where_zero(b_ - number(b)).is_empty()) ++n;
    return n;
  }
};

// Two equations of one set may have factors together that neither has.
TEST_F(Parts, FactorsAfterSolving) {
  const auto on = [&](const MPoly& p, const MPoly& q) {
    return by_factors(all_.where_zero(p).where_zero(q), any_);
  };
  const auto points = on(b_ - a_ * a_, b_ - number(4));
  EXPECT_EQ(points.size(), 2U);
  EXPECT_EQ(count(points, 2, 4), 1);
  EXPECT_EQ(count(points, -2, 4), 1);
  EXPECT_EQ(on(b_ - a_ * a_, b_ - number(2)).size(), 1U); // a^2 = 2
  EXPECT_EQ(on(b_ - a_ * a_, b_ - number(0)).size(), 1U); // twice the same point
  EXPECT_EQ(on(b_ - a_ * a_ * a_, b_ - a_).size(), 3U);   // a = 0, 1, -1
  EXPECT_EQ(on(b_ - a_ * a_, b_ * b_ - b_).size(), 3U);   // a^4 = a^2
  EXPECT_EQ(by_factors(all_.where_zero(a_ - b_), any_).size(), 1U);
}

// An algebraic number that is not rational is the square of no rational number.
TEST_F(Parts, ConditionsAtAlgebraicNumbers) {
  const auto at = [&](const MPoly& p, const MFraction& square, const Kind::Optional& kind = {},
                      bool or_all_rational = false) {
    return on_set(some(kind, {square}, or_all_rational), all_.where_zero(p));
  };
  const MFraction a(a_), b(b_), one(ring_, Rational(1)), two(ring_, Rational(2));
  const auto is = [](const std::variant<bool, Statement>& answer, bool value) {
    const bool* known = std::get_if<bool>(&answer);
    return known != nullptr && *known == value;
  };
  EXPECT_TRUE(is(at(a_ * a_ - number(2), a), false));
  EXPECT_TRUE(is(at(a_ * a_ - number(2), one / (a + one)), false));
  EXPECT_TRUE(is(at(a_ * a_ - number(2), a * a + two), true));
  EXPECT_TRUE(is(at(a_ * a_ - number(2), a * a + two, Kind::odd_half), false));
  EXPECT_TRUE(is(at(a_ * a_ - number(2), a, Kind::integer, true), false));
  EXPECT_TRUE(std::holds_alternative<Statement>(at(a_ * a_ - number(2), b)));
  EXPECT_TRUE(std::holds_alternative<Statement>(at(a_ * a_ - b_, a)));
  // a = 4 is special, a = 2 is not: not the same at all points
  const MPoly both = (a_ - number(4)) * (a_ - number(2));
  EXPECT_TRUE(std::holds_alternative<Statement>(at(both, a)));
  EXPECT_TRUE(is(at((a_ - number(3)) * (a_ - number(2)), a), false));
  // of 4 and 3 the first is a square, if that is enough
  const MPoly squares = (a_ - number(4)) * (a_ - number(3));
  EXPECT_TRUE(is(at(squares, a, Kind::odd_half), false));
  EXPECT_TRUE(std::holds_alternative<Statement>(at(squares, a, Kind::odd_half, true)));
}

TEST_F(Parts, EachPointIsInOnePart) {
  const CutParts parts = split(all_, {{a_ * b_}, {{a_ - b_, a_ * a_ - number(4)}, {b_}}}, any_);
  for (long a = -3; a <= 3; ++a)
    for (long b = -3; b <= 3; ++b) {
      const bool inside = a * b == 0 && (a != b || a * a != 4) && b != 0;
      EXPECT_EQ(count(parts.inside, a, b), inside ? 1 : 0) << a << ' ' << b;
      EXPECT_EQ(count(parts.outside, a, b), inside ? 0 : 1) << a << ' ' << b;
    }
}

TEST_F(Parts, WhatCannotVanishIsNoCut) {
  const MayVanish none = [](const MPoly&) { return false; };
  EXPECT_TRUE(split(all_, {.zero = {a_}}, none).inside.empty());
  EXPECT_EQ(split(all_, {.not_all_zero = {{a_}}}, none).inside.size(), 1U);
}

// With b^2 = -1 known, "a = 2*b, a^2 + 4 = 0, b^2 + 1 = 0" is a = 2*b.
TEST_F(Parts, WhatFollowsFromTheConstantsIsNotTold) {
  const MPoly imaginary = b_ * b_ + number(1);
  const Set there = all_.where_zero(imaginary).where_zero(a_ - number(2) * b_);
  const auto told = proper_equations(there.where_zero(a_ * a_ + number(4)), {imaginary});
  ASSERT_EQ(told.size(), 1U);
  EXPECT_TRUE(is_zero(there.restrict(told.front())));
  EXPECT_TRUE(proper_equations(all_.where_zero(imaginary), {imaginary}).empty());
  EXPECT_EQ(proper_equations(all_.where_zero(imaginary), {}).size(), 1U);
}

// Where b >= 0 is assumed, b^2 = 4 is b = 2: no part has b = -2, whichever comes first.
TEST_F(Parts, NoPartIsOutsideTheAssumptions) {
  const MayVanish nonnegative = [&](const MPoly& p) { return !(p == b_ + number(2)); };
  const Set two = all_.where_zero(b_ * b_ - number(4));
  const CutParts parts = split(two, {.not_all_zero = {{b_ - number(2)}}}, nonnegative);
  EXPECT_TRUE(parts.inside.empty());
  ASSERT_EQ(parts.outside.size(), 1U);
  EXPECT_EQ(parts.outside.front().equations(), std::vector{b_ - number(2)});
  EXPECT_EQ(split(two, {.zero = {b_ - number(2)}}, nonnegative).outside.size(), 0U);
  EXPECT_EQ(split(two, {.not_all_zero = {{b_ - number(2)}}}, any_).inside.size(), 1U);
}

TEST_F(Parts, HalvesAreUnited) {
  const Set line = all_.where_zero(a_ - number(1));
  const auto one = united({line.where_zero(b_), line.where_nonzero(b_).where_nonzero(b_ - a_),
                           line.where_zero(b_ - number(1))});
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one.front().equations(), line.equations());
  EXPECT_TRUE(inequations(one.front()).empty());
  EXPECT_EQ(united({line.where_zero(b_), line.where_nonzero(b_ - a_).where_nonzero(b_)}).size(),
            1U);
  EXPECT_EQ(united({all_.where_zero(a_), line.where_nonzero(a_)}).size(), 2U);
}

// a = 0 without (0, 1), and b = 1: inequations that the union does not need are not told.
TEST_F(Parts, PlacesInFewWords) {
  const auto few = in_few_words({all_.where_zero(a_).where_nonzero(b_ - number(1)),
                                 all_.where_zero(b_ - number(1)).where_nonzero(a_),
                                 all_.where_zero(a_).where_zero(b_ - number(1))});
  ASSERT_EQ(few.size(), 2U);
  for (const Set& p : few)
    EXPECT_TRUE(p.proper_inequations().empty());
}

// b = a and b = -a, all else alike.
TEST_F(Parts, PlacesThatDifferByASign) {
  const auto away = [&](const MPoly& p) { return all_.where_zero(p).where_nonzero(a_); };
  const auto few = in_few_words({away(b_ - a_), away(b_ + a_)});
  ASSERT_EQ(few.size(), 1U);
  EXPECT_TRUE(few.front().vanishes(b_ * b_ - a_ * a_));
  EXPECT_FALSE(few.front().vanishes(b_ - a_));
  EXPECT_TRUE(few.front().is_nonzero(a_));
  EXPECT_EQ(in_few_words({away(b_ - a_), away(b_ - number(2) * a_)}).size(), 2U);
}

// The hole of the second lies on the first, which its inequation does not mention.
TEST_F(Parts, AHoleOnAnotherPlace) {
  const auto few =
      in_few_words({all_.where_zero(a_), all_.where_zero(b_ - number(2) * a_).where_nonzero(b_)});
  ASSERT_EQ(few.size(), 2U);
  for (const Set& p : few)
    EXPECT_TRUE(p.proper_inequations().empty());
}

// Where a hole is filled by no place it is told, and so is one filled under another condition.
TEST_F(Parts, HolesAreTold) {
  const Statement odd = some(Kind::odd_half, {a_});
  const Statement whole = some(Kind::integer, {a_});
  const Set outside = all_.where_nonzero(b_);
  EXPECT_EQ(in_few_words({*outside.where(odd)}).front().inequations().size(), 1U);
  EXPECT_EQ(in_few_words({*outside.where(odd), *all_.where_zero(b_).where(whole)}).size(), 2U);
  EXPECT_EQ(in_few_words({*outside.where(odd), *all_.where_zero(b_).where(odd)}).size(), 1U);
  EXPECT_EQ(in_few_words({*outside.where(odd), all_.where_zero(b_)}).size(), 2U);
}

// a^2 + b^2 = 0 has real points with b = 0 only, and many others.
TEST_F(Parts, HolesWithoutRealPoints) {
  const MPoly squares = a_ * a_ + b_ * b_;
  const Set hole = all_.where_nonzero(squares);
  const Set away = all_.where_nonzero(b_).where_nonzero(squares);
  const auto left = [](const std::vector<Set>& all) { return inequations(all.front()).size(); };
  Assumptions real;
  real.real = {0, 1};
  EXPECT_EQ(left(in_few_words({away}, {}, real)), 1U);
  EXPECT_EQ(left(in_few_words({hole}, {}, real)), 1U); // a = b = 0
  EXPECT_EQ(left(in_few_words({away})), 2U);
  Assumptions one;
  one.real = {1};
  EXPECT_EQ(left(in_few_words({away}, {}, one)), 2U); // a = i*b
  const Set axis = all_.where_zero(b_);
  const auto both = in_few_words({away, axis}, {}, real);
  ASSERT_EQ(both.size(), 1U);
  EXPECT_EQ(left(both), 0U);
  EXPECT_EQ(in_few_words({away, axis}).size(), 2U);
  Assumptions positive; // a > 0: a = -b^2 is nowhere
  positive.real = {0, 1};
  positive.require(MFraction(a_), Sign::positive);
  EXPECT_EQ(left(in_few_words({all_.where_nonzero(a_ + b_ * b_)}, {}, positive)), 0U);
  EXPECT_EQ(left(in_few_words({all_.where_nonzero(a_ - b_ * b_)}, {}, positive)), 1U);
}

// The union stays the same at each point.
TEST_F(Parts, FewWordsSayTheSame) {
  const std::vector<MPoly> cuts{a_, b_, a_ - b_, a_ - number(1), a_ * b_ - number(2)};
  for (unsigned choice = 1; choice < 64; ++choice) {
    std::vector<Set> sets;
    std::vector<Set> rest{all_};
    for (std::size_t i = 0; i < cuts.size(); ++i) {
      const CutParts parts = split(rest.front(), {.zero = {cuts[i]}}, any_);
      if ((choice >> i) & 1U) sets.insert(sets.end(), parts.inside.begin(), parts.inside.end());
      rest = parts.outside;
    }
    if (choice & 32U) sets.push_back(rest.front());
    const std::vector<Set> after = in_few_words(sets);
    for (long a = -2; a <= 2; ++a)
      for (long b = -2; b <= 2; ++b)
        EXPECT_EQ(count(sets, a, b) > 0, count(after, a, b) > 0) << choice << ' ' << a << ' ' << b;
  }
}

TEST_F(Parts, EquationsAreSolvedForParameters) {
  const SolvedSet s = solve(all_.where_nonzero(b_).where_zero(a_ * b_ - number(1)));
  ASSERT_EQ(s.values.size(), 1U);
  EXPECT_TRUE(s.left.empty());
  EXPECT_EQ(solve(all_.where_zero(a_ * a_ - number(2))).left.size(), 1U);
  EXPECT_EQ(solve(all_.where_zero(a_ * b_ * b_ - number(0) - b_ * b_ * b_ * b_)).left.size(), 1U);
}

TEST_F(Parts, DifferencesAtNumbers) {
  const auto at = [&](const Kind::Optional& kind, const Rational& square, bool holds = true) {
    const Set there = all_.where_zero((MFraction(a_) - MFraction(ring_, square)).num());
    return std::get<bool>(on_set({some(kind, {a_}).says, holds}, there));
  };
  EXPECT_TRUE(at(Kind::rational, Rational(4, 9)));
  EXPECT_FALSE(at(Kind::rational, Rational(2)));
  EXPECT_FALSE(at(Kind::rational, Rational(-4)));
  EXPECT_TRUE(at(Kind::half_integer, Rational(9, 4)));
  EXPECT_FALSE(at(Kind::half_integer, Rational(1, 9)));
  EXPECT_TRUE(at(Kind::integer, Rational(0)));
  EXPECT_FALSE(at(Kind::integer, Rational(1, 4)));
  EXPECT_TRUE(at(Kind::odd_half, Rational(25, 4)));
  EXPECT_FALSE(at(Kind::odd_half, Rational(4)));
  EXPECT_FALSE(at(Kind::rational, Rational(4, 9), false));
}

// Numbers are taken out of a root where the condition is that of another one.
TEST_F(Parts, DifferencesAreToldInASimpleForm) {
  const auto told = [&](const Kind::Optional& kind, const Rational& number, const MFraction& f) {
    return to_string(some(kind, {MFraction(ring_, number) * f}));
  };
  const MFraction a(a_);
  const MFraction odd = MFraction(ring_, Rational(8)) * a - MFraction(ring_, Rational(7));
  EXPECT_EQ(told(Kind::half_integer, 4, a * a), "4*a is an integer");
  EXPECT_EQ(told(Kind::half_integer, 1, a), "2*sqrt(a) is an integer");
  EXPECT_EQ(told(Kind::half_integer, Rational(1, 4), a), "sqrt(a) is an integer");
  EXPECT_EQ(told(Kind::half_integer, Rational(1, 4), odd), "sqrt(8*a - 7) is an integer");
  EXPECT_EQ(told(Kind::rational, Rational(1, 4), odd), "sqrt(8*a - 7) is rational");
  EXPECT_EQ(told(Kind::rational, Rational(9, 4), a * a), "a is rational");
  EXPECT_EQ(told(Kind::rational, Rational(8), a), "sqrt(2*a) is rational");
  EXPECT_EQ(told(Kind::integer, Rational(9, 4), a * a), "3*a is an even integer");
}

// "Some 2 Delta is an integer, or all are rational."
TEST_F(Parts, SeveralDifferences) {
  const Statement c = some(Kind::half_integer, {a_, b_}, true);
  const auto where = [&](const Rational& a) {
    return all_.where_zero((MFraction(a_) - MFraction(ring_, a)).num());
  };
  EXPECT_TRUE(std::get<bool>(on_set(c, where(1))));
  const auto rational = std::get<Statement>(on_set(c, where(Rational(1, 9))));
  EXPECT_TRUE(numbers(rational).or_all_rational);
  EXPECT_EQ(numbers(rational).squares.size(), 1U);
  const auto irrational = std::get<Statement>(on_set(c, where(2)));
  EXPECT_FALSE(numbers(irrational).or_all_rational);
  EXPECT_TRUE(implies(irrational, some(Kind::rational, {b_})));
  EXPECT_FALSE(implies(some(Kind::rational, {b_}), irrational));
}

// Every common zero where a - b is not 0 satisfies the equations of one component.
TEST_F(Parts, ComponentsContainAllZeros) {
  const std::vector<std::vector<MPoly>> systems = {
      {a_ * b_, a_ * a_ - b_},
      {(a_ - number(1)) * (b_ + number(2)), (a_ - b_) * (a_ + b_ - number(2))},
      {a_ * a_ * b_ - number(1), a_ - b_ * b_},
      {(a_ * a_ - b_ * b_) * b_, (a_ - number(2)) * (a_ - number(1))},
      {a_ * a_ - number(1), a_ * a_ - number(4)}};
  for (const auto& equations : systems) {
    const auto all = components(equations, {a_ - b_});
    for (long a = -3; a <= 3; ++a)
      for (long b = -3; b <= 3; ++b) {
        const auto vanish = [&](const std::vector<MPoly>& some) {
          return std::all_of(some.begin(), some.end(), [&](const MPoly& f) {
            return is_zero(substitute(
                f, {{0, MFraction(ring_, Rational(a))}, {1, MFraction(ring_, Rational(b))}}));
          });
        };
        if (a != b && vanish(equations)) {
          EXPECT_TRUE(std::any_of(all.begin(), all.end(), vanish)) << a << ' ' << b;
        }
      }
  }
  EXPECT_TRUE(components({a_ * a_ - number(1), a_ * a_ - number(4)}, {}).empty());
  EXPECT_EQ(components({a_ * b_, a_ - number(1)}, {}).size(), 1U);
}

// Also where the number is told with another rational factor.
TEST_F(Parts, SpecialDifferencesAreRational) {
  const MFraction a(a_);
  const Statement half = some(Kind::odd_half, {a});
  const Statement twice = some(Kind::rational, {Rational(4) * a});
  const Statement other = some(Kind::rational, {Rational(2) * a});
  EXPECT_TRUE(implies(half, twice));
  EXPECT_FALSE(implies(half, other));
  EXPECT_FALSE(implies(twice, half));
  EXPECT_TRUE(implies(half, some(Kind::integer, {Rational(4) * a})));
  EXPECT_FALSE(implies(half, some(Kind::odd_half, {Rational(4) * a})));
  EXPECT_FALSE(implies(half, some(Kind::integer, {Rational(9) * a})));
  EXPECT_TRUE(implies(half, some(Kind::odd_half, {Rational(9) * a})));
}

// At every rational point where a statement is so, what it says of one difference is so.
TEST_F(Parts, WhatAStatementSaysOfADifference) {
  const MFraction a(a_);
  const auto square = [&](long p, long q) { return MFraction(ring_, Rational(p * p, q * q)); };
  const Residues odd{Rational(1), Rational(2)};
  const std::vector<Assertion> all = {
      SumIn{{a}, {{Rational(1, 2), Rational(2)}, {Rational(-3, 2), Rational(4)}}},
      SumIn{{a}, {odd}},
      SumIn{{square(1, 2), a}, {odd}},
      SumIn{{square(2, 1), square(1, 2), a}, {odd}},
      SumIn{{square(1, 4), square(1, 4), a}, {odd}},
      SumIn{{square(1, 3), square(1, 2), a}, {odd}},
      AllRational{{a}},
      SomeIn{{a}, Classes{half_integers}},
      InRow{{square(1, 2), square(1, 3), a}, GroupType::S4}};
  for (const Assertion& s : all) {
    const auto c = necessary_condition({{{s, true}}});
    ASSERT_TRUE(c) << to_string(Statement{s});
    long met = 0;
    for (long q : {1, 2, 3, 4, 12})
      for (long p = 0; p <= 12 * q; ++p) {
        const Rational value(p * p, q * q);
        const auto at = [&](const MFraction& f) {
          return NfElem(is_zero(f) || is_constant(f) ? (is_zero(f) ? Rational(0) : to_rational(f))
                                                     : value);
        };
        if (!is_so({s, true}, at)) continue;
        ++met;
        const Set there = all_.where_zero((a - MFraction(ring_, value)).num());
        const auto here = on_set({*c}, there);
        EXPECT_TRUE(std::get<bool>(here)) << to_string({*c}) << " at " << to_string(value);
      }
    EXPECT_GT(met, 0) << to_string(Statement{s});
  }
  EXPECT_FALSE(necessary_condition({{{all[0], false}}}));
  EXPECT_FALSE(necessary_condition({{{all[0], true}}, {}}));
  EXPECT_FALSE(necessary_condition({{{SumIn{{a, MFraction(b_)}, {odd}}, true}}}));
}

// A difference that occurs twice in a sum, and the rows of the table with two that are open.
TEST_F(Parts, ADifferenceMayOccurTwice) {
  const MFraction a(a_);
  const MFraction third(ring_, Rational(1, 9));
  const Residues odd{Rational(1), Rational(2)};
  const std::vector<std::vector<Statement>> parts = {
      {{SumIn{{third, a, a}, {odd}}}},
      {{SomeIn{{a, a}, Classes{half_integers}, false, 2}}},
      {{InRow{{third, a, a}, GroupType::A4}}},
      {{InRow{{third, a, a}, GroupType::A5}}}};
  const auto all = necessary_condition(parts);
  ASSERT_TRUE(all);
  EXPECT_TRUE(all->classes);
  long met = 0;
  for (long q : {1, 2, 3, 4, 5, 6, 7, 30})
    for (long p = 0; p <= 8 * q; ++p) {
      const Rational value(p * p, q * q);
      const auto at = [&](const MFraction& f) {
        return NfElem(is_zero(f) ? Rational(0) : is_constant(f) ? to_rational(f) : value);
      };
      const bool some = std::any_of(parts.begin(), parts.end(),
                                    [&](const auto& part) { return is_so(part.front(), at); });
      if (!some) continue;
      ++met;
      const Set there = all_.where_zero((a - MFraction(ring_, value)).num());
      EXPECT_TRUE(std::get<bool>(on_set({*all}, there))) << to_string(value);
    }
  EXPECT_GT(met, 20);
  // 2 Delta = 0 is not an odd integer, and says nothing of Delta where c itself is one
  EXPECT_FALSE(necessary_condition({{{SumIn{{MFraction(ring_, Rational(1)), a, a}, {odd}}}}}));
}

// All values up to a bound, by looking at each.
TEST_F(Parts, CommonValuesAreAllOfThem) {
  const MFraction a(a_), b(b_), one(ring_, Rational(1)), four(ring_, Rational(4));
  const Classes thirds{{Rational(1, 3), Rational(1)}, {Rational(1, 2), Rational(1)}};
  const Statement x = some(thirds, {Rational(4, 9) * (one / a)});
  struct Pair {
    Statement first, second;
  };
  const std::vector<Pair> pairs = {
      {x, some(thirds, {Rational(4, 9) * a})},
      {some(Kind::integer, {a}), some(Kind::half_integer, {(four + a) / (a + one)})},
      {some(Kind::half_integer, {(Rational(9) * a + one) / (a + one)}),
       some(Kind::half_integer, {(Rational(9) * a - one) / (a - one)})},
      {some(Kind::odd_half, {a}), some(Kind::integer, {one / a - one})}};
  for (const auto& [first, second] : pairs) {
    const auto common = common_values(first, second);
    ASSERT_TRUE(common);
    const bool of_first = common->square == numbers(first).squares.front();
    const Statement& other = of_first ? second : first;
    // numbers of (1/6)Z as the root of the square, a from it
    for (long n = 0; n <= 300; ++n) {
      const Rational square(n * n, 36);
      const MFraction equation = common->square - MFraction(ring_, square);
      if (degree(equation.num(), 0) < 1) continue;
      const Set there = all_.where_zero(equation.num());
      const auto here = on_set(of_first ? first : second, there);
      const auto also = on_set(other, there);
      const bool both = std::holds_alternative<bool>(here) && std::get<bool>(here) &&
                        std::holds_alternative<bool>(also) && std::get<bool>(also);
      const bool told =
          std::find(common->values.begin(), common->values.end(), square) != common->values.end();
      EXPECT_EQ(both, told) << to_string(first) << "; " << to_string(second) << " at "
                            << to_string(square);
    }
  }
}

TEST_F(Parts, CommonValuesNeedALimitAndOneRelation) {
  const MFraction a(a_), b(b_), one(ring_, Rational(1));
  const auto finite = [](const Statement& x, const Statement& y) {
    return common_values(x, y).has_value();
  };
  const Statement of_a = some(Kind::integer, {a});
  EXPECT_FALSE(finite(of_a, some(Kind::integer, {Rational(2) * a + one}))); // Pell
  EXPECT_FALSE(finite(of_a, some(Kind::integer, {b})));                     // independent
  EXPECT_FALSE(finite(of_a, some(Kind::rational, {one / a})));              // Q is dense
  EXPECT_FALSE(finite(of_a, negation(some(Kind::integer, {one / a}))));
  EXPECT_TRUE(finite(some(Kind::integer, {a / b}), some(Kind::integer, {b / a}))); // one relation
  const MFraction ratio = a * a / (b * b);
  EXPECT_EQ(common_values(some(Kind::integer, {ratio}), some(Kind::integer, {one / ratio}))
                ->values.size(),
            1U);
  EXPECT_TRUE(
      finite(some(Kind::integer, {a * a + b * b}), some(Kind::integer, {one - a * a - b * b})));
}
// D1^2 + 4 D2^2 = 5/4 and the like: an ellipse, whose points may be rational in D2.
TEST_F(Parts, CommonValuesWhereOneSquareFalls) {
  const MFraction a(a_), one(ring_, Rational(1)), five(ring_, Rational(5));
  const auto values = [](const Statement& x, const Statement& y) {
    const auto found = common_values(x, y);
    return found ? found->values.size() : 99;
  };
  // D2^2 = 5 - D1^2: (0, not a square), 1 and 4
  EXPECT_EQ(values(some(Kind::integer, {a}), some(Kind::integer, {five - a})), 2U);
  EXPECT_EQ(values(some(Kind::integer, {a}), some(Kind::rational, {five - a})), 2U);
  EXPECT_EQ(values(some(Kind::odd_half, {a}),
                   some(Kind::odd_half, {MFraction(ring_, Rational(1, 2)) - a})),
            1U);
  // half integers: 1/4 + 19/4 and 9/4 + 11/4 are not, 25/4 > 5; with D1 in Z and D2 in Z/2 as above
  EXPECT_EQ(values(some(Kind::odd_half, {a}), some(Kind::rational, {five - a})), 0U);
  EXPECT_EQ(values(some(Kind::integer, {a}), some(Kind::integer, {five * a - a * a})),
            3U); // 0, 1, 4
  EXPECT_EQ(values(some(Kind::rational, {a}), some(Kind::rational, {five - a})), 99U);
  EXPECT_EQ(values(some(Kind::integer, {a}), some(Kind::integer, {a - five})), 99U); // Pell again
}

} // namespace
} // namespace kov::parts_test
