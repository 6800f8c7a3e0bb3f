// A mistake of the program leaves a file from which it can be repeated.

#include "process/reproducer.hpp"
#include "support/own_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace kov::cli::reproducer_test {
namespace {

using Json = nlohmann::ordered_json;

TEST(Reproducer, HoldsTheCommandItsFilesAndWhatHappened) {
  const std::string file = test::own_folder() + "reproduced.toml";
  std::ofstream(file) << "r = \"z\"\n";
  const Json j = Json::parse(reproducer({"kovacic", "check", file}, "two \xff answers", "a line"));
  EXPECT_EQ(j.at("format"), "kovacic-reproducer/1");
  EXPECT_EQ(j.at("command").size(), 3U);
  EXPECT_EQ(j.at("files").at(file), "r = \"z\"\n");
  EXPECT_EQ(j.at("input"), "a line");
  EXPECT_NE(j.at("what").get<std::string>().find("answers"), std::string::npos);
  EXPECT_FALSE(j.at("version").get<std::string>().empty());
}

TEST(Reproducer, GoesWhereItCanBeWritten) {
  const std::string text = reproducer({"kovacic"}, "a mistake", "");
  const std::string path = write_reproducer(text, {"/proc/none", test::own_folder()});
  ASSERT_TRUE(std::filesystem::exists(path));
  EXPECT_NE(path.find("kovacic-reproducer-"), std::string::npos);
  EXPECT_EQ(path, write_reproducer(text, {test::own_folder()})) << "one mistake, one file";
  EXPECT_EQ(write_reproducer(text, {"/proc/none"}), "");
}

} // namespace
} // namespace kov::cli::reproducer_test
