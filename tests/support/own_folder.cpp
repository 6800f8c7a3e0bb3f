#include "support/own_folder.hpp"

#include <cstdlib>
#include <filesystem>
#include <stdexcept>

namespace kov::test {

namespace {

struct Folder {
  Folder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "kovacic-test-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no folder: " + pattern);
    path = pattern + "/";
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
  std::string path;
};

} // namespace

const std::string& own_folder() {
  static const Folder folder;
  return folder.path;
}

} // namespace kov::test
