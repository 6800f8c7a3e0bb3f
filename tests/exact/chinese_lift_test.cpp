#include "exact/chinese_lift.hpp"

#include "exact/error.hpp"
#include "exact/fields.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

using namespace testing;

class ChineseLiftLaws : public OverFields {
protected:
  static void add_residues(ChineseLift& lift, const std::vector<PrimeIdeal>& ideals,
                           const std::vector<NfElem>& elements) {
    std::vector<std::vector<mp_limb_t>> rows;
    for (const PrimeIdeal& ideal : ideals) {
      auto& row = rows.emplace_back();
      for (const NfElem& e : elements)
        row.push_back(ideal.reduce(e).value());
    }
    lift.add(ideals, rows);
  }
};

TEST_P(ChineseLiftLaws, ElementsComeBackFromTheirResidues) {
  const std::vector<NfElem> elements{element(), NfElem(k), element(), NfElem(Rational(-5, 7), k)};
  ChineseLift lift(k, elements.size());
  PrimeIdeals primes = PrimeIdeals::large(k);
  add_residues(lift, primes.next_split(), elements);
  const auto found = lift.reconstruct();
  ASSERT_TRUE(found);
  EXPECT_EQ(*found, elements);
  EXPECT_EQ(lift.primes(), 1U);
}

TEST_P(ChineseLiftLaws, LongElementsNeedMorePrimesAndNoFewer) {
  const NfElem large = NfElem(Rational(pow(Integer(3), 70), pow(Integer(2), 90))) * nonzero();
  const std::vector<NfElem> elements{coerce(large, k), element()};
  ChineseLift lift(k, 2);
  PrimeIdeals primes = PrimeIdeals::large(k);
  std::size_t needed = 0;
  for (std::size_t i = 1; i <= 6; ++i) {
    add_residues(lift, primes.next_split(), elements);
    const auto found = lift.reconstruct();
    if (found && *found == elements && needed == 0) needed = i;
    if (needed != 0) { // once right, right with every further prime
      ASSERT_TRUE(found);
      EXPECT_EQ(*found, elements);
    }
  }
  EXPECT_GE(needed, 3U); // numerator and denominator have more than 180 bits together
  EXPECT_LE(needed, 5U);
}

TEST_P(ChineseLiftLaws, ResiduesOfAllIdealsAreNeeded) {
  ChineseLift lift(k, 1);
  PrimeIdeals primes(k, 1000);
  auto ideals = primes.next_split();
  EXPECT_THROW(lift.add(ideals, {}), InternalError);
}

KOV_OVER_ALL_FIELDS(ChineseLiftLaws);

// The tries together cost a constant factor: their numbers of primes grow like a geometric series.
TEST(ChineseLift, TriesAreRare) {
  std::size_t last = 1;
  std::size_t sum = 0;
  for (std::size_t n = 1; n <= 3000; ++n) {
    if (!worth_a_try(n)) continue;
    EXPECT_LE(n, 2 * last);
    sum += n;
    EXPECT_LE(sum, 5 * n);
    last = n;
  }
  EXPECT_FALSE(worth_a_try(5));
  EXPECT_TRUE(worth_a_try(3072));
}

} // namespace
} // namespace kov
