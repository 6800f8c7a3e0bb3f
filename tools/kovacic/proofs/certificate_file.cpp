#include "proofs/certificate_file.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace kov::cli {

std::string laid_out(std::string_view json) {
  std::string out;
  out.reserve(json.size() + json.size() / 8 + 16);
  std::string broken; // for each open bracket: 'b' if its members stand on lines of their own
  const auto line = [&] { out.append(1, '\n').append(broken.size(), ' '); };
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    const auto next = json.find_first_not_of(" \n\t\r", i + 1);
    switch (c) {
    case ' ':
    case '\n':
    case '\t':
    case '\r':
      break;
    case '"': {
      std::size_t end = i + 1;
      while (end < json.size() && json[end] != '"')
        end += json[end] == '\\' ? 2 : 1;
      out.append(json.substr(i, end + 1 - i));
      i = end;
      break;
    }
    case '{':
    case '[': {
      const char inside = next < json.size() ? json[next] : ']';
      out += c;
      broken += (c == '{' && inside != '}') || inside == '{' ? 'b' : '-';
      if (broken.back() == 'b') line();
      break;
    }
    case '}':
    case ']': {
      const bool own_line = !broken.empty() && broken.back() == 'b';
      if (!broken.empty()) broken.pop_back();
      if (own_line) line();
      out += c;
      break;
    }
    case ',':
      out += c;
      if (!broken.empty() && broken.back() == 'b')
        line();
      else
        out += ' ';
      break;
    case ':':
      out += ": ";
      break;
    default:
      out += c;
    }
  }
  return out;
}

std::string file_name(const std::string& name) {
  std::string plain = name.substr(0, 200);
  std::replace_if(
      plain.begin(), plain.end(),
      [](unsigned char c) { return c >= 0x80 || (std::isalnum(c) == 0 && c != '_' && c != '.'); },
      '-');
  if (plain.empty() || plain.front() == '.') plain.insert(0, "-");
  return plain;
}

std::string loops_file(const std::string& certificate) {
  const std::filesystem::path path(certificate);
  return (path.parent_path() / path.stem()).string() + ".loops" + path.extension().string();
}

std::string file_certificate(const Settings& settings, const std::string& name,
                             const std::string& json) {
  make_directory(settings.certificate);
  const std::string path = settings.certificate + "/" + file_name(name) + ".json";
  write_file(path, laid_out(json) + "\n");
  return path;
}

} // namespace kov::cli
