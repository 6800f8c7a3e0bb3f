// Conditions on differences against the numbers themselves: what is said of a set holds at each of its points.

#include "parameters/set.hpp"
#include "support/random.hpp"
#include "support/statements.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace kov::statement_laws_test {
namespace {

using test::Kind;
using test::numbers;
using test::Random;
using test::random_rounds;
using test::some;

const Ring& ring() {
  static const Ring r = make_ring({"a", "b"});
  return r;
}
MFraction number(const Rational& q) { return {ring(), q}; }
MFraction letter(const char* name) { return MFraction::variable(ring(), name); }

Set everything() { return {ring(), {0, 1}}; }
Set where(Set set, const char* name, const Rational& value) {
  return set.where_zero((letter(name) - number(value)).num());
}

// By its definition, for given squares.
bool is_so(const Statement& s, const std::vector<Rational>& squares) {
  const auto in = [](const Rational& root, const Rational& a, const Rational& step) {
    return is_integer((root - a) / step) || is_integer((root + a) / step);
  };
  const SomeIn& c = numbers(s);
  const auto special = [&](const Rational& square) {
    const auto root = exact_sqrt(square);
    return root && (!c.classes || std::ranges::any_of(*c.classes, [&](const Residues& r) {
             return in(*root, r.a, r.step);
           }));
  };
  const bool all_rational =
      c.or_all_rational &&
      std::ranges::all_of(squares, [](const Rational& q) { return exact_sqrt(q).has_value(); });
  return (all_rational || std::ranges::any_of(squares, special)) == s.holds;
}

// Roots of numbers like these are special often enough.
Rational random_square(Random& random) {
  const Rational root(random.between(0, 9), random.between(1, 4));
  return random.once_in(5) ? root - Rational(2) : root * root;
}
Statement random_condition(Random& random, const std::vector<MFraction>& squares) {
  static const std::vector<Kind::Optional> kinds{Kind::rational, Kind::half_integer, Kind::integer,
                                                 Kind::odd_half, Classes{}};
  Statement c = some(random.one_of(kinds), squares);
  if (auto& classes = numbers(c).classes; classes && classes->empty())
    for (long k = random.between(1, 2); k > 0; --k)
      classes->push_back(
          {Rational(random.between(0, 5), random.between(1, 6)), random.between(1, 3)});
  numbers(c).or_all_rational = squares.size() > 1 && random.once_in(2);
  return c;
}

TEST(DifferenceLaws, AtAPointItIsWhatTheNumbersSay) {
  random_rounds(200, [](Random& random) {
    const Rational a = random_square(random), b = random_square(random);
    Statement c =
        random_condition(random, random.once_in(2) ? std::vector{letter("a")}
                                                   : std::vector{letter("a"), letter("b")});
    c.holds = random.once_in(2);
    const std::vector<Rational> squares =
        numbers(c).squares.size() == 1 ? std::vector{a} : std::vector{a, b};
    const Set there = where(where(everything(), "a", a), "b", b);
    EXPECT_EQ(std::get<bool>(on_set(c, there)), is_so(c, squares)) << to_string(c);
    EXPECT_EQ(std::get<bool>(on_set(negation(c), there)), !is_so(c, squares)) << to_string(c);
    EXPECT_EQ(negation(negation(c)), c);
  });
}

// First on a line, then at its point: nothing is lost on the way, and nothing is gained.
TEST(DifferenceLaws, OnASetItIsWhatItIsAtThePoints) {
  random_rounds(200, [](Random& random) {
    const Rational a = random_square(random), b = random_square(random);
    Statement c = random_condition(random, {letter("a"), letter("b")});
    c.holds = random.once_in(2);
    const Set line =
        random.once_in(2)
            ? where(everything(), "a", a)
            : everything().where_zero(
                  ((letter("a") - number(a)) * (letter("b") - number(b + Rational(1)))).num());
    const Set point = where(where(everything(), "a", a), "b", b);
    const auto on_line = on_set(c, line);
    const bool here = std::holds_alternative<bool>(on_line)
                          ? std::get<bool>(on_line)
                          : std::get<bool>(on_set(std::get<Statement>(on_line), point));
    EXPECT_EQ(here, is_so(c, {a, b})) << to_string(c);
  });
}

// The two zeros of an equation may be irrational, and complex.
TEST(DifferenceLaws, AtTheZerosOfAnEquation) {
  const Statement integer = some(Kind::integer, {letter("a")});
  const auto at = [&](const MFraction& equation) {
    return on_set(integer, everything().where_zero(equation.num()));
  };
  const MFraction square = letter("a") * letter("a");
  EXPECT_FALSE(std::get<bool>(at(square - number(2)))) << "sqrt(sqrt(2))";
  EXPECT_FALSE(std::get<bool>(at(square + number(1)))) << "sqrt(i)";
  EXPECT_TRUE(std::holds_alternative<Statement>(at(square - number(16)))) << "a = 4, and a = -4";
  EXPECT_TRUE(std::get<bool>(at(square * letter("a")))) << "0 three times";
}

TEST(DifferenceLaws, WhatFollowsHoldsWhereItFollows) {
  long followed = 0;
  random_rounds(400, [&](Random& random) {
    const Rational by(random.between(1, 4), random.between(1, 3));
    const Statement c = random_condition(random, {letter("a")});
    Statement d = random_condition(random, {number(by * by) * letter("a")});
    EXPECT_TRUE(implies(c, c));
    EXPECT_TRUE(implies(negation(c), negation(c)));
    EXPECT_FALSE(implies(c, negation(c)));
    if (!implies(c, d)) return;
    ++followed;
    for (long p = 0; p <= 60; ++p)
      for (const long q : {1, 2, 3, 4, 5, 6, 12}) {
        const Rational a = Rational(p, q) * Rational(p, q);
        EXPECT_TRUE(!is_so(c, {a}) || is_so(d, {a * by * by}))
            << to_string(c) << " implies " << to_string(d) << " at " << to_string(a);
      }
  });
  EXPECT_GT(followed, 0);
}

// Delta2^2 = (m a + n)/(a + k) for Delta1^2 = a: each number at which both are special is listed.
TEST(DifferenceLaws, CommonValuesAreNotForgotten) {
  long met = 0;
  random_rounds(80, [&](Random& random) {
    const MFraction a = letter("a");
    const Rational m = random_square(random), n(random.between(-9, 9)), k(random.between(-5, 5));
    if (m * k == n) return; // a number
    const MFraction other = (number(m) * a + number(n)) / (a + number(k));
    Statement c = random_condition(random, {a}), d = random_condition(random, {other});
    if (!numbers(c).classes || !numbers(d).classes) return;
    const auto common = common_values(c, d);
    if (!common) return;
    EXPECT_TRUE(std::ranges::is_sorted(common->values));
    for (long p = 0; p <= 40; ++p)
      for (const long q : {1, 2, 3, 4, 6}) {
        const Rational square = Rational(p, q) * Rational(p, q);
        if (is_zero(square + k)) continue;
        const Rational there = (m * square + n) / (square + k);
        if (!is_so(c, {square}) || !is_so(d, {there})) continue;
        ++met;
        const Rational& value = common->square == a ? square : there;
        EXPECT_TRUE(std::ranges::find(common->values, value) != common->values.end())
            << to_string(c) << "; " << to_string(d) << " at a = " << to_string(square);
      }
  });
  EXPECT_GT(met, 0);
}

TEST(DifferenceLaws, SpecialSquaresAreAllOfThemBelowTheBound) {
  random_rounds(60, [](Random& random) {
    const Statement c = random_condition(random, {letter("a")});
    if (!numbers(c).classes) return;
    const long bound = random.between(0, 4);
    const std::vector<Rational> all = squares_in(*numbers(c).classes, bound);
    EXPECT_TRUE(std::ranges::is_sorted(all));
    for (const Rational& square : all)
      EXPECT_TRUE(is_so(c, {square})) << to_string(c) << ' ' << to_string(square);
    const Integer n = denominator(*numbers(c).classes);
    for (long p = 0; p <= bound * 60; ++p) {
      const Rational root(p, 60);
      if (!is_so(c, {root * root})) continue;
      EXPECT_TRUE(is_integer(root * Rational(n))) << to_string(c) << ' ' << to_string(root);
      EXPECT_TRUE(std::ranges::find(all, root * root) != all.end())
          << to_string(c) << ' ' << to_string(root);
    }
  });
}

} // namespace
} // namespace kov::statement_laws_test
