// The frame of the random attacks itself.

#include "support/random.hpp"

#include <gmock/gmock.h>

namespace kov::test {
namespace {

TEST(RandomRounds, RepeatThemselvesAndDifferFromEachOther) {
  const auto draw = [](std::uint64_t seed) {
    Random random(seed);
    std::vector<long> drawn;
    for (int i = 0; i < 20; ++i)
      drawn.push_back(random.between(-1000, 1000));
    return drawn;
  };
  EXPECT_EQ(draw(1), draw(1));
  EXPECT_NE(draw(1), draw(2));
  EXPECT_THAT(draw(3),
              ::testing::Each(::testing::AllOf(::testing::Ge(-1000), ::testing::Le(1000))));
}

TEST(RandomRounds, AFailureIsReproducedByACommand) {
  EXPECT_THAT(
      reproduced_by(17),
      ::testing::MatchesRegex(
          "reproduce: KOV_RANDOM_SEED=17 KOV_RANDOM_ROUNDS=1 build/release/tests/test_random "
          "--gtest_filter=RandomRounds.AFailureIsReproducedByACommand"));
}

} // namespace
} // namespace kov::test
