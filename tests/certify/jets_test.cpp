// Certificates of higher variational equations (docs/theory/jet_certificates.md): those of the solver
// are accepted, and each rule refuses something false that looks like it.

#include "certify/jets/check.hpp"
#include "exact/error.hpp"
#include "proof/text/json.hpp"
#include "support/source_dir.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace kov::certify::jets_test {
namespace {

std::string contents(const std::string& path) {
  std::ifstream in(path);
  std::ostringstream s;
  s << in.rdbuf();
  return s.str();
}

std::map<std::string, std::string> corpus() {
  std::map<std::string, std::string> texts;
  for (const auto& e :
       std::filesystem::directory_iterator(test::in_source("/tests/certify/data/jets")))
    texts[e.path().stem().string()] = contents(e.path());
  return texts;
}

/// The rule that refuses a text; empty if it is accepted.
std::string refused_by(const std::string& text) {
  try {
    const auto verdict = check_jets(read_jets_certificate(text));
    const auto* no = std::get_if<Rejected>(&verdict);
    return no ? no->step : "";
  } catch (const InvalidArgument&) {
    return "malformed";
  }
}

Json& entry(Json& j, const Json::Array& path) {
  Json* at = &j;
  for (const Json& key : path)
    if (auto* list = std::get_if<Json::Array>(&at->value))
      at = &list->at(std::stoul(*key.text()));
    else
      for (auto& [name, value] : std::get<Json::Object>(at->value))
        if (name == *key.text()) {
          at = &value;
          break;
        }
  return *at;
}

TEST(JetsCertificate, ThoseOfTheSolverAreAccepted) {
  const auto texts = corpus();
  ASSERT_GE(texts.size(), 8U);
  for (const auto& [name, text] : texts)
    EXPECT_EQ(refused_by(text), "") << name;
}

TEST(JetsCertificate, WhatIsWrittenIsRead) {
  for (const auto& [name, text] : corpus())
    EXPECT_EQ(write_jets_certificate(read_jets_certificate(text)), to_string(parse_json(text, 256)))
        << name;
}

// Lines {"of": name, "at": path, "value": what is put there, "rule", "why"}, the same for the other
// checker.  Without a rule: a change that is true.
TEST(JetsCertificate, FalseOnesAreRefusedByTheirRule) {
  std::ifstream lines(test::in_source("/tests/certify/false/jets.jsonl"));
  ASSERT_TRUE(lines);
  const auto texts = corpus();
  for (std::string line; std::getline(lines, line);) {
    const Json parsed = parse_json(line);
    std::map<std::string, Json> change;
    for (const auto& [key, value] : *parsed.object())
      change[key] = value;
    Json j = parse_json(texts.at(*change["of"].text()), 256);
    entry(j, *change["at"].array()) = change["value"];
    EXPECT_EQ(refused_by(to_string(j)), *change["rule"].text()) << line;
  }
}

std::vector<std::string> stated(const std::string& name) {
  const JetsCertificate c = read_jets_certificate(corpus().at(name));
  return statement(c, std::get<JetsAccepted>(check_jets(c)));
}

TEST(JetsCertificate, WhatIsStated) {
  const auto lines = stated("henon_heiles_n4");
  ASSERT_EQ(lines.size(), 8U);
  EXPECT_EQ(lines[0], "the system \"hh_b35.toml\" with parameters A, B");
  EXPECT_EQ(lines[2], "along the line (q1, q2) = (0, 0) + y*(0, 1)");
  EXPECT_EQ(lines[3], "  except where B = 0");
  EXPECT_EQ(lines[5],
            "is not integrable in Liouville's sense with first integrals that are meromorphic near "
            "the phase curve, for all but countably many values of the energy (Morales-Ruiz, Ramis "
            "and Simo), as");
}

} // namespace
} // namespace kov::certify::jets_test
