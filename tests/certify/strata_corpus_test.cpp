// Certificates over strata written by the solver, for families and for mechanical systems: accepted
// as they are, and in no other way (docs/theory/strata_certificates.md).

#include "certify/strata_text.hpp"
#include "proof/text/json.hpp"
#include "support/source_dir.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace kov::certify::strata_corpus_test {
namespace {

const std::filesystem::path folder = test::in_source("/tests/certify");

std::string contents(const std::filesystem::path& p) {
  std::ifstream in(p);
  std::ostringstream s;
  s << in.rdbuf();
  return s.str();
}

// By name.
std::map<std::string, std::string> corpus() {
  std::map<std::string, std::string> texts;
  for (const auto& e : std::filesystem::directory_iterator(folder / "data/strata"))
    texts[e.path().stem().string()] = to_string(parse_json(contents(e.path()), 256));
  return texts;
}

TEST(StrataCorpus, EveryCertificateIsAccepted) {
  const auto texts = corpus();
  ASSERT_GT(texts.size(), 10U);
  for (const auto& [name, text] : texts) {
    EXPECT_EQ(refusal(text), "") << name;
    EXPECT_EQ(accepted(text).trusted > 0, name == "trusted") << name;
  }
}

// The entry at a path: names and indices.
Json& entry(Json& j, const Json::Array& path, std::size_t length) {
  Json* at = &j;
  for (std::size_t i = 0; i < length; ++i) {
    const std::string& key = *path[i].text();
    if (auto* a = std::get_if<Json::Array>(&at->value)) {
      at = &a->at(std::stoul(key));
      continue;
    }
    auto& o = std::get<Json::Object>(at->value);
    auto found = std::find_if(o.begin(), o.end(), [&](const auto& x) { return x.first == key; });
    if (found == o.end()) found = o.insert(o.end(), {key, Json{}});
    at = &found->second;
  }
  return *at;
}

void erase(Json& j, const Json::Array& path) {
  Json& parent = entry(j, path, path.size() - 1);
  const std::string& key = *path.back().text();
  if (auto* a = std::get_if<Json::Array>(&parent.value))
    a->erase(a->begin() + std::stol(key));
  else
    std::erase_if(std::get<Json::Object>(parent.value),
                  [&](const auto& x) { return x.first == key; });
}

// Lines {"of": name, "at": path, "value": what is put there, "why"}; without value the entry is
// taken out.
TEST(StrataCorpus, FalseCertificatesAreRefused) {
  std::ifstream lines(folder / "false/strata.jsonl");
  if (!lines) GTEST_SKIP();
  for (std::string line; std::getline(lines, line);) {
    const Json change = parse_json(line);
    std::map<std::string, Json> part;
    for (const auto& [key, value] : *change.object())
      part[key] = value;
    Json j = parse_json(contents(folder / "data/strata" / (*part["of"].text() + ".json")), 256);
    const Json::Array& path = *part["at"].array();
    if (part.count("value") > 0)
      entry(j, path, path.size()) = part["value"];
    else
      erase(j, path);
    EXPECT_NE(refusal(to_string(j)), "") << line;
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
  for (const auto& [name, text] : corpus()) {
    if (name == "trusted") continue; // what is not checked may say anything
    refuse_each(text, R"("abelian":"no")", R"("abelian":"yes")");
    refuse_each(text, R"("abelian":"yes")", R"("abelian":"no")");
  }
}

// The theorems that need more than the one that was used, and other facts in place of those given.
TEST(StrataCorpus, NoOtherTheorem) {
  for (const auto& [name, text] : corpus()) {
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
} // namespace kov::certify::strata_corpus_test
