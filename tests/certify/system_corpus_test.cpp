// Certificates of the whole way written by the solver: accepted as they are, and in no other way
// (docs/theory/system_certificates.md).

#include "certify/system_text.hpp"
#include "proof/text/json.hpp"
#include "support/source_dir.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

namespace kov::certify::system_corpus_test {
namespace {

// By name.
std::map<std::string, std::string> corpus() {
  std::map<std::string, std::string> texts;
  for (const auto& e :
       std::filesystem::directory_iterator(test::in_source("/tests/certify/data/system"))) {
    std::ifstream in(e.path());
    std::ostringstream s;
    s << in.rdbuf();
    texts[e.path().stem().string()] = to_string(parse_json(s.str(), 300));
  }
  return texts;
}

TEST(SystemCorpus, EveryCertificateIsAccepted) {
  const auto texts = corpus();
  ASSERT_GT(texts.size(), 12U);
  for (const auto& [name, text] : texts)
    EXPECT_EQ(refused_by(text), "") << name;
}

TEST(SystemCorpus, WhatIsStatedIsReadable) {
  const auto lines = stated(corpus().at("spring_pendulum-vertical"));
  ASSERT_GT(lines.size(), 6U);
  EXPECT_EQ(lines[0].rfind("the system \"", 0), 0U) << lines[0];
  EXPECT_EQ(lines[1].rfind("  {", 0), 0U) << lines[1];
}

using Path = std::vector<std::string>;

// Calls visit for every text below `at`, which it may change.
template <class Visit> void texts_below(Json& at, Path& path, const Visit& visit) {
  if (auto* text = std::get_if<std::string>(&at.value)) return visit(path, *text);
  const auto below = [&](const std::string& key, Json& child) {
    path.push_back(key);
    texts_below(child, path, visit);
    path.pop_back();
  };
  if (auto* array = std::get_if<Json::Array>(&at.value))
    for (std::size_t i = 0; i < array->size(); ++i)
      below(std::to_string(i), (*array)[i]);
  if (auto* object = std::get_if<Json::Object>(&at.value))
    for (auto& [key, child] : *object)
      below(key, child);
}

bool is_free_text(const Path& path) {
  static const std::set<std::string> free{"title",  "meaning", "manifold", "name",       "kind",
                                          "degree", "format",  "variable", "coordinates"};
  return std::any_of(path.begin(), path.end(),
                     [](const auto& key) { return free.contains(key); }) ||
         path.front() == "parameters" || (path.front() == "equation" && path[1] == "certificate");
}

bool is_number(const std::string& s) {
  return !s.empty() && s.find_first_not_of("0123456789") == std::string::npos;
}

bool is_level(const Path& p) { return p.size() > 1 && (p[1] == "equations" || p[1] == "levels"); }

// Another value of the same kind: a number one more, a polynomial with one more term.  On the curve
// the first coordinate may be 0; a constant that is added to the Hamiltonian changes nothing.
std::string changed(const Path& path, const std::string& s, const std::string& coordinate,
                    const std::string& z) {
  const bool divisor = is_number(path.back()) && path.back() != "0" && is_number(s) &&
                       path[path.size() - 2] != "row";
  if (divisor) return std::to_string(std::stol(s) + 1);
  if (path.back() == "hamiltonian" || path[path.size() - 2] == "hamiltonian")
    return s + " + 3*" + coordinate + "^2";
  if (path.front() == "claims") return s + " + 3*" + coordinate;
  if (path.front() == "system" || path[1] == "change" || is_level(path)) return s + " + 7";
  return s + " + " + z + "^7";
}

// One text changed at a time.  The vectors of N3 are not unique, and 0/3 is 0.
TEST(SystemCorpus, AChangedCertificateIsRefused) {
  for (const auto& [name, text] : corpus()) {
    const bool has_root = text.find("\"root\"") != std::string::npos;
    if (text.size() > 2300 && !has_root) continue;
    std::vector<std::string> accepted;
    std::size_t count = 0;
    const auto coordinate = read_system_certificate(text).way.system.ring->name(0);
    for (std::size_t target = 0;; ++target) {
      Json j = parse_json(text, 300);
      Path path;
      std::size_t seen = 0;
      std::string where;
      texts_below(j, path, [&](const Path& p, std::string& s) {
        const bool zero_over = is_level(p) && p.size() == 4 && p.back() == "1";
        if (is_free_text(p) || zero_over || seen++ != target) return;
        for (const std::string& key : p)
          where += "." + key;
        s = changed(p, s, coordinate, "z");
      });
      if (where.empty()) break;
      ++count;
      if (where.rfind(".normal.vectors", 0) != 0 && refused_by(to_string(j)).empty())
        accepted.push_back(where);
    }
    EXPECT_GT(count, 20U) << name;
    for (const std::string& where : accepted)
      ADD_FAILURE() << name << where << " may be changed";
  }
}

} // namespace
} // namespace kov::certify::system_corpus_test
