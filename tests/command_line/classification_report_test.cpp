// The report of a classification says proved of what is, and open of what is not.

#include "systems/classification_page.hpp"

#include "classify/classify.hpp"
#include "report/render_theorem.hpp"
#include "support/own_folder.hpp"
#include "system/system.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace kov::cli::classification_report_test {
namespace {

constexpr const char* cubic = R"toml(format = "equation/1"
[system]
kind = "hamiltonian"
coordinates = ["x", "y"]
momenta = ["u", "v"]
parameters = ["a"]
hamiltonian = "(u^2 + v^2)/2 + a*x^2*y + y^3/3"
)toml";

System read() {
  const std::string path = test::own_folder() + "cubic.toml";
  std::ofstream(path) << cubic;
  return read_system(read_document(path), {});
}

TEST(ClassificationReport, WhatIsOpenIsCountedAndNotProved) {
  const System s = read();
  SystemClassification c = classify_system(s);
  ASSERT_EQ(c.status(), Verdict::depends);
  TheoremResult whole = as_theorem(s, c);
  EXPECT_EQ(whole.count(NodeStatus::open), 0U);
  EXPECT_TRUE(whole.complete());
  EXPECT_EQ(whole.conclusion().find("NOT DECIDED"), std::string::npos) << whole.conclusion();

  for (ClassifiedStratum& x : c.strata)
    if (x.status == StratumStatus::integrable) {
      x.status = StratumStatus::open;
      break;
    }
  const TheoremResult part = as_theorem(s, c);
  EXPECT_EQ(part.count(NodeStatus::open), 1U);
  EXPECT_EQ(part.conclusion().rfind("NOT DECIDED: 1 step is open", 0), 0U) << part.conclusion();

  for (ClassifiedStratum& x : c.strata)
    x.status = StratumStatus::open;
  const TheoremResult nothing = as_theorem(s, c);
  EXPECT_EQ(nothing.count(NodeStatus::proved), 0U);
  EXPECT_EQ(nothing.conclusion().rfind("NOT DECIDED: 1 step is open", 0), 0U);
  for (const std::string& page :
       {report::theorem_tex(part), report::theorem_html(part), report::theorem_html(nothing)}) {
    EXPECT_NE(page.find("NOT DECIDED"), std::string::npos);
    EXPECT_EQ(page.find("PROVED"), std::string::npos);
  }
}

} // namespace
} // namespace kov::cli::classification_report_test
