#include "moves/equivalence.hpp"

#include "families.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov {
namespace {

Equivalence diagonal(const System& s, const std::vector<long>& factors, long time, long bracket) {
  Equivalence e;
  e.ring = s.ring();
  for (std::size_t i = 0; i < factors.size(); ++i)
    e.phase.push_back(Rational(factors[i]) * MFraction::variable(s.ring(), s.field.coordinates[i]));
  e.time = MFraction(s.ring(), Rational(time));
  e.bracket = MFraction(s.ring(), Rational(bracket));
  return e;
}

// It carries the field: integrals, but neither involution nor leaves.
TEST(Equivalences, TheBracketIsCarriedToAMultiple) {
  const System s = in_the_plane("'a'", "(p1^2 + p2^2 + q1^2 + a*q2^2)/2");
  EXPECT_TRUE(holds(s, diagonal(s, {2, 2, 2, 2}, 1, 4)));
  EXPECT_FALSE(holds(s, diagonal(s, {2, 2, 2, 2}, 1, 1)));
  for (const long bracket : {1L, 4L})
    EXPECT_FALSE(holds(s, diagonal(s, {2, 1, 2, 1}, 1, bracket)));
}

TEST(Equivalences, TheTimeMayRunBackwards) {
  const System s = in_the_plane("'a'", "(p1^2 + p2^2)/2 + a*q1^3 + q1*q2^2");
  EXPECT_TRUE(holds(s, diagonal(s, {1, 1, -1, -1}, -1, -1)));
  EXPECT_FALSE(holds(s, diagonal(s, {1, 1, -1, -1}, 1, -1)));
  EXPECT_FALSE(holds(s, diagonal(s, {1, 1, -1, -1}, -1, 1)));
}

TEST(Equivalences, TheyAreInvertible) {
  const System s = in_the_plane("", "0*q1");
  EXPECT_FALSE(holds(s, diagonal(s, {1, 1, 0, 0}, 1, 0)));
}

// q1 is left out at a = 0: q2 is left out where the other parameter is 0.
TEST(Equivalences, AClassIsCarriedWithWhatItLeavesOut) {
  const System s = in_the_plane("'a', 'b'", "(p1^2 + p2^2)/2 + a*q1^3 + b*q2^3");
  Equivalence swap = diagonal(s, {1, 1, 1, 1}, 1, 1);
  std::swap(swap.phase[0], swap.phase[1]);
  std::swap(swap.phase[2], swap.phase[3]);
  const MFraction a = MFraction::variable(s.ring(), "a"), b = MFraction::variable(s.ring(), "b");
  swap.parameters = {{s.ring()->index("a"), b}, {s.ring()->index("b"), a}};
  ASSERT_TRUE(holds(s, swap));
  ClassifiedStratum x{.where = Set(s.ring(), s.field.parameters),
                      .status = StratumStatus::excluded};
  x.by.resize(1);
  x.by.front().integrals.without = {"q1"};
  const auto there = carried(s, swap, x);
  ASSERT_TRUE(there);
  EXPECT_EQ(there->stratum.by.front().integrals.without, std::vector<std::string>{"q2"});
  // what is left does not use q2: functions of q1 only, behind the map
  Equivalence mixed = swap;
  mixed.phase[0] = mixed.phase[0] + mixed.phase[1];
  ASSERT_TRUE(carried(s, mixed, x));
  EXPECT_EQ(carried(s, mixed, x)->stratum.by.front().integrals.without,
            std::vector<std::string>{"q2"});
  // what is left uses both
  mixed = swap;
  mixed.phase[1] = mixed.phase[0] + mixed.phase[1];
  EXPECT_FALSE(carried(s, mixed, x));
}

} // namespace
} // namespace kov
