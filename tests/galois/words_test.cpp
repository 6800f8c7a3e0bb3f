// Every argument of a classification has its sentence, and the sentence says what the values say.

#include "galois/classify.hpp"

#include "support/equations.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace kov {
namespace {

using kov::testing::from_omega;
using kov::testing::from_square;
using kov::testing::riemann;
using ::testing::HasSubstr;

const Poly z = Poly::z();

RationalFunction by_differences(const Rational& a, const Rational& b, const Rational& c) {
  return riemann(NfElem(a * a), NfElem(b * b), NfElem(c * c));
}
RationalFunction over_square(const Rational& b) { return {Poly(b), z * z}; }

struct Known {
  Argument argument;
  RationalFunction r;
  const char* said; ///< in the sentence
};

std::vector<Known> known() {
  const Rational half(1, 2), third(1, 3), fifth(1, 5);
  const RationalFunction radical = // one line: a radical, and an integral that is none
      from_omega(RationalFunction(Poly(third), z) + RationalFunction(Poly(third), z - Poly(1)));
  return {
      {Argument::zero, RationalFunction(0), "r = 0"},
      {Argument::torus_two_lines, RationalFunction(1), "y1*y2 is rational"},
      {Argument::torus_two_lines, over_square(1), "at z = 0 is not rational"},
      {Argument::torus_dihedral, RationalFunction(Poly(1), z) + over_square(Rational(-3, 16)),
       "irregular at infinity"},
      {Argument::torus_one_line, RationalFunction(z * z + Poly(3)), "exactly one exponential"},
      {Argument::torus_no_line, RationalFunction(z), "no exponential solution"},
      {Argument::logarithm_one_line, over_square(Rational(-1, 4)), "a logarithm at z = 0"},
      {Argument::logarithm_no_line, by_differences(0, 0, half), "has a logarithm at z = "},
      {Argument::integral_exponents, over_square(2), "all solutions are rational"},
      {Argument::integral_exponents, over_square(Rational(3, 4)), "square roots of rational"},
      {Argument::two_quartics, by_differences(half, half, half), "the quaternion group"},
      {Argument::two_radicals, over_square(Rational(-2, 9)), "radicals of order 3"},
      {Argument::one_radical, radical, "exactly one exponential solution, a radical"},
      {Argument::dihedral, by_differences(half, half, Rational(2, 5)), "a 5-th root"},
      {Argument::no_invariant, by_differences(half, third, Rational(1, 7)), "Sym^12"},
      {Argument::primitive, by_differences(half, third, third), "is Sym^6"},
      {Argument::primitive, by_differences(half, third, Rational(1, 4)), "is Sym^8"},
      {Argument::primitive, by_differences(half, third, fifth), "is Sym^12"},
  };
}

TEST(Words, EverySentenceIsThatOfItsArgument) {
  for (const Known& k : known()) {
    SCOPED_TRACE(to_string(k.r));
    const Classification c = classify(k.r);
    if (c.argument == Argument::p_curvature) { // a shorter proof of the same
      EXPECT_EQ(c.group->type, GroupType::SL2);
      EXPECT_THAT(reason(c), HasSubstr("modulo p = " + std::to_string(c.p_curvature->prime.p)));
      continue;
    }
    EXPECT_EQ(c.argument, k.argument);
    EXPECT_THAT(reason(c), HasSubstr(k.said));
  }
}

// The place that decides the branch is the one that the sentence names.
TEST(Words, TheDecisivePlaceIsNamed) {
  for (const long at : {-3L, 0L, 2L, 7L})
    for (const Poly& q : {z - Poly(at), z * z + Poly(at * at + 1)}) {
      const Classification c = classify(RationalFunction(Poly(1), pow(q, 3)));
      ASSERT_TRUE(c.local);
      EXPECT_EQ(c.kind, Trichotomy::irregular_or_irrational);
      const std::string name = place_name(place_at(*c.local, c.decisive));
      EXPECT_EQ(name, degree(q) == 1 ? "z = " + std::to_string(at) : to_string(q) + " = 0");
      EXPECT_EQ(c.component, Connected::sl2);
      if (c.argument != Argument::p_curvature) {
        EXPECT_THAT(reason(c), HasSubstr("irregular at " + name));
      }
    }
}

// What the theory of each step excludes (trichotomy.md, 6): the argument alone determines the
// component.
TEST(Words, AnArgumentHasOneComponent) {
  for (const Known& k : known()) {
    SCOPED_TRACE(to_string(k.r));
    const Classification c = classify(k.r);
    ASSERT_TRUE(c.component);
    switch (c.argument) {
    case Argument::torus_two_lines:
    case Argument::torus_dihedral:
      EXPECT_EQ(*c.component, Connected::torus);
      break;
    case Argument::torus_one_line:
      EXPECT_EQ(*c.component, Connected::borel);
      break;
    case Argument::logarithm_one_line:
    case Argument::one_radical:
    case Argument::fourth_power:
      EXPECT_EQ(*c.component, Connected::additive);
      break;
    case Argument::p_curvature:
    case Argument::torus_no_line:
    case Argument::logarithm_no_line:
    case Argument::no_invariant:
      EXPECT_EQ(*c.component, Connected::sl2);
      break;
    default:
      EXPECT_EQ(*c.component, Connected::trivial);
    }
  }
}

// The ways to tell a finite dihedral group from the infinite one, each with what it rests on.
TEST(Words, TorsionIsExplained) {
  const Poly F0 = pow(z, 3) + z + Poly(1);
  const struct {
    RationalFunction r;
    Torsion by;
    std::string said;
  } table[] = {
      {from_square(RationalFunction(F0), NfElem(1)), Torsion::holomorphic, "genus 1"},
      {from_square(RationalFunction(F0 * z * z), NfElem(1)), Torsion::orders_differ,
       "infinite order"},
      {by_differences(Rational(1, 2), Rational(1, 2), Rational(1, 3)), Torsion::genus_zero,
       "a 3-th root"},
  };
  for (const auto& row : table) {
    SCOPED_TRACE(to_string(row.r));
    const Classification c = classify(row.r);
    ASSERT_EQ(c.argument, Argument::dihedral);
    EXPECT_EQ(c.dihedral->by, row.by);
    EXPECT_THAT(reason(c), HasSubstr(row.said));
    for (const ReducedOrder& o : c.dihedral->orders)
      if (row.by == Torsion::orders_differ && &o == &c.dihedral->orders.front()) {
        EXPECT_THAT(reason(c), HasSubstr("order " + to_string(o.order) + " modulo " +
                                         std::to_string(o.prime.p)));
      }
  }
}

TEST(Words, WithoutTimeTheSentenceSaysSo) {
  Budget late = Budget::of_seconds(0);
  late.deadline = *late.deadline - std::chrono::seconds(1);
  for (const Known& k : known()) {
    const Classification c = classify(k.r, late);
    if (!c.undecided) continue; // the local data alone may tell
    EXPECT_FALSE(c.group);
    EXPECT_THAT(reason(c), HasSubstr("undecided: time limit"));
  }
}

} // namespace
} // namespace kov
