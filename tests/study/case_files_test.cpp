// Every system file under cases/: its claims and its [[expect]] blocks.

#include "study/expect.hpp"
#include "support/source_dir.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace kov {
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

TEST_P(CaseFile, KeepsItsPromises) {
  for (const auto& r : study::test_file(GetParam()))
    EXPECT_EQ(r.message, "") << r.file << ":" << r.line << ": " << r.name;
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
} // namespace kov
