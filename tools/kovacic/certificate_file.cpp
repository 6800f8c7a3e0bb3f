#include "certificate_file.hpp"

#include <algorithm>
#include <cctype>

namespace kov::cli {

std::string file_certificate(const Settings& settings, const std::string& name,
                             const std::string& json) {
  std::string plain = name.substr(0, 200);
  std::replace_if(
      plain.begin(), plain.end(),
      [](unsigned char c) { return c >= 0x80 || (std::isalnum(c) == 0 && c != '_' && c != '.'); },
      '-');
  if (plain.empty() || plain.front() == '.') plain.insert(0, "-");
  make_directory(settings.certificate);
  const std::string path = settings.certificate + "/" + plain + ".json";
  write_file(path, json + "\n");
  return path;
}

} // namespace kov::cli
