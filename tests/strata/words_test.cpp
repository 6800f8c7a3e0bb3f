// Every stratum has its words: a reason, a group where it is decided, what is left where it is not.

#include "strata/specialisation.hpp"
#include "strata/words.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov::strata {
namespace {

using testing::HasSubstr;
using testing::Not;

const Ring ring = make_ring({"z", "a", "b", "n"});
const MFraction z = MFraction::variable(ring, "z");
const MFraction a = MFraction::variable(ring, "a");
const MFraction b = MFraction::variable(ring, "b");
const MFraction n = MFraction::variable(ring, "n");

MFraction number(long p, long q = 1) { return MFraction(ring, Rational(p, q)); }

// The term (d^2 - 1)/4 with exponent difference d at a pole.
MFraction of_difference(const MFraction& d) { return (d * d - number(1)) / number(4); }

struct Kind {
  const char* name;
  MFraction r;
};
void PrintTo(const Kind& k, std::ostream* out) { *out << k.name; }

std::vector<Kind> kinds() {
  const MFraction one = number(1);
  const MFraction riemann =
      of_difference(a) / (z * z) + of_difference(b) / ((z - one) * (z - one)) +
      (of_difference(n) - of_difference(a) - of_difference(b)) / (z * (z - one));
  const MFraction cubic = number(4) * z * z * z - a * z - b;
  const MFraction slope = number(12) * z * z - a;
  return {
      {"Bessel", -one + (n * n - number(1, 4)) / (z * z)},
      {"Whittaker", number(1, 4) - a / z + (b * b - number(1, 4)) / (z * z)},
      {"Weber", z * z + a},
      {"Airy", a * z + b},
      {"Constant", a},
      {"Euler", of_difference(n) / (z * z)},
      {"Riemann", riemann},
      {"Quartic", z * z * z * z + a * z + b},
      {"QuarticWithOddLength", z * z * z + a * z},
      {"Lame", (n * (n + one) * z + b) / cubic - number(3, 16) * slope * slope / (cubic * cubic) +
                   number(12) * z / (number(2) * cubic)},
      {"IrrationalDifference", a / ((z * z + one) * (z * z + one)) + b / (z * z)},
      {"ManyPoles", a / (z * z) + b / ((z - one) * (z - one)) + n / ((z + one) * (z + one))},
      {"PoleOfOrderFour", a / (z * z * z * z) + b / (z * z) + n},
      {"Logarithm", of_difference(number(2)) / (z * z) + a / z + b},
      {"PulledBack", number(4) * z * z * (-one + (n * n - number(1, 4)) / (z * z * z * z)) +
                         number(3, 4) / (z * z)},
      {"TwoIrregularPlaces", a / (z * z * z) + b / z + one},
      {"Reducible", a * a + a / z},
      {"Dihedral",
       -number(3, 16) / (z * z) - number(3, 16) / ((z - one) * (z - one)) + a / (z * (z - one))},
  };
}

class Words : public testing::TestWithParam<Kind> {};

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

INSTANTIATE_TEST_SUITE_P(OfFamilies, Words, testing::ValuesIn(kinds()),
                         [](const auto& one) { return std::string(one.param.name); });

} // namespace
} // namespace kov::strata
