// A headline on its way from a child to its parent, and in words.

#include "study/headline_words.hpp"
#include "systems/study_report.hpp"

#include <gtest/gtest.h>

namespace kov::cli::headline_test {
namespace {

using study::Headline;

TEST(Headline, KeepsItsClassOnTheWay) {
  Headline h;
  h.verdict = Verdict::depends;
  h.excluded = {{.kind = IntegralClass::Kind::rational},
                {.near = IntegralClass::Near::closed_curve,
                 .curves = {"N"},
                 .on_leaf = true,
                 .functions = {"s"},
                 .without = {"x"},
                 .through = {{"x", "s"}},
                 .frame = "of top.toml",
                 .liouville = false}};
  h.trusted = 2, h.unchecked = 1, h.refused = 3, h.complete = false;
  const Json told{{"headline", nlohmann::json(h)}};
  EXPECT_EQ(Json::parse(told.dump()).at("headline").get<Headline>(), h);
}

TEST(Headline, SaysWhereNothingIsKnown) {
  EXPECT_EQ(
      one_line(study::HeadlineWords{"NON-INTEGRABLE", "except where a = 0", "by a theorem"}),
      "NON-INTEGRABLE, except where a = 0 (by a theorem; nothing is known about the exceptions)");
  EXPECT_EQ(one_line(study::in_words(Verdict::undecided, true)), "UNDECIDED IN PART");
  EXPECT_EQ(one_line(study::in_words(Verdict::depends, true)), "DEPENDS ON THE PARAMETERS");
}

TEST(StageIn, OfAReportOnTheWay) {
  EXPECT_EQ(stage_in(R"({"exit":1,"text":"\"at_work\":\"no\"","json":{},"at_work":"jets"})"),
            "jets");
  for (const char* other : {"", "a page", "[1]", R"({"json":{"at_work":"jets"}})"})
    EXPECT_EQ(stage_in(other), "") << other;
}

} // namespace
} // namespace kov::cli::headline_test
