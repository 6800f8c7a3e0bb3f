// The main theorem of the sliding top, from its file: nothing open, certificates for both judges.

#include "support/own_folder.hpp"
#include "support/source_dir.hpp"
#include "theorem/prove.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

using namespace kov;

TEST(MainTheorem, IsProvedFromTheCaseFiles) {
  const TheoremResult r =
      prove(read_theorem(read_document(test::in_source("/cases/sliding_top/main_theorem.toml"))));
  for (const NodeResult& n : r.nodes) {
    EXPECT_NE(n.status, NodeStatus::open) << n.node.id << ": " << n.summary;
    EXPECT_NE(n.status, NodeStatus::refuted) << n.node.id << ": " << n.summary;
  }
  EXPECT_TRUE(r.complete());
  EXPECT_EQ(r.count(NodeStatus::reasoned), 0U);
  EXPECT_EQ(r.uses().size(), 3U);
  EXPECT_EQ(r.trusted_steps(), std::vector<std::string>{}); // nothing else is taken on faith
  EXPECT_FALSE(r.bundle.empty()) << r.no_bundle;
  EXPECT_TRUE(r.unchecked_hypotheses().empty());
  EXPECT_EQ(r.statement().find("leaf"), std::string::npos) << r.statement();
  EXPECT_GE(r.certificates(), 9U);
  for (const NodeResult& n : r.nodes) // for all bodies, not only for the sample
    if (n.node.id == "lemma-2" || n.node.id == "lemma-3" || n.node.id == "long-axis") {
      ASSERT_FALSE(n.certificates.empty()) << n.node.id;
      EXPECT_NE(n.certificates.front().find("kovacic-system/1"), std::string::npos) << n.node.id;
      EXPECT_NE(n.certificates.front().find("kovacic-strata/1"), std::string::npos) << n.node.id;
    }

  if (std::system("command -v python3 > /dev/null 2>&1") != 0) GTEST_SKIP() << "no python3";
  const std::string file = test::own_folder() + "certificate.json";
  for (const NodeResult& n : r.nodes)
    for (const std::string& c : n.certificates) {
      std::ofstream(file) << c;
      const std::string command = "python3 " + test::in_source("/tools/verify/kovacic_verify.py ") +
                                  file + " > /dev/null 2>&1";
      EXPECT_EQ(std::system(command.c_str()), 0) << n.node.id;
    }
}
