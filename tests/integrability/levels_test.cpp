// What is asked of the level that a parameter chooses.

#include "support/checked.hpp"

#include <gtest/gtest.h>

namespace kov::levels_test {
namespace {

ManifoldReport run(const std::string& h, const std::string& assume, const std::string& energy,
                   const ParameterValues& values) {
  const std::string text = "[system]\nkind = \"hamiltonian\"\ncoordinates = [\"x\", \"y\"]\n"
                           "momenta = [\"px\", \"py\"]\nparameters = [\"b\", \"h\"]\n"
                           "hamiltonian = \"" +
                           h + "\"\n" + assume +
                           "[[manifold]]\nname = \"axis\"\nequations = [\"y = 0\", \"py = 0\"]\n"
                           "level = \"H = h\"\n[reduce]\nvariable = \"y\"\n" +
                           energy;
  return test::checked(text, {}, values);
}

const std::string cubic = "(px^2 + py^2)/2 + x^3/3 + b*x*y^2/2";

// To look for an energy changes no answer that needs none.
TEST(Levels, WithoutOneToChooseTheAnswerIsTheSame) {
  for (const char* b : {"1", "2", "1/2", "1/3"})
    for (const char* energy : {"", "energy = \"auto\"\n"})
      EXPECT_EQ(run(cubic, "", energy, {{"b", b}, {"h", "1"}}).verdict,
                run(cubic, "", "", {{"b", b}, {"h", "1"}}).verdict)
          << b << energy;
  const ManifoldReport m = run(cubic, "", "energy = \"auto\"\n", {{"h", "1"}});
  ASSERT_TRUE(m.blocks.at(0).strata); // with its reasons
  EXPECT_EQ(m.blocks[0].strata->strata.size(),
            run(cubic, "", "", {{"h", "1"}}).blocks.at(0).strata->strata.size());
}

TEST(Levels, WhatIsAssumedOfTheLevelIsNotLookedAt) {
  for (const auto& e :
       run(cubic, "[assume]\nh = \"nonzero\"\n", "energy = \"auto\"\n", {}).blocks.at(0).energies)
    EXPECT_NE(sentence(e.at), "h = 0");
}

// r = 0, and only p and q know the energy.
TEST(Levels, AParameterThatROnlySeemsToNeed) {
  EXPECT_EQ(run("(px^2 + py^2)/2 - 1/r",
                "relations = [\"r^2 = x^2 + b*y^2\"]\n[[system.function]]\nname = \"r\"\n"
                "derivative = { x = \"x/r\", y = \"b*y/r\" }\n",
                "", {{"b", "1"}})
                .verdict,
            Verdict::no_obstruction);
}

} // namespace
} // namespace kov::levels_test
