// Every equation without free parameters of the public corpus: right group, right identity
// component.

#include "corpus.hpp"

namespace kov {
namespace {

class Corpus : public testing::TestWithParam<Json> {};

TEST_P(Corpus, GroupAndIdentityComponent) {
  const Json& entry = GetParam();
  const Decision d = decide(equation_of(entry));
  ASSERT_TRUE(d.group) << reason(d);
  const Json& expected = entry.at("expected");
  EXPECT_EQ(corpus_name(*d.group), expected.at("group").get<std::string>()) << reason(d);
  EXPECT_EQ(certainly(d.abelian), expected.at("identity_component_abelian").get<bool>());
  EXPECT_EQ(*d.kovacic_case, expected.at("kovacic_case").get<int>());
  EXPECT_EQ(d.solutions.empty(), d.group->type == GroupType::SL2);
}

INSTANTIATE_TEST_SUITE_P(Public, Corpus, testing::ValuesIn(corpus("public.jsonl")), name_of);
// Equations on which implementations are known to fail (one row or two for each number).
INSTANTIATE_TEST_SUITE_P(Pitfalls, Corpus, testing::ValuesIn(corpus("pitfalls.jsonl")), name_of);

} // namespace
} // namespace kov
