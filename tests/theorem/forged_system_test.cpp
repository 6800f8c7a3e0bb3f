// Ways to cheat with the system files of a theorem: weights, assumptions, functions, fixed values,
// names.  Each theorem here is false as its title has it; it must not be proved, or the statement
// must say less.

#include "support/own_folder.hpp"
#include "theorem/prove.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

using namespace kov;
using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

namespace {

using Files = std::vector<std::pair<std::string, std::string>>; ///< name, text

TheoremResult proved(const Files& files, const std::string& theorem) {
  for (const auto& [name, text] : files)
    std::ofstream(test::own_folder() + name) << text;
  return prove(read_theorem(parse_document("format = \"theorem/1\"\n" + theorem,
                                           test::own_folder() + "forged_theorem.toml")));
}

// q1^2 q2 + (1 + e) q2^3: integrable for e = 1 and e = 15, not for e = 0.
std::string cubic(const std::string& parameters, const std::string& coefficient,
                  const std::string& rest) {
  return "[system]\nkind = \"hamiltonian\"\ncoordinates = [\"q1\", \"q2\"]\n"
         "momenta = [\"p1\", \"p2\"]\nparameters = [" +
         parameters + "]\nhamiltonian = \"(p1^2 + p2^2)/2 + q1^2*q2 + (" + coefficient +
         ")*q2^3\"\n" + rest;
}

const std::string axis =
    "[[manifold]]\nname = \"N\"\nequations = [\"q1 = 0\", \"p1 = 0\"]\n"
    "level = [\"H = h\"]\n[reduce]\nvariable = \"q1\"\nchange = \"z = q2^3\"\n";
const std::string real_e = "[assume]\ne = \"real\"\n";
const std::string henon_heiles = cubic("\"h\"", "1", axis);

std::string cover(const std::string& system, const std::string& needs, const std::string& nodes) {
  return "title = \"T\"\nsystem = \"" + system +
         "\"\n[[node]]\nid = \"main\"\nkind = \"cover\"\nneeds = [" + needs + "]\n" + nodes;
}

std::string case_of(const std::string& file, const std::string& rest = {}) {
  return "[[node]]\nid = \"ni\"\nkind = \"case\"\nfile = \"" + file + "\"\n" + rest;
}

std::string by_lowest_order(const std::string& file, const std::string& other) {
  return cover(file, "\"ni\"",
               case_of(other, "of = \"lo\"\n") +
                   "[[node]]\nid = \"lo\"\nkind = \"lowest-order\"\n" + "file = \"" + file +
                   "\"\nother = \"" + other + "\"\n");
}

// x' = 1, y'' = f y, along y = 0
std::string linear(const std::string& parameters, const std::string& f, const std::string& rest) {
  return "[system]\nkind = \"vector-field\"\ncoordinates = [\"x\", \"y1\", \"y2\"]\nparameters = "
         "[" +
         parameters + "]\n[system.field]\nx = \"1\"\ny1 = \"y2\"\ny2 = \"(" + f + ")*y1\"\n" +
         rest + "[[manifold]]\nname = \"N\"\nequations = [\"y1 = 0\", \"y2 = 0\"]\n";
}

std::string function(const std::string& derivative) {
  return "[[system.function]]\nname = \"E\"\nderivative = { x = \"" + derivative + "\" }\n";
}

// Of rank two, with as many Casimir functions as there are first integrals.
std::string rank_two(const std::string& parameters, const std::string& s, const std::string& rest) {
  return "[system]\nkind = \"poisson\"\ncoordinates = [\"x\", \"y1\", \"y2\", \"w\"]\nparameters = "
         "[" +
         parameters +
         "]\nbracket = [[\"0\",\"0\",\"0\",\"1\"], [\"0\",\"0\",\"0\",\"y2\"], "
         "[\"0\",\"0\",\"0\",\"" +
         s + "*x*y1\"], [\"-1\",\"-y2\",\"-" + s + "*x*y1\",\"0\"]]\nhamiltonian = \"w\"\n" + rest;
}

struct Forgery {
  std::string name;
  Files files;
  std::string theorem;
};

void PrintTo(const Forgery& f, std::ostream* out) { *out << f.name; }

Forgery weights(const std::string& name, const std::string& w) {
  return {name,
          {{"forged_whole.toml",
            cubic("\"e\"", "1 + e", real_e + "[expansion]\nweights = {" + w + "}\n")},
           {"forged_part.toml", henon_heiles}},
          by_lowest_order("forged_whole.toml", "forged_part.toml")};
}

// the lowest order of the quotient is another one where e = 0
const std::string vanishing_denominator =
    "[system]\nkind = \"hamiltonian\"\ncoordinates = [\"q1\", \"q2\"]\nmomenta = [\"p1\", \"p2\"]\n"
    "parameters = [\"e\"]\nhamiltonian = \"(p1^2 + p2^2)/2 + e*(q1^2*q2 + q2^3)/(e + q1^2)\"\n" +
    real_e + "[expansion]\nweights = {q1 = 2, q2 = 2, p1 = 3, p2 = 3}\n";

const std::vector<Forgery> forgeries{
    weights("a_weight_of_a_parameter", "e = 1"),
    weights("a_weight_of_a_parameter_beside_others", "q1 = 2, q2 = 2, p1 = 3, p2 = 3, e = 1"),
    weights("weights_below_zero", "q1 = -2, q2 = -2, p1 = -3, p2 = -3, e = 1"),
    {"a_lowest_order_that_is_another_one_somewhere",
     {{"forged_whole.toml", vanishing_denominator}, {"forged_part.toml", henon_heiles}},
     by_lowest_order("forged_whole.toml", "forged_part.toml")},
    {"assumptions_of_the_lowest_order_only",
     {{"forged_whole.toml",
       cubic("\"e\"", "1 + e",
             real_e + "[expansion]\nweights = {q1 = 2, q2 = 2, p1 = 3, p2 = 3}\n")},
      {"forged_part.toml",
       cubic("\"e\", \"h\"", "1 + e", real_e + "conditions = [\"e^2 <= 0\"]\n" + axis)}},
     by_lowest_order("forged_whole.toml", "forged_part.toml")},
    {"a_function_of_the_step_that_is_a_parameter",
     {{"forged_whole.toml", linear("\"a\"", "a", "[assume]\na = \"real\"\n")},
      {"forged_part.toml", linear("", "E", function("E"))}},
     cover("forged_whole.toml", "\"ni\"", case_of("forged_part.toml", "as = { E = \"a\" }\n"))},
    {"a_function_of_the_step_by_the_name_of_a_parameter",
     {{"forged_whole.toml", linear("\"E\"", "E", "[assume]\nE = \"real\"\n")},
      {"forged_part.toml", linear("", "E", function("E"))}},
     cover("forged_whole.toml", "\"ni\"", case_of("forged_part.toml"))},
    {"a_function_of_the_system_that_is_a_parameter",
     {{"forged_whole.toml", linear("", "x + E", function("-1"))},
      {"forged_part.toml", linear("\"a\"", "x + a", "")}},
     cover("forged_whole.toml", "\"ni\"", case_of("forged_part.toml", "as = { a = \"E\" }\n"))},
    {"two_functions_of_one_name",
     {{"forged_whole.toml", linear("", "E", function("0"))},
      {"forged_part.toml", linear("", "E", function("E"))}},
     cover("forged_whole.toml", "\"ni\"", case_of("forged_part.toml"))},
    {"a_symmetry_of_a_fixed_parameter",
     {{"forged_whole.toml", cubic("\"e\"", "1 + e", real_e + "[set]\ne = \"1\"\n")},
      {"forged_part.toml", henon_heiles}},
     cover("forged_whole.toml", "\"ni\"", case_of("forged_part.toml", "at = { e = \"0\" }\n")) +
         "[[symmetry]]\nas = { e = \"0\" }\n"},
    {"another_value_of_a_fixed_parameter",
     {{"forged_whole.toml", cubic("\"e\"", "1 + e", real_e + "[set]\ne = \"1\"\n")},
      {"forged_part.toml", henon_heiles}},
     cover("forged_whole.toml", "\"ni\"", case_of("forged_part.toml", "at = { e = \"0\" }\n"))},
};

class Forged : public testing::TestWithParam<Forgery> {};

} // namespace

TEST_P(Forged, IsNotProved) {
  try {
    const TheoremResult r = proved(GetParam().files, GetParam().theorem);
    EXPECT_THAT(r.conclusion(), testing::StartsWith("NOT PROVED")) << r.statement();
    EXPECT_EQ(r.statement(), "");
  } catch (const InputError& e) { // the file is refused, with the place
    EXPECT_THAT(e.what(), HasSubstr(".toml:"));
  }
}

INSTANTIATE_TEST_SUITE_P(SystemFiles, Forged, testing::ValuesIn(forgeries),
                         [](const auto& test) { return test.param.name; });

namespace {

std::string summary_of(const TheoremResult& r, const std::string& id) {
  for (const NodeResult& n : r.nodes)
    if (n.node.id == id) return n.summary;
  return "";
}

// The step is about real f, and f^2 = e: of e > 0 it speaks, of e < 0 it does not.
TEST(ForgedReality, ARootIsRealWhereItsSquareIsNotNegative) {
  const std::string part = linear("\"f\"", "x + f^2", "[assume]\nf = \"real\"\n");
  const auto of = [&](const std::string& assumed, const std::string& square,
                      const std::string& if_) {
    return proved({{"forged_whole.toml",
                    linear("\"e\"", "x + " + square, "[assume]\ne = \"" + assumed + "\"\n")},
                   {"forged_part.toml", part}},
                  cover("forged_whole.toml", "\"ni\"",
                        case_of("forged_part.toml",
                                "roots = { r = \"" + square + "\" }\nas = { f = \"r\" }\n" + if_)));
  };
  const std::string refused = "it assumes that f real";
  EXPECT_THAT(summary_of(of("real", "e", ""), "ni"), HasSubstr(refused));
  EXPECT_THAT(summary_of(of("real", "e", "if = [\"e < 0\"]\n"), "ni"), HasSubstr(refused));
  EXPECT_THAT(summary_of(of("real", "e^2 - 1", ""), "ni"), HasSubstr(refused));
  EXPECT_THAT(summary_of(of("real", "e", "if = [\"e > 0\"]\n"), "ni"), Not(HasSubstr(refused)));
  EXPECT_THAT(summary_of(of("real", "e^2 + 1", ""), "ni"), Not(HasSubstr(refused)));
  EXPECT_THAT(of("real", "e^2 + 1", "").conclusion(), testing::StartsWith("PROVED"));
  EXPECT_THAT(of("positive", "e", "").conclusion(), testing::StartsWith("PROVED"));
  EXPECT_THAT(of("positive", "0 - e", "").conclusion(), testing::StartsWith("NOT PROVED"));
}

// (1 + p) q2 (q1^2 + q2^2) at the origin, (1 - p) of it at q1 = 1.
std::string two_places(const std::string& symmetry) {
  const auto potential = [](const std::string& q) { return "(" + q + "^2*q2 + q2^3)"; };
  const std::string begin = "[system]\nkind = \"hamiltonian\"\ncoordinates = [\"q1\", \"q2\"]\n"
                            "momenta = [\"p1\", \"p2\"]\nparameters = [\"p\"]\nhamiltonian = \""
                            "(p1^2 + p2^2)/2 + (1 + p)*" +
                            potential("q1"),
                    real_p = "[assume]\np = \"real\"\n";
  std::ofstream(test::own_folder() + "forged_whole.toml")
      << begin << "*(1 - q1)^4 + (1 - p)*" << potential("(1 - q1)") << "*q1^4\"\n"
      << real_p << "[expansion]\nweights = {q1 = 2, q2 = 2, p1 = 3, p2 = 3}\n";
  std::ofstream(test::own_folder() + "forged_lowest.toml") << begin << "\"\n" << real_p;
  return cover("forged_whole.toml", "\"ni\"",
               case_of("forged_part.toml",
                       "of = \"lo\"\nif = [\"p != -1\"]\nas = {q1 = \"(1 + p)*q1\", q2 = \"(1 + "
                       "p)*q2\", p1 = \"(1 + p)*p1\", p2 = \"(1 + p)*p2\"}\n") +
                   "[[node]]\nid = \"lo\"\nkind = \"lowest-order\"\nfile = "
                   "\"forged_whole.toml\"\nother = \"forged_lowest.toml\"\n") +
         "[[symmetry]]\nas = " + symmetry + "\n";
}

} // namespace

// "Near the origin" is near another point for the image.
TEST(LowestOrder, IsNotCarriedToAnotherPoint) {
  const TheoremResult r = proved({{"forged_part.toml", henon_heiles}},
                                 two_places("{ q1 = \"1 - q1\", p1 = \"-p1\", p = \"-p\" }"));
  EXPECT_FALSE(r.complete()) << r.statement();
  EXPECT_THAT(summary_of(r, "main"), HasSubstr("moves the origin"));
  EXPECT_THAT(summary_of(r, "ni"), Not(HasSubstr("NOT CHECKED")));
}

// F1 and F1 + F2 G are independent, not so where F2 = 0: the leaf of a phase curve may be there.
// With both Casimir functions the leaves are seen to be regular, and integrals of the manifold are excluded;
// those of a body are known, whatever the file calls them.
TEST(LowestOrder, KnowsTheLeaves) {
  for (const std::string claim : {"integral", "casimir"}) {
    const std::string top = "[system]\nkind = \"euler-poisson\"\ncoordinates = [\"M1\", \"M2\", "
                            "\"M3\", \"Gamma1\", \"Gamma2\", \"Gamma3\"]\n",
                      h = "hamiltonian = \"(M1^2 + M2^2 + M3^2/3)/2 + Gamma1";
    const TheoremResult r = proved(
        {{"forged_whole.toml",
          top + h +
              " + Gamma1^2\"\n[expansion]\nweights = {M1 = 1, M2 = 1, M3 = 1, Gamma1 = 2, "
              "Gamma2 = 2, Gamma3 = 2}\n"},
         {"forged_lowest.toml", top + h + "\"\n"},
         {"forged_part.toml",
          top + "parameters = [\"h\"]\n" + h +
              "\"\n[[casimir]]\nname = \"F1\"\nvalue = \"Gamma1^2 + Gamma2^2 + Gamma3^2\"\n"
              "[[" +
              claim +
              "]]\nname = \"F2\"\nvalue = \"M1*Gamma1 + M2*Gamma2 + M3*Gamma3\"\n"
              "[[manifold]]\nname = \"N\"\nequations = [\"M1 = 0\", \"M3 = 0\", \"Gamma2 = 0\"]\n"
              "level = [\"F1 = 1\", \"H = h\"]\n[reduce]\nvariable = \"M1\"\nchange = \"z = "
              "Gamma1\"\n"}},
        cover("forged_whole.toml", "\"ni\"",
              case_of("forged_part.toml", "of = \"lo\"\n") +
                  "[[node]]\nid = \"lo\"\nkind = \"lowest-order\"\nfile = \"forged_whole.toml\"\n"
                  "other = \"forged_lowest.toml\"\n"));
    EXPECT_TRUE(r.complete()) << r.statement() << summary_of(r, "ni");
    EXPECT_FALSE(r.bundle.empty()) << r.no_bundle;
    EXPECT_THAT(r.statement(), HasSubstr("meromorphic near the origin"));
    EXPECT_THAT(r.statement(), Not(HasSubstr("leaf")));
  }
}

// An exception without a name of its own is an exception.
TEST(Statement, NamesEveryException) {
  const std::string real = "[assume]\ns = \"real\"\n";
  const std::string line = "[[manifold]]\nname = \"N\"\nequations = [\"y1 = 0\", \"y2 = 0\"]\n"
                           "level = [\"w = 1\"]\n";
  const TheoremResult r = proved(
      {{"forged_whole.toml", rank_two("\"s\"", "s", real)},
       {"forged_part.toml", rank_two("\"s\"", "s", real + "conditions = [\"s != 0\"]\n" + line)},
       {"forged_free.toml", rank_two("", "0", "[[casimir]]\nname = \"C\"\nvalue = \"y2\"\n")}},
      cover("forged_whole.toml", "\"ni\", \"free\"",
            case_of("forged_part.toml", "if = [\"s != 0\"]\n") +
                "[[node]]\nid = \"free\"\nkind = \"claims\"\nfile = \"forged_free.toml\"\n"
                "at = { s = \"0\" }\n"));
  EXPECT_THAT(r.statement(), AnyOf(testing::IsEmpty(), HasSubstr("(s = 0)")));
}

// What the file fixes is part of what is stated, of a cover and of claims.
TEST(Statement, SaysTheValuesThatTheFileFixes) {
  const std::string fixed = real_e + "[set]\ne = \"0\"\n";
  const TheoremResult r = proved(
      {{"forged_whole.toml", cubic("\"e\"", "1 + e", fixed)}, {"forged_part.toml", henon_heiles}},
      cover("forged_whole.toml", "\"ni\"", case_of("forged_part.toml")));
  EXPECT_THAT(r.statement(), AnyOf(testing::IsEmpty(), HasSubstr("Let e = 0. ")));
  const TheoremResult claims =
      proved({{"forged_whole.toml",
               cubic("\"e\"", "1 + e",
                     real_e + "[set]\ne = \"1\"\n[[integral]]\nname = \"K\"\n"
                              "value = \"q1^4 + 4*q1^2*q2^2 - 4*p1*(p1*q2 - p2*q1)\"\n")}},
             "title = \"T\"\nsystem = \"forged_whole.toml\"\n[[node]]\nid = \"main\"\n"
             "kind = \"claims\"\nfile = \"forged_whole.toml\"\n");
  EXPECT_THAT(claims.statement(), HasSubstr("K = q1^4"));
  EXPECT_THAT(claims.statement(), HasSubstr("Let e = 1. "));
}

// A name that is defined says what it stands for.
TEST(Statement, ExpandsDefinedNamesInAssumptions) {
  const TheoremResult r = proved(
      {{"forged_whole.toml", cubic("\"e\"", "1 + e",
                                   "[system.define]\ngeneric = \"-e^2\"\n" + real_e +
                                       "conditions = [\"generic >= 0\"]\n")},
       {"forged_part.toml", henon_heiles}},
      cover("forged_whole.toml", "\"ni\"", case_of("forged_part.toml", "at = {e = \"0\"}\n")));
  EXPECT_THAT(r.statement(), Not(HasSubstr("generic")));
  EXPECT_THAT(r.statement(), HasSubstr("-e^2 >= 0"));
}

// A first integral is named with the coordinates that it is written in.
TEST(Statement, SaysInWhichCoordinatesAnIntegralIs) {
  const std::string separable = "[system]\nkind = \"hamiltonian\"\ncoordinates = [\"q1\", \"q2\"]\n"
                                "momenta = [\"p1\", \"p2\"]\nhamiltonian = "
                                "\"(p1^2 + p2^2)/2 + q1^4\"\n[[integral]]\nname = \"K\"\n"
                                "value = \"p2\"\n";
  const std::string whole = cubic("\"e\"", "0", real_e);
  const TheoremResult r = proved(
      {{"forged_whole.toml",
        "[system]\nkind = \"hamiltonian\"\ncoordinates = [\"q1\", \"q2\"]\n"
        "momenta = [\"p1\", \"p2\"]\nparameters = [\"e\"]\nhamiltonian = \"(p1^2 + p2^2)/2 + "
        "(1 - e)*q2^4 + e*(q1^2*q2 + q2^3)\"\n" +
            real_e + "conditions = [\"e*(1 - e) = 0\"]\n"},
       {"forged_free.toml", separable},
       {"forged_part.toml", henon_heiles}},
      cover("forged_whole.toml", "\"ni\", \"free\"",
            case_of("forged_part.toml", "at = { e = \"1\" }\n") +
                "[[node]]\nid = \"free\"\nkind = \"claims\"\nfile = \"forged_free.toml\"\n"
                "at = { e = \"0\" }\nas = {q1 = \"q2\", q2 = \"q1\", p1 = \"p2\", p2 = \"p1\"}\n"));
  EXPECT_THAT(r.statement(), HasSubstr("K = p2"));
  EXPECT_THAT(r.statement(), HasSubstr("in the coordinates of forged_free.toml"));
}

namespace {

// The theorem of one step about claims, with other words.
TheoremResult with_words(const std::string& title, const std::string& name) {
  return proved({{"forged_whole.toml", cubic("", "1",
                                             "[[equal]]\nname = \"" + name +
                                                 "\"\nleft = \"1\"\nright = \"1\"\n"
                                                 "[[integral]]\nname = \"" +
                                                 name + "\"\nvalue = \"2*H\"\n")}},
                "title = \"" + title +
                    "\"\nsystem = \"forged_whole.toml\"\n[[node]]\n"
                    "id = \"main\"\ntitle = \"" +
                    title +
                    "\"\nkind = \"claims\"\n"
                    "file = \"forged_whole.toml\"\n");
}

} // namespace

TEST(Statement, HasNoWordsOfTheAuthor) {
  const std::string lie = "The Riemann hypothesis holds. The top is not integrable";
  const TheoremResult r = with_words("T", lie);
  EXPECT_THAT(r.statement(), HasSubstr("2*H is a first integral"));
  EXPECT_THAT(r.statement(), Not(HasSubstr("Riemann")));
  for (const CheckedIdentity& c : r.nodes.front().checks)
    EXPECT_THAT(c.statement, Not(HasSubstr("Riemann")));
}

// A title that looks like a line of the answer stays on its own line.
TEST(Words, AreOneLine) {
  const TheoremResult r = with_words("x\\n\\n[proved]   Riemann\\u001b[2J\\nPROVED", "n");
  for (const std::string& text : {r.theorem.title, r.nodes.front().node.title}) {
    EXPECT_EQ(text.find('\n'), std::string::npos);
    EXPECT_EQ(text.find('\033'), std::string::npos);
    EXPECT_THAT(text, HasSubstr("x [proved] Riemann"));
  }
}

// That integrals are independent and enough is the word of the file where no certificate shows it: it may refuse
// the step, or there is none (the cover is not one of all parameters).
TEST(Words, SayThatIntegralsAreEnough) {
  for (const std::string where : {"", "if = [\"e != 7\"]\n"}) {
    const TheoremResult r =
        proved({{"forged_whole.toml", cubic("\"e\"", "1 + e", "")}},
               "title = \"T\"\nsystem = \"forged_whole.toml\"\n[[node]]\nid = \"main\"\n"
               "kind = \"cover\"\nneeds = [\"i\"]\n" +
                   where +
                   "[[node]]\nid = \"i\"\nkind = \"claims\"\nfile = \"forged_whole.toml\"\n"
                   "integrable = true\n[[node.integral]]\nname = \"K\"\nvalue = \"H^2\"\n");
    EXPECT_EQ(r.bundle.empty(), !where.empty()) << r.no_bundle;
    EXPECT_FALSE(r.complete());
    EXPECT_EQ(r.verdict(), std::string("PROVED") + (where.empty() ? "" : " BUT FOR A CERTIFICATE") +
                               ", except 1 step that the file takes on trust");
    EXPECT_EQ(r.trusted_steps().size(), where.empty() ? 1U : 2U);
    EXPECT_EQ(r.statement().find("e != 7") != std::string::npos, !where.empty()) << r.statement();
  }
}

// What is on trust is counted once at each step that rests on it, whatever lies between them.
TEST(Words, AreCountedUpTheTree) {
  const TheoremResult r = proved(
      {{"forged_whole.toml", cubic("\"e\"", "1 + e", "[[integral]]\nvalue = \"H\"\n")}},
      "title = \"T\"\nsystem = \"forged_whole.toml\"\n[[node]]\nid = \"main\"\n"
      "kind = \"cover\"\nneeds = [\"a\", \"b\", \"c\"]\n"
      "[[node]]\nid = \"a\"\nkind = \"trusted\"\nstep = \"known\"\nregions = [[\"e = 1\"]]\n"
      "[[node]]\nid = \"b\"\nkind = \"trusted\"\nstep = \"so it is\"\nregions = [[\"e != 1\"]]\n"
      "[[node]]\nid = \"c\"\nkind = \"claims\"\nfile = \"forged_whole.toml\"\nneeds = [\"b\"]\n");
  EXPECT_EQ(r.verdict(), "PROVED, except 2 steps that the file takes on trust");
  EXPECT_EQ(status_of(r.nodes[0]), "proved, with 2 steps on trust");
  EXPECT_EQ(status_of(r.nodes[1]), "trusted");
  EXPECT_EQ(status_of(r.nodes[3]), "proved, with 1 step on trust");
  EXPECT_EQ(r.trusted_steps().size(), 2U);
  EXPECT_FALSE(r.complete());
  EXPECT_FALSE(r.bundle.empty()) << r.no_bundle;
}

// A case of a file is proved or open, whatever step it names.  A slip is told.
TEST(Words, OfACaseThatIsNotProved) {
  const auto with = [](const std::string& coefficient, const std::string& manifold) {
    return proved(
        {{"forged_whole.toml", cubic("\"h\"", coefficient, axis)}},
        cover("forged_whole.toml", "\"ni\"",
              case_of("forged_whole.toml", "step = \"known\"\nmanifold = \"" + manifold + "\"\n")));
  };
  const TheoremResult known = with("1", "N"), words = with("2", "N");
  EXPECT_TRUE(known.complete()) << known.conclusion();
  EXPECT_TRUE(known.trusted_steps().empty());
  EXPECT_TRUE(words.verdict().starts_with("NOT PROVED")) << words.verdict();
  EXPECT_EQ(status_of(words.nodes.back()), "open");
  EXPECT_FALSE(words.complete());
  EXPECT_TRUE(words.bundle.empty());
  EXPECT_THROW(with("1", "M"), InputError);
}

// The theorem of the literature is somebody else's proof.
TEST(Conclusion, OfATheoremOfTheLiteratureIsNotProved) {
  const TheoremResult r = proved(
      {{"forged_whole.toml", literature_theorem("Ziglin 1983")->system},
       {"forged_claims.toml",
        literature_theorem("Ziglin 1983")->system + "[[integral]]\nvalue = \"H\"\n"}},
      "title = \"T\"\nsystem = \"forged_whole.toml\"\n[[node]]\nid = \"main\"\nkind = \"theorem\"\n"
      "theorem = \"Ziglin 1983\"\nneeds = [\"x\"]\n[[node]]\nid = \"x\"\nkind = \"claims\"\n"
      "file = \"forged_claims.toml\"\n");
  EXPECT_THAT(r.conclusion(), Not(testing::StartsWith("PROVED")));
}
