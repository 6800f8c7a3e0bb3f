// Several solutions of one system as one theorem: the union of what they exclude, point by point.

#include "integrability/one_level.hpp"
#include "study/together.hpp"

#include "exact/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace kov::together_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

System with_parameters(const std::string& assume = "") {
  return read_system(parse_document(
      "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
      "parameters = ['a', 'b', 'h', 'k']\nhamiltonian = '(u^2 + v^2)/2 + a*x^2*y + b*y^3'\n" +
          assume +
          "[[manifold]]\nname = 'x'\nequations = ['x = 0', 'u = 0']\nlevel = ['H = h + k']\n",
      "test.toml"));
}

MPoly number(const Ring& ring, long n) { return MPoly(ring, Integer(n)); }

// Here with a = i, b = j: is the point in the set?
bool contains(const Set& s, long i, long j) {
  const MPoly a = MPoly::variable(s.ring(), "a"), b = MPoly::variable(s.ring(), "b");
  return !s.where_zero(a - number(s.ring(), i)).where_zero(b - number(s.ring(), j)).is_empty();
}

class Together : public testing::Test {
protected:
  System s_ = with_parameters();
  MPoly a_ = MPoly::variable(s_.ring(), "a"), b_ = MPoly::variable(s_.ring(), "b");
  std::mt19937 random_{17};

  MPoly line() {
    std::uniform_int_distribution<long> c(-2, 2);
    return number(s_.ring(), c(random_)) * a_ + number(s_.ring(), c(random_)) * b_ +
           number(s_.ring(), c(random_));
  }
  long at(const MPoly& p, long i, long j) const {
    const MFraction value =
        substitute(MFraction(p), {{s_.ring()->index("a"), MFraction(number(s_.ring(), i))},
                                  {s_.ring()->index("b"), MFraction(number(s_.ring(), j))}});
    return is_zero(value) ? 0 : 1;
  }
  bool holds(const Exclusion& e, long i, long j) const {
    const auto vanishes = [&](const MPoly& p) { return at(p, i, j) == 0; };
    return std::all_of(e.zero.begin(), e.zero.end(), vanishes) &&
           std::none_of(e.not_all_zero.begin(), e.not_all_zero.end(), [&](const auto& list) {
             return std::all_of(list.begin(), list.end(), vanishes);
           });
  }
};

// Each point is in one stratum, which is excluded by the first of the reasons that hold there.
TEST_F(Together, TheFirstReasonExcludes) {
  for (int family = 0; family < 12; ++family) {
    std::vector<Exclusion> all;
    for (int k = 0; k < 3; ++k) {
      Exclusion e;
      if (k != 1) e.zero = {line()};
      e.not_all_zero = {{line(), line()}, {line()}};
      e.by.solution = std::to_string(k);
      all.push_back(std::move(e));
    }
    const SystemClassification c = together(s_, all);
    for (long i = -2; i <= 2; ++i)
      for (long j = -2; j <= 2; ++j) {
        std::string expected = "open", found;
        for (auto e = all.rbegin(); e != all.rend(); ++e)
          if (holds(*e, i, j)) expected = e->by.solution;
        for (const ClassifiedStratum& x : c.strata)
          if (contains(x.where, i, j))
            found += x.status == StratumStatus::excluded ? x.by.front().solution : "open";
        EXPECT_EQ(found, expected) << family << ": " << i << ' ' << j;
      }
  }
}

TEST_F(Together, TwoHalvesAreTheWhole) {
  Exclusion here, there;
  here.not_all_zero = {{a_}};
  there.zero = {a_};
  EXPECT_EQ(together(s_, {here, there}).status(), Verdict::non_integrable);
  EXPECT_EQ(together(s_, {there, here}).status(), Verdict::non_integrable);
  EXPECT_EQ(together(s_, {here}).status(), Verdict::undecided);
  EXPECT_EQ(together(s_, {}).status(), Verdict::undecided);
}

TEST_F(Together, WhatIsAssumedEmptyIsNotOpen) {
  const System positive = with_parameters("[assume]\na = 'positive'\n");
  Exclusion here;
  here.not_all_zero = {{MPoly::variable(positive.ring(), "a")}};
  EXPECT_EQ(together(positive, {here}).status(), Verdict::non_integrable);
}

// One may choose h if what is assumed leaves a value outside of every curve.
std::vector<std::string> chosen(const std::string& conditions) {
  const System s = with_parameters("[assume]\nconditions = [" + conditions + "]\n");
  std::vector<std::string> names;
  for (const std::size_t i : free_levels(s))
    names.push_back(s.ring()->name(i));
  return names;
}

TEST(FreeLevels, HalfLinesAndInequationsLeaveEnough) {
  EXPECT_THAT(chosen(""), ElementsAre("h", "k"));
  EXPECT_THAT(chosen("'h > 0'"), ElementsAre("h", "k"));
  EXPECT_THAT(chosen("'h > a', 'h != b'"), ElementsAre("h", "k"));
  EXPECT_THAT(chosen("'k <= -3'"), ElementsAre("h", "k"));
  EXPECT_THAT(chosen("'h^2 < 1'"), ElementsAre("h", "k")); // open, and not empty
  EXPECT_THAT(chosen("'h > k'"), ElementsAre("h", "k"));
}

TEST(FreeLevels, OthersAreParametersLikeAll) {
  EXPECT_THAT(chosen("'h = a'"), ElementsAre("k"));
  EXPECT_THAT(chosen("'h >= 0', 'h <= 0'"), ElementsAre("k"));
  EXPECT_THAT(chosen("'a*h > 0'"), ElementsAre("k"));
  EXPECT_THAT(chosen("'a*h^2 < 1'"), ElementsAre("k"));
  EXPECT_THAT(chosen("'h > a*k'"), IsEmpty());
}

} // namespace
} // namespace kov::together_test
