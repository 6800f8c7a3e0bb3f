// Every system file under cases/: its claims and its [[expect]] blocks.

#include "study/expect.hpp"
#include "support/source_dir.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace kov::case_files_test {
namespace {

std::vector<std::string> system_files() {
  std::vector<std::string> files;
  const std::string root = test::in_source("/cases");
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root))
    if (entry.path().extension() == ".toml" &&
        is_system_document(read_document(entry.path().string())))
      files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

class CaseFile : public testing::TestWithParam<std::string> {};

// Each claim is proved (or refuted, where the file says holds = false), at the values of the first [[expect]];
// each of them is asked with its own values.
TEST_P(CaseFile, KeepsItsPromises) {
  const Entry document = read_document(GetParam());
  bool with_claims = true;
  for (const ParameterValues& values : study::rounds(read_system(document), {})) {
    const study::SystemStudy all = study::study(document, values);
    if (std::exchange(with_claims, false))
      for (const ClaimReport& c : all.claims) {
        EXPECT_TRUE(is_met(c.claim, c.result))
            << c.claim.line << ": " << c.claim.name << c.claim.text << ": " << c.result.detail;
      }
    for (const SystemExpectation& x : all.system.expectations)
      if (x.where == values) {
        EXPECT_EQ(study::unmet(x, all.manifolds), "") << x.line << ": " << study::describe(x);
      }
  }
}

std::string test_name(const testing::TestParamInfo<std::string>& file) {
  const std::filesystem::path path(file.param);
  std::string name = path.parent_path().filename().string() + "_" + path.stem().string();
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Systems, CaseFile, testing::ValuesIn(system_files()), test_name);

} // namespace
} // namespace kov::case_files_test
