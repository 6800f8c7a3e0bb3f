#include "symbol/input_error.hpp"

#include <algorithm>

namespace kov {
namespace {

constexpr std::size_t shown_width = 110; // characters of a source line that a message shows

// Length in bytes of the UTF-8 character at s[i]; 0 if the bytes are not one.
std::size_t utf8_length(std::string_view s, std::size_t i) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(s[k]); };
  const unsigned char c = byte(i);
  const std::size_t n = c < 0x80                ? 1
                        : c >= 0xC2 && c < 0xE0 ? 2
                        : c >= 0xE0 && c < 0xF0 ? 3
                        : c >= 0xF0 && c < 0xF5 ? 4
                                                : 0;
  if (n == 0 || i + n > s.size()) return 0;
  for (std::size_t k = 1; k < n; ++k)
    if ((byte(i + k) & 0xC0) != 0x80) return 0;
  if (n == 3 && c == 0xE0 && byte(i + 1) < 0xA0) return 0;
  if (n == 4 && c == 0xF0 && byte(i + 1) < 0x90) return 0;
  return n;
}

// Characters as a reader counts them: one per UTF-8 sequence, one per broken byte.
std::size_t count_characters(std::string_view s) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < s.size(); ++n)
    i += std::max<std::size_t>(1, utf8_length(s, i));
  return n;
}

std::string location(const std::string& file, long line, long column) {
  std::string s = file;
  if (line > 0) s += ":" + std::to_string(line);
  if (line > 0 && column > 0) s += ":" + std::to_string(column);
  return s;
}

// The characters [from, from + count) of s.
std::string cut(std::string_view s, std::size_t from, std::size_t count) {
  std::size_t i = 0;
  for (; from > 0 && i < s.size(); --from)
    i += std::max<std::size_t>(1, utf8_length(s, i));
  const std::size_t begin = i;
  for (; count > 0 && i < s.size(); --count)
    i += std::max<std::size_t>(1, utf8_length(s, i));
  return std::string(s.substr(begin, i - begin));
}

} // namespace

OriginPtr origin_of_text(std::string file, std::string text, std::string what) {
  auto o = std::make_shared<Origin>();
  o->file = std::move(file);
  o->text = std::move(text);
  o->what = std::move(what);
  return o;
}

OriginPtr origin_from(const OriginPtr& origin, std::size_t offset) {
  auto o = std::make_shared<Origin>(*origin);
  o->offset += offset;
  return o;
}

std::string printable(std::string_view bytes) {
  std::string s;
  for (std::size_t i = 0; i < bytes.size();) {
    const std::size_t n = utf8_length(bytes, i);
    const auto c = static_cast<unsigned char>(bytes[i]);
    // C1 controls are two bytes in UTF-8: C2 80 ... C2 9F
    const bool control = c < 0x20 || c == 0x7F ||
                         (n == 2 && c == 0xC2 && static_cast<unsigned char>(bytes[i + 1]) < 0xA0);
    if (c == '\t')
      s += ' ';
    else if (n == 0 || control)
      s += '?';
    else
      s += bytes.substr(i, n);
    i += std::max<std::size_t>(1, n);
  }
  return s;
}

InputError::Place InputError::locate(const Origin& origin, Span where) {
  const std::string_view text = origin.text;
  const std::size_t at = std::min(origin.offset + where.offset, text.size());
  const std::size_t newline = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
  const std::size_t begin = newline == std::string_view::npos ? 0 : newline + 1;
  const std::size_t end = std::min(text.find('\n', at), text.size());
  const std::size_t stop = std::min(at + where.length, end);
  return {.line = origin.first_line + std::count(text.begin(), text.begin() + begin, '\n'),
          .column = static_cast<long>(count_characters(text.substr(begin, at - begin))) + 1,
          .length = std::max(1L, static_cast<long>(count_characters(text.substr(at, stop - at)))),
          .source_line = std::string(text.substr(begin, end - begin))};
}

InputError::InputError(std::string file, Place place, std::string message, std::string hint)
    : InputError(std::move(file), place.line, place.column, place.length, std::move(message),
                 std::move(hint), std::move(place.source_line)) {}

InputError::InputError(const Origin& origin, Span where, std::string message, std::string hint)
    : InputError(origin.file, locate(origin, where),
                 origin.what.empty() ? std::move(message) : message + " in " + origin.what,
                 std::move(hint)) {}

InputError::InputError(std::string file, long line, long column, long length, std::string message,
                       std::string hint, std::string source_line)
    : Error(location(file, line, column) + ": error: " + message), file_(std::move(file)),
      line_(line), column_(column), length_(std::max(1L, length)), message_(std::move(message)),
      hint_(std::move(hint)), source_line_(std::move(source_line)) {}

std::string render(const InputError& e, bool color) {
  const auto paint = [&](const char* code, const std::string& s) {
    return color ? "\033[" + std::string(code) + "m" + s + "\033[0m" : s;
  };
  std::string out = paint("1", printable(location(e.file(), e.line(), e.column())) + ":") + " " +
                    paint("1;31", "error:") + " " + paint("1", printable(e.message())) + "\n";
  if (!e.source_line().empty() && e.column() > 0) {
    const std::string number = std::to_string(e.line());
    const std::string margin = std::string(number.size() < 5 ? 5 - number.size() : 0, ' ') + number;
    const auto column = static_cast<std::size_t>(e.column()) - 1;
    const std::size_t total = count_characters(e.source_line());
    std::size_t from = 0;
    if (total > shown_width && column > shown_width * 2 / 3)
      from = std::min(column - shown_width / 2, total - shown_width / 2);
    const std::string lead = from > 0 ? "..." : "";
    const std::string tail = from + shown_width < total ? "..." : "";
    const std::size_t room =
        std::max<std::size_t>(1, shown_width - std::min(shown_width, column - from));
    const std::size_t width = std::min(static_cast<std::size_t>(e.length()), room);
    out += margin + " | " + lead + printable(cut(e.source_line(), from, shown_width)) + tail + "\n";
    out += std::string(margin.size(), ' ') + " | " + std::string(lead.size() + column - from, ' ') +
           paint("1;32", "^" + std::string(width - 1, '~')) + "\n";
  }
  if (!e.hint().empty()) out += "  " + paint("1;36", "note:") + " " + printable(e.hint()) + "\n";
  return out;
}

} // namespace kov
