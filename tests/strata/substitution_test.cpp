// A substitution in an equation may be made in its answer: a function for a parameter, a value for it, a cover of
// the line for its variable.

#include "strata/at_point.hpp"
#include "strata/families.hpp"

namespace kov::strata::substitution_test {
namespace {

using test::ExactPoint;
using test::Family;
using test::family_ring;
using test::Random;
using test::random_rounds;
using test::the_stratum;

MFraction named(const char* name) { return MFraction::variable(family_ring, name); }
MFraction constant(long p, long q = 1) { return MFraction(family_ring, Rational(p, q)); }
std::size_t index_of(const char* name) { return family_ring->index(name); }

Question without_assumptions(const MFraction& r) {
  Question q;
  q.r = r;
  return q;
}

/// Small values, often special ones.
std::map<std::size_t, NfElem> random_values(Random& random) {
  std::map<std::size_t, NfElem> values;
  for (const char* name : {"a", "b", "n"})
    values[index_of(name)] =
        NfElem(random.once_in(2) ? Rational(random.between(-2, 2))
                                 : Rational(random.between(-7, 9), random.between(1, 4)));
  return values;
}

/// Where both know the verdict it is the same, and so is the group where it should be.
void expect_the_same(const Leaf& x, const Leaf& y, bool group) {
  EXPECT_EQ(x.no_equation(), y.no_equation()) << reason(x) << "\nbut " << reason(y);
  if (x.abelian == Truth::unknown || y.abelian == Truth::unknown) return;
  EXPECT_EQ(x.abelian, y.abelian) << reason(x) << "\nbut " << reason(y);
  if (group && x.group && y.group) {
    EXPECT_EQ(x.group->type, y.group->type) << reason(x) << "\nbut " << reason(y);
  }
}

class Substituted : public testing::TestWithParam<Family> {
protected:
  const Question asked = without_assumptions(GetParam().r);
  const std::vector<Stratum> strata = decide_strata(asked).told_apart();
};

// a = phi(a, b): the strata of the new family are the preimages of those of the old one.
TEST_P(Substituted, AParameterIsAFunctionOfOthers) {
  const MFraction a = named("a"), b = named("b"), one = constant(1);
  for (const MFraction& phi : {a * a, a + b, a * b - one, one / a, (a - one) / (a + one)}) {
    const Question moved = without_assumptions(substitute(asked.r, {{index_of("a"), phi}}));
    const auto others = decide_strata(moved).told_apart();
    random_rounds(30, [&](Random& random) {
      auto values = random_values(random);
      const ExactPoint there(asked.z, values);
      if (is_zero(there(MFraction(phi.den())))) return; // the old parameter has no value
      values[index_of("a")] = there(phi);
      const ExactPoint here(asked.z, values);
      SCOPED_TRACE(to_string(phi) + " at " + there.text(family_ring));
      const auto x = the_stratum(strata, here), y = the_stratum(others, there);
      ASSERT_TRUE(x && y);
      expect_the_same(x->leaf, y->leaf, true);
    });
  }
}

// An equation with a number for a parameter, and the same number as an assumption.
TEST_P(Substituted, AValueIsPutInOrAssumed) {
  random_rounds(4, [&](Random& random) {
    const char* name = random.one_of(std::vector<const char*>{"a", "b", "n"});
    const Rational value(random.between(-3, 4), random.between(1, 2));
    MFraction put_in(family_ring);
    try {
      put_in = substitute(asked.r, {{index_of(name), MFraction(family_ring, value)}});
    } catch (const DomainError&) {
      return; // there is no equation
    }
    Question assumed = asked;
    assumed.assumptions.require(named(name) - MFraction(family_ring, value), Sign::zero);
    const auto with_number = decide_strata(without_assumptions(put_in)).told_apart();
    const auto with_assumption = decide_strata(assumed).told_apart();
    for (int k = 0; k < 12; ++k) {
      auto values = random_values(random);
      values[index_of(name)] = NfElem(value);
      const ExactPoint point(asked.z, values);
      SCOPED_TRACE(point.text(family_ring));
      const auto x = the_stratum(with_number, point), y = the_stratum(with_assumption, point);
      ASSERT_TRUE(x && y);
      expect_the_same(x->leaf, y->leaf, true);
      EXPECT_EQ(y->leaf.abelian == Truth::unknown, x->leaf.abelian == Truth::unknown);
    }
  });
}

// z = w^k, y = sqrt(z') u: u'' = (z'^2 r(z) + (k^2 - 1)/(4 w^2)) u, and the identity component is the same.
TEST_P(Substituted, ACoverOfTheLineHasTheSameComponent) {
  const MFraction w = named("z");
  for (const long k : {2L, 3L}) {
    const MFraction z = pow(w, static_cast<int>(k)), slope = derivative(z, asked.z);
    const Question above = without_assumptions(slope * slope * substitute(asked.r, {{asked.z, z}}) +
                                               constant(k * k - 1, 4) / (w * w));
    const auto others = decide_strata(above).told_apart();
    random_rounds(20, [&](Random& random) {
      const ExactPoint point(asked.z, random_values(random));
      SCOPED_TRACE("k = " + std::to_string(k) + " at " + point.text(family_ring));
      const auto x = the_stratum(strata, point), y = the_stratum(others, point);
      ASSERT_TRUE(x && y);
      expect_the_same(x->leaf, y->leaf, false);
    });
  }
}

INSTANTIATE_TEST_SUITE_P(OfFamilies, Substituted, testing::ValuesIn(test::families()),
                         [](const auto& one) { return std::string(one.param.name); });

// Two parameters that occur by their sum only: each stratum is one of the sum.
TEST(Strata, ParametersThatOccurByTheirSum) {
  const MFraction sum = named("a") + named("b");
  for (const Family& f : test::families()) {
    MFraction r(family_ring);
    try {
      r = substitute(f.r, {{index_of("a"), sum}, {index_of("b"), constant(1)}});
    } catch (const DomainError&) {
      continue;
    }
    const auto strata = decide_strata(without_assumptions(r)).told_apart();
    random_rounds(20, [&](Random& random) {
      auto values = random_values(random);
      const ExactPoint one(0, values);
      const NfElem shift(Rational(random.between(-5, 5), random.between(1, 3)));
      values[index_of("a")] = values[index_of("a")] + shift;
      values[index_of("b")] = values[index_of("b")] - shift;
      const ExactPoint other(0, values);
      SCOPED_TRACE(std::string(f.name) + " at " + one.text(family_ring));
      const auto x = the_stratum(strata, one), y = the_stratum(strata, other);
      ASSERT_TRUE(x && y);
      EXPECT_EQ(x->leaf.abelian, y->leaf.abelian) << reason(x->leaf) << "\nbut " << reason(y->leaf);
    });
  }
}

} // namespace
} // namespace kov::strata::substitution_test
