// Reports: formulas in three markups, and whole documents.

#include "report/loops_picture.hpp"
#include "report/render_theorem.hpp"
#include "support/own_folder.hpp"
#include "support/source_dir.hpp"
#include "theorem/prove.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <fstream>
#include <sstream>

using namespace kov;
using namespace kov::report;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

namespace {

const TheoremResult& heavy_top() {
  static const TheoremResult r =
      prove(read_theorem(read_document(test::in_source("/cases/classics/heavy_top_theorem.toml"))));
  return r;
}

// The same theorem, with a step that is cited.
const TheoremResult& with_a_cited_theorem() {
  static const TheoremResult r = [] {
    const std::string path = test::in_source("/cases/classics/heavy_top_theorem.toml");
    std::ifstream in(path);
    std::string text{std::istreambuf_iterator<char>(in), {}};
    const std::string need = "\"three\", ";
    text.replace(text.find(need), need.size(), need + "\"cited\", ");
    text += "\n[[node]]\nid = \"cited\"\nkind = \"theorem\"\ntheorem = \"Ziglin 1983\"\n"
            "at = { B = \"A\" }\nif = [\"L1^2 + L2^2 > 0\", \"A != C\", \"L3 != 0\"]\n";
    return prove(read_theorem(parse_document(text, path)));
  }();
  return r;
}

// Names as they are typeset: momenta, velocities, indices; a name of several letters stays upright.
TEST(Report, NamesOfFormulas) {
  using report::formula;
  using report::Markup;
  for (const auto& [name, tex] :
       std::vector<std::pair<std::string, std::string>>{{"p_theta*1", "p_{\\theta }"},
                                                        {"px^2", "p_{x}^{2}"},
                                                        {"x_dot^2", "\\dot{x}^{2}"},
                                                        {"q1_dot + 1", "\\dot{q_{1}}"},
                                                        {"a_1 + 1", "a_{1}"},
                                                        {"p_theta1 + 1", "p_{\\theta _{1}}"},
                                                        {"my_name + 1", "my\\_name"},
                                                        {"psi + 1", "\\psi"},
                                                        {"p0 + 1", "p_{0}"}})
    EXPECT_NE(formula(name, Markup::tex).find(tex), std::string::npos)
        << formula(name, Markup::tex);
  EXPECT_NE(formula("p_theta + 1", Markup::html).find("<msub><mi>p</mi><mi>&theta;</mi></msub>"),
            std::string::npos)
      << formula("p_theta + 1", Markup::html);
}

} // namespace

TEST(Formula, InLatex) {
  EXPECT_EQ(formula("2*A - 2*B - C = 0", Markup::tex), "$2\\, A - 2\\, B - C = 0$");
  EXPECT_EQ(formula("-a^2/(b + 1)", Markup::tex), "$\\displaystyle -\\frac{a^{2}}{b + 1}$");
  EXPECT_EQ(formula("L1 != 0, Gamma3 = 0", Markup::tex), "$L_{1} \\neq 0$, $\\Gamma _{3} = 0$");
  EXPECT_EQ(formula("yes", Markup::tex), "yes");
}

TEST(Formula, SignsStandInFront) {
  for (const auto& [given, written] : std::vector<std::pair<std::string, std::string>>{
           {"(-r)*sqrt(n)", "-r\\, \\sqrt{n}"},
           {"a*(-b)*(-c)", "a\\, b\\, c"},
           {"x - (-2)*a", "x + 2\\, a"},
           {"x + (-r)*n", "x - r\\, n"},
           {"-(-x)", "x"},
           {"x + (-a - b)", "x - a - b"},
           {"x - (a - b)", "x - \\left(a - b\\right)"},
           {"-(a - b)*c", "-\\left(a - b\\right)\\, c"},
           {"a/(-b)", "-\\frac{a}{b}"},
           {"(-a)^2", "\\left(-a\\right)^{2}"},
           {"x^(-1/2)", "x^{-\\frac{1}{2}}"},
           {"-(a + b)", "-\\left(a + b\\right)"}}) {
    const bool tall = written.find("\\frac") != std::string::npos;
    EXPECT_EQ(formula(given, Markup::tex), (tall ? "$\\displaystyle " : "$") + written + "$");
    EXPECT_EQ(report::in_markup(parse_expression(given, "f"), Markup::tex), written);
  }
  EXPECT_EQ(formula("sin(2*x)*exp(x)", Markup::tex), "$\\sin\\left(2\\, x\\right)\\, \\exp(x)$");
}

TEST(Formula, InMathml) {
  const std::string m = formula("z^2 < 1/2", Markup::html);
  EXPECT_THAT(m, HasSubstr("<msup>"));
  EXPECT_THAT(m, HasSubstr("<mo>&lt;</mo>"));
  EXPECT_THAT(m, HasSubstr("<mfrac>"));
}

TEST(Prose, IsEscapedAndScriptsAreSet) {
  EXPECT_EQ(prose("a < b & Gamma3^2 <= x_1", Markup::html),
            "<math><mi>a</mi><mo>&lt;</mo><mi>b</mi></math> &amp; "
            "<math><msubsup><mi>&Gamma;</mi><mn>3</mn><mrow><mn>2</mn></mrow></msubsup>"
            "<mo>&le;</mo><msub><mi>x</mi><mn>1</mn></msub></math>");
  EXPECT_EQ(prose("100% of file_name.toml", Markup::tex), "100\\% of file\\_name.toml");
  EXPECT_THAT(prose("<script>alert(1)</script>", Markup::html), Not(HasSubstr("<script>")));
}

TEST(Prose, RootsAreSetAsRoots) {
  const std::string text = "Delta^2 = a, and sqrt((4*a + 1)/4) or sqrt(sqrt(b)) is not rational";
  const std::string t = prose(text, Markup::tex);
  EXPECT_THAT(t, HasSubstr("$\\Delta ^{2} = a$"));
  EXPECT_THAT(t, HasSubstr("$\\sqrt{\\sqrt{b}}$ is not rational"));
  EXPECT_THAT(t, Not(HasSubstr("sqrt(")));
  EXPECT_THAT(prose(text, Markup::html), HasSubstr("<msqrt>"));
  EXPECT_THAT(prose("sqrt(no formula, sqrt(", Markup::tex), HasSubstr("sqrt(no formula"));
}

// Letters, sets of numbers, chains and brackets in a sentence; an article is none of them.
TEST(Prose, SaysItInMathematics) {
  for (const auto& [given, written] : std::vector<std::pair<std::string, std::string>>{
           {"n is in 1/2 + Z, 3*Z or 1 + 4*Z",
            "$n$ is in $1/2 + \\mathbb{Z}$, $3\\, \\mathbb{Z}$ or $1 + 4\\, \\mathbb{Z}$"},
           {"for Z > 0", "for $Z > 0$"},
           {"a, b or a - c is a number", "$a$, $b$ or $a - c$ is a number"},
           {"A circle and a line", "A circle and a line"},
           {"A = B = C (Lagrange)", "$A = B = C$ (Lagrange)"},
           {"D_4 = -1 < 0", "$D_{4} = -1 < 0$"},
           {"moved by B -> C", "moved by $B \\to C$"},
           {"Bessel's equation (m = n)", "Bessel's equation ($m = n$)"},
           {"{M1, M2} = -M3 holds", "$\\{M_{1}, M_{2}\\} = -M_{3}$ holds"},
           {"the group is SL(2, C), linear in C",
            "the group is $\\mathrm{SL}(2, \\mathbb{C})$, linear in $C$"}})
    EXPECT_EQ(prose(given, Markup::tex), written);
  EXPECT_THAT(prose("n is in Z", Markup::html), HasSubstr("&#8484;"));
  EXPECT_EQ(formula("y'(0) = 1", Markup::tex), "$y'(0) = 1$");
  EXPECT_EQ(formula("C = B/2, C = A/2 and L1 != 0", Markup::tex),
            "$C = B/2$, $C = A/2$ and $L_{1} \\neq 0$");
}

TEST(Picture, PointsLieInTheBox) {
  PolePicture p;
  p.points = {{Rational(-5), Rational(2), "", false}, {Rational(100), Rational(0), "", true}};
  const PlacedPicture q = place(p, {1000, 600, 10, 20});
  for (const PlacedPoint& x : q.points) {
    EXPECT_GE(x.x, 0);
    EXPECT_LE(x.x, 1000);
    EXPECT_GE(x.y, 0);
    EXPECT_LE(x.y, 600);
  }
}

// Points of one height, as near as the letters are wide, with labels that are longer.
TEST(Picture, LabelsCoverNoOtherLabelOrPoint) {
  PolePicture p;
  for (const int x : {0, 1, 2, 3, 20})
    p.points.push_back({Rational(x), Rational(0), "sqrt(5)/2", x % 2 == 0});
  const PictureSize size{100000, 56000, 1700, 3000};
  const auto points = place(p, size).points;
  for (const PlacedPoint& a : points)
    for (const PlacedPoint& b : points) {
      const long length = size.letter_width * 7; // of "√5/2" and more
      const bool beside = a.label_x + length <= b.label_x || b.label_x + length <= a.label_x;
      const bool above = a.label_y + size.letter_height <= b.label_y ||
                         b.label_y + size.letter_height <= a.label_y;
      EXPECT_TRUE(&a == &b || beside || above);
      EXPECT_FALSE(b.x > a.label_x && b.x < a.label_x + length && b.y > a.label_y &&
                   b.y < a.label_y + size.letter_height);
    }
}

TEST(Formula, BracketsPrimesAndInfinity) {
  EXPECT_EQ(formula("{M1, Gamma2} = -Gamma3, a = 0", Markup::tex),
            "$\\{M_{1}, \\Gamma _{2}\\} = -\\Gamma _{3}$, $a = 0$");
  EXPECT_THAT(formula("{q, p} = 1", Markup::html), HasSubstr("<mo>{</mo>"));
  EXPECT_EQ(formula("infinity", Markup::tex), "$\\infty$");
  EXPECT_EQ(prose("M1' and Ziglin's", Markup::tex), "$M_{1}'$ and Ziglin's");
  EXPECT_EQ(prose("Let mu > 0, J > 0 (a is a rank-1 set).", Markup::tex),
            "Let $\\mu  > 0$, $J > 0$ (a is a rank-1 set).");
  EXPECT_EQ(heading("c12", Markup::tex), "$c_{12}$");
  EXPECT_EQ(heading("a sample", Markup::tex), "a sample");
}

// The legend names what is drawn; the file is XML, which knows no names of characters.
TEST(Picture, LoopsOfMonodromy) {
  const Poly z = Poly::z();
  const auto m = monodromy::monodromy(RationalFunction(Rational(0)),
                                      RationalFunction(Poly(3), z * z * (z - Poly(1))));
  const std::string svg = loops_svg(m, "a < 2*b & c", {"0", "1"});
  EXPECT_THAT(svg, AllOf(HasSubstr("1: around 0"), HasSubstr("2: around 1"), HasSubstr(">base<"),
                         HasSubstr("a &lt; 2&#8201;b &amp; c"), Not(HasSubstr("&thinsp;"))));
  std::size_t loops = 0;
  for (auto at = svg.find("<polyline"); at != std::string::npos; at = svg.find("<polyline", at + 1))
    ++loops;
  EXPECT_EQ(loops, 4U); // to each place, and around it
  const auto airy = monodromy::monodromy(RationalFunction(Rational(0)), RationalFunction(-z));
  EXPECT_THAT(loops_svg(airy, "Airy", {}), HasSubstr("no finite singularity"));
}

// Each vertex of a loop lies in the picture, also around a place far from all others.
TEST(Picture, LoopsAreNotCutOff) {
  const Poly z = Poly::z();
  const auto m = monodromy::monodromy(
      RationalFunction(Rational(0)), RationalFunction(Poly(1), z * (z - Poly(1)) * (z - Poly(40))));
  const std::string svg = loops_svg(m, "far", {"0", "1", "40"});
  for (auto at = svg.find("points=\""); at != std::string::npos;
       at = svg.find("points=\"", at + 1)) {
    const auto begin = at + 8;
    std::istringstream list(svg.substr(begin, svg.find('"', begin) - begin));
    for (std::string point; list >> point;) {
      const auto comma = point.find(',');
      for (const double coordinate : {std::stod(point), std::stod(point.substr(comma + 1))}) {
        EXPECT_GE(coordinate, 0) << point;
        EXPECT_LE(coordinate, 640) << point;
      }
    }
  }
}

// What a referee asks for: the system before the theorem, works with titles, what checks it again.
TEST(Report, IsCompleteByItself) {
  const std::string tex = theorem_tex(heavy_top()), html = theorem_html(heavy_top());
  EXPECT_LT(tex.find("The system"), tex.find("\\textbf{Theorem.}"));
  EXPECT_THAT(tex, AllOf(HasSubstr("\\bibitem{Ziglin1980}"), HasSubstr("\\cite{Ziglin1980}"),
                         HasSubstr("Splitting of separatrices"), HasSubstr("kovacic verify")));
  EXPECT_THAT(html, AllOf(HasSubstr("Splitting of separatrices"), HasSubstr("SHA-256")));
  for (const InputFile& f : heavy_top().files) {
    EXPECT_EQ(f.sha256.size(), 64U);
    EXPECT_THAT(tex, HasSubstr(f.sha256));
  }
}

TEST(Report, HtmlIsOneFileWithoutScriptsOrNetwork) {
  const std::string page = theorem_html(heavy_top());
  EXPECT_THAT(page, Not(HasSubstr("<script")));
  EXPECT_THAT(page, Not(HasSubstr("src=")));
  EXPECT_THAT(page, Not(HasSubstr("@import")));
  EXPECT_THAT(page, Not(HasSubstr("url(")));
  EXPECT_THAT(page, HasSubstr("<svg"));
  EXPECT_THAT(theorem_html(with_a_cited_theorem()), HasSubstr("Hypothesis not checked"));
}

TEST(Report, JsonHasTheStatusOfEveryStep) {
  const auto j = nlohmann::json::parse(theorem_json(heavy_top()));
  EXPECT_EQ(j.at("format"), "kovacic-proof/1");
  EXPECT_EQ(j.at("nodes").size(), heavy_top().nodes.size());
  EXPECT_EQ(j.at("unchecked_hypotheses").size(), 0U);
  const auto cited = nlohmann::json::parse(theorem_json(with_a_cited_theorem()));
  EXPECT_EQ(cited.at("unchecked_hypotheses").size(), 1U);
}

TEST(Report, TextShowsUncheckedHypothesesInPlainView) {
  EXPECT_THAT(theorem_text(heavy_top()), Not(HasSubstr("NOT CHECKED")));
  EXPECT_THAT(theorem_text(with_a_cited_theorem()), HasSubstr("HYPOTHESIS NOT CHECKED"));
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
