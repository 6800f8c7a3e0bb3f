// Parts of a system that do not meet, at rest.

#include "manifold/find.hpp"
#include "manifold/rests.hpp"
#include "system/system.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace kov {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::set<std::string> rests(const std::string& field) {
  const System s = read_system(parse_document(
      "[system]\nkind = 'vector-field'\ncoordinates = ['x', 'y', 'z']\nparameters = ['a']\n"
      "[system.field]\n" +
          field,
      "test.toml"));
  std::set<std::string> all;
  for (const auto& place : parts_at_rest(s.field)) {
    std::string text;
    for (const Equation& e : place)
      text += (text.empty() ? "" : ", ") + e.text;
    all.insert(text);
  }
  return all;
}

TEST(Rests, OfEachPartWithAnother) {
  EXPECT_THAT(rests("x = 'y'\ny = '-x'\nz = 'z^2 - 4'\n"),
              ElementsAre("x = 0, y = 0", "z = -2", "z = 2"));
  EXPECT_THAT(rests("x = 'y'\ny = '-x*z'\nz = 'z^2 - 4'\n"), IsEmpty()) << "one part";
  EXPECT_THAT(rests("x = 'x*(x - 1)^2'\ny = '1'\nz = '1/z'\n"), ElementsAre("x = 0", "x = 1"))
      << "each once; the others have none";
}

TEST(Rests, HaveRationalValuesForAllParameters) {
  EXPECT_THAT(rests("x = 'x^2 - 2'\ny = 'y^2 + 1'\nz = 'z - 3'\n"), ElementsAre("z = 3"));
  EXPECT_THAT(rests("x = 'x - a'\ny = 'a*y - 1'\nz = 'z*(z^2 - a)'\n"),
              ElementsAre("x = a", "z = 0"));
}

// A function of one part alone: its values are part of the place.
TEST(Rests, OfPendula) {
  const System s = read_system(parse_document(
      "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
      "hamiltonian = '(u^2 + v^2)/2 - cos(x) + y^4'\n",
      "test.toml"));
  std::vector<std::size_t> sizes;
  for (const auto& place : parts_at_rest(s.field))
    sizes.push_back(place.size());
  EXPECT_EQ(sizes.size(), 3) << "two of the pendulum, one of the other part";
  // what is found is proved by the prover of all sets
  const FoundManifolds found = find_manifolds(s.field, {*s.field.hamiltonian});
  EXPECT_GE(std::ranges::count_if(found.proved,
                                  [](const FoundManifold& m) {
                                    return m.kind == "a part at rest" && m.leaf_dimension() == 1;
                                  }),
            2);
}

} // namespace
} // namespace kov
