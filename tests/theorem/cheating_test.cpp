// Ways to cheat in a theorem file: each is one change of a file that is proved, and each must end
// in "not proved", with the place.

#include "exact/error.hpp"
#include "support/source_dir.hpp"
#include "theorem/prove.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

using namespace kov;
using testing::HasSubstr;

namespace {

const std::string cases = test::in_source("/cases/");

std::string text_of(const std::string& path) {
  std::ifstream file(cases + path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

TheoremResult proved(const std::string& path, const std::string& text) {
  return prove(read_theorem(parse_document(text, cases + path)));
}

// `from` in the node `id` (or in the whole file) becomes `to`.
struct Cheat {
  std::string name, file, id, from, to;
  std::string place; ///< id of the step that must not be proved
};

void PrintTo(const Cheat& c, std::ostream* out) { *out << c.name; }

std::string changed(const Cheat& c) {
  std::string text = text_of(c.file);
  const std::size_t begin = c.id.empty() ? 0 : text.find("\nid        = \"" + c.id + "\"");
  const std::size_t at = begin == std::string::npos ? begin : text.find(c.from, begin);
  EXPECT_NE(at, std::string::npos) << c.name;
  return at == std::string::npos ? text : text.replace(at, c.from.size(), c.to);
}

const std::string main_theorem = "sliding_top/main_theorem.toml";
const std::string heavy_theorem = "classics/heavy_top_theorem.toml";
const std::string kind_case = "kind      = \"case\"";

const std::vector<Cheat> cheats{
    {"another_system", main_theorem, "lemma-3", "lemma3_all.toml", "../classics/henon_heiles.toml",
     "lemma-3"},
    {"another_body", main_theorem, "kovalevskaya-body", "\"gravity.toml\"", "\"long_axis.toml\"",
     "kovalevskaya-body"},
    {"wrong_region", main_theorem, "lemma-3", "L3 = \"0\", g = \"0\"", "g = \"0\"", "lemma-3"},
    {"a_larger_region", main_theorem, "lemma-3", "\"A != C\", ", "", "lemma-3"},
    {"missing_case", main_theorem, "main", ", \"lemma-3\"]", "]", ""},
    {"a_stratum_removed", main_theorem, "long-axis", "\"L1 != 0\"]", "\"L1 != 0\", \"A != 2*m\"]",
     "main"},
    {"weakened_expectation", main_theorem, "lemma-3", "sample    = { A = \"1\", C = \"3/2\" }",
     "where = { C = \"A\" }\nexpect = \"any\"", ""},
    {"expect_any_on_an_integrable_body", main_theorem, "kovalevskaya-body",
     "where     = { A = \"2*C\" }\nsample    = { C = \"1\" }",
     "where     = { A = \"C\" }\nexpect = \"any\"", "main"},
    {"permuted_axis", main_theorem, "lagrange", "L1 = \"0\", L2 = \"0\"", "L2 = \"0\", L3 = \"0\"",
     "lagrange"},
    {"a_false_symmetry", main_theorem, "", "L1 = \"L2\", L2 = \"L3\"", "L1 = \"L3\", L2 = \"L2\"",
     "main"},
    {"another_unit", main_theorem, "lemma-3", "C = \"C/(m*r^2)\"", "C = \"2*C/(m*r^2)\"",
     "lemma-3"},
    {"a_splitting_that_does_not_scale", main_theorem, "asymmetric", "where     = { g = \"0\" }",
     "where     = { g = \"L1\" }", ""},
    {"a_case_about_something_else", main_theorem, "heavy-three", "of        = \"lowest-order\"\n",
     "", "heavy-three"},
    {"integrals_everywhere", main_theorem, "euler",
     "at        = { L1 = \"0\", L2 = \"0\", L3 = \"0\" }", "", "euler"},
    {"no_system", main_theorem, "", "system = \"sliding_top.toml\"", "", "main"},
    {"words_for_a_proof", main_theorem, "main", "kind      = \"cover\"",
     "kind      = \"argument\"\nstatement = \"So it is.\"", "main"},
    {"cyclic_reference", main_theorem, "lemma-3", "at        = {",
     "needs = [\"main\"]\nat        = {", ""},
    {"the_case_for_more_bodies", main_theorem, "heavy-tilted", ", \"L3 != 0\"", "", "heavy-tilted"},
    {"a_flat_body_that_is_not", main_theorem, "heavy-flat", "7*C - 8*A > 0", "8*C - 8*A > 0",
     "heavy-flat"},
    {"one_of_the_six_left_out", heavy_theorem, "main", "\"five-twelfths\", ", "", ""},
    {"missing_case_of_the_heavy_top", heavy_theorem, "main", "\"kovalevskaya\", ", "", ""},
    {"the_lowest_order_of_some_systems_only", main_theorem, "lowest-order",
     "other     = \"lowest_order.toml\"",
     "other     = \"lowest_order.toml\"\nwhere = { m = \"1\" }\nat = { m = \"1\" }", "heavy-three"},
    {"a_parameter_that_is_a_function_of_the_variables", main_theorem, "lemma-3",
     "as        = { A = \"A/(m*r^2)\"", "as        = { A = \"A/(m*r^2) + 0*M3 + Gamma1\"",
     "lemma-3"},
    {"another_integral", heavy_theorem, "euler", "../sliding_top/euler.toml",
     "heavy_top_kovalevskaya.toml", "euler"},
};

class Cheating : public testing::TestWithParam<Cheat> {};

} // namespace

TEST_P(Cheating, IsNotProved) {
  const Cheat& c = GetParam();
  try {
    const TheoremResult r = proved(c.file, changed(c));
    EXPECT_FALSE(r.complete()) << r.conclusion();
    EXPECT_THAT(r.conclusion(), testing::StartsWith("NOT PROVED")) << r.conclusion();
    EXPECT_EQ(r.statement(), "");
    for (const NodeResult& n : r.nodes)
      if (n.node.id == c.place) {
        EXPECT_NE(n.status, NodeStatus::proved) << n.summary;
        EXPECT_NE(n.status, NodeStatus::trusted) << n.summary;
      }
  } catch (const InputError& e) { // the file is refused, with the place
    EXPECT_THAT(e.what(), testing::HasSubstr(".toml:"));
  }
}

INSTANTIATE_TEST_SUITE_P(TheoremFiles, Cheating, testing::ValuesIn(cheats),
                         [](const auto& test) { return test.param.name; });

// The words of the author change nothing but the words.
TEST(Cheating, RewordedStatementsCarryNoMark) {
  std::string text = text_of(heavy_theorem);
  const TheoremResult honest = proved(heavy_theorem, text);
  ASSERT_TRUE(honest.complete()) << honest.conclusion();
  const std::string lie = "All non-trivial zeros of zeta have real part 1/2.";
  const auto begin = text.find("statement = \"\"\""), end = text.find("\"\"\"", begin + 15);
  ASSERT_NE(end, std::string::npos);
  text.replace(begin, end + 3 - begin, "statement = \"" + lie + "\"");
  const TheoremResult r = proved(heavy_theorem, text);
  EXPECT_EQ(r.statement(), honest.statement());
  EXPECT_EQ(r.conclusion(), honest.conclusion());
  EXPECT_EQ(r.statement().find(lie), std::string::npos);
}

// Hypotheses belong to the theorems in use: a file without a word about them has the same.
TEST(Cheating, HypothesesCannotBeLeftOut) {
  std::string text = text_of(heavy_theorem);
  const std::string need = "\"three\", ";
  text.replace(text.find(need), need.size(), need + "\"cited\", ");
  const TheoremResult r =
      proved(heavy_theorem,
             text + "\n[[node]]\nid = \"cited\"\nkind = \"theorem\"\ntheorem = \"Ziglin 1983\"\n"
                    "at = { B = \"A\" }\nif = [\"L1^2 + L2^2 > 0\", \"A != C\", \"L3 != 0\"]\n");
  ASSERT_FALSE(r.unchecked_hypotheses().empty());
  EXPECT_THAT(r.unchecked_hypotheses().front(), HasSubstr("independent are so on the leaves"));
  EXPECT_THAT(r.conclusion(), HasSubstr("NOT CHECKED"));
}
