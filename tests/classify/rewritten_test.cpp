// What is decided does not depend on how the question is written: 60 pairs and more.
//
// A small sample in the suite; all pairs: tools/attack --minutes 20 'Rewritten.*'.

#include "classify/classify.hpp"

#include "rewritten.hpp"

#include <gmock/gmock.h>

#include <map>

namespace kov::test {
namespace {

// The status, and the number of sets of each kind: names and forms of the sets may differ.
std::string answer(const std::string& text) {
  ClassifyOptions options;
  options.check.decide.budget.give(6e9);
  return to_string(
      classify_system(read_system(parse_document(text, "rewritten.toml")), options).status());
}

const std::string& plain_answer(const Question& q) {
  static std::map<const Question*, std::string> all;
  const auto known = all.find(&q);
  return known != all.end() ? known->second : all[&q] = answer(text_of(q, writings(q).front()));
}

void expect_nothing_lost(const Question& q, const Writing& w) {
  const std::string text = text_of(q, w);
  EXPECT_EQ(answer(text), plain_answer(q)) << text;
}

TEST(Rewritten, ThereAreSixtyPairs) {
  std::size_t pairs = 0;
  for (const Question& q : questions())
    pairs += writings(q).size() - 1;
  EXPECT_GE(pairs, 60U);
}

// Of tops whose separatrices split: a tenth of a second each.
TEST(Rewritten, TopsLoseNothing) {
  for (const Question& q : {questions()[0], questions()[1]})
    for (const Writing& w : writings(q))
      EXPECT_EQ(answer(text_of(q, w)), "non-integrable") << text_of(q, w);
}

TEST(Rewritten, NothingIsLost) {
  random_rounds(3, [](Random& random) {
    const Question& q = random.one_of(questions());
    expect_nothing_lost(q, random.one_of(writings(q)));
  });
}

} // namespace
} // namespace kov::test
