// The relations of functions and constants describe one system, or are refused.

#include "system/relations.hpp"

#include "exact/error.hpp"
#include "system/read_system.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov {
namespace {

using testing::HasSubstr;

// Constants s, t and a parameter a, functions r = sqrt(...) by their relations.
std::string file(const std::string& relations, const std::string& set = "") {
  return "system = {kind = 'hamiltonian', coordinates = ['x', 'y'], momenta = ['u', 'v'], "
         "parameters = ['a'], constants = ['s', 't'], hamiltonian = '(u^2+v^2)/2 + s*x*y + t*a', "
         "relations = [" +
         relations + "]}\n[set]\n" + set;
}

std::string refusal(const std::string& text) {
  try {
    static_cast<void>(read_system(parse_document(text, "file.toml")));
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(Relations, OfOneSystem) {
  for (const char* good :
       {"'s^2 = 2', 't^2 = 3'", "'s^2 = a', 't^2 = 1 - a'", "'s^3 = 2', 't = s^2'",
        "'s^2 = -1', 't^2 = 3*s'", "'s^4 = a^2 + 1', 't^2 = s'", "'s = 2', 't = a'",
        "'s^2 = a^2 + 1', 't*s = 1'", "'s^3 = 3*s + 1', 't = 0'"})
    EXPECT_EQ(refusal(file(good)), "") << good;
}

TEST(Relations, OfSeveralSystemsAreRefused) {
  for (const char* bad :
       {"'s^2 = 256', 't = 1'", "'s^2 = 5*s + 6', 't = 1'", "'s^3 = 2*s', 't = 1'",
        "'s^2 = a^2', 't = 1'", "'s^2 = 2', 't^2 = 8'", "'s^2 = a', 't^2 = 4*a'",
        "'s^2 = -1', 't^2 = -4'", "'s^4 = -4', 't = 1'", "'s^2 = 0', 't = 1'",
        "'s*t = 0', 's + t = 1'", "'s^2 = a', 't^2 = a^3'", "'s^2 = 2', 't^4 = 2'"})
    EXPECT_THAT(refusal(file(bad)), HasSubstr("several solutions")) << bad;
}

TEST(Relations, AConstantCanHaveAValue) {
  EXPECT_EQ(refusal(file("'s^2 = 256', 't = 1'", "s = '-16'")), "");
  EXPECT_THAT(refusal(file("'s^2 = 256', 't = 1'", "s = '4'")), HasSubstr("does not hold"));
  EXPECT_THAT(refusal(file("'s^2 = a', 't = 1'", "a = '4'")), HasSubstr("(s - 2)*(s + 2)"));
  EXPECT_EQ(refusal(file("'s^2 = a', 't = 1'", "a = '4'\ns = '2'")), "");
}

// x r = 0: r = 0, or any r above x = 0.
TEST(Relations, ComponentsAboveSpecialCoordinates) {
  const Ring ring = make_ring({"x", "r"});
  const MFraction x = MFraction::variable(ring, "x"), r = MFraction::variable(ring, "r");
  VectorField v;
  v.ring = ring;
  v.coordinates = {0};
  v.functions = {{1, "r", {MFraction(ring)}}};
  v.components = {r};
  v.relations = {(x * r).num()};
  EXPECT_THAT(reducible_relations(v).value(), HasSubstr("solution"));
  v.relations = {(r * r - x).num()};
  EXPECT_FALSE(reducible_relations(v));
}

} // namespace
} // namespace kov
