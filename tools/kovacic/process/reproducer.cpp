#include "process/reproducer.hpp"

#include "exact/error.hpp"
#include "process/settings.hpp"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace kov::cli {
namespace {

constexpr std::uintmax_t largest_file = std::uintmax_t{1} << 20;

std::vector<std::string>& command_line() {
  static std::vector<std::string> words;
  return words;
}

// FNV-1a: the same mistake gives the same name.
std::string hash_of(const std::string& text) {
  std::uint64_t h = 0xcbf29ce484222325;
  for (const unsigned char c : text)
    h = (h ^ c) * 0x100000001b3;
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(h));
  return digits;
}

nlohmann::ordered_json files_of(const std::vector<std::string>& command) {
  namespace fs = std::filesystem;
  nlohmann::ordered_json files = nlohmann::ordered_json::object();
  for (const std::string& word : command) {
    std::error_code failed;
    if (&word == &command.front() || !fs::is_regular_file(word, failed) ||
        fs::file_size(word, failed) > largest_file)
      continue;
    std::ostringstream text;
    text << std::ifstream(word, std::ios::binary).rdbuf();
    files[word] = text.str();
  }
  return files;
}

std::vector<std::string> directories() {
  const char* temporary = std::getenv("TMPDIR");
  return {".", temporary != nullptr && *temporary != '\0' ? temporary : "/tmp"};
}

} // namespace

void remember_command(int argc, char** argv) { command_line().assign(argv, argv + argc); }

std::string reproducer(const std::vector<std::string>& command, const std::string& what,
                       const std::string& input) {
  const nlohmann::ordered_json j = {{"format", "kovacic-reproducer/1"},
                                    {"version", KOV_VERSION},
                                    {"what", what},
                                    {"command", command},
                                    {"input", input},
                                    {"files", files_of(command)}};
  return j.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string write_reproducer(const std::string& text, const std::vector<std::string>& directories) {
  for (const std::string& directory : directories) {
    const std::string path = directory + "/kovacic-reproducer-" + hash_of(text) + ".json";
    try {
      write_file(path, text);
      return path;
    } catch (const Error&) { // the next one
    }
  }
  return {};
}

void leave_reproducer(const std::string& what, const std::string& input) {
  try {
    const std::string path =
        write_reproducer(reproducer(command_line(), what, input), directories());
    if (!path.empty())
      std::fprintf(stderr, "  note: what repeats it is in %s: please send us this file\n",
                   path.c_str());
  } catch (const std::exception&) { // the mistake itself is reported already
  }
}

} // namespace kov::cli
