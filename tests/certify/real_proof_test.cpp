// Signs over the reals, theorem_certificates.md 2: for each rule something true and something false
// that looks like it.

#include "certify/equation/facts.hpp"
#include "certify/theorem/real_proof.hpp"

#include <gmock/gmock.h>

namespace kov::certify {
namespace {

const Ring& ring() {
  static const Ring r = make_ring({"a", "b"});
  return r;
}

bool proves(Conditions given, const std::string& node) {
  Arithmetic arithmetic;
  std::size_t nodes = 100;
  const Json json = parse_json(node);
  try {
    RealProof(ring(), {true, true}, arithmetic, nodes)
        .refute(Node(json, "node", rationals()), given);
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

TEST(RealProof, OneTermIsStrict) {
  EXPECT_TRUE(proves({is("a", Sign::positive), is("-a", Sign::nonnegative)}, sum_of_both));
  EXPECT_FALSE(proves({is("a", Sign::nonnegative), is("-a", Sign::nonnegative)}, sum_of_both));
}

TEST(RealProof, WhatIsNotZeroHasAnEvenPower) {
  EXPECT_FALSE(proves({is("a", Sign::nonzero), is("-a", Sign::nonnegative)}, sum_of_both));
  EXPECT_TRUE(proves({is("a^2 + b^2", Sign::zero), is("a", Sign::nonzero)}, squares));
  EXPECT_FALSE(proves({is("a^2 - b^2", Sign::zero), is("a", Sign::nonzero)}, squares));
}

TEST(RealProof, OnlyEquationsHaveCofactors) {
  EXPECT_FALSE(proves({is("a^2 + b^2", Sign::nonnegative), is("a", Sign::nonzero)}, squares));
}

TEST(RealProof, ANumberIsPositive) {
  const char* const node =
      R"({"node":"empty","terms":[["1","1",["1","1"]],["2","1"]],"zeros":[["0","-1"]]})";
  EXPECT_TRUE(proves({is("a", Sign::zero), is("a - 2", Sign::nonnegative)}, node));
  EXPECT_FALSE(proves({is("a", Sign::zero), is("a + 2", Sign::nonnegative)}, node));
  EXPECT_FALSE(proves({is("a", Sign::zero)}, R"({"node":"empty","terms":[],"zeros":[]})"));
}

bool proves_of_complex(Conditions given, const std::string& node) {
  Arithmetic arithmetic;
  std::size_t nodes = 100;
  const Json json = parse_json(node);
  try {
    RealProof(ring(), {false, true}, arithmetic, nodes, {true, false})
        .refute(Node(json, "node", rationals()), given);
    return true;
  } catch (const Refused&) {
    return false;
  }
}

TEST(RealProof, ASumOfSquaresMayVanishAtComplexNumbers) {
  const char* const no_root =
      R"({"node":"empty","terms":[["1","1"],["1","a"]],"zeros":[["0","-1"]]})";
  EXPECT_TRUE(proves({is("a^2 + 1", Sign::zero)}, no_root));
  EXPECT_FALSE(proves_of_complex({is("a^2 + 1", Sign::zero)}, no_root));
}

TEST(RealProof, OneProductThatIsAnEquation) {
  const char* const odd = R"({"node":"empty","terms":[["1","1",["0","1"]]],"zeros":[["1","-1"]]})";
  EXPECT_TRUE(proves_of_complex({is("a", Sign::nonzero), is("a", Sign::zero)}, odd));
  EXPECT_FALSE(proves_of_complex({is("a", Sign::nonzero), is("a + 1", Sign::zero)}, odd));
  EXPECT_FALSE(proves_of_complex({is("a", Sign::nonnegative), is("a", Sign::zero)}, odd));
}

TEST(RealProof, ComplexNumbersHaveNoSign) {
  const std::string empty =
      R"({"node":"empty","terms":[["1","1",["0","1"]]],"zeros":[["0","-1"]]})";
  EXPECT_FALSE(proves_of_complex({is("a", Sign::zero)}, R"({"node":"sign","p":"a","positive":)" +
                                                            empty + R"(,"zero":)" + empty +
                                                            R"(,"negative":)" + empty + "}"));
}

} // namespace
} // namespace kov::certify
