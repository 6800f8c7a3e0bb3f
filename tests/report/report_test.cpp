// Reports: formulas in three markups, and whole documents.

#include "report/render_theorem.hpp"
#include "support/own_folder.hpp"
#include "support/source_dir.hpp"
#include "theorem/prove.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <fstream>

using namespace kov;
using namespace kov::report;
using testing::HasSubstr;
using testing::Not;

namespace {

const TheoremResult& heavy_top() {
  static const TheoremResult r =
      prove(read_theorem(read_document(test::in_source("/cases/classics/heavy_top_theorem.toml"))));
  return r;
}

} // namespace

TEST(Formula, InLatex) {
  EXPECT_EQ(formula("2*A - 2*B - C = 0", Markup::tex), "$2\\, A - 2\\, B - C = 0$");
  EXPECT_EQ(formula("-a^2/(b + 1)", Markup::tex), "$\\frac{ - a^{2}}{b + 1}$");
  EXPECT_EQ(formula("L1 != 0, Gamma3 = 0", Markup::tex), "$L_{1} \\neq 0$, $\\Gamma _{3} = 0$");
  EXPECT_EQ(formula("yes", Markup::tex), "yes");
}

TEST(Formula, InMathml) {
  const std::string m = formula("z^2 < 1/2", Markup::html);
  EXPECT_THAT(m, HasSubstr("<msup>"));
  EXPECT_THAT(m, HasSubstr("<mo>&lt;</mo>"));
  EXPECT_THAT(m, HasSubstr("<mfrac>"));
}

TEST(Prose, IsEscapedAndScriptsAreSet) {
  EXPECT_EQ(prose("a < b & Gamma3^2 <= x_1", Markup::html),
            "a &lt; b &amp; &Gamma;<sub>3</sub><sup>2</sup> &le; x<sub>1</sub>");
  EXPECT_EQ(prose("100% of file_name.toml", Markup::tex), "100\\% of file\\_name.toml");
  EXPECT_THAT(prose("<script>alert(1)</script>", Markup::html), Not(HasSubstr("<script>")));
}

TEST(Prose, RootsAreSetAsRoots) {
  const std::string text = "Delta^2 = a, and sqrt((4*a + 1)/4) or sqrt(sqrt(b)) is not rational";
  const std::string t = prose(text, Markup::tex);
  EXPECT_THAT(t, HasSubstr("$\\Delta$"));
  EXPECT_THAT(t, HasSubstr("$\\sqrt{\\sqrt{b}}$ is not rational"));
  EXPECT_THAT(t, Not(HasSubstr("sqrt(")));
  EXPECT_THAT(prose(text, Markup::html), HasSubstr("<msqrt>"));
  EXPECT_THAT(prose("sqrt(no formula, sqrt(", Markup::tex), HasSubstr("sqrt(no formula"));
}

TEST(Picture, PointsLieInTheBox) {
  PolePicture p;
  p.points = {{Rational(-5), Rational(2), "", false}, {Rational(100), Rational(0), "", true}};
  const PlacedPicture q = place(p, 1000, 600);
  for (const PlacedPoint& x : q.points) {
    EXPECT_GE(x.x, 0);
    EXPECT_LE(x.x, 1000);
    EXPECT_GE(x.y, 0);
    EXPECT_LE(x.y, 600);
  }
}

TEST(Report, HtmlIsOneFileWithoutScriptsOrNetwork) {
  const std::string page = theorem_html(heavy_top());
  EXPECT_THAT(page, Not(HasSubstr("<script")));
  EXPECT_THAT(page, Not(HasSubstr("src=")));
  EXPECT_THAT(page, Not(HasSubstr("@import")));
  EXPECT_THAT(page, Not(HasSubstr("url(")));
  EXPECT_THAT(page, HasSubstr("<svg"));
  EXPECT_THAT(page, HasSubstr("Hypothesis not checked"));
}

TEST(Report, JsonHasTheStatusOfEveryStep) {
  const auto j = nlohmann::json::parse(theorem_json(heavy_top()));
  EXPECT_EQ(j.at("format"), "kovacic-proof/1");
  EXPECT_EQ(j.at("nodes").size(), heavy_top().nodes.size());
  EXPECT_EQ(j.at("unchecked_hypotheses").size(), 1U);
}

TEST(Report, TextShowsUncheckedHypothesesInPlainView) {
  EXPECT_THAT(theorem_text(heavy_top()), HasSubstr("HYPOTHESIS NOT CHECKED"));
}

// Needs texlive-latex-base; skipped where it is not installed.
TEST(Report, LatexCompiles) {
  if (std::system("command -v pdflatex > /dev/null 2>&1") != 0) GTEST_SKIP() << "no pdflatex";
  std::ofstream(test::own_folder() + "report.tex") << theorem_tex(heavy_top());
  const std::string command =
      "cd " + test::own_folder() +
      " && pdflatex -interaction=nonstopmode -halt-on-error report.tex > log.txt 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0);
}
