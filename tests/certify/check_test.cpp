#include "certify/equation/check.hpp"

#include "exact/error.hpp"
#include "proof/text/limits.hpp"
#include "proof/text/meter.hpp"
#include "support/source_dir.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace kov::certify::check_test {
namespace {

std::string read_file(const std::filesystem::path& p) {
  std::ifstream in(p);
  std::ostringstream s;
  s << in.rdbuf();
  return s.str();
}

std::vector<std::filesystem::path> certificates(const std::string& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& e :
       std::filesystem::directory_iterator(test::in_source("/tests/certify/") + folder))
    if (e.path().extension() == ".json") files.push_back(e.path());
  std::sort(files.begin(), files.end());
  return files;
}

TEST(Corpus, EveryCertificateIsAccepted) {
  ASSERT_GT(certificates("data").size(), 10U);
  for (const auto& file : certificates("data")) {
    const Certificate c = read_certificate(read_file(file));
    const auto verdict = check(c);
    const auto* r = std::get_if<Rejected>(&verdict);
    EXPECT_EQ(r, nullptr) << file << ": step " << (r ? r->step + ": " + r->why : "");
  }
}

// Each file is one way to a false theorem that looks like a proof.
TEST(Corpus, FalseCertificatesAreRefused) {
  ASSERT_FALSE(certificates("false").empty());
  for (const auto& file : certificates("false")) {
    try {
      const auto verdict = check(read_certificate(read_file(file)));
      EXPECT_TRUE(std::holds_alternative<Rejected>(verdict)) << file;
    } catch (const InvalidArgument&) { // refused unread: the field is none, say
    }
  }
}

// What one certificate leaves of the work of a file is all that the others have: equations as steps, and as leaves.
TEST(Meter, IsOneForAllCertificatesOfAFile) {
  const Certificate one = read_certificate(
      read_file(test::in_source("/tests/certify/data/airy-naive.json"))); // costs 100 or so
  const auto accepted = [&] {
    const FileMeter inside; // counts for the file that it is in
    const auto verdict = check(one);
    const auto* no = std::get_if<Rejected>(&verdict);
    EXPECT_TRUE(no == nullptr || no->limit) << no->why;
    return no == nullptr;
  };
  EXPECT_TRUE(accepted());
  const FileMeter file;
  FileMeter::charge(0, 0, max_total - 1e5);
  EXPECT_TRUE(accepted());
  int others = 1;
  while (others < 10000 && accepted())
    ++others;
  EXPECT_LT(others, 10000);
}

TEST(Corpus, WritingAndReadingIsTheIdentity) {
  for (const auto& file : certificates("data")) {
    const std::string text = write_certificate(read_certificate(read_file(file)));
    EXPECT_EQ(text, write_certificate(read_certificate(text))) << file;
  }
}

} // namespace
} // namespace kov::certify::check_test
