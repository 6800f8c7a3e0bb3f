// What `check` proves of a file's own manifolds is proved by `classify` before it searches anything.

#include "classify/stated.hpp"

#include "study/together.hpp"
#include "support/checked.hpp"
#include "support/points.hpp"
#include "support/source_dir.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov::stated_test {
namespace {

using test::status_at;

System planar(const std::string& hamiltonian, const std::string& more) {
  return read_system(parse_document(
      "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
      "parameters = ['a', 'h']\nhamiltonian = '" +
          hamiltonian + "'\n" + more,
      "test.toml"));
}
const std::string even_quartic = "(u^2 + v^2 + x^2 + y^2)/2 + a*x^2*y^2";
const std::string diagonal =
    "[[manifold]]\nname = 'diagonal'\nequations = ['x = y', 'u = v']\nlevel = 'H = h'\n";
const char* const stated_stage = ", as the file states it";

bool is_of_the_file(const SystemClassification& c) { return c.at_work.ends_with(stated_stage); }

// What is known when the first search begins; then the work ends.
SystemClassification before_any_search(const System& s) {
  struct Ended {};
  std::optional<SystemClassification> known;
  ClassifyOptions options;
  options.so_far = [&](const SystemClassification& c) {
    if (is_of_the_file(c)) return;
    known = c;
    throw Ended{};
  };
  try {
    known = classify_system(s, options);
  } catch (const Ended&) {
  }
  return *known;
}

// A search that the load of the machine lengthens comes after what it could make one lose.
TEST(Stated, ComesBeforeAnySearch) {
  const System top = read_system(test::in_source("/cases/sliding_top/lemma2_symmetric.toml"));
  EXPECT_EQ(before_any_search(top).status(), Verdict::non_integrable);
  for (const std::string& h : {even_quartic, even_quartic + " + a^2*x*y*(x^2 + y^2)"})
    for (const std::string assume : {"", "[assume]\nh = 'positive'\n", "[assume]\nh = 'nonzero'\n",
                                     "[assume]\nconditions = ['h < 3', 'h != a']\n"}) {
      const System s = planar(h, assume + diagonal);
      const auto c = before_any_search(s);
      for (const Rational& a : {Rational(1), Rational(-3), Rational(2, 7)})
        EXPECT_EQ(status_at(c, {{"a", a}}), "excluded") << h << assume << to_string(a);
      EXPECT_EQ(status_at(c, {{"a", 0}}), "open") << h << assume;
    }
}

// Where the file admits no level its answer says nothing of the parameters.
TEST(Stated, OnlyWhereThereIsALevel) {
  const System product = planar(even_quartic, "[assume]\nconditions = ['a*h != 0']\n" + diagonal);
  ASSERT_EQ(together(product,
                     exclusions_of_verdict(product, test::checked(study::FileStudy(product)), {}))
                .status(),
            Verdict::non_integrable);
  const auto c = classify_system(product);
  EXPECT_EQ(status_at(c, {{"a", 0}}), "integrable");
  EXPECT_EQ(status_at(c, {{"a", 2}}), "excluded");
  for (const std::string assume :
       {"'h > a'", "'h > 1', 'h < 0*a + 2'", "'a*h > 0'", "'a*h^2 > 2'", "'h = a'"}) {
    const System s = planar(even_quartic, "[assume]\nconditions = [" + assume + "]\n" + diagonal);
    EXPECT_THAT(stated_solutions(s, {}).all, testing::IsEmpty()) << assume;
  }
}

// The stages that a limit may end are told, and can be left out.
TEST(Stated, EachManifoldIsAStage) {
  const System s = planar(even_quartic, diagonal + "[[manifold]]\nname = 'other'\n"
                                                   "equations = ['x = -y', 'u = -v']\n"
                                                   "level = 'H = h'\n");
  std::vector<std::string> stages;
  ClassifyOptions options;
  options.so_far = [&](const SystemClassification& c) { stages.push_back(c.at_work); };
  options.skip = {std::string("diagonal") + stated_stage};
  const StatedSolutions stated = stated_solutions(s, options);
  EXPECT_THAT(stages, testing::ElementsAre(std::string("diagonal") + stated_stage,
                                           std::string("other") + stated_stage));
  ASSERT_EQ(stated.all.size(), 1U);
  EXPECT_EQ(stated.all.front().name, "other");
  EXPECT_FALSE(stated.decided);
}

} // namespace
} // namespace kov::stated_test
