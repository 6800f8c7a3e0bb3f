// Work is counted: the same in each run, whatever the clock says.

#include "exact/meter.hpp"

#include "exact/error.hpp"
#include "exact/factor.hpp"
#include "exact/ideal.hpp"
#include "exact/polynomials.hpp"
#include "exact/share.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <thread>

namespace kov {
namespace {

using ::testing::HasSubstr;

class Meter : public testing::Polynomials {
protected:
  static double work_of(const std::function<void()>& task) {
    const double before = meter();
    task();
    return meter() - before;
  }
  [[nodiscard]] MPoly dense(unsigned long e) const {
    return pow((x + y + one).num(), e) * pow((x - y - one - one).num(), e);
  }
};

TEST_F(Meter, TheSameWorkTwice) {
  const MPoly f = dense(9), g = dense(7) * (x * y + one).num();
  const std::vector<std::function<void()>> tasks{
      [&] { static_cast<void>(f * g); },
      [&] { static_cast<void>(gcd(f, g)); },
      [&] { static_cast<void>(factor(g)); },
      [&] { static_cast<void>(resultant(f, g, 0)); },
      [&] { static_cast<void>(MFraction(f, g) + MFraction(g, f * f)); },
      [&] { static_cast<void>(irreducible_factors(pow(Poly::z(), 60) - Poly(1))); },
      [&] {
        const Ideal ideal(ring, {0, 1}, {(x * x * y - one).num(), (y * y * x - x - one).num()}, {});
        static_cast<void>(ideal.contains(f));
      }};
  for (const auto& task : tasks) {
    task(); // tables are made once
    const double first = work_of(task);
    EXPECT_GT(first, 0);
    EXPECT_EQ(first, work_of(task));
    double beside = 0;
    const std::jthread busy([](const std::stop_token& done) {
      while (!done.stop_requested()) {
      }
    });
    beside = work_of(task);
    EXPECT_EQ(first, beside);
  }
}

TEST_F(Meter, LargerProductsAreMoreWork) {
  const MPoly f = dense(4), g = dense(8);
  const double little = work_of([&] { static_cast<void>(f * f); });
  const double much = work_of([&] { static_cast<void>(g * g); });
  EXPECT_GT(much, 4 * little);
}

TEST_F(Meter, EachThreadHasItsOwn) {
  const double before = meter();
  std::jthread([] { charge(1000); }).join();
  EXPECT_EQ(meter(), before);
}

TEST_F(Meter, ABudgetEndsAtItsWork) {
  Budget budget;
  EXPECT_FALSE(budget.is_spent());
  budget.give(1000);
  charge(999);
  EXPECT_NO_THROW(budget.check());
  charge(2);
  EXPECT_TRUE(budget.is_spent());
  EXPECT_FALSE(budget.is_cut_short()); // that is of the clock
  try {
    budget.check();
    ADD_FAILURE() << "no limit";
  } catch (const OutOfBudget& limit) {
    EXPECT_THAT(limit.what(), HasSubstr("work limit of 1e+03 reached"));
  }
}

TEST_F(Meter, APartIsOfWhatIsLeft) {
  Budget whole;
  whole.give(1000);
  charge(500);
  const Budget part = part_of_the_work(whole, 0.5);
  EXPECT_NEAR(*part.work_end - meter(), 250, 1);
  EXPECT_EQ(part_of_the_work(whole, 1).work_end, whole.work_end);
  charge(600);
  EXPECT_EQ(part_of_the_work(whole, 0.5).work_end, whole.work_end); // nothing is left of it
  EXPECT_FALSE(part_of_the_work(Budget{}, 0.5).work_end.has_value());
}

TEST_F(Meter, WordsAreNotCounted) {
  const double before = meter();
  {
    const Unmetered words;
    charge(1000);
  }
  EXPECT_EQ(meter(), before);
}

TEST_F(Meter, TheClockCutsShort) {
  EXPECT_FALSE(Budget::of_seconds(60).is_cut_short());
  EXPECT_TRUE(Budget::of_seconds(-1).is_cut_short());
}

} // namespace
} // namespace kov
