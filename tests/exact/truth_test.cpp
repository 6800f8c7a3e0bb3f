// Answers, limits and errors: truth.hpp, budget.hpp, error.hpp.

#include "exact/truth.hpp"

#include "exact/budget.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

TEST(Truth, UnknownIsNeitherCertainNorExcluded) {
  const struct {
    Truth t, opposite;
    bool certain;
  } table[] = {{Truth::yes, Truth::no, true},
               {Truth::no, Truth::yes, false},
               {Truth::unknown, Truth::unknown, false}};
  for (const auto& [t, opposite, certain] : table) {
    EXPECT_EQ(!t, opposite);
    EXPECT_EQ(!!t, t);
    EXPECT_EQ(certainly(t), certain);
    EXPECT_FALSE(certainly(t) && certainly(!t));
  }
  EXPECT_EQ(truth(true), Truth::yes);
  EXPECT_EQ(truth(false), Truth::no);
}

TEST(Budget, NoLimitIsNeverOver) {
  const Budget none;
  EXPECT_NO_THROW(none.check());
  EXPECT_NO_THROW(none.check_degree(none.max_degree));
  EXPECT_THROW(none.check_degree(none.max_degree + 1), OutOfBudget);
}

TEST(Budget, TimeIsOverAfterTheDeadlineAndSaysHowLongItWas) {
  EXPECT_NO_THROW(Budget::of_seconds(1000).check());
  for (const auto& [seconds, text] :
       {std::pair(0.0, "time limit of 0 s reached"), {-1.5, "time limit of -1.5 s reached"}}) {
    Budget late = Budget::of_seconds(seconds);
    late.deadline = *late.deadline - std::chrono::seconds(1);
    try {
      late.check();
      ADD_FAILURE() << "the time was over";
    } catch (const OutOfBudget& e) {
      EXPECT_STREQ(e.what(), text);
    }
  }
}

TEST(Budget, StopsOnRequest) {
  std::stop_source source;
  Budget budget;
  budget.stop = source.get_token();
  EXPECT_NO_THROW(budget.check());
  source.request_stop();
  EXPECT_THROW(budget.check(), OutOfBudget);
}

TEST(Error, AFailedCheckSaysWhereWithoutPathsOfTheMachine) {
  try {
    KOV_ENSURE(1 + 1 == 3);
    ADD_FAILURE() << "the check let it pass";
  } catch (const InternalError& e) {
    const std::string what = e.what();
    EXPECT_NE(what.find("1 + 1 == 3 (exact/truth_test.cpp:"), std::string::npos) << what;
  }
  EXPECT_NO_THROW(KOV_ENSURE(1 + 1 == 2));
}

TEST(Error, AllErrorsHaveOneBase) {
  EXPECT_THROW(throw InvalidArgument("x"), Error);
  EXPECT_THROW(throw DomainError("x"), Error);
  EXPECT_THROW(throw OutOfBudget("x"), Error);
  EXPECT_THROW(throw InternalError("x"), std::runtime_error);
}

} // namespace
} // namespace kov
