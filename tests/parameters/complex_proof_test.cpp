// Emptiness over the complex numbers: what is found is accepted by the judge, what is not empty is not
// found, and a cover has no gap at complex points.

#include "parameters/complex_proof.hpp"

#include "certify/equation/facts.hpp"
#include "proof/condition/show.hpp"

#include <gmock/gmock.h>

namespace kov::complex_proof_test {
namespace {

const Ring& ring() {
  static const Ring r = make_ring({"a", "b", "c"});
  return r;
}
MPoly poly(const char* text) { return certify::read_polynomial(ring(), text); }
Condition is(const char* f, Sign sign) { return {poly(f), sign}; }
ComplexProof proof() { return {ring(), {true, true, true}}; }

bool accepted(const Json& node, const certify::Conditions& given) {
  certify::Arithmetic arithmetic;
  std::size_t nodes = 1000;
  certify::ConditionSet set(ring(), arithmetic, {true, true, true}, {false, false, false});
  for (const Condition& c : given)
    set.assume(c);
  certify::SetProof(set, nodes).absent(certify::Node(node, "node", rationals()));
  return true;
}
bool is_empty(const std::vector<Condition>& given) {
  const auto node = proof().contradiction(given);
  return node && accepted(*node, given);
}

TEST(ComplexProof, EquationsAndInequations) {
  EXPECT_TRUE(is_empty({is("a - 1", Sign::zero), is("a - 2", Sign::zero)}));
  EXPECT_TRUE(is_empty({is("a*b", Sign::zero), is("a", Sign::nonzero), is("b", Sign::nonzero)}));
  EXPECT_TRUE(is_empty({is("a^2 - b", Sign::zero), is("b", Sign::zero), is("a", Sign::nonzero)}));
  EXPECT_TRUE(is_empty({is("b - 16", Sign::zero), is("a - b*c", Sign::zero),
                        is("c - 2", Sign::zero), is("a - 32", Sign::nonzero)}));
  EXPECT_TRUE(is_empty({is("a^3 - b^2", Sign::zero), is("a*c - b", Sign::zero),
                        is("a", Sign::nonzero), is("a - c^2", Sign::nonzero)}));
}

TEST(ComplexProof, ComplexPointsArePoints) {
  EXPECT_FALSE(is_empty({is("a^2 + 1", Sign::zero)}));
  EXPECT_FALSE(is_empty({is("a^2 + b^2", Sign::zero), is("a", Sign::nonzero)}));
  EXPECT_FALSE(is_empty({is("a^2 - 2", Sign::zero), is("a - b", Sign::zero)}));
  EXPECT_FALSE(is_empty({}));
}

TEST(ComplexProof, ACoverHasNoGap) {
  const Budget budget;
  const auto covers = [&](const std::vector<std::vector<Condition>>& all) {
    std::vector<RegionOfPart> regions;
    for (const auto& conditions : all)
      regions.push_back({regions.size(), std::nullopt, conditions});
    return tree_of_regions(proof(), {}, regions, budget).has_value();
  };
  EXPECT_TRUE(covers({{is("a", Sign::zero)}, {is("a", Sign::nonzero)}}));
  EXPECT_TRUE(covers({{is("a", Sign::zero), is("b", Sign::zero)},
                      {is("a", Sign::nonzero)},
                      {is("b", Sign::nonzero)}}));
  EXPECT_FALSE(covers({{is("a", Sign::zero)}, {is("a", Sign::nonzero), is("b", Sign::nonzero)}}));
  EXPECT_FALSE(covers({{is("a^2 + 1", Sign::nonzero)}})); // of real numbers it is all
}

// A family of many strata: curves a - i b = 0, a conic, and their points with more lines.
TEST(ComplexProof, ACoverByManyStrata) {
  Budget budget;
  budget.give(1e9);
  const long lines = 9;
  std::vector<std::vector<Condition>> all(1);
  const auto line = [](long i) { return poly(("a - " + std::to_string(i) + "*b").c_str()); };
  const MPoly conic = poly("11*a^2 + 16*a*c + 21*b*c"), cubic = poly("a^3 + 2*a*b*c - 7*c^3 + b^3");
  const std::vector<Condition> outside{{poly("b"), Sign::nonzero}};
  for (long i = 1; i <= lines; ++i) {
    all[0].push_back({line(i), Sign::nonzero});
    std::vector<Condition> curve{{line(i), Sign::zero}};
    for (const MPoly& f : {conic, cubic}) {
      all.push_back({{line(i), Sign::zero}, {f, Sign::zero}});
      curve.push_back({f, Sign::nonzero});
    }
    all.push_back(curve);
  }
  all[0].push_back({conic, Sign::nonzero});
  all[0].push_back({cubic, Sign::nonzero});
  all.push_back({{cubic, Sign::zero}});
  all.push_back({{conic, Sign::zero}, {cubic, Sign::nonzero}});
  for (const bool whole : {true, false}) {
    if (!whole) all.erase(all.begin() + 3); // a - b = 0, off both curves
    std::vector<RegionOfPart> regions;
    for (const auto& conditions : all)
      regions.push_back({regions.size(), std::nullopt, conditions});
    EXPECT_EQ(tree_of_regions(proof(), outside, regions, budget).has_value(), whole);
  }
}

} // namespace
} // namespace kov::complex_proof_test
