// level = ["H = h"]: the value of a level that nothing else is called is a free constant, declared or not.

#include "system/read_system.hpp"

#include "exact/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov::level_values_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

System with_level(const std::string& level, const std::string& more = "",
                  const std::string& parameters = "'mass', 'energy'") {
  return read_system(parse_document("format = 'equation/1'\n[system]\nkind = 'hamiltonian'\n"
                                    "coordinates = ['q1', 'q2']\nmomenta = ['p1', 'p2']\n"
                                    "parameters = [" +
                                        parameters +
                                        "]\nhamiltonian = '(p1^2 + p2^2)/(2*mass) + q1^2*q2 + "
                                        "q2^3'\n[system.define]\nD = 'q1*p2'\n[[integral]]\nname = "
                                        "'F1'\nvalue = '2*H'\n[[manifold]]\nequations = ['q1 = 0', "
                                        "'p1 = 0']\nlevel = [" +
                                        level + "]\n" + more,
                                    "level.toml"),
                     {});
}

std::vector<std::string> parameters(const System& s) {
  std::vector<std::string> names;
  for (const std::size_t i : s.field.parameters)
    names.push_back(s.ring()->name(i));
  return names;
}

TEST(LevelValues, AreParameters) {
  for (const char* letter : {"h", "E", "c", "h_1", "lambda", "z", "t"})
    EXPECT_THAT(parameters(with_level(std::string("'H = ") + letter + "'")),
                ElementsAre("mass", "energy", letter));
  EXPECT_THAT(parameters(with_level("'H = h', 'F1 = h'")), ElementsAre("mass", "energy", "h"));
  EXPECT_THAT(parameters(with_level("'H = h'", "[[manifold]]\nequations = ['q1 = 0', 'p1 = "
                                               "0']\nlevel = ['F1 = c', 'H = h']\n")),
              ElementsAre("mass", "energy", "h", "c"));
}

TEST(LevelValues, MayBeAssumedAndSet) {
  const System s = with_level("'H = h'", "[assume]\nconditions = ['h > 0']\n");
  EXPECT_THAT(s.real, ElementsAre("h"));
  const System fixed = with_level("'H = h'", "[set]\nh = '1/2'\n");
  ASSERT_TRUE(fixed.values.contains("h"));
  EXPECT_EQ(to_string(fixed.values.at("h")), "1/2");
}

// What has a meaning keeps it; a formula or a number needs no letter.
TEST(LevelValues, WhatIsKnownStays) {
  for (const char* level :
       {"'H = energy'", "'H = F1'", "'H = D'", "'H = 2'", "'H = mass/2'", "'F1 = H'", "'H = q2'"})
    EXPECT_THAT(parameters(with_level(level)), ElementsAre("mass", "energy")) << level;
  EXPECT_THAT(parameters(with_level("'H = h'", "", "'mass', 'h'")), ElementsAre("mass", "h"));
}

TEST(LevelValues, MistakesInWritingAreMistakes) {
  for (const auto& [level, meant] :
       {std::pair("'H = energi'", "'energy'"), std::pair("'H = Energy'", "'energy'"),
        std::pair("'H = mas'", "'mass'"), std::pair("'H = f1'", "'F1'")}) {
    try {
      (void)with_level(level);
      FAIL() << level;
    } catch (const InputError& e) {
      EXPECT_THAT(std::string(e.what()) + e.hint(), HasSubstr(meant)) << level;
    }
  }
  EXPECT_THROW((void)with_level("'H = I'"), InputError);
  EXPECT_THROW((void)with_level("'H = 2*h'"), InputError); // one letter alone is a value
  EXPECT_THROW((void)with_level("'H = h + k'"), InputError);
  EXPECT_THROW((void)with_level("'K = h'"), InputError);
}

} // namespace
} // namespace kov::level_values_test
