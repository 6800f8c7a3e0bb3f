// Every stratum has its words: a reason, a group where it is decided, what is left where it is not.

#include "strata/families.hpp"
#include "strata/specialisation.hpp"
#include "strata/words.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov::strata::words_test {
namespace {

using testing::HasSubstr;
using testing::Not;

using test::Family;

class Words : public testing::TestWithParam<Family> {};

TEST_P(Words, EveryStratumHasThem) {
  Question q;
  q.r = GetParam().r;
  const StrataAnswer answer = decide_strata(q);
  ASSERT_FALSE(answer.strata.empty());
  for (const Stratum& s : answer.told_apart()) {
    const std::string where = to_string(s.conditions);
    for (const std::string& text : condition_texts(s))
      EXPECT_FALSE(text.empty());
    const std::string why = reason(s.leaf);
    EXPECT_FALSE(why.empty()) << where;
    EXPECT_LE(reason_in_brief(s.leaf).size(), why.size()) << where;
    if (s.leaf.abelian == Truth::unknown) {
      EXPECT_THAT(why, HasSubstr("undecided")) << where;
    } else {
      EXPECT_THAT(why, Not(HasSubstr("undecided"))) << where;
      EXPECT_THAT(open_condition(s.leaf), testing::IsEmpty()) << where;
    }
    if (s.leaf.group) {
      EXPECT_FALSE(group_text(s.leaf).empty()) << where;
    }
  }
}

// The same strata at random points, by the solver without parameters.
TEST_P(Words, AndItsVerdictAtPoints) {
  Question q;
  q.r = GetParam().r;
  const StrataAnswer answer = decide_strata(q);
  test::compare(q, answer, 20261122);
}

INSTANTIATE_TEST_SUITE_P(OfFamilies, Words, testing::ValuesIn(test::families()),
                         [](const auto& one) { return std::string(one.param.name); });

} // namespace
} // namespace kov::strata::words_test
