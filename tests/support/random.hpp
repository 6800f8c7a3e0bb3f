#pragma once
// Random attacks: the same rounds in every run of the suite, fresh ones with tools/attack.
//
//   TEST(Families, AgreeWithThePointwiseSolver) {
//     random_rounds(200, [](Random& random) {
//       const long a = random.between(-5, 5);
//       ...
//       EXPECT_EQ(...) << text_of_the_case;
//     });
//   }
//
// A failure prints the command that repeats its round alone.  Environment: KOV_RANDOM_SEED is the
// seed of the first round (else 1), KOV_RANDOM_ROUNDS the number of rounds (else what the test
// says).

#include <gtest/gtest.h>

#include <cerrno> // program_invocation_short_name
#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

namespace kov::test {

/// A stream of random choices; the same seed gives the same stream on every machine.
class Random {
public:
  explicit Random(std::uint64_t seed) : bits_(seed), seed_(seed) {}

  /// lowest <= value <= highest
  [[nodiscard]] long between(long lowest, long highest) {
    return lowest + static_cast<long>(bits_() % static_cast<std::uint64_t>(highest - lowest + 1));
  }
  /// true once in `n` times
  [[nodiscard]] bool once_in(long n) { return between(1, n) == 1; }
  /// one of the members; requires at least one
  template <class T> [[nodiscard]] const T& one_of(const std::vector<T>& members) {
    return members[static_cast<std::size_t>(between(0, static_cast<long>(members.size()) - 1))];
  }
  [[nodiscard]] std::mt19937_64& bits() { return bits_; }
  [[nodiscard]] std::uint64_t seed() const { return seed_; }

private:
  std::mt19937_64 bits_;
  std::uint64_t seed_;
};

[[nodiscard]] inline std::uint64_t number_in_environment(const char* name,
                                                         std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text != nullptr && *text != '\0' ? std::strtoull(text, nullptr, 10) : otherwise;
}

/// The command that repeats the round with this seed in the test that runs now.
[[nodiscard]] inline std::string reproduced_by(std::uint64_t seed) {
  const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
  return "reproduce: KOV_RANDOM_SEED=" + std::to_string(seed) +
         " KOV_RANDOM_ROUNDS=1 build/release/tests/" + program_invocation_short_name +
         " --gtest_filter=" + info->test_suite_name() + "." + info->name();
}

/// Calls attack(Random&) round after round, each with a seed of its own, until one of them fails.
template <class Attack> void random_rounds(std::uint64_t usual, Attack attack) {
  const std::uint64_t first = number_in_environment("KOV_RANDOM_SEED", 1);
  const std::uint64_t rounds = number_in_environment("KOV_RANDOM_ROUNDS", usual);
  for (std::uint64_t i = 0; i < rounds && !::testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE(reproduced_by(first + i));
    Random random(first + i);
    attack(random);
  }
}

} // namespace kov::test
