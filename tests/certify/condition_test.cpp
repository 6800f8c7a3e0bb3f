// Signs over the reals, theorem_certificates.md 2: for each rule something true and something false
// that looks like it.

#include "certify/equation/facts.hpp"
#include "proof/condition/show.hpp"

#include <gmock/gmock.h>

namespace kov::certify::condition_test {
namespace {

const Ring& ring() {
  static const Ring r = make_ring({"a", "b"});
  return r;
}

bool proves(const Conditions& given, const std::string& node,
            std::vector<bool> real = {true, true}) {
  Arithmetic arithmetic;
  std::size_t nodes = 100;
  const Json json = parse_json(node);
  ConditionSet set(ring(), arithmetic, {true, true}, std::move(real));
  for (const Condition& c : given)
    set.assume(c);
  try {
    SetProof(set, nodes).absent(Node(json, "node", rationals()));
    return true;
  } catch (const Refused&) {
    return false;
  }
}

Condition is(const char* f, Sign sign) { return {read_polynomial(ring(), f), sign}; }

const char* const sum_of_both =
    R"({"node":"empty","terms":[["1","1",["0","1"]],["1","1",["1","1"]]],"zeros":[]})";
const char* const squares =
    R"({"node":"empty","terms":[["1","1",["1","2"]],["1","b"]],"zeros":[["0","-1"]]})";

TEST(SetProof, OneTermIsStrict) {
  EXPECT_TRUE(proves({is("a", Sign::positive), is("-a", Sign::nonnegative)}, sum_of_both));
  EXPECT_FALSE(proves({is("a", Sign::nonnegative), is("-a", Sign::nonnegative)}, sum_of_both));
}

TEST(SetProof, WhatIsNotZeroHasAnEvenPower) {
  EXPECT_FALSE(proves({is("a", Sign::nonzero), is("-a", Sign::nonnegative)}, sum_of_both));
  EXPECT_TRUE(proves({is("a^2 + b^2", Sign::zero), is("a", Sign::nonzero)}, squares));
  EXPECT_FALSE(proves({is("a^2 - b^2", Sign::zero), is("a", Sign::nonzero)}, squares));
}

TEST(SetProof, OnlyEquationsHaveCofactors) {
  EXPECT_FALSE(proves({is("a^2 + b^2", Sign::nonnegative), is("a", Sign::nonzero)}, squares));
}

TEST(SetProof, ANumberIsPositive) {
  const char* const node =
      R"({"node":"empty","terms":[["1","1",["1","1"]],["2","1"]],"zeros":[["0","-1"]]})";
  EXPECT_TRUE(proves({is("a", Sign::zero), is("a - 2", Sign::nonnegative)}, node));
  EXPECT_FALSE(proves({is("a", Sign::zero), is("a + 2", Sign::nonnegative)}, node));
  EXPECT_FALSE(proves({is("a", Sign::zero)}, R"({"node":"empty","terms":[],"zeros":[]})"));
}

bool proves_of_complex(const Conditions& given, const std::string& node) {
  return proves(given, node, {false, true});
}

TEST(SetProof, ASumOfSquaresMayVanishAtComplexNumbers) {
  const char* const no_root =
      R"({"node":"empty","terms":[["1","1"],["1","a"]],"zeros":[["0","-1"]]})";
  EXPECT_TRUE(proves({is("a^2 + 1", Sign::zero)}, no_root));
  EXPECT_FALSE(proves_of_complex({is("a^2 + 1", Sign::zero)}, no_root));
}

TEST(SetProof, OneProductThatIsAnEquation) {
  const char* const odd = R"({"node":"empty","terms":[["1","1",["0","1"]]],"zeros":[["1","-1"]]})";
  EXPECT_TRUE(proves_of_complex({is("a", Sign::nonzero), is("a", Sign::zero)}, odd));
  EXPECT_FALSE(proves_of_complex({is("a", Sign::nonzero), is("a + 1", Sign::zero)}, odd));
  EXPECT_FALSE(proves_of_complex({is("a", Sign::nonnegative), is("a", Sign::zero)}, odd));
}

TEST(SetProof, ComplexNumbersHaveNoSign) {
  const std::string empty =
      R"({"node":"empty","terms":[["1","1",["0","1"]]],"zeros":[["0","-1"]]})";
  EXPECT_FALSE(proves_of_complex({is("a", Sign::zero)}, R"({"node":"sign","p":"a","positive":)" +
                                                            empty + R"(,"zero":)" + empty +
                                                            R"(,"negative":)" + empty + "}"));
}

TEST(SetProof, ATermMayBeStrictByWhatIsNotZero) {
  const Condition zero = is("a^2*b^2", Sign::zero);
  const char* const square = R"({"node":"empty","terms":[["1","a*b"]],"zeros":[["0","-1"]]})";
  for (const bool real : {true, false}) {
    const auto with = [&](Sign of_b) {
      return proves({zero, is("a", Sign::nonzero), is("b", of_b)}, square, {real, real});
    };
    EXPECT_TRUE(with(Sign::nonzero));
    EXPECT_TRUE(with(Sign::positive));
    EXPECT_FALSE(with(Sign::nonnegative));
    EXPECT_FALSE(with(Sign::zero));
  }
  EXPECT_FALSE(
      proves({is("b^2", Sign::zero)}, R"({"node":"empty","terms":[["1","0"]],"zeros":[]})"));
}

/// A set of complex a and b.
struct Values {
  Arithmetic arithmetic{};
  ConditionSet set{ring(), arithmetic, {true, true}, {false, false}};
  explicit Values(const Conditions& all = {}) {
    for (const Condition& c : all)
      set.assume(c);
  }
  [[nodiscard]] static MPoly poly(const char* f) { return read_polynomial(ring(), f); }
  [[nodiscard]] bool shows(const char* num, const char* den, bool integral, long times) const {
    try {
      set.need_shown({{poly(num), poly(den)}, integral, Integer(times), 0, {}});
      return true;
    } catch (const Refused&) {
      return false;
    }
  }
};

TEST(ConditionSet, RealIsWhatASignSays) {
  const Values x({is("a*b", Sign::positive), is("a", Sign::nonzero)});
  EXPECT_TRUE(x.set.is_real(Values::poly("-2*a*b")));
  EXPECT_TRUE(x.set.is_real(Values::poly("3")));
  EXPECT_FALSE(x.set.is_real(Values::poly("a")));
  EXPECT_FALSE(x.set.is_real(Values::poly("a^2*b^2")));
  EXPECT_TRUE(x.set.is_positive(Values::poly("2*a*b")));
  EXPECT_FALSE(x.set.is_positive(Values::poly("-a*b")));
}

TEST(ConditionSet, UnitsAreProductsOfThem) {
  Values x({is("a*b - b", Sign::nonzero), is("a - 1", Sign::positive)});
  EXPECT_TRUE(x.set.is_unit(Values::poly("a*b^3 - b^3")));
  EXPECT_FALSE(x.set.is_unit(Values::poly("a*b")));
  EXPECT_FALSE(x.set.is_unit(Values::poly("0")));
  x.set.assume(is("a", Sign::nonzero));
  EXPECT_TRUE(x.set.is_unit(Values::poly("a*b")));
  x.set.forget();
  EXPECT_FALSE(x.set.is_unit(Values::poly("a*b")));
  // a = 2, before and after anything is asked
  Values y({is("b*a - 1", Sign::nonzero)});
  for (Values* z : {&x, &y})
    static_cast<void>(z->set.solve(Values::poly("a - 2"), 0));
  EXPECT_TRUE(x.set.is_unit(Values::poly("b")));
  EXPECT_TRUE(y.set.is_unit(Values::poly("2*b - 1")));
  EXPECT_FALSE(y.set.is_unit(Values::poly("b")));
}

TEST(ConditionSet, IntegersThatFollow) {
  Values x, none;
  x.set.assume(Membership{{Values::poly("a"), Values::poly("1")}, true});
  none.set.assume(Membership{{Values::poly("a"), Values::poly("1")}, false});
  EXPECT_TRUE(x.shows("2*a", "1", true, 2));
  EXPECT_FALSE(x.shows("a", "2", true, 1));       // half of an integer
  EXPECT_FALSE(x.shows("a^2", "a", true, 1));     // at a = 0
  EXPECT_FALSE(none.shows("2*a", "1", false, 1)); // twice what is none
  EXPECT_TRUE(none.shows("a", "2", false, 2));
  EXPECT_FALSE(none.set.is_real(Values::poly("a")));
}

} // namespace
} // namespace kov::certify::condition_test
