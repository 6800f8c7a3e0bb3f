// Z3 as an oracle: what it may do to the process.

#include "parameters/reals.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>
#include <unistd.h>

namespace kov::reals_test {
namespace {

volatile std::sig_atomic_t interrupts = 0;

// Equations of degree six in six unknowns: longer than any limit of this test.
std::vector<Condition> long_question() {
  const Ring ring = make_ring({"a", "b", "c", "d", "e", "f"});
  std::vector<Condition> all;
  for (std::size_t i = 0; i < ring->size(); ++i) {
    MFraction sum(ring, Rational(static_cast<long>(i) - 7));
    for (std::size_t k = 0; k < ring->size(); ++k) {
      const MFraction x = MFraction::variable(ring, ring->name(k));
      const MFraction y = MFraction::variable(ring, ring->name((k + i + 1) % ring->size()));
      sum = sum +
            MFraction(ring, Rational(static_cast<long>(2 * k + i + 3))) * x * x * x * y * y * y -
            x * y;
    }
    all.push_back({sum.num(), Sign::zero});
  }
  return all;
}

// Z3 has a handler of its own for the interrupt, which keeps the first one to itself.
TEST(Reals, AnInterruptReachesTheHandlerOfTheProgram) {
  const auto before = std::signal(SIGINT, [](int) { interrupts = interrupts + 1; });
  std::jthread sender([] {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    static_cast<void>(::kill(::getpid(), SIGINT)); // to the process, as a terminal does
  });
  static_cast<void>(has_real_point(long_question()));
  sender.join();
  static_cast<void>(std::signal(SIGINT, before));
  EXPECT_EQ(interrupts, 1);
}

TEST(Reals, WhoeverAsksToStopDoesNotWait) {
  std::stop_source source;
  Budget budget = Budget::of_seconds(60);
  budget.stop = source.get_token();
  budget.max_work = 1e12;
  const auto begun = Budget::Clock::now();
  const std::jthread sender([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    source.request_stop();
  });
  EXPECT_THROW(static_cast<void>(has_real_point(long_question(), budget)), OutOfBudget);
  EXPECT_LT(Budget::Clock::now() - begun, std::chrono::seconds(30));
}

// Answers are kept: what was cut short at any time is asked again.
TEST(Reals, AnAnswerThatWasCutShortIsNotKept) {
  const Ring ring = make_ring({"a", "b", "c"});
  const auto x = [&](const char* name) { return MFraction::variable(ring, name); };
  for (long k = 1; k <= 20; ++k) {
    const MFraction sum = x("a") * x("a") * x("b") + x("b") * x("c") * x("c") - x("a") * x("c");
    const std::vector<Condition> all{
        {(sum * sum + x("b") * x("b") - MFraction(ring, Rational(k))).num(), Sign::zero},
        {(x("a") * x("b") * x("c") - MFraction(ring, Rational(k))).num(), Sign::positive}};
    std::stop_source source;
    Budget budget;
    budget.stop = source.get_token();
    {
      const std::jthread sender([&] {
        std::this_thread::sleep_for(std::chrono::microseconds(k * 150));
        source.request_stop();
      });
      try {
        static_cast<void>(has_real_point(all, budget));
      } catch (const OutOfBudget&) {
      }
    }
    EXPECT_EQ(has_real_point(all), Truth::yes) << k;
  }
}

} // namespace
} // namespace kov::reals_test
