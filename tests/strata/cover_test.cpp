// The strata are disjoint and cover the parameters, and each says at its points what the equation with
// numbers says there: verdict, group, and the bound of a group that is not the same everywhere.

#include "strata/at_point.hpp"
#include "strata/families.hpp"

#include <array>

namespace kov::strata::cover_test {
namespace {

using test::agree_at;
using test::ExactPoint;
using test::Family;
using test::Random;
using test::random_exact_point;
using test::random_rounds;

const Ring& ring = test::family_ring;
const MFraction z = MFraction::variable(ring, "z");
const MFraction a = MFraction::variable(ring, "a");
const MFraction b = MFraction::variable(ring, "b");
const MFraction n = MFraction::variable(ring, "n");
const MFraction one(ring, Rational(1));

MFraction number(long p, long q = 1) { return MFraction(ring, Rational(p, q)); }

Question asked(const MFraction& r) {
  Question q;
  q.r = r;
  return q;
}

class Cover : public testing::TestWithParam<Family> {};

TEST_P(Cover, EachPointIsInOneStratum) {
  const Question q = asked(GetParam().r);
  const auto strata = decide_strata(q).told_apart();
  random_rounds(60, [&](Random& random) {
    const ExactPoint point = random_exact_point(q, random, random.once_in(2));
    EXPECT_TRUE(the_stratum(strata, point)) << point.text(ring);
  });
}

TEST_P(Cover, AndThatIsTheEquationThere) {
  const Question q = asked(GetParam().r);
  const auto strata = decide_strata(q).told_apart();
  int known = 0;
  random_rounds(12, [&](Random& random) {
    known += agree_at(q, strata, random_exact_point(q, random, random.once_in(4))) ? 1 : 0;
  });
  EXPECT_GT(known, 0);
}

// The answer on z = c x + d and on x = 1/(z - d) is the same: their constants may be parameters, too.
TEST_P(Cover, AMovedEquationHasTheSameVerdicts) {
  const MFraction r = GetParam().r;
  const Question q = asked(r);
  const auto strata = decide_strata(q).told_apart();
  const Question moved = asked(number(4) * substitute(r, {{0, number(2) * z - number(3)}}));
  const Question inverted = asked(substitute(r, {{0, one + one / z}}) / pow(z, 4));
  for (const Question& other : {moved, inverted}) {
    const auto others = decide_strata(other).told_apart();
    random_rounds(25, [&](Random& random) {
      const ExactPoint point = random_exact_point(q, random, random.once_in(2));
      SCOPED_TRACE(point.text(ring));
      const auto here = the_stratum(strata, point), there = the_stratum(others, point);
      ASSERT_TRUE(here && there);
      const Leaf &x = here->leaf, &y = there->leaf;
      EXPECT_EQ(x.no_equation(), y.no_equation());
      if (x.abelian == Truth::unknown || y.abelian == Truth::unknown) return;
      EXPECT_EQ(x.abelian, y.abelian) << reason(x) << "\nbut " << reason(y);
      if (x.group && y.group) {
        EXPECT_EQ(x.group->type, y.group->type);
      }
    });
  }
}

INSTANTIATE_TEST_SUITE_P(OfFamilies, Cover, testing::ValuesIn(test::families()),
                         [](const auto& one) { return std::string(one.param.name); });

// Squares of three exponent differences, in every order: 0, 1 and infinity are alike.
TEST(Strata, ThePlacesOfRiemannAreAlike) {
  const auto riemann = [](const MFraction& P, const MFraction& Q, const MFraction& R) {
    const MFraction w = z - one;
    return (P - one) / (number(4) * z * z) + (Q - one) / (number(4) * w * w) +
           (one - P - Q + R) / (number(4) * z * w);
  };
  const std::vector<MFraction> squares{a * a, number(1, 9),
                                       (a + number(1, 2)) * (a + number(1, 2))};
  const std::vector<std::array<std::size_t, 3>> orders{{0, 1, 2}, {1, 0, 2}, {2, 1, 0}, {1, 2, 0}};
  std::vector<std::vector<Stratum>> answers;
  const Question q = asked(riemann(squares[0], squares[1], squares[2]));
  for (const auto& [i, j, k] : orders)
    answers.push_back(
        decide_strata(asked(riemann(squares[i], squares[j], squares[k]))).told_apart());
  Random random(7);
  for (int k = 0; k < 40; ++k) {
    const ExactPoint point = random_exact_point(q, random, k % 5 == 0);
    const auto first = the_stratum(answers.front(), point);
    for (const auto& other : answers) {
      const auto there = the_stratum(other, point);
      ASSERT_TRUE(first && there);
      EXPECT_EQ(there->leaf.abelian, first->leaf.abelian) << point.text(ring);
      EXPECT_EQ(there->leaf.group, first->leaf.group) << point.text(ring);
    }
  }
}

// One assumption more: fewer points, and at those nothing is contradicted.
TEST(Strata, AnAssumptionContradictsNothing) {
  random_rounds(12, [](Random& random) {
    const Family f = random.one_of(test::families());
    const Question q = asked(f.r);
    Question narrow = q;
    const MFraction p =
        random.one_of(std::vector<MFraction>{a - b, a + number(2), n - one, a * b - one});
    const Sign sign = random.one_of(std::vector<Sign>{Sign::nonzero, Sign::zero, Sign::positive});
    narrow.assumptions.require(p, sign);
    if (sign == Sign::positive) narrow.assumptions.declare_real(p);
    SCOPED_TRACE(std::string(f.name) + " where " + to_string(narrow.assumptions.conditions));
    const auto wide = decide_strata(q).told_apart(), inside = decide_strata(narrow).told_apart();
    int met = 0;
    for (int k = 0; k < 60; ++k) {
      const ExactPoint point = random_exact_point(q, random, false);
      if (!std::ranges::all_of(narrow.assumptions.conditions,
                               [&](const Condition& c) { return point.holds(c); }))
        continue;
      ++met;
      SCOPED_TRACE(point.text(ring));
      const auto x = the_stratum(wide, point), y = the_stratum(inside, point);
      ASSERT_TRUE(x && y);
      if (x->leaf.abelian != Truth::unknown && y->leaf.abelian != Truth::unknown) {
        EXPECT_EQ(x->leaf.abelian, y->leaf.abelian);
      }
    }
    EXPECT_TRUE(met > 0 || sign == Sign::zero);
  });
}

// r is made of an exponential solution, or of a product of two: abelian wherever it means something.
TEST(Strata, AKnownSolutionIsNeverExcluded) {
  random_rounds(16, [](Random& random) {
    const auto c = [&] {
      const MFraction x = random.one_of(std::vector<MFraction>{a, b, n, one, a * b, a + one});
      return Rational(random.between(1, 4), random.between(1, 3)) * x;
    };
    const MFraction omega = random.once_in(2) ? c() / z + c() / (z - b) : c() / z + c() * z + b;
    const MFraction r = derivative(omega, 0) + omega * omega;
    const StrataAnswer reducible = decide_strata(asked(r));
    // a triangular group: its component is abelian or not, and the group is no other one
    const MFraction v = z * (z - a) * (c() * z + b), phi = derivative(v, 0) / (number(2) * v);
    const Question q = asked(c() / v + derivative(phi, 0) / number(2) + phi * phi / number(4));
    const StrataAnswer imprimitive = decide_strata(q);
    for (const Stratum& s : imprimitive.told_apart())
      EXPECT_NE(s.leaf.abelian, Truth::no)
          << to_string(q.r) << " where " << to_string(s.conditions);
    for (const Stratum& s : reducible.told_apart())
      if (s.leaf.group) {
        EXPECT_EQ(kovacic_case(*s.leaf.group), 1)
            << to_string(r) << " where " << to_string(s.conditions) << ": " << reason(s.leaf);
      }
  });
}

} // namespace
} // namespace kov::strata::cover_test
