// The three invariant manifolds of the paper are found, for the body of Lemma 3.

#include "manifold/find.hpp"
#include "sliding_top.hpp"

#include <set>

namespace kov::lemmas {
namespace {

std::set<std::set<std::string>> phase_curve_manifolds(const System& s) {
  std::vector<MFraction> integrals{*s.field.hamiltonian};
  for (const auto& claim : s.claims)
    integrals.push_back(claim.value);
  std::set<std::set<std::string>> found;
  for (const auto& m : find_manifolds(s.field, integrals).proved)
    if (m.leaf_dimension() == 1 && !m.equilibria) {
      std::set<std::string> equations;
      for (const auto& e : m.equations)
        equations.insert(e.text);
      found.insert(std::move(equations));
    }
  return found;
}

TEST(Manifolds, TheThreeOfThePaper) {
  const auto found = phase_curve_manifolds(sliding_top("lemma3.toml"));
  EXPECT_TRUE(found.count({"M1 = 0", "M3 = 0", "Gamma2 = 0"}));
  EXPECT_TRUE(found.count({"M2 = 0", "M3 = 0", "Gamma1 = 0"}));
  EXPECT_TRUE(found.count({"M1 = 0", "M2 = 0", "Gamma3 = 0"}));
}

TEST(Manifolds, OneForABodyWithItsCentreInAPrincipalPlane) {
  const auto found = phase_curve_manifolds(sliding_top("lemma2.toml"));
  EXPECT_TRUE(found.count({"M1 = 0", "M3 = 0", "Gamma2 = 0"}));
  EXPECT_FALSE(found.count({"M2 = 0", "M3 = 0", "Gamma1 = 0"}));
}

} // namespace
} // namespace kov::lemmas
