#include "literature/references.hpp"

#include <algorithm>
#include <map>

namespace kov {

extern const char* const references_text; // references_text.cpp.in

namespace {

// The text between a brace and its partner.
std::string braced(const std::string& text, std::size_t open) {
  long depth = 0;
  for (std::size_t i = open; i < text.size(); ++i) {
    depth += text[i] == '{' ? 1 : text[i] == '}' ? -1 : 0;
    if (depth == 0) return text.substr(open + 1, i - open - 1);
  }
  return {};
}

// field = {...} of an entry that stands in one line.
std::string field(const std::string& entry, const std::string& name) {
  const auto at = entry.find(" " + name + " = {");
  return at == std::string::npos ? "" : braced(entry, entry.find('{', at));
}

// "Ziglin, S. L. and Moser, J." in the order of speech.
std::string authors(const std::string& listed) {
  std::string out;
  for (std::size_t at = 0; at < listed.size();) {
    const auto end = std::min(listed.find(" and ", at), listed.size());
    const std::string one = listed.substr(at, end - at);
    at = end + 5;
    const auto comma = one.find(", ");
    out += (out.empty()           ? ""
            : at >= listed.size() ? " and "
                                  : ", ") +
           (comma == std::string::npos ? one : one.substr(comma + 2) + " " + one.substr(0, comma));
  }
  return out;
}

std::string published(const std::string& entry) {
  std::string out;
  for (const char* name : {"journal", "booktitle", "publisher"})
    if (const auto value = field(entry, name); !value.empty())
      out += (out.empty() ? "" : ", ") + value;
  if (const auto volume = field(entry, "volume"); !volume.empty()) out += " " + volume;
  if (const auto year = field(entry, "year"); !year.empty()) out += " (" + year + ")";
  if (const auto pages = field(entry, "pages"); !pages.empty()) out += ", pp. " + pages;
  if (const auto doi = field(entry, "doi"); !doi.empty()) out += ", doi:" + doi;
  if (const auto note = field(entry, "note"); !note.empty()) out += ", " + note;
  return out;
}

std::map<std::string, Reference> all_references() {
  std::map<std::string, Reference> all;
  const std::string text = references_text;
  for (std::size_t at = text.find('@'); at != std::string::npos; at = text.find("\n@", at + 1)) {
    const std::string entry = braced(text, text.find('{', at));
    const std::string key = entry.substr(0, entry.find(','));
    all[key] = {key, authors(field(entry, "author")), field(entry, "title"), published(entry)};
  }
  return all;
}

// An accent and its letter.
const std::map<std::string, std::string>& accents() {
  static const std::map<std::string, std::string> letters{
      {"\\'a", "á"},  {"\\'e", "é"},  {"\\'i", "í"},  {"\\'o", "ó"},  {"\\'u", "ú"},
      {"\\'E", "É"},  {"\\`a", "à"},  {"\\`e", "è"},  {"\\`A", "À"},  {"\\^a", "â"},
      {"\\^e", "ê"},  {"\\^i", "î"},  {"\\^o", "ô"},  {"\\\"a", "ä"}, {"\\\"e", "ë"},
      {"\\\"i", "ï"}, {"\\\"o", "ö"}, {"\\\"u", "ü"}, {"\\\"O", "Ö"}, {"\\\"U", "Ü"},
      {"\\\"A", "Ä"}, {"\\c c", "ç"}, {"\\o", "ø"},   {"\\O", "Ø"},   {"\\ss", "ß"}};
  return letters;
}

} // namespace

std::optional<Reference> reference(const std::string& key) {
  static const std::map<std::string, Reference> all = all_references();
  const auto found = all.find(key);
  if (found == all.end()) return std::nullopt;
  return found->second;
}

std::string without_tex(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\') {
      const auto letter = std::ranges::find_if(accents(), [&](const auto& accent) {
        return text.compare(i, accent.first.size(), accent.first) == 0;
      });
      if (letter != accents().end()) {
        out += letter->second;
        i += letter->first.size() - 1;
        continue;
      }
    }
    if (text.compare(i, 2, "--") == 0) {
      out += "–";
      ++i;
    } else if (text[i] != '{' && text[i] != '}') {
      out += text[i];
    }
  }
  return out;
}

} // namespace kov
