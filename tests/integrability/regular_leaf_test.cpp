// The symplectic leaves around a curve: when integrals of the whole manifold are excluded.
// docs/theory/mechanics.md (6), lemma T

#include "certify/system/check.hpp"
#include "integrability/regular_leaf.hpp"
#include "integrability/way.hpp"
#include "support/checked.hpp"
#include "support/source_dir.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov::regular_leaf_test {
namespace {

struct Leaves {
  bool solver = false;
  std::optional<bool> checker{}; ///< of the certificate, if there is one: on_leaf is false
  std::string integrals;
};

Leaves leaves_of(const System& s) {
  CheckOptions options;
  options.decide.want_certificate = true;
  const ManifoldReport m = test::checked(study::FileStudy(s), options);
  Leaves found{has_regular_leaves(s, m), {}, m.by ? sentence(m.by->integrals) : ""};
  for (const BlockReport& b : m.blocks)
    if (b.way && b.decision && !b.decision->certificate.empty()) {
      std::string none;
      const auto text = certificate_of(*b.way, b.decision->certificate, none);
      if (!text) continue;
      const auto verdict = certify::check_way(certify::read_system_certificate(*text));
      if (const auto* yes = std::get_if<certify::SystemAccepted>(&verdict))
        found.checker = !yes->integrals.on_leaf;
    }
  return found;
}

std::string top(const std::string& claims, const std::string& third = "3") {
  return R"(
format = "equation/1"
[system]
kind = "euler-poisson"
coordinates = ["M1", "M2", "M3", "G1", "G2", "G3"]
hamiltonian = "(M1^2 + M2^2 + )" +
         third + R"(*M3^2)/2 + G1"
)" + claims +
         R"(
[[manifold]]
name = "N"
equations = ["M1 = 0", "M3 = 0", "G2 = 0"]
level = ["G1^2 + G2^2 + G3^2 = 1", "H = 0"]
[reduce]
manifold = "N"
variable = "M1"
change = "z = G1"
)";
}
const std::string F1 = "[[casimir]]\nname = \"F1\"\nvalue = \"G1^2 + G2^2 + G3^2\"\n";
const std::string F2 = "[[casimir]]\nname = \"F2\"\nvalue = \"M1*G1 + M2*G2 + M3*G3\"\n";
const std::string power = "[[casimir]]\nname = \"F3\"\nvalue = \"(G1^2 + G2^2 + G3^2)^2\"\n";

Leaves leaves_of(const std::string& text) {
  return leaves_of(read_system(parse_document(text, "top.toml")));
}

// Both Casimir functions, in any order and in other words; not one, nor one and its square.
TEST(RegularLeaf, OfATop) {
  for (const std::string& claims : {F1 + F2, F2 + F1, power + F2, F1 + power + F2}) {
    const Leaves found = leaves_of(top(claims));
    EXPECT_TRUE(found.solver) << claims;
    EXPECT_EQ(found.integrals, "meromorphic") << claims;
    EXPECT_EQ(found.checker, std::optional(true)) << claims;
  }
  for (const std::string& claims : {F1 + power, F2}) {
    const Leaves found = leaves_of(top(claims));
    EXPECT_FALSE(found.solver) << claims;
    if (!found.integrals.empty()) {
      EXPECT_THAT(found.integrals, testing::HasSubstr("on the symplectic leaf")) << claims;
    }
    EXPECT_NE(found.checker, std::optional(true)) << claims;
  }
}

// {q1, p1} = 1, {q2, p2} = c with the Casimir function c: where c = 0 the leaf has dimension two.
std::string with_center(const std::string& value, const std::string& claim) {
  return R"(
format = "equation/1"
[system]
kind = "poisson"
coordinates = ["q1", "p1", "q2", "p2", "c"]
bracket = [["0", "1", "0", "0", "0"], ["-1", "0", "0", "0", "0"], ["0", "0", "0", "c", "0"], ["0", "0", "-c", "0", "0"], ["0", "0", "0", "0", "0"]]
hamiltonian = "(p1^2 + p2^2)/2 + q1^3 + q1*q2^2*3 + q1"
)" + claim +
         R"(
[[manifold]]
name = "N"
equations = ["q2 = 0", "p2 = 0"]
level = ["c = )" +
         value + R"(", "H = 1"]
[reduce]
manifold = "N"
variable = "q2"
change = "z = q1"
)";
}

TEST(RegularLeaf, ASingularOne) {
  const std::string claim = "[[casimir]]\nname = \"C\"\nvalue = \"c\"\n";
  try {
    EXPECT_TRUE(leaves_of(with_center("1", claim)).solver);
    EXPECT_TRUE(leaves_of(with_center("-2", claim)).solver);
    EXPECT_FALSE(leaves_of(with_center("0", claim)).solver);
    EXPECT_FALSE(leaves_of(with_center("1", "")).solver);
  } catch (const std::exception& e) {
    FAIL() << e.what();
  }
}

TEST(RegularLeaf, ACanonicalSystemHasOne) {
  const Leaves found = leaves_of(read_system(
      read_document(test::in_source("/cases/classics/henon_heiles.toml")), {{"beta", "3"}}));
  EXPECT_FALSE(found.solver); // nothing to ask
  EXPECT_THAT(found.integrals, testing::Not(testing::HasSubstr("leaf")));
}

} // namespace
} // namespace kov::regular_leaf_test
