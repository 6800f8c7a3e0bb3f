// Certificates over strata written by the solver, for families and for mechanical systems: accepted
// as they are, and in no other way (docs/theory/strata_certificates.md).

#include "certify/strata_text.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace kov::certify {
namespace {

std::vector<std::string> corpus() {
  std::vector<std::string> texts;
  for (const auto& e :
       std::filesystem::directory_iterator(KOV_SOURCE_DIR "/tests/certify/strata")) {
    std::ifstream in(e.path());
    std::ostringstream s;
    s << in.rdbuf();
    texts.push_back(s.str());
  }
  std::sort(texts.begin(), texts.end());
  return texts;
}

TEST(StrataCorpus, EveryCertificateIsAccepted) {
  const auto texts = corpus();
  ASSERT_GT(texts.size(), 10U);
  for (const std::string& text : texts) {
    EXPECT_ACCEPTED(text);
    EXPECT_EQ(accepted(text).trusted, 0U);
  }
}

// Each part replaced at each place where it occurs, one after the other.
void refuse_each(const std::string& text, const std::string& part, const std::string& by) {
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    std::string other = text;
    other.replace(at, part.size(), by);
    EXPECT_NE(refusal(other), "") << part << " -> " << by << " at " << at << " of "
                                  << text.substr(0, 200);
  }
}

TEST(StrataCorpus, NoLeafSaysTheOpposite) {
  for (const std::string& text : corpus()) {
    refuse_each(text, R"("abelian":"no")", R"("abelian":"yes")");
    refuse_each(text, R"("abelian":"yes")", R"("abelian":"no")");
  }
}

// The theorems that need more than the one that was used, and other facts in place of those given.
TEST(StrataCorpus, NoOtherTheorem) {
  for (const std::string& text : corpus()) {
    refuse_each(text, R"("by":"rational")", R"("by":"torus")");
    refuse_each(text, R"("by":"torus")", R"("by":"rational")");
    refuse_each(text, R"("by":"one-open")", R"("by":"rational")");
    refuse_each(text, R"("by":"irreducible-log")", R"("by":"torus-log")");
    refuse_each(text, R"("order":"2")", R"("order":"3")");
    refuse_each(text, R"("order":"1")", R"("order":"2")");
    refuse_each(text, R"("zero":"solve")", R"("zero":"outside")");
    refuse_each(text, R"("times":"1")", R"("times":"0")");
  }
}

} // namespace
} // namespace kov::certify
